"""A recording as it was read from a file of any format."""

from collections.abc import Mapping, Sequence
from dataclasses import dataclass, field
from functools import cached_property
from pathlib import Path

import numpy as np
from numpy.typing import NDArray

from mocapmend.files.corrections import SetAside, SmoothedRun
from mocapmend.files.force_plate import ForcePlate
from mocapmend.files.opening import Stamp
from mocapmend.files.provenance import Provenance
from mocapmend.files.records import KeptGap, RepairRecord
from mocapmend_algorithms.corrections import Move
from mocapmend_algorithms.gaps import Gap, find_gaps
from mocapmend_algorithms.recording import Recording


@dataclass(frozen=True)
class Event:
    """A moment that the file names.

    Attributes
    ----------
    label : str
        What happened, as "Foot Strike".
    context : str
        To which side or object, as "Left"; may be empty.
    frame : float
        Frame from 0 = the first stored frame; may lie between frames or outside the recording.
    time : float
        Seconds as the file counts them, from its frame 1.
    """

    label: str
    context: str
    frame: float
    time: float


def truncation(promised: float, frames: int) -> str:
    """Return the warning for a file that holds fewer frames than it says."""
    return (
        f"The file is truncated: it says that it holds {promised:.0f} frames, but only {frames} "
        "are there."
    )


@dataclass(frozen=True, eq=False, kw_only=True)
class Source:
    """A recording as it was read from a file.

    Attributes
    ----------
    path : Path
        Where it was.
    kind : str
        The file's format, for the user, as "C3D" or "BVH".
    recording : Recording
        The markers or joints, as the file has them.
    events : tuple of Event
        Ordered by time.
    bones : tuple of (int, int)
        The file's own sticks, pairs of markers; empty where the format has none.
    model_outputs : tuple of str
        Labels of the stored points that are not markers.
    analog_labels : tuple of str
        One per analog channel.
    analog_rate : float
        Analog samples per second (Hz), 0 without analog.
    force_plates : tuple of ForcePlate
        In the order of the file.
    warnings : tuple of str
        What was odd and what was assumed, as sentences.
    frames_promised : int
        Frames that the file says it holds; 0 where it says nothing.
    stamp : Stamp
        To notice that the file was changed since.
    provenance : Provenance or None
        Its repair record, where it has been repaired by this program.
    repaired : tuple of Gap
        The gap that each of these repairs fills, in their order.
    kept_open : mapping of Gap to KeptGap
        Gaps that the user keeps open, from the repair record too.
    set_aside : mapping of Gap to SetAside
        Runs whose measured samples count as missing, from the repair record.
    moves : tuple of Move
        What was exchanged between markers since the file was recorded, from there too.
    smoothed : mapping of Gap to SmoothedRun
        Runs that were smoothed, from there too.
    """

    path: Path
    kind: str
    recording: Recording
    stamp: Stamp
    events: tuple[Event, ...] = ()
    bones: tuple[tuple[int, int], ...] = ()
    model_outputs: tuple[str, ...] = ()
    analog_labels: tuple[str, ...] = ()
    analog_rate: float = 0.0
    force_plates: tuple[ForcePlate, ...] = ()
    warnings: tuple[str, ...] = ()
    frames_promised: int = 0
    provenance: Provenance | None = None
    repaired: tuple[Gap, ...] = ()
    kept_open: Mapping[Gap, KeptGap] = field(default_factory=dict)
    set_aside: Mapping[Gap, SetAside] = field(default_factory=dict)
    moves: tuple[Move, ...] = ()
    smoothed: Mapping[Gap, SmoothedRun] = field(default_factory=dict)

    @property
    def stored_points(self) -> tuple[int, ...]:
        """The point of the file, from 0, that each marker is."""
        return tuple(range(self.recording.markers))

    @cached_property
    def markers_by_point(self) -> Mapping[int, int]:
        """The marker of each stored point that is one, counted from 1 as repair records do."""
        return {point + 1: marker for marker, point in enumerate(self.stored_points)}

    @property
    def repairs(self) -> tuple[RepairRecord, ...]:
        """The repairs that the file has had; `repaired` has their gaps."""
        return () if self.provenance is None else self.provenance.repairs

    @property
    def never_filled(self) -> dict[Gap, str]:
        """The gaps that no repair may fill, with the reasons."""
        return {gap: kept.reason for gap, kept in self.kept_open.items() if kept.never}

    @cached_property
    def measured(self) -> Recording:
        """The recording without earlier repairs: what repairs are computed from."""
        if not self.repaired:
            return self.recording
        points = self.recording.points.copy()
        for gap in self.repaired:
            points[gap.start : gap.stop, gap.marker] = np.nan
        return self.recording.with_points(points)

    @cached_property
    def as_stored(self) -> Recording:
        """The recording without any repair: as it was measured, as far as the file tells.

        What was smoothed is so here too.
        """
        if not (self.set_aside or self.moves):
            return self.measured
        now = self.measured.points.copy()
        for run, entry in self.set_aside.items():
            now[run.start : run.stop, run.marker] = entry.samples[:, :3]
        before = now.copy()
        for move in self.moves:
            before[move.start : move.stop, move.origin] = now[move.start : move.stop, move.marker]
        return self.recording.with_points(before)

    @property
    def first_labels(self) -> tuple[str, ...]:
        """What the markers were called before any was renamed, as far as the file tells."""
        labels = list(self.recording.labels)
        for entry in () if self.provenance is None else self.provenance.corrections.renamed:
            labels[self.markers_by_point[entry.point]] = entry.former
        return tuple(labels)

    def place(self, run: Gap) -> tuple[str, int, int, int]:
        """Return marker, point, first and last frame of a run as a repair record has them."""
        recording = self.recording
        first, last = recording.first_frame + run.start, recording.first_frame + run.stop - 1
        return recording.labels[run.marker], self.stored_points[run.marker] + 1, first, last

    def read_fourth(self, runs: Sequence[Gap]) -> list[NDArray[np.float32]]:
        """Return what the file stores beside the coordinates of some runs; here it is nothing.

        Returns
        -------
        list of ndarray, shape (frames of the run,)
        """
        return [np.zeros(run.length, np.float32) for run in runs]

    def open_gaps(self) -> list[Gap]:
        """Return the gaps of the measured samples that no earlier repair fills."""
        repaired = set(self.repaired)
        return [gap for gap in find_gaps(self.measured.present) if gap not in repaired]

    @property
    def truncated(self) -> bool:
        """Whether the file holds fewer frames than it says."""
        return self.recording.frames < self.frames_promised
