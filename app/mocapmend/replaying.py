"""The edits of a recipe, made again in a file."""

import json
from collections.abc import Collection, Container, Iterable, Mapping, Sequence
from dataclasses import dataclass
from pathlib import Path
from typing import Any

import numpy as np
from numpy.typing import NDArray

from mocapmend import training
from mocapmend.engine import Changes, fill_anyway, record
from mocapmend.errors import MocapmendError
from mocapmend.files import KeptGap, SampleRun, Source
from mocapmend.files.records import RecordedRun, RepairRecord
from mocapmend.files.sidecar import hash_file
from mocapmend.recipe import Recipe, read_recipe
from mocapmend_algorithms import Gap, Progress, Recording
from mocapmend_algorithms.fill import registry
from mocapmend_algorithms.fill.contract import FillResult
from mocapmend_algorithms.progress import part


@dataclass(frozen=True)
class FillJob:
    """Gaps that one method fills with the same parameters."""

    method: str
    params: Any
    gaps: tuple[Gap, ...]


@dataclass(frozen=True)
class Plan:
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
    """

    reopened: tuple[Gap, ...]
    jobs: tuple[FillJob, ...]
    kept_open: Mapping[Gap, KeptGap]
    freed: tuple[Gap, ...]


def plan(source: Source, recipe: Recipe) -> Plan:
    """Find the gaps of a recipe in a file.

    Raises
    ------
    MocapmendError
        If an edit does not fit the file, its method is not known, or its training set is not
        there.
    """
    gaps = _Fillable(source.measured)
    repaired = set(source.repaired)
    reopened = [_gap_of(source, item, repaired) for item in recipe.reopened]
    filled = [_gap_of(source, item, gaps) for item in recipe.fills]
    freed = [_gap_of(source, item, source.kept_open) for item in recipe.freed]
    open_gaps = {*source.open_gaps(), *reopened}
    kept = [_gap_of(source, item, open_gaps) for item in recipe.kept_open]
    twice = (_has_twice([*reopened, *filled]), _has_twice([*freed, *kept]))
    if any(twice) or _overlapping(source, kept, filled):
        raise _does_not_fit(source, "it has two edits of one gap")
    never = set(source.never_filled).difference(freed)
    if refused := _overlapping(source, never, filled):
        frames = _frames(recipe.fills[filled.index(refused[0])])
        raise _does_not_fit(source, f"{frames} are never to be filled")
    ways: dict[str, tuple[str, Any]] = {}
    jobs: dict[str, list[Gap]] = {}
    for item, gap in zip(recipe.fills, filled, strict=True):
        alike = json.dumps([item.method, item.parameters], sort_keys=True)
        if alike not in ways:
            ways[alike] = _method(source, item)
        jobs.setdefault(alike, []).append(gap)
    return Plan(
        tuple(reopened),
        tuple(FillJob(*ways[key], tuple(of)) for key, of in jobs.items()),
        dict(zip(kept, recipe.kept_open, strict=True)),
        tuple(freed),
    )


def prepare(source: Source, path: Path, progress: Progress) -> tuple[Plan, bool]:
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


def fill(recording: Recording, jobs: Sequence[FillJob], progress: Progress) -> list[FillResult]:
    """Fill the gaps of a plan, all of them.

    Parameters
    ----------
    recording : Recording
        The measured samples.
    jobs : sequence of FillJob
        What to fill.
    progress : Progress
        Called often; may cancel.

    Returns
    -------
    list of FillResult
        One per job.

    Raises
    ------
    MocapmendError
        If a method leaves one of its gaps open.
    """
    results = []
    for number, job in enumerate(jobs):
        share = part(progress, number / len(jobs), (number + 1) / len(jobs))
        result = fill_anyway(recording, job.gaps, job.method, job.params, share)
        if result.unfilled:
            left = result.unfilled[0]
            raise MocapmendError(
                f"A gap of {recording.labels[left.gap.marker]} cannot be filled: {left.reason}.",
                todo="The recipe was made for another recording, or by another version.",
            )
        results.append(result)
    return results


def replay(source: Source, recipe: Recipe, progress: Progress) -> Changes:
    """Make the edits of a recipe in a file.

    Parameters
    ----------
    source : Source
        The file.
    recipe : Recipe
        What to do.
    progress : Progress
        Called often; may cancel.

    Returns
    -------
    Changes
        What the file becomes by it.

    Raises
    ------
    MocapmendError
        If an edit does not fit the file, or cannot be made.
    """
    planned = plan(source, recipe)
    results = fill(source.measured, planned.jobs, progress)
    kept = dict(zip(source.repaired, source.repairs, strict=True))
    values = {gap: _missing(gap) for gap in planned.reopened}
    for gap in planned.reopened:
        kept.pop(gap, None)
    for job, result in zip(planned.jobs, results, strict=True):
        for patch in result.patches:
            values[patch.gap] = patch.values
            donors = result.donors(patch.gap)
            kept[patch.gap] = record(source, patch, job.method, job.params, donors)
    kept_open = {**source.kept_open, **planned.kept_open}
    filled = [gap for job in planned.jobs for gap in job.gaps]
    for gap in (*planned.freed, *_overlapping(source, filled, source.kept_open)):
        kept_open.pop(gap, None)
    runs = [SampleRun(gap.marker, gap.start, values[gap]) for gap in sorted(values)]
    return Changes(
        tuple(runs),
        tuple(kept[gap] for gap in sorted(kept)),
        tuple(kept_open[gap] for gap in sorted(kept_open)),
    )


def _has_twice(gaps: Collection[Gap]) -> bool:
    return len(set(gaps)) < len(gaps)


def _overlapping(source: Source, some: Iterable[Gap], others: Iterable[Gap]) -> list[Gap]:
    """Return those of the others that have samples in common with some gaps."""
    covered = np.zeros(source.recording.present.shape, np.bool_, order="F")
    for gap in some:
        covered[gap.start : gap.stop, gap.marker] = True
    return [gap for gap in others if covered[gap.start : gap.stop, gap.marker].any()]


def _missing(gap: Gap) -> NDArray[np.float64]:
    return np.full((gap.length, 3), np.nan)


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
    recording = source.recording
    marker = source.markers_by_point.get(item.point)
    if marker is None or recording.labels[marker] != item.marker:
        raise _does_not_fit(source, f"its point {item.point} is not the marker {item.marker}")
    gap = Gap(marker, *item.rows(recording.first_frame))
    if gap not in gaps:
        raise _does_not_fit(source, f"{_frames(item)} are not one of its gaps")
    return gap


def _frames(item: RecordedRun) -> str:
    return f"frames {item.first_frame} to {item.last_frame} of {item.marker}"


def _method(source: Source, item: RepairRecord) -> tuple[str, Any]:
    try:
        method = registry.method(item.method)
        params = registry.restore_params(method, training.without_digests(item.parameters))
    except (KeyError, ValueError) as error:
        raise MocapmendError(
            f"The recipe cannot be replayed: {error.args[0]}.",
            str(source.path),
            "Use the version of the program that the recipe names.",
        ) from None
    training.require_same(params, item.parameters)
    return method.id, params


def _does_not_fit(source: Source, why: str) -> MocapmendError:
    return MocapmendError(
        f"The recipe does not fit this file: {why}.",
        str(source.path),
        "Use it with the file that it was made for.",
    )
