"""What a repair record lists besides gaps: wrong samples that were put right."""

import math
from base64 import b64decode, b64encode
from collections.abc import Callable, Iterable, Iterator, Mapping
from dataclasses import asdict, dataclass, field
from typing import Any, Self

import numpy as np
from numpy.typing import NDArray

from mocapmend.files.record_values import Entry, Kinds, entries_of, parameter, rounded, values_of
from mocapmend.files.records import PLACE, Recorded, RecordedRun

_SET_ASIDE: Kinds = {**PLACE, "problem": (str,), "reason": (str,), "original": (str,)}
_MOVED: Kinds = {**PLACE, "from_marker": (str,), "from_point": (int,)}
_SMOOTHED: Kinds = {
    **PLACE,
    "method": (str,),
    "parameters": (dict,),
    "chosen": (dict,),
    "rms_change_mm": (int, float, type(None)),
}
_PER_AXIS = frozenset({"cutoff_hz", "window_frames"})
"""What a method chooses for each axis."""
_RENAMED: Kinds = {"point": (int,), "former": (str,), "marker": (str,)}


@dataclass(frozen=True)
class SetAside(RecordedRun):
    """Measured samples that nobody shall believe: missing since, or replaced by a repair.

    Attributes
    ----------
    problem : str
        What was wrong with them: the id of the detector, or what the user said.
    reason : str
        Why, for people.
    original : str
        What was measured, so that it can be put back: four little-endian float32 per frame (x, y,
        z in the file's unit, and the fourth word), in base64.
    """

    problem: str
    reason: str
    original: str

    @property
    def samples(self) -> NDArray[np.float32]:
        """What was measured, shape (frames, 4): x, y, z, fourth word."""
        raw = np.frombuffer(b64decode(self.original, validate=True), "<f4")
        return raw.reshape(self.frames, 4).astype(np.float32)

    @staticmethod
    def encoded(samples: NDArray[np.float32]) -> str:
        """Return samples, shape (frames, 4), as `original` has them."""
        return b64encode(samples.astype("<f4").tobytes()).decode("ascii")

    @classmethod
    def from_json(cls, data: object) -> Self:
        """Make one of what a JSON document has of it; keys that are unknown are left out.

        Raises
        ------
        ValueError
            If it is none.
        """
        made = cls(**values_of(data, _SET_ASIDE, "a run set aside", long={"original"}))
        if made.frames < 1 or not np.isfinite(made.samples[:, :3]).all():
            raise ValueError("the samples of a run set aside are damaged")
        return made


@dataclass(frozen=True)
class MovedRun(RecordedRun):
    """A run that holds what was stored as another point: markers that were exchanged.

    Attributes
    ----------
    from_marker : str
        The label of the other point.
    from_point : int
        The other point, counted from 1.
    """

    from_marker: str
    from_point: int

    @classmethod
    def from_json(cls, data: object) -> Self:
        """Make one of what a JSON document has of it; keys that are unknown are left out.

        Raises
        ------
        ValueError
            If it is none.
        """
        return cls(**values_of(data, _MOVED, "a run that was moved"))


@dataclass(frozen=True)
class SmoothedRun(RecordedRun):
    """A run whose samples were smoothed; what was measured is in the original file alone.

    Attributes
    ----------
    method : str
        Method id.
    parameters : dict
        Its parameters.
    chosen : dict
        What it chose by itself, as cut-off frequencies.
    rms_change_mm : float
        How far samples were moved; NaN where unknown.
    """

    method: str
    parameters: Mapping[str, Any] = field(default_factory=dict)
    chosen: Mapping[str, Any] = field(default_factory=dict)
    rms_change_mm: float = math.nan

    def as_json(self) -> dict[str, Any]:
        """Return it for a JSON document; None stands for what is not known."""
        return asdict(self) | {"rms_change_mm": rounded(self.rms_change_mm)}

    @classmethod
    def from_json(cls, data: object) -> Self:
        """Make one of what a JSON document has of it; keys that are unknown are left out.

        Raises
        ------
        ValueError
            If it is none.
        """
        values = values_of(data, _SMOOTHED, "a run that was smoothed")
        for key in ("parameters", "chosen"):
            values[key] = {k: parameter(v, (str, int, float)) for k, v in values[key].items()}
        for key in _PER_AXIS.intersection(values["chosen"]):
            if not _are_numbers(values["chosen"][key]):
                raise ValueError(f"the {key!r} of a run that was smoothed are no numbers")
        change = values["rms_change_mm"]
        return cls(**values | {"rms_change_mm": math.nan if change is None else float(change)})


