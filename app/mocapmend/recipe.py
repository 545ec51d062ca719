"""A recipe: the edits of one file as a small text file, to be made again with the same result.

A fill is written down as its gap, its method and the parameters of that, without the values: they
are computed again, from the measured samples alone, so that the order does not matter.
"""

import json
from collections.abc import Container, Sequence
from dataclasses import dataclass
from pathlib import Path
from typing import Any, BinaryIO

import numpy as np
from numpy.typing import NDArray

from mocapmend.engine import Changes, record
from mocapmend.errors import MocapmendError
from mocapmend.files import RepairRecord, SampleRun, Source
from mocapmend.files.atomic import write_atomically
from mocapmend.files.opening import open_file
from mocapmend.files.provenance import (
    PROGRAM,
    decode_document,
    encode_document,
    line,
    records,
)
from mocapmend.files.sidecar import hash_file
from mocapmend_algorithms import Gap, Progress, find_gaps
from mocapmend_algorithms.fill import registry
from mocapmend_algorithms.fill.contract import Patch

KEY = "mocapmend_recipe"
MOST_BYTES = 200_000_000


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
    return Recipe(
        input=hash_file(source.path),
        fills=tuple(item for item in repairs if line(item) not in kept),
        reopened=tuple(
            item for item in source.repairs if (item.point, item.first_frame) not in wanted
        ),
    )


def write_recipe(source: Source, repairs: Sequence[RepairRecord], path: Path) -> None:
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
    write_atomically(path, lambda stream: _write(stream, data), lambda written: None)


def read_recipe(path: Path) -> Recipe:
    """Read a recipe.

    Raises
    ------
    MocapmendError
        If it is not one.
    """
    with open_file(path) as (stream, stamp):
        if stamp.size > MOST_BYTES:
            raise _no_recipe(path, "it is too large")
        raw = stream.read()
    try:
        return _decode(raw)
    except ValueError as error:
        raise _no_recipe(path, str(error)) from None


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
    recording = source.measured
    gaps = set(find_gaps(recording.present))
    kept = dict(zip(source.repaired, source.repairs, strict=True))
    values: dict[Gap, Patch | None] = {}
    for item in recipe.reopened:
        gap = _gap_of(source, item, kept)
        del kept[gap]
        values[gap] = None
    jobs: dict[str, list[tuple[Gap, RepairRecord]]] = {}
    for item in recipe.fills:
        jobs.setdefault(_job(item), []).append((_gap_of(source, item, gaps), item))
    for number, job in enumerate(jobs.values()):
        share = number / len(jobs)
        method, params = _method(source, job[0][1])
        result = method.function(
            recording,
            [gap for gap, _ in job],
            params,
            lambda done, share=share: progress(share + done / len(jobs)),
        )
        if result.unfilled:
            raise MocapmendError(
                f"A gap of {recording.labels[result.unfilled[0].gap.marker]} cannot be filled: "
                f"{result.unfilled[0].reason}.",
                str(source.path),
                "The recipe was made for another recording, or by another version.",
            )
        for patch in result.patches:
            values[patch.gap] = patch
            kept[patch.gap] = record(source, patch, method.id, params)
    runs = [
        SampleRun(gap.marker, gap.start, _missing(gap) if patch is None else patch.values)
        for gap, patch in sorted(values.items(), key=lambda pair: pair[0])
    ]
    return Changes(tuple(runs), tuple(kept[gap] for gap in sorted(kept)))


def _missing(gap: Gap) -> NDArray[np.float64]:
    return np.full((gap.length, 3), np.nan)


def _decode(raw: bytes) -> Recipe:
    data = decode_document(raw, KEY)
    edits = data.get("edits")
    if not isinstance(edits, list) or not all(isinstance(edit, dict) for edit in edits):
        raise ValueError("it has no list of edits")
    kinds = {edit.get("do") for edit in edits}
    if strange := kinds - {"fill", "reopen"}:
        raise ValueError(f"it asks for something unknown: {min(map(str, strange))}")
    if not isinstance(data.get("input_sha256"), str):
        raise ValueError("it does not say which file it was made for")

    def chosen(kind: str) -> tuple[RepairRecord, ...]:
        return records([edit for edit in edits if edit["do"] == kind])

    return Recipe(data["input_sha256"], chosen("fill"), chosen("reopen"), str(data.get("program")))


def _gap_of(source: Source, item: RepairRecord, gaps: Container[Gap]) -> Gap:
    """Find the gap that an edit is about."""
    recording = source.recording
    start, stop = (frame - recording.first_frame for frame in (item.first_frame, item.last_frame))
    points = {point + 1: marker for marker, point in enumerate(source.stored_points)}
    marker = points.get(item.point)
    if marker is None or recording.labels[marker] != item.marker:
        raise _does_not_fit(source, f"its point {item.point} is not the marker {item.marker}")
    gap = Gap(marker, start, stop + 1)
    if gap not in gaps:
        frames = f"frames {item.first_frame} to {item.last_frame}"
        raise _does_not_fit(source, f"{frames} of {item.marker} are not one of its gaps")
    return gap


def _method(source: Source, item: RepairRecord) -> tuple[registry.Method, Any]:
    try:
        method = registry.method(item.method)
        return method, registry.restore_params(method, item.parameters)
    except (KeyError, ValueError) as error:
        raise MocapmendError(
            f"The recipe cannot be replayed: {error.args[0]}.",
            str(source.path),
            "Use the version of the program that the recipe names.",
        ) from None


def _job(item: RepairRecord) -> str:
    """Return what fills must have in common to be computed together."""
    return json.dumps([item.method, item.parameters], sort_keys=True)


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


def _write(stream: BinaryIO, data: bytes) -> None:
    stream.write(data)
