"""What a repair record lists: the gaps that were filled, and those that are kept open."""

import json
import math
from collections.abc import Mapping
from dataclasses import asdict, dataclass, field
from typing import Any, Protocol, Self

from mocapmend.files.record_values import (
    Kinds,
    entries_of,
    is_plain,
    parameter,
    rounded,
    values_of,
)

NEVER_FILLED = "it is marked as never to be filled"
LEFT_OPEN = "left open by hand"
NO_REASON = frozenset({NEVER_FILLED, LEFT_OPEN})
"""What stands there where the user has given no reason."""

PLACE: Kinds = {"marker": (str,), "point": (int,), "first_frame": (int,), "last_frame": (int,)}
_REPAIR: Kinds = {
    **PLACE,
    "method": (str,),
    "parameters": (dict,),
    "donors": (list,),
    "expected_error_mm": (int, float, type(None)),
    "r90_mm": (int, float, type(None)),
}
_KEPT_OPEN: Kinds = {**PLACE, "never": (bool,), "reason": (str,)}


class Recorded(Protocol):
    """An entry of a record."""

    @property
    def place(self) -> tuple[int, int]:
        """What entries are ordered by."""
        ...

    def as_json(self) -> dict[str, Any]:
        """Return it for a JSON document."""
        ...


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
            "expected_error_mm": rounded(self.expected_error_mm),
            "r90_mm": rounded(self.r90_mm),
        }

    @classmethod
    def from_json(cls, data: object) -> Self:
        """Make a record of what a JSON document has of it; keys that are unknown are left out.

        Raises
        ------
        ValueError
            If it is none.
        """
        values = values_of(data, _REPAIR, "a repair")
        if not all(isinstance(donor, str) and is_plain(donor) for donor in values["donors"]):
            raise ValueError("a donor is not a label")
        values["parameters"] = {k: parameter(v) for k, v in values["parameters"].items()}
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
        return cls(**values_of(data, _KEPT_OPEN, "a gap kept open"))


def repair_records(data: object) -> tuple[RepairRecord, ...]:
    """Make records of a JSON list.

    Raises
    ------
    ValueError
        If it is none, or one of them is not a record.
    """
    return entries_of(data, RepairRecord.from_json, "it has no list of repairs")


def kept_gaps(data: object) -> tuple[KeptGap, ...]:
    """Make gaps that are kept open of a JSON list.

    Raises
    ------
    ValueError
        If it is none, or one of them is not such a gap.
    """
    return entries_of(data, KeptGap.from_json, "it has no list of gaps kept open")


def line(entry: Recorded) -> str:
    """Return an entry as one line of ASCII."""
    return json.dumps(entry.as_json(), separators=(",", ":"), allow_nan=False)