def _are_numbers(value: object) -> bool:
    return (
        isinstance(value, tuple)
        and bool(value)
        and not any(isinstance(one, (bool, str)) for one in value)
    )


@dataclass(frozen=True)
class Renamed:
    """A point that got another label.

    Attributes
    ----------
    point : int
        Counted from 1.
    former, marker : str
        Its label before, and since.
    """

    point: int
    former: str
    marker: str

    @property
    def place(self) -> tuple[int, int]:
        """What entries are ordered by."""
        return self.point, 0

    def as_json(self) -> dict[str, Any]:
        """Return it for a JSON document."""
        return asdict(self)

    @classmethod
    def from_json(cls, data: object) -> Self:
        """Make one of what a JSON document has of it; keys that are unknown are left out.

        Raises
        ------
        ValueError
            If it is none.
        """
        return cls(**values_of(data, _RENAMED, "a marker that was renamed"))


KINDS = ("set_aside", "moved", "smoothed", "renamed")
"""The kinds of corrections, by their names in a record."""


def changed_labels(earlier: Iterable[Renamed], now: Iterable[Renamed]) -> dict[int, str]:
    """Return the labels that a copy of a file has in place of the file's own.

    Parameters
    ----------
    earlier, now : iterable of Renamed
        What the repair record of the file, and that of the copy, say.

    Returns
    -------
    dict of int to str
        By stored point, from 0.
    """
    before, after = ({entry.point: entry for entry in entries} for entries in (earlier, now))
    labels = {}
    for point in sorted({*before, *after}):
        old = before[point].marker if point in before else after[point].former
        new = after[point].marker if point in after else before[point].former
        if new != old:
            labels[point - 1] = new
    return labels


@dataclass(frozen=True)
class Corrections:
    """What was put right besides filling gaps, each kind ordered by point and frame.

    Attributes
    ----------
    set_aside : tuple of SetAside
        Measured samples that count as missing.
    moved : tuple of MovedRun
        Samples that were exchanged between markers.
    smoothed : tuple of SmoothedRun
        Samples that were smoothed.
    renamed : tuple of Renamed
        Points with other labels.
    """

    set_aside: tuple[SetAside, ...] = ()
    moved: tuple[MovedRun, ...] = ()
    smoothed: tuple[SmoothedRun, ...] = ()
    renamed: tuple[Renamed, ...] = ()

    def __bool__(self) -> bool:
        return bool(self.set_aside or self.moved or self.smoothed or self.renamed)

    def lists(self) -> Iterator[tuple[str, tuple[Recorded, ...]]]:
        """Yield the kinds that there are some of, with their entries."""
        for kind in KINDS:
            if entries := getattr(self, kind):
                yield kind, entries

    @classmethod
    def from_lists(cls, lists: Mapping[str, object]) -> Self:
        """Make them of what a JSON document has of each kind; those that it lacks are empty.

        Raises
        ------
        ValueError
            If one of them is no list of such entries.
        """

        def read(kind: str, entry: Callable[[object], Entry]) -> tuple[Entry, ...]:
            return entries_of(lists.get(kind, []), entry, f"it has no list of {kind}")

        return cls(
            read("set_aside", SetAside.from_json),
            read("moved", MovedRun.from_json),
            read("smoothed", SmoothedRun.from_json),
            read("renamed", Renamed.from_json),
        )


NO_CORRECTIONS = Corrections()
