"""What a repair record lists: the gaps that were filled, and those that are kept open."""

import json
import math
from collections.abc import Callable, Mapping
from dataclasses import asdict, dataclass, field
from typing import Any, Self, TypeVar

MOST_ENTRIES = 1_000_000
DIGITS = 4
"""Significant digits of an expected error: more would mean nothing."""
LARGEST_FRAME = 2**53
LONGEST_TEXT = 1000
NEVER_FILLED = "it is marked as never to be filled"
LEFT_OPEN = "left open by hand"
NO_REASON = frozenset({NEVER_FILLED, LEFT_OPEN})
"""What stands there where the user has given no reason."""

Kinds = Mapping[str, tuple[type, ...]]
Entry = TypeVar("Entry")

_PLACE: Kinds = {"marker": (str,), "point": (int,), "first_frame": (int,), "last_frame": (int,)}
_REPAIR: Kinds = {
    **_PLACE,
    "method": (str,),
    "parameters": (dict,),
    "donors": (list,),
    "expected_error_mm": (int, float, type(None)),
    "r90_mm": (int, float, type(None)),
}
_KEPT_OPEN: Kinds = {**_PLACE, "never": (bool,), "reason": (str,)}
SCALARS = (str, int, float, type(None))


@dataclass(frozen=True)
class RecordedRun:
    """A run of one marker.

    Attributes
    ----------
    marker : str
        Its label.
    point : int
        The stored point, counted from 1 as in POINT:LABELS.
    first_frame, last_frame : int
        As the file counts frames.
    """

    marker: str
    point: int
    first_frame: int
    last_frame: int

    @property
    def frames(self) -> int:
        """Number of frames."""
        return self.last_frame - self.first_frame + 1

    @property
    def place(self) -> tuple[int, int]:
        """Point and first frame: what entries are ordered by."""
        return self.point, self.first_frame

    def rows(self, first_frame: int) -> tuple[int, int]:
        """Return start and stop of its frames in a recording that begins with a frame."""
        return self.first_frame - first_frame, self.last_frame - first_frame + 1

    def as_json(self) -> dict[str, Any]:
        """Return it for a JSON document."""
        return asdict(self)


@dataclass(frozen=True)
class RepairRecord(RecordedRun):
    """A run of one marker that was missing and is filled.

    Attributes
    ----------
    method : str
        Method id.
    parameters : dict
        The method's parameters; lists of names are tuples.
    donors : tuple of str
        Labels of the markers that the repair was computed from.
    expected_error_mm, r90_mm : float
        Expected 3-D RMS error, and the median radius of the 90 % band; NaN where unknown.
    """

    method: str
    parameters: Mapping[str, Any] = field(default_factory=dict)
    donors: tuple[str, ...] = ()
    expected_error_mm: float = math.nan
    r90_mm: float = math.nan

    def as_json(self) -> dict[str, Any]:
        """Return it for a JSON document; None stands for what is not known."""
        return asdict(self) | {
            "donors": list(self.donors),
            "expected_error_mm": _rounded(self.expected_error_mm),
            "r90_mm": _rounded(self.r90_mm),
        }

    @classmethod
    def from_json(cls, data: object) -> Self:
        """Make a record of what a JSON document has of it; keys that are unknown are left out.

        Raises
        ------
        ValueError
            If it is none.
        """
        values = _values(data, _REPAIR, "a repair")
        if not all(isinstance(donor, str) and _is_plain(donor) for donor in values["donors"]):
            raise ValueError("a donor is not a label")
        values["parameters"] = {k: _parameter(v) for k, v in values["parameters"].items()}
        for key in ("expected_error_mm", "r90_mm"):
            values[key] = math.nan if values[key] is None else float(values[key])
        return cls(**values | {"donors": tuple(values["donors"])})


@dataclass(frozen=True)
class KeptGap(RecordedRun):
    """A gap that the user keeps open.

    Attributes
    ----------
    never : bool
        Whether no repair may fill it; else it was looked at and left.
    reason : str
        Why, for people.
    """

    never: bool
    reason: str

    @classmethod
    def from_json(cls, data: object) -> Self:
        """Make one of what a JSON document has of it; keys that are unknown are left out.

        Raises
        ------
        ValueError
            If it is none.
        """
        return cls(**_values(data, _KEPT_OPEN, "a gap kept open"))


def repair_records(data: object) -> tuple[RepairRecord, ...]:
    """Make records of a JSON list.

    Raises
    ------
    ValueError
        If it is none, or one of them is not a record.
    """
    return _entries(data, RepairRecord.from_json, "it has no list of repairs")


def kept_gaps(data: object) -> tuple[KeptGap, ...]:
    """Make gaps that are kept open of a JSON list.

    Raises
    ------
    ValueError
        If it is none, or one of them is not such a gap.
    """
    return _entries(data, KeptGap.from_json, "it has no list of gaps kept open")


def line(entry: RecordedRun) -> str:
    """Return an entry as one line of ASCII."""
    return json.dumps(entry.as_json(), separators=(",", ":"), allow_nan=False)


def _entries(data: object, read: Callable[[object], Entry], without: str) -> tuple[Entry, ...]:
    if not isinstance(data, list) or len(data) > MOST_ENTRIES:
        raise ValueError(without)
    return tuple(map(read, data))


def _values(data: object, kinds: Kinds, what: str) -> dict[str, Any]:
    """Return what a JSON object has under some keys; others are left out."""
    if not isinstance(data, dict):
        raise ValueError(f"{what} is not an object")
    wrong = _wrong_key(data, kinds)
    if wrong is not None:
        raise ValueError(f"{wrong!r} of {what} is missing or of another kind")
    values = {key: data[key] for key in kinds}
    if not all(map(_is_plain, values.values())):
        raise ValueError(f"a number or a text of {what} is too large")
    return values


def _wrong_key(data: Mapping[str, object], kinds: Kinds) -> str | None:
    """Return the first key that is missing or of another kind."""
    for key, allowed in kinds.items():
        value = data.get(key)
        a_bool = isinstance(value, bool) and bool not in allowed
        if key not in data or a_bool or not isinstance(value, allowed):
            return key
    return None


def _parameter(value: object) -> object:
    """Return a parameter as it was before it was written: JSON has no tuples."""
    parts = value if isinstance(value, list) else [value]
    kinds = str if isinstance(value, list) else SCALARS
    if not all(isinstance(part, kinds) and _is_plain(part) for part in parts):
        raise ValueError("a parameter is neither a number nor a text, nor a list of texts")
    return tuple(value) if isinstance(value, list) else value


def _is_plain(value: object) -> bool:
    """Say whether a value is none of those that a damaged file has and a program trips over."""
    if isinstance(value, (int, float)):
        return abs(value) <= LARGEST_FRAME
    return not isinstance(value, str) or len(value) <= LONGEST_TEXT


def _rounded(value: float) -> float | None:
    return float(f"{value:.{DIGITS}g}") if math.isfinite(value) else None
