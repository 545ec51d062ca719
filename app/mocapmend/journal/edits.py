"""Undo commands as records of a journal: the samples of all runs one after another, to the bit."""

import dataclasses
from collections.abc import Iterable, Mapping, Sequence
from typing import Any

import numpy as np
from numpy.typing import ArrayLike, NDArray

from mocapmend.believed import Correction
from mocapmend.doubts import Change, Doubt, Doubts
from mocapmend.edits import Edit, Repair, Smoothed
from mocapmend.journal.file import Event, Record
from mocapmend.state import ABSENT, SampleState
from mocapmend_algorithms import Gap, Recording
from mocapmend_algorithms.corrections import Exchange
from mocapmend_algorithms.fill.contract import Patch
from mocapmend_algorithms.fill.registry import method, restore_params
from mocapmend_algorithms.smooth.registry import restore_params as restore_smoothing
from mocapmend_algorithms.smooth.registry import smoother

NO_FILL = -1

Way = tuple[str, Any, tuple[str, ...], int]
"""How a gap was filled: method, parameters, donors, and from which state of the samples."""


def encode(
    text: str,
    edits: Sequence[Edit],
    correction: Correction | None = None,
    labels: Mapping[int, str] | None = None,
) -> Record:
    """Return an undo command as a record.

    Parameters
    ----------
    text : str
        What the user reads in the menu.
    edits : sequence of Edit
        What the runs shall hold. The patch of a repair is what its edit writes.
    correction : Correction, optional
        What is exchanged or set aside after that.
    labels : mapping of int to str, optional
        What markers are called from now on.
    """
    ways: dict[Way, int] = {}
    fills = [
        NO_FILL if edit.repair is None else ways.setdefault(_way(edit.repair), len(ways))
        for edit in edits
    ]
    patches = [edit.repair.patch for edit in edits if edit.repair is not None]
    event = {
        "step": text,
        "ways": [
            [name, dataclasses.asdict(params), list(donors), *([base] if base else [])]
            for name, params, donors, base in ways
        ],
        "gaps": len(edits),
        "samples": sum(edit.gap.length for edit in edits),
        "filled": sum(patch.gap.length for patch in patches),
    }
    # Journals of before have none, and what reads those passes it by.
    if reasons := {str(k): e.reason for k, e in enumerate(edits) if e.reason is not None}:
        event["reasons"] = reasons
    smoothed = {k: edit.smoothed for k, edit in enumerate(edits) if edit.smoothed is not None}
    if smoothed:
        event["smoothed"] = {
            str(k): [made.method, dict(made.params), dict(made.chosen), made.rms]
            for k, made in smoothed.items()
        }
    if labels:
        event["labels"] = {str(marker): label for marker, label in labels.items()}
    if correction is not None:
        event["correction"] = {
            "exchanges": [list(each) for each in correction.exchanges],
            "gone": _listed(correction.doubts.gone),
            "come": _listed(correction.doubts.come),
            "found_as": list(correction.found_as),
        }
    data = (
        *_bytes("<i8", [[(edit.gap.marker, edit.gap.start, edit.gap.stop) for edit in edits]]),
        *_bytes("<i4", [fills]),
        *_bytes("u1", (edit.states for edit in edits)),
        *_bytes("<f8", (edit.values for edit in edits)),
        *_bytes("<f8", (patch.sigma for patch in patches)),
        *_bytes("<f8", (patch.r90 for patch in patches)),
    )
    return event, b"".join(data)


def decode(event: Event, data: bytes, recording: Recording) -> tuple[str, list[Edit]]:
    """Return the text and the edits of an undo command.

    Parameters
    ----------
    event, data : dict, bytes
        What `encode` made.
    recording : Recording
        That the edits shall fit.

    Raises
    ------
    AttributeError, KeyError, TypeError or ValueError
        If they do not fit it, or are none.
    """
    text, count, samples, filled_samples = (
        event[name] for name in ("step", "gaps", "samples", "filled")
    )
    ways = [
        (name, restore_params(method(name), params), tuple(donors), *map(int, base))
        for name, params, donors, *base in event["ways"]
    ]
    _require(all(isinstance(donor, str) for _, _, donors, *_ in ways for donor in donors))
    _require(isinstance(text, str) and type(count) is type(samples) is type(filled_samples) is int)
    _require(
        (count > 0 or "correction" in event or "labels" in event)
        and count >= 0
        and samples >= 0
        and filled_samples >= 0
    )
    layout = (
        ("<i8", 3 * count),
        ("<i4", count),
        ("u1", samples),
        ("<f8", 3 * samples),
        ("<f8", filled_samples),
        ("<f8", filled_samples),
    )
    corners, fills, states, values, sigma, r90 = _split(data, layout)
    gaps, values = corners.reshape(-1, 3), values.reshape(-1, 3)
    marker, start, stop = gaps.T
    _require(bool(((marker >= 0) & (marker < recording.markers)).all()))
    _require(bool(((start >= 0) & (start < stop) & (stop <= recording.frames)).all()))
    lengths = stop - start
    filled = fills != NO_FILL
    _require(bool(((fills >= NO_FILL) & (fills < len(ways))).all()))
    _require(len(values) == len(states) == lengths.sum())
    _require(len(sigma) == len(r90) == lengths[filled].sum())
    _require(bool(np.isin(states, list(SampleState)).all()))
    missing = np.isin(states, ABSENT)
    _require(bool(np.isfinite(values[~missing]).all() and np.isnan(values[missing]).all()))
    reasons = {int(place): reason for place, reason in event.get("reasons", {}).items()}
    _require(all(isinstance(reason, str) for reason in reasons.values()))
    _require(all(0 <= place < count for place in reasons))
    smoothed = {int(place): _smoothed(*made) for place, made in event.get("smoothed", {}).items()}
    _require(all(0 <= place < count for place in smoothed))
    edits = []
    ends, band_ends = np.cumsum(lengths), np.cumsum(lengths * filled)
    rows = zip(gaps.tolist(), fills, ends, band_ends, strict=True)
    for place, (row, fill, end, band_end) in enumerate(rows):
        gap = Gap(*row)
        own, band = slice(end - gap.length, end), slice(band_end - gap.length, band_end)
        repair = None
        if fill != NO_FILL:
            name, params, donors, *base = ways[fill]
            patch = Patch(gap, values[own], sigma[band], r90[band])
            repair = Repair(name, params, patch, donors, *base)
        reason = reasons.get(place)
        _require(reason is None or bool(missing[own].all()))
        edits.append(Edit(gap, values[own], states[own], repair, reason, smoothed.get(place)))
    return text, edits


