"""A recipe found in a file: its gaps, runs and methods, or why it does not fit."""

import json
from collections.abc import Collection, Container, Iterable, Mapping, Sequence
from dataclasses import dataclass
from pathlib import Path
from typing import Any, NamedTuple, TypeVar

import numpy as np

from mocapmend import training
from mocapmend.doubts import Doubt
from mocapmend.engine import FillJob
from mocapmend.errors import MocapmendError
from mocapmend.files import KeptGap, MovedRun, Renamed, SmoothedRun, Source
from mocapmend.files.corrections import changed_labels
from mocapmend.files.records import RecordedRun, RepairRecord
from mocapmend.files.sidecar import hash_file
from mocapmend.layers import Layers
from mocapmend.recipe import Recipe, read_recipe
from mocapmend_algorithms import Gap, Progress, Recording
from mocapmend_algorithms.corrections import Move
from mocapmend_algorithms.fill import registry
from mocapmend_algorithms.smooth import registry as smoothers

Entry = TypeVar("Entry", RepairRecord, SmoothedRun)


class SmoothJob(NamedTuple):
    """Runs that one method smooths with the same parameters."""

    method: str
    params: Any
    runs: tuple[Gap, ...]


@dataclass(frozen=True)
class Planned:
    """A recipe for one file.

    Attributes
    ----------
    reopened : tuple of Gap
        Repairs that are turned back into gaps.
    jobs : tuple of FillJob
        What is filled.
    kept_open : mapping of Gap to KeptGap
        Gaps that are kept open from now on.
    freed : tuple of Gap
        Gaps that the file kept open before.
    layers : Layers
        What is exchanged and set aside, from which the gaps are filled.
    smoothing : tuple of SmoothJob
        What is smoothed at last.
    renamed : tuple of Renamed
        All points that are called otherwise than they were first.
    """

    reopened: tuple[Gap, ...]
    jobs: tuple[FillJob, ...]
    kept_open: Mapping[Gap, KeptGap]
    freed: tuple[Gap, ...]
    layers: Layers
    smoothing: tuple[SmoothJob, ...]
    renamed: tuple[Renamed, ...] = ()

    def labels(self, source: Source) -> dict[int, str]:
        """Return the labels that markers of the file get."""
        known = () if source.provenance is None else source.provenance.corrections.renamed
        labels = changed_labels(known, self.renamed)
        return {source.markers_by_point[point + 1]: label for point, label in labels.items()}


def plan(source: Source, recipe: Recipe) -> Planned:
    """Find the gaps of a recipe in a file.

    Raises
    ------
    MocapmendError
        If an edit does not fit the file, its method is not known, or its training set is not
        there.
    """
    layers = _layers(source, recipe)
    gaps = _Fillable(layers.recording)
    repaired = set(source.repaired)
    reopened = [_gap_of(source, item, repaired) for item in recipe.reopened]
    filled = [_gap_of(source, item, gaps) for item in recipe.fills]
    freed = [_gap_of(source, item, source.kept_open) for item in recipe.freed]
    open_gaps = {*layers.open_gaps(), *reopened}
    kept = [_gap_of(source, item, open_gaps) for item in recipe.kept_open]
    twice = (_has_twice([*reopened, *filled]), _has_twice([*freed, *kept]))
    if any(twice) or overlapping(source, kept, filled):
        raise _does_not_fit(source, "it has two edits of one gap")
    never = set(source.never_filled).difference(freed)
    if refused := overlapping(source, never, filled):
        frames = _frames(recipe.fills[filled.index(refused[0])])
        raise _does_not_fit(source, f"{frames} are never to be filled")
    jobs = _grouped(
        (json.dumps([item.method, item.parameters], sort_keys=True), item, gap)
        for item, gap in zip(recipe.fills, filled, strict=True)
    )
    return Planned(
        tuple(reopened),
        tuple(FillJob(*_method(source, item), tuple(of)) for item, of in jobs),
        dict(zip(kept, recipe.kept_open, strict=True)),
        tuple(freed),
        layers,
        _smoothing(source, recipe.smoothed),
        _renamed(source, recipe),
    )


def prepare(source: Source, path: Path, progress: Progress) -> tuple[Planned, bool]:
    """Read a recipe and find its gaps in a file, and say whether it was made for this very file.

    Raises
    ------
    MocapmendError
        If it is no recipe, or does not fit the file.
    """
    recipe = read_recipe(path)
    planned = plan(source, recipe)
    progress(0.5)
    return planned, hash_file(source.path) == recipe.input


def _layers(source: Source, recipe: Recipe) -> Layers:
    """Return what is exchanged and set aside by a recipe.

    Raises
    ------
    MocapmendError
        If it does not fit the file.
    """
    now = Layers.of(source)
    moves, aside = set(now.moves), dict(now.set_aside)
    for entry in recipe.moved_back:
        moves.discard(_move(source, entry))
    for run in recipe.believed:
        aside.pop(_run_of(source, run), None)
    moves |= {_move(source, entry) for entry in recipe.moved}
    aside |= {_run_of(source, one): Doubt(one.problem, one.reason) for one in recipe.set_aside}
    try:
        after = Layers.with_moves(source, sorted(moves), aside)
    except ValueError:
        raise _does_not_fit(source, "what it exchanges contradicts itself") from None
    if not all(after.measured(run).all() for run in aside):
        raise _does_not_fit(source, "samples that it sets aside were not measured")
    return after


