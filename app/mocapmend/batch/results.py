"""What a batch says about each of its files: plain data that travels between processes."""

import re
from collections.abc import Mapping
from dataclasses import asdict, dataclass, field, fields
from typing import Any, Literal, TypeVar, get_args, get_origin

from mocapmend.errors import MocapmendError

NUMBER = re.compile(r"\d+(\.\d+)?")
Plain = TypeVar("Plain", "Reason", "Fixed", "Smoothed", "Figures", "Row", "Seen")
State = Literal["repaired", "unchanged", "nothing", "failed", "waiting"]


@dataclass(frozen=True)
class Reason:
    """Why gaps of a file stayed open: those whose reasons differ in their numbers alone.

    Attributes
    ----------
    gaps, samples : int
        How many gaps, and how many samples are missing in them.
    example : str
        The reason of the longest of them.
    """

    gaps: int
    samples: int
    example: str

    @property
    def kind(self) -> str:
        """The reason without its numbers."""
        return NUMBER.sub("#", self.example)


@dataclass(frozen=True)
class Fixed:
    """Bad samples of a file that were put right.

    Attributes
    ----------
    kind : str
        Id of the detector that has found them.
    runs, samples : int
        How many runs, and how many samples are in them.
    """

    kind: str
    runs: int
    samples: int


@dataclass(frozen=True)
class Smoothed:
    """What smoothing has done to a file.

    Attributes
    ----------
    markers : int
        How many were smoothed.
    rms_mm, largest_mm : float or None
        Root mean square of the shifts, median over the markers, and the largest shift; None where
        nothing was smoothed.
    """

    markers: int
    rms_mm: float | None
    largest_mm: float | None


@dataclass(frozen=True, kw_only=True)
class Figures:
    """What was found in a file and what was done to it.

    Attributes
    ----------
    frames, markers : int
        Size of the recording.
    rate_hz : float
        Frames per second.
    gaps, filled, left_open : int
        Gaps that were open, those of them that were filled, and the others.
    samples_missing, samples_filled : int
        Samples that were missing, and those of them that were filled.
    reasons : tuple of Reason
        Why gaps stayed open, the most frequent reason first.
    expected_median_mm, expected_worst_mm : float or None
        Of the expected errors of the filled gaps; None where none is known.
    worst_place : str
        Marker and frames of the worst one.
    no_estimate : int
        Filled gaps whose error could not be estimated.
    tracked_before, tracked_after : float or None
        Tracking success in %: the share of the markers that are there and not known to be wrong,
        mean over the frames; None where no marker is ever seen.
    wrong_before : float or None
        Likewise the share of those that were there but wrong: set aside or exchanged since.
    fixed : tuple of Fixed
        Bad samples that were put right, by kind.
    smoothed : Smoothed or None
        None without smoothing.
    warnings : tuple of str
        What was odd about the file.
    """

    frames: int
    markers: int
    rate_hz: float
    gaps: int
    filled: int
    left_open: int
    samples_missing: int
    samples_filled: int
    reasons: tuple[Reason, ...] = ()
    expected_median_mm: float | None = None
    expected_worst_mm: float | None = None
    worst_place: str = ""
    no_estimate: int = 0
    tracked_before: float | None = None
    wrong_before: float | None = None
    tracked_after: float | None = None
    fixed: tuple[Fixed, ...] = ()
    smoothed: Smoothed | None = None
    warnings: tuple[str, ...] = ()

    @property
    def samples_fixed(self) -> int:
        """Bad samples that were put right."""
        return sum(each.samples for each in self.fixed)

    @property
    def samples_left(self) -> int:
        """Samples that are missing still."""
        return self.samples_missing - self.samples_filled


@dataclass(frozen=True)
class Problem:
    """Why a file could not be repaired, as `MocapmendError` has it."""

    what: str
    where: str = ""
    todo: str = ""

    @classmethod
    def of(cls, error: MocapmendError) -> "Problem":
        """Keep what an error says."""
        return cls(error.what, error.where, error.todo)


@dataclass(frozen=True, kw_only=True)
class Row:
    """One file of a batch.

    Attributes
    ----------
    file : str
        Its path within the folder, with "/" between folders.
    state : str
        "repaired" now, "unchanged" since an earlier run that has repaired it, "nothing" to repair
        in it, "failed", or "waiting" where the batch was stopped before.
    figures : Figures or None
        None where it is not repaired.
    problem : Problem or None
        Why it failed, or why there is nothing to repair.
    output, report : str or None
        The repaired copy and its report, within the output folder.
    seconds : float
        How long it took.
    """

    file: str
    state: State
    figures: Figures | None = None
    problem: Problem | None = None
    output: str | None = None
    report: str | None = None
    seconds: float = 0.0

    def as_json(self) -> dict[str, Any]:
        """Return plain data; `from_json` reads it."""
        return asdict(self)

    @classmethod
    def from_json(cls, data: Mapping[str, Any]) -> "Row":
        """Read what `as_json` has returned.

        Raises
        ------
        KeyError, TypeError, ValueError
            If it is something else.
        """
        figures = dict(data["figures"])
        smoothed = figures["smoothed"]
        figures |= {
            "reasons": tuple(made(Reason, reason) for reason in figures["reasons"]),
            "fixed": tuple(made(Fixed, each) for each in figures["fixed"]),
            "smoothed": None if smoothed is None else made(Smoothed, smoothed),
            "warnings": tuple(figures["warnings"]),
        }
        return made(cls, {**data, "figures": made(Figures, figures)})


@dataclass(frozen=True)
class Seen:
    """A file as it was at some moment.

    Attributes
    ----------
    size, mtime_ns : int
        Size in bytes and time of change.
    sha256 : str
        Of its bytes.
    record_sha256 : str
        Of the repair record beside it; "" without one.
    """

    size: int
    mtime_ns: int
    sha256: str
    record_sha256: str = ""


def made(kind: type[Plain], data: Mapping[str, Any]) -> Plain:
    """Return an instance of one of these classes whose values are of the kinds that it says.

    Raises
    ------
    TypeError
        If one is not, or if there are others: somebody has edited what the data were read from.
    """
    entry = kind(**data)
    for item in fields(entry):
        if not _is_of(getattr(entry, item.name), item.type):
            raise TypeError(f"{item.name} is of another kind")
    return entry


def _is_of(value: object, kind: Any) -> bool:
    if get_origin(kind) is tuple:
        return isinstance(value, tuple) and all(isinstance(one, get_args(kind)[0]) for one in value)
    if get_origin(kind) is Literal:
        return value in get_args(kind)
    return isinstance(value, kind) and not isinstance(value, bool)


@dataclass(frozen=True)
class Finished:
    """What a worker says at the end of a file.

    Attributes
    ----------
    row : Row
        For the user.
    input, output : Seen or None
        The file and its repaired copy; None where it failed.
    untouched : bool
        Whether it is known of a file that failed that its copy is what it was before.
    trace : str
        Where an unexpected error came from, for the log.
    """

    row: Row
    input: Seen | None = None
    output: Seen | None = None
    untouched: bool = False
    trace: str = field(default="", repr=False)
