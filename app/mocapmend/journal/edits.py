"""Undo commands as JSON: the samples of all their runs one after another, without loss."""

import base64
import binascii
import dataclasses
from collections.abc import Sequence
from typing import Any

import numpy as np
from numpy.typing import NDArray

from mocapmend.document import Edit, Repair
from mocapmend.journal.file import Event
from mocapmend.state import SampleState
from mocapmend_algorithms import Gap, Recording
from mocapmend_algorithms.fill.contract import Patch
from mocapmend_algorithms.fill.registry import method, restore_params

NO_FILL = -1


def encode(text: str, edits: Sequence[Edit]) -> Event:
    """Return an undo command as JSON has it.

    Parameters
    ----------
    text : str
        What the user reads in the menu.
    edits : sequence of Edit
        What the runs shall hold. The patch of a repair is what its edit writes.
    """
    ways: dict[tuple[str, Any], int] = {}
    fills = [
        NO_FILL
        if edit.repair is None
        else ways.setdefault((edit.repair.method, edit.repair.params), len(ways))
        for edit in edits
    ]
    patches = [edit.repair.patch for edit in edits if edit.repair is not None]
    gaps = [(edit.gap.marker, edit.gap.start, edit.gap.stop) for edit in edits]
    return {
        "step": text,
        "gaps": _pack([np.array(gaps)], "<i8"),
        "values": _pack([edit.values for edit in edits], "<f8"),
        "states": _pack([edit.states for edit in edits], "u1"),
        "ways": [[name, dataclasses.asdict(params)] for name, params in ways],
        "fills": _pack([np.array(fills)], "<i4"),
        "sigma": _pack([patch.sigma for patch in patches], "<f8"),
        "r90": _pack([patch.r90 for patch in patches], "<f8"),
    }


def decode(event: Event, recording: Recording) -> tuple[str, list[Edit]]:
    """Return the text and the edits of an undo command.

    Parameters
    ----------
    event : dict
        What `encode` made.
    recording : Recording
        That the edits shall fit.

    Raises
    ------
    KeyError, TypeError or ValueError
        If they do not fit it, or are none.
    """
    text = event["step"]
    gaps = _unpack(event["gaps"], "<i8").reshape(-1, 3)
    values = _unpack(event["values"], "<f8").reshape(-1, 3)
    states = _unpack(event["states"], "u1")
    fills = _unpack(event["fills"], "<i4")
    sigma, r90 = _unpack(event["sigma"], "<f8"), _unpack(event["r90"], "<f8")
    ways = [(name, restore_params(method(name), params)) for name, params in event["ways"]]
    _require(isinstance(text, str) and len(fills) == len(gaps) > 0)
    marker, start, stop = gaps.T
    _require(bool(((marker >= 0) & (marker < recording.markers)).all()))
    _require(bool(((start >= 0) & (start < stop) & (stop <= recording.frames)).all()))
    lengths = stop - start
    filled = fills != NO_FILL
    _require(bool(((fills >= NO_FILL) & (fills < len(ways))).all()))
    _require(len(values) == len(states) == lengths.sum())
    _require(len(sigma) == len(r90) == lengths[filled].sum())
    _require(bool(np.isin(states, list(SampleState)).all()))
    missing = states == SampleState.MISSING
    _require(bool(np.isfinite(values[~missing]).all() and np.isnan(values[missing]).all()))
    edits = []
    ends, band_ends = np.cumsum(lengths), np.cumsum(lengths * filled)
    for row, fill, end, band_end in zip(gaps.tolist(), fills, ends, band_ends, strict=True):
        gap = Gap(*row)
        own, band = slice(end - gap.length, end), slice(band_end - gap.length, band_end)
        repair = None
        if fill != NO_FILL:
            name, params = ways[fill]
            repair = Repair(name, params, Patch(gap, values[own], sigma[band], r90[band]))
        edits.append(Edit(gap, values[own], states[own], repair))
    return text, edits


def _pack(parts: Sequence[NDArray[Any]], dtype: str) -> str:
    joined = b"".join(np.ascontiguousarray(part, dtype).tobytes() for part in parts)
    return base64.b64encode(joined).decode("ascii")


def _unpack(text: str, dtype: str) -> NDArray[Any]:
    try:
        raw = base64.b64decode(text, validate=True)
    except binascii.Error as error:
        raise ValueError("not base64") from error
    stored = np.frombuffer(raw, dtype)
    return stored.astype(stored.dtype.newbyteorder("="))


def _require(condition: bool) -> None:  # noqa: FBT001 - what it is called for
    if not condition:
        raise ValueError("edits that do not fit the recording")