def _move(source: Source, entry: MovedRun) -> Move:
    origin = source.markers_by_point.get(entry.from_point)
    if origin is None or source.recording.labels[origin] != entry.from_marker:
        raise _does_not_fit(
            source, f"its point {entry.from_point} is not the marker {entry.from_marker}"
        )
    return Move(*_run_of(source, entry), origin)


def _renamed(source: Source, recipe: Recipe) -> tuple[Renamed, ...]:
    """Return what points are called after a recipe."""
    known = () if source.provenance is None else source.provenance.corrections.renamed
    entries = {entry.point: entry for entry in known}
    for entry in recipe.renamed_back:
        entries.pop(entry.point, None)
    for entry in recipe.renamed:
        marker = source.markers_by_point.get(entry.point)
        if marker is None:
            raise _does_not_fit(source, f"its point {entry.point} is no marker")
        entries[entry.point] = entry
    return tuple(entries[point] for point in sorted(entries))


def _smoothing(source: Source, stated: Sequence[SmoothedRun]) -> tuple[SmoothJob, ...]:
    """Return the smoothing of a recipe, what was done alike as one job."""

    def alike(item: SmoothedRun) -> str:
        # What was chosen for all of several runs depends on which these were.
        together = dict(item.chosen) if item.parameters.get("cutoff_for") == "all" else {}
        return json.dumps([item.method, dict(item.parameters), together], sort_keys=True)

    jobs = _grouped((alike(item), item, _run_of(source, item)) for item in stated)
    return tuple(SmoothJob(*_smoother(source, item), tuple(sorted(of))) for item, of in jobs)


def _grouped(stated: Iterable[tuple[str, Entry, Gap]]) -> list[tuple[Entry, list[Gap]]]:
    """Bring together what is to be done alike, as a text says: the first entry and all runs."""
    alike: dict[str, tuple[Entry, list[Gap]]] = {}
    for key, item, run in stated:
        alike.setdefault(key, (item, []))[1].append(run)
    return list(alike.values())


def _smoother(source: Source, item: SmoothedRun) -> tuple[str, Any]:
    try:
        known = smoothers.smoother(item.method)
        return known.id, smoothers.restore_params(known, item.parameters)
    except (KeyError, ValueError) as error:
        raise _unknown_method(source, error) from None


def _has_twice(gaps: Collection[Gap]) -> bool:
    return len(set(gaps)) < len(gaps)


def overlapping(source: Source, some: Iterable[Gap], others: Iterable[Gap]) -> list[Gap]:
    """Return those of the others that have samples in common with some gaps."""
    covered = np.zeros(source.recording.present.shape, np.bool_, order="F")
    for gap in some:
        covered[gap.start : gap.stop, gap.marker] = True
    return [gap for gap in others if covered[gap.start : gap.stop, gap.marker].any()]


class _Fillable(Container[Gap]):
    """The gaps of a recording, and those whose ends cover measured samples too."""

    def __init__(self, recording: Recording) -> None:
        self._present = recording.present

    def __contains__(self, gap: object) -> bool:
        assert isinstance(gap, Gap)
        there = self._present[:, gap.marker]
        edges = [row for row in (gap.start - 1, gap.stop) if 0 <= row < len(there)]
        inside = 0 <= gap.start < gap.stop <= len(there)
        return inside and not there[gap.start : gap.stop].all() and bool(there[edges].all())


def _gap_of(source: Source, item: RecordedRun, gaps: Container[Gap]) -> Gap:
    """Find the gap that an edit is about."""
    gap = _stated(source, item)
    if gap not in gaps:
        raise _does_not_fit(source, f"{_frames(item)} are not one of its gaps")
    return gap


def _run_of(source: Source, item: RecordedRun) -> Gap:
    """Find the run that an edit is about."""
    run = _stated(source, item)
    if not 0 <= run.start < run.stop <= source.recording.frames:
        raise _does_not_fit(source, f"{_frames(item)} are not in it")
    return run


def _stated(source: Source, item: RecordedRun) -> Gap:
    """Return the run that an edit names, of which nothing but the marker is known to be there."""
    recording = source.recording
    marker = source.markers_by_point.get(item.point)
    if marker is None or recording.labels[marker] != item.marker:
        raise _does_not_fit(source, f"its point {item.point} is not the marker {item.marker}")
    return Gap(marker, *item.rows(recording.first_frame))


def _frames(item: RecordedRun) -> str:
    return f"frames {item.first_frame} to {item.last_frame} of {item.marker}"


def _method(source: Source, item: RepairRecord) -> tuple[str, Any]:
    try:
        method = registry.method(item.method)
        params = registry.restore_params(method, training.without_digests(item.parameters))
    except (KeyError, ValueError) as error:
        raise _unknown_method(source, error) from None
    training.require_same(params, item.parameters)
    return method.id, params


def _unknown_method(source: Source, error: Exception) -> MocapmendError:
    return MocapmendError(
        f"The recipe cannot be replayed: {error.args[0]}.",
        str(source.path),
        "Use the version of the program that the recipe names.",
    )


def _does_not_fit(source: Source, why: str) -> MocapmendError:
    return MocapmendError(
        f"The recipe does not fit this file: {why}.",
        str(source.path),
        "Use it with the file that it was made for.",
    )