def decode_correction(event: Event, recording: Recording) -> Correction | None:
    """Return what an undo command exchanges and sets aside; None for nothing.

    Parameters
    ----------
    event : dict
        What `encode` made.
    recording : Recording
        That it shall fit.

    Raises
    ------
    AttributeError, KeyError, TypeError or ValueError
        If it does not fit it, or is none.
    """
    stated = event.get("correction")
    if stated is None:
        return None
    exchanges = tuple(Exchange(*map(int, each)) for each in stated["exchanges"])
    gone, come = (_doubts(stated[name]) for name in ("gone", "come"))
    for first, second, start, stop in exchanges:
        _require(first != second)
        for run in (Gap(first, start, stop), Gap(second, start, stop)):
            _require_inside(run, recording)
    for run in (*gone, *come):
        _require_inside(run, recording)
    # Journals of before have none.
    found_as = tuple(stated.get("found_as", ()))
    _require(all(isinstance(kind, str) for kind in found_as))
    return Correction(exchanges, Change(gone, come), found_as)


def decode_labels(event: Event, recording: Recording) -> dict[int, str]:
    """Return what an undo command calls markers.

    Raises
    ------
    AttributeError, TypeError or ValueError
        If it does not fit the recording, or is none.
    """
    labels = {int(marker): label for marker, label in event.get("labels", {}).items()}
    _require(all(0 <= marker < recording.markers for marker in labels))
    _require(all(isinstance(label, str) for label in labels.values()))
    return labels


def _smoothed(name: str, params: dict[str, Any], chosen: dict[str, Any], rms: float) -> Smoothed:
    restore_smoothing(smoother(name), params)
    _require(isinstance(chosen, dict))
    return Smoothed(name, params, chosen, float(rms))


def _listed(doubts: Doubts) -> list[list[int | str]]:
    return [[*run, *doubt] for run, doubt in doubts.items()]


def _doubts(rows: list[list[Any]]) -> dict[Gap, Doubt]:
    found = {}
    for marker, start, stop, problem, reason in rows:
        _require(isinstance(problem, str) and isinstance(reason, str))
        found[Gap(int(marker), int(start), int(stop))] = Doubt(problem, reason)
    return found


def _require_inside(run: Gap, recording: Recording) -> None:
    _require(0 <= run.marker < recording.markers and 0 <= run.start < run.stop <= recording.frames)


def _way(repair: Repair) -> Way:
    return repair.method, repair.params, repair.donors, repair.base


def _bytes(dtype: str, parts: Iterable[ArrayLike]) -> Iterable[bytes]:
    return (np.asarray(part, dtype).tobytes() for part in parts)


def _split(data: bytes, layout: Sequence[tuple[str, int]]) -> list[NDArray[Any]]:
    """Return arrays of the dtypes and lengths that lie in the bytes one after another."""
    sizes = [np.dtype(dtype).itemsize * length for dtype, length in layout]
    _require(sum(sizes) == len(data))
    raw = np.frombuffer(data, np.uint8)
    ends = np.cumsum(sizes).tolist()
    # A copy in the order of this machine: the arrays lie where they came to lie.
    return [
        raw[end - size : end].view(dtype).astype(np.dtype(dtype).newbyteorder("="))
        for (dtype, _), size, end in zip(layout, sizes, ends, strict=True)
    ]


def _require(condition: bool) -> None:  # noqa: FBT001 - what it is called for
    if not condition:
        raise ValueError("edits that do not fit the recording")
