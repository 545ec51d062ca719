"""A recipe: the edits of one file as a small text file, to be made again with the same result.

A fill is written down as its gap, its method and the parameters of that, without the values: they
are computed again, from the measured samples alone, so that the order does not matter.
"""

import json
from collections.abc import Container, Sequence
from dataclasses import dataclass
from pathlib import Path
from typing import Any

import numpy as np
from numpy.typing import NDArray

from mocapmend import training
from mocapmend.engine import Changes, fill_anyway, record
from mocapmend.errors import MocapmendError
from mocapmend.files import RepairRecord, SampleRun, Source
from mocapmend.files.atomic import write_bytes
from mocapmend.files.opening import read_whole
from mocapmend.files.provenance import (
    PROGRAM,
    decode_document,
    encode_document,
    hashes,
    line,
    program_name,
    records,
)
from mocapmend.files.sidecar import hash_file
from mocapmend_algorithms import Gap, Progress, Recording, no_progress
from mocapmend_algorithms.fill import registry
from mocapmend_algorithms.fill.contract import FillResult

KEY = "mocapmend_recipe"
MOST_BYTES = 50_000_000


@dataclass(frozen=True)
class Recipe:
    """The edits of a file.

    Attributes
    ----------
    input : str
        SHA-256 of the file that they were made in.
    fills : tuple of RepairRecord
        The gaps that are filled, and how.
    reopened : tuple of RepairRecord
        Repairs that the file had before, and that are missing samples again.
    program : str
        The program that wrote the recipe, with its version.
    """

    input: str
    fills: tuple[RepairRecord, ...]
    reopened: tuple[RepairRecord, ...] = ()
    program: str = PROGRAM


def recipe_of(source: Source, repairs: Sequence[RepairRecord]) -> Recipe:
    """Return the recipe that makes the given repairs of a file out of the ones that it has.

    Raises
    ------
    MocapmendError
        If the file cannot be read.
    """
    kept = set(map(line, source.repairs))
    wanted = {(item.point, item.first_frame) for item in repairs}
    ordered = sorted(repairs, key=lambda item: (item.point, item.first_frame))
    return Recipe(
        input=hash_file(source.path),
        fills=tuple(item for item in ordered if line(item) not in kept),
        reopened=tuple(
            item for item in source.repairs if (item.point, item.first_frame) not in wanted
        ),
    )


def write_recipe(
    source: Source,
    repairs: Sequence[RepairRecord],
    path: Path,
    progress: Progress = no_progress,
) -> None:
    """Write a recipe; a file of that name is replaced.

    Raises
    ------
    MocapmendError
        If it cannot be written.
    """
    recipe = recipe_of(source, repairs)
    head = {KEY: 1, "program": recipe.program, "input_sha256": recipe.input}
    edits = [{"do": "fill", **item.as_json()} for item in recipe.fills]
    edits += [{"do": "reopen", **item.as_json()} for item in recipe.reopened]
    data = encode_document(head, "edits", edits)
    write_bytes(path, data)
    progress(1.0)


def read_recipe(path: Path) -> Recipe:
    """Read a recipe.

    Raises
    ------
    MocapmendError
        If it is not one.
    """
    try:
        return _decode(read_whole(path, MOST_BYTES))
    except ValueError as error:
        raise _no_recipe(path, str(error)) from None


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
    """

    reopened: tuple[Gap, ...]
    jobs: tuple[FillJob, ...]


def plan(source: Source, recipe: Recipe) -> Plan:
    """Find the gaps of a recipe in a file.

    Raises
    ------
    MocapmendError
        If an edit does not fit the file, its method is not known, or its training set is not
        there.
    """
    gaps = _Fillable(source.measured)
    reopened = tuple(_gap_of(source, item, source.repaired) for item in recipe.reopened)
    filled = [_gap_of(source, item, gaps) for item in recipe.fills]
    if len({*reopened, *filled}) < len(reopened) + len(filled):
        raise _does_not_fit(source, "it has two edits of one gap")
    ways: dict[str, tuple[str, Any]] = {}
    jobs: dict[str, list[Gap]] = {}
    for item, gap in zip(recipe.fills, filled, strict=True):
        alike = json.dumps([item.method, item.parameters], sort_keys=True)
        if alike not in ways:
            ways[alike] = _method(source, item)
        jobs.setdefault(alike, []).append(gap)
    return Plan(reopened, tuple(FillJob(*ways[key], tuple(of)) for key, of in jobs.items()))


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
        share = number / len(jobs)
        result = fill_anyway(
            recording,
            job.gaps,
            job.method,
            job.params,
            lambda done, share=share: progress(share + done / len(jobs)),
        )
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
    runs = [SampleRun(gap.marker, gap.start, values[gap]) for gap in sorted(values)]
    return Changes(tuple(runs), tuple(kept[gap] for gap in sorted(kept)))


def _missing(gap: Gap) -> NDArray[np.float64]:
    return np.full((gap.length, 3), np.nan)


def _decode(raw: bytes) -> Recipe:
    data = decode_document(raw, KEY)
    edits = data.get("edits")
    if not isinstance(edits, list) or not all(isinstance(edit, dict) for edit in edits):
        raise ValueError("it has no list of edits")
    if not all(edit.get("do") in ("fill", "reopen") for edit in edits):
        raise ValueError("it asks for something else than filling and reopening gaps")
    (made_for,) = hashes([data.get("input_sha256")])

    def chosen(kind: str) -> tuple[RepairRecord, ...]:
        return records([edit for edit in edits if edit["do"] == kind])

    return Recipe(made_for, chosen("fill"), chosen("reopen"), program_name(data.get("program")))


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


def _gap_of(source: Source, item: RepairRecord, gaps: Container[Gap]) -> Gap:
    """Find the gap that an edit is about."""
    recording = source.recording
    marker = source.markers_by_point.get(item.point)
    if marker is None or recording.labels[marker] != item.marker:
        raise _does_not_fit(source, f"its point {item.point} is not the marker {item.marker}")
    gap = Gap(marker, *item.rows(recording.first_frame))
    if gap not in gaps:
        frames = f"frames {item.first_frame} to {item.last_frame}"
        raise _does_not_fit(source, f"{frames} of {item.marker} are not one of its gaps")
    return gap


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


def _no_recipe(path: Path, why: str) -> MocapmendError:
    return MocapmendError(
        f"This is not a recipe: {why}.", str(path), "Choose a file that was saved as a recipe."
    )
