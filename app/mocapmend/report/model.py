"""What a report holds."""

from dataclasses import dataclass

from mocapmend.files.records import RepairRecord
from mocapmend.report.put_right import NOTHING_PUT_RIGHT, PutRight
from mocapmend.report.refining import Refining
from mocapmend_algorithms import Gap, Recording
from mocapmend_algorithms.arrays import BoolArray, FloatArray, IntArray
from mocapmend_algorithms.fill.contract import Patch
from mocapmend_algorithms.metrics import SuccessCurves


@dataclass(frozen=True)
class RepairRow:
    """One filled gap.

    Attributes
    ----------
    gap : Gap
        Which.
    method : str
        Method id.
    expected_error_mm : float
        Expected 3-D RMS error; NaN where unknown.
    r90_mm : float
        Median over the gap of the radius that should hold the true position with probability
        0.9; NaN where unknown.
    donors : tuple of str
        Labels of the markers that the repair was computed from.
    """

    gap: Gap
    method: str
    expected_error_mm: float = float("nan")
    r90_mm: float = float("nan")
    donors: tuple[str, ...] = ()

    @classmethod
    def of(
        cls, patch: Patch, method: str, recording: Recording, donors: tuple[str, ...] = ()
    ) -> "RepairRow":
        """Describe a patch of a recording."""
        error, r90 = patch.expected_error * recording.mm, patch.typical_r90 * recording.mm
        return cls(patch.gap, method, error, r90, donors)

    @classmethod
    def from_record(cls, gap: Gap, record: RepairRecord) -> "RepairRow":
        """Describe a repair that the file had before."""
        return cls(gap, record.method, record.expected_error_mm, record.r90_mm, record.donors)


@dataclass(frozen=True)
class OpenGap:
    """A gap that is still there, and why."""

    gap: Gap
    reason: str


@dataclass(frozen=True)
class EditRow:
    """One undoable step.

    Attributes
    ----------
    text : str
        What was done.
    markers, runs : int
        How many markers, and how many runs of samples of them, it wrote.
    filled, cleared : int
        Samples that it filled, and samples that it set missing.
    """

    text: str
    markers: int
    runs: int
    filled: int
    cleared: int = 0


@dataclass(frozen=True)
class About:
    """What the report says about its making.

    Attributes
    ----------
    file : str
        Name of the recording, without its folder.
    methods : tuple of str
        The methods used, with their parameters.
    limits : str
        The limits that held, as a sentence.
    warnings : tuple of str
        What was odd about the file.
    earlier : int
        How many of the repairs the file had when it was opened.
    earlier_program : str
        The program that made those.
    proof : tuple of str
        What the checks of the written file found; empty where none was written.
    edits : tuple of EditRow
        The steps, in order.
    put_right : PutRight
        What was set aside, exchanged and smoothed, by earlier repairs too.
    refining : Refining or None
        How a network has computed all markers, where one has.
    """

    file: str
    methods: tuple[str, ...] = ()
    limits: str = ""
    warnings: tuple[str, ...] = ()
    earlier: int = 0
    earlier_program: str = ""
    proof: tuple[str, ...] = ()
    edits: tuple[EditRow, ...] = ()
    put_right: PutRight = NOTHING_PUT_RIGHT
    refining: Refining | None = None


@dataclass(frozen=True)
class MarkerRow:
    """What happened to one marker.

    Attributes
    ----------
    label : str
        As the file has it.
    missing_before, missing_after : float
        Share of the frames in which it is missing, in %.
    gaps_before, gaps_after : int
        Number of gaps.
    longest_before, longest_after : int
        Length of the longest gap in frames, 0 without gaps.
    filled : int
        Samples that were missing and are there now.
    unfilled : int
        Samples that are missing still.
    filled_by : tuple of (str, float)
        Method ids, and the share of the frames that each filled, in %.
    worst_error_mm : float
        Largest expected error among its repairs; NaN where unknown.
    """

    label: str
    missing_before: float
    missing_after: float
    gaps_before: int
    gaps_after: int
    longest_before: int
    longest_after: int
    filled: int
    unfilled: int
    filled_by: tuple[tuple[str, float], ...]
    worst_error_mm: float


@dataclass(frozen=True, eq=False)
class Report:
    """A recording before and after its repairs.

    Attributes
    ----------
    rate : float
        Frames per second (Hz).
    first_frame, frames : int
        Number of the first frame as the file counts it, and how many there are.
    unit : str
        Length unit of the bones.
    success_before, success_after : SuccessCurves
        Tracking success over time; both count the markers that are seen at all in either. What
        was there but wrong was not tracked.
    segments : int
        How many groups of markers move as one; 0 where none are known.
    segment_success : tuple of (SuccessCurves, SuccessCurves) or None
        The same before and after for segments, which are tracked when all their markers are.
    bones : tuple of (int, int)
        Marker pairs.
    bone_names : tuple of str
        The labels of their ends.
    spread_before, spread_after : ndarray, shape (bones,)
        Coefficient of variation of their lengths in %; NaN where unknown.
    bone_repairs : ndarray of int, shape (bones,)
        Frames in which an end of the bone was changed, not smoothed alone, and the other end is
        there.
    shown_bones : tuple of int
        The bones most affected by the repairs, at most 6, as indices into `bones`.
    lengths_before, lengths_after : ndarray, shape (frames, shown bones)
        Their lengths, NaN where an end is missing.
    changed : ndarray of bool, shape (frames, shown bones)
        Where `bone_repairs` counts.
    markers : tuple of MarkerRow
        One per marker.
    labels : tuple of str
        Of the markers.
    repairs : tuple of RepairRow
        The filled gaps.
    open_gaps : tuple of OpenGap
        All gaps that are still there.
    missing_before, wrong_before : int
        Samples that were missing, and those that were there but wrong.
    altered : int
        Samples that were measured and are others now, or none.
    """

    rate: float
    first_frame: int
    frames: int
    unit: str
    success_before: SuccessCurves
    success_after: SuccessCurves
    segments: int
    segment_success: tuple[SuccessCurves, SuccessCurves] | None
    bones: tuple[tuple[int, int], ...]
    bone_names: tuple[str, ...]
    spread_before: FloatArray
    spread_after: FloatArray
    bone_repairs: IntArray
    shown_bones: tuple[int, ...]
    lengths_before: FloatArray
    lengths_after: FloatArray
    changed: BoolArray
    markers: tuple[MarkerRow, ...]
    labels: tuple[str, ...]
    repairs: tuple[RepairRow, ...]
    open_gaps: tuple[OpenGap, ...]
    missing_before: int
    wrong_before: int
    altered: int
