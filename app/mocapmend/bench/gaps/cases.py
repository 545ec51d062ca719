"""Case files: which gaps to punch into which recording, and the errors of other methods there."""

import json
import math
from collections.abc import Mapping, Sequence
from dataclasses import dataclass
from functools import cached_property
from pathlib import Path
from typing import Any, TypeGuard

from mocapmend.bench.gaps.protocols import Protocol, best, best_published, protocol_of, reference
from mocapmend.errors import MocapmendError
from mocapmend.files.opening import cannot_read, open_file
from mocapmend_algorithms import Gap

MOST_BYTES = 100_000_000
TODO = "Use a file of the form of peers/cases.json."
HALVES = ("A", "B")


@dataclass(frozen=True, eq=False)
class Case:
    """Gaps to punch into a recording.

    Attributes
    ----------
    name : str
        Unique.
    family : str
        Of the protocol, such as "P2".
    recording : str
        Its name; halves are split by it.
    file : str
        Under the data folder.
    rate : float
        In Hz.
    frames, markers : int
        Size of the recording.
    gaps : tuple of Gap
        What to punch; markers count without those that are not labelled.
    peers : mapping of str to float
        RMSE of other methods in mm.
    """

    name: str
    family: str
    recording: str
    file: str
    rate: float
    frames: int
    markers: int
    gaps: tuple[Gap, ...]
    peers: Mapping[str, float]

    @cached_property
    def protocol(self) -> Protocol:
        """The protocol."""
        return protocol_of(self.family, self.gaps, self.rate)

    @property
    def reference_mm(self) -> float | None:
        """RMSE of the protocol's reference in mm; None where it has none."""
        return best(self.peers, reference(self.protocol))

    @property
    def best_published_mm(self) -> float | None:
        """RMSE of the best published method in mm; None where there is none."""
        return best_published(self.peers)


def read_cases(paths: Sequence[Path]) -> list[Case]:
    """Read case files.

    Raises
    ------
    MocapmendError
        If one cannot be read, is none, or names a case again.
    """
    cases: dict[str, Case] = {}
    for path in paths:
        for number, entry in enumerate(_entries(path), 1):
            case = _case(entry, f"{path}, case {number}")
            if case.name in cases:
                raise MocapmendError(f"There are two cases {case.name!r}.", str(path), TODO)
            cases[case.name] = case
    return list(cases.values())


def halves(cases: Sequence[Case]) -> dict[str, str]:
    """Split the recordings: of each family's, in the order of their names, every other one.

    A recording of several families is in the same half in all of them.

    Returns
    -------
    dict of str to str
        "A" or "B", by recording.
    """
    found: dict[str, str] = {}
    for family in sorted({case.family for case in cases}):
        own = sorted({case.recording for case in cases if case.family == family} - found.keys())
        found |= {name: HALVES[order % 2] for order, name in enumerate(own)}
    return found


def _entries(path: Path) -> list[Any]:
    with open_file(path) as (stream, stamp):
        if stamp.size > MOST_BYTES:
            raise MocapmendError("This is too large for a case file.", str(path), TODO)
        try:
            content = json.loads(stream.read())
        except OSError as error:
            raise cannot_read(str(path), error) from error
        except (ValueError, RecursionError):
            raise MocapmendError("This is no JSON file.", str(path), TODO) from None
    if not isinstance(content, list) or not content:
        raise MocapmendError("This is no list of cases.", str(path), TODO)
    return content


def _case(entry: Any, where: str) -> Case:
    if not isinstance(entry, dict):
        raise MocapmendError("This is no case.", where, TODO)
    return Case(
        name=_text(entry, "case", where),
        family=_text(entry, "protocol", where),
        recording=_text(entry, "recording", where),
        file=_text(entry, "file", where),
        rate=_rate(entry, where),
        frames=_count(entry, "frames", where),
        markers=_count(entry, "markers", where),
        gaps=_gaps(entry, where),
        peers=_peers(entry, where),
    )


def _text(entry: Mapping[str, Any], key: str, where: str) -> str:
    value = entry.get(key)
    if not isinstance(value, str) or not value.isprintable() or not value:
        raise MocapmendError(f"{key!r} is no text.", where, TODO)
    return value


def _rate(entry: Mapping[str, Any], where: str) -> float:
    value = entry.get("rate")
    if not _is_number(value) or not value > 0:
        raise MocapmendError("'rate' is no frame rate.", where, TODO)
    return float(value)


def _count(entry: Mapping[str, Any], key: str, where: str) -> int:
    value = entry.get(key)
    if not _is_index(value) or value == 0:
        raise MocapmendError(f"{key!r} is no number of {key}.", where, TODO)
    return value


def _gaps(entry: Mapping[str, Any], where: str) -> tuple[Gap, ...]:
    rows = entry.get("gaps")
    frames, markers = _count(entry, "frames", where), _count(entry, "markers", where)
    if not isinstance(rows, list) or not rows:
        raise MocapmendError("'gaps' is no list of gaps.", where, TODO)
    for row in rows:
        if not (isinstance(row, list) and len(row) == 3 and all(map(_is_index, row))):
            raise MocapmendError("A gap is not [marker, first, stop].", where, TODO)
        marker, start, stop = row
        if not (marker < markers and start < stop <= frames):
            raise MocapmendError(f"The gap {row} is not inside the recording.", where, TODO)
    return tuple(Gap(*row) for row in rows)


def _peers(entry: Mapping[str, Any], where: str) -> dict[str, float]:
    peers = entry.get("peers")
    if not isinstance(peers, dict):
        raise MocapmendError("'peers' is no table of methods.", where, TODO)
    found: dict[str, float] = {}
    for name, figures in peers.items():
        if not name.isprintable():
            raise MocapmendError("The name of a peer is no text.", where, TODO)
        error = figures.get("rmse_mm", math.nan) if isinstance(figures, dict) else math.nan
        if error is None:
            continue
        if not _is_number(error) or error < 0:
            raise MocapmendError(f"The peer {name!r} has no 'rmse_mm'.", where, TODO)
        found[name] = float(error)
    return found


def _is_number(value: Any) -> TypeGuard[int | float]:
    # The bounds keep what follows from overflowing.
    return isinstance(value, int | float) and not isinstance(value, bool) and abs(value) < 1e9


def _is_index(value: Any) -> TypeGuard[int]:
    return isinstance(value, int) and _is_number(value) and value >= 0
