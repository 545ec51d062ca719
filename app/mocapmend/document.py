"""The open recording: the only owner and the only writer of its samples."""

from collections.abc import Iterable, Iterator, Mapping, Sequence
from dataclasses import replace
from itertools import compress
from typing import TypeVar

import numpy as np
from numpy.typing import NDArray
from PySide6.QtCore import QObject, Signal
from PySide6.QtGui import QUndoStack

from mocapmend.believed import Believed, Correction
from mocapmend.doubts import Doubts
from mocapmend.edits import Contents, Edit, Repair, Smoothed
from mocapmend.files import Source
from mocapmend.files.records import NEVER_FILLED
from mocapmend.layers import Layers
from mocapmend.names import new_names, short_names
from mocapmend.report import RepairRow, repair_rows
from mocapmend.shared_recording import SharedRecording
from mocapmend.shares import Layer, Shares
from mocapmend.state import ABSENT, SampleState
from mocapmend.states import States
from mocapmend.unsaved import Unsaved
from mocapmend.working_copy import WorkingCopy
from mocapmend.written import Places, places_of
from mocapmend_algorithms import Gap, Recording
from mocapmend_algorithms.fill.contract import Patch
from mocapmend_algorithms.skeleton import Skeleton

T = TypeVar("T")
NO_SKELETON = Skeleton("", (), "none")


class Document(QObject):
    """A recording that is being repaired.

    Repairs that the file had when it was opened are repairs here too: they can be reverted. So do
    gaps that it keeps open stay so, until they are freed.

    Samples, and why the user keeps gaps open, change only through `apply` and `correct`, which undo
    commands call. Every change of samples raises `revision` and is announced by `samples_changed`
    with the tuple of changed runs; where only reasons change, `left_open_changed` says so. Before
    that `base_changed` says where the measured samples that are believed have changed.

    Parameters
    ----------
    source : Source
        The recording as it was read.
    skeleton : Skeleton or None
        Its bones; None where they are still to be found: `set_skeleton` brings them.
    states : States, optional
        Of the samples, where they are known already.
    parent : QObject, optional
        Owns the document.
    """

    names_changed = Signal()
    samples_changed = Signal(tuple)
    base_changed = Signal()
    left_open_changed = Signal()
    skeleton_changed = Signal()

    def __init__(
        self,
        source: Source,
        skeleton: Skeleton | None,
        states: States | None = None,
        parent: QObject | None = None,
    ) -> None:
        super().__init__(parent)
        self.source = source
        self.found_skeleton = skeleton
        self.undo_stack = QUndoStack(self)
        self.revision = 0
        self.original = source.measured
        """The measured samples as the file has them."""
        self._believed = Believed(source)
        self.base_revision = 0
        """Tells the states of `base` apart; undoing brings a former one back."""
        self._newest_base = 0
        self._earlier = dict(_earlier_repairs(source))
        self.repairs = dict(self._earlier)
        self.smoothed_earlier = dict(_earlier_smoothing(source))
        """The runs that were smoothed when the file was opened; never changed."""
        self.smoothed = dict(self.smoothed_earlier)
        """The runs that are smoothed, and how. What else changes them takes that off first."""
        self.left_open: dict[Gap, str] = {}
        """Why fills left gaps open: results, no edits."""
        self._reasons = {gap: kept.reason for gap, kept in source.kept_open.items()}
        """Why the user keeps gaps open, those never to be filled among them."""
        self.names = short_names(source.recording.labels)
        self._samples = WorkingCopy(source.recording.points)
        self._states = States(source) if states is None else states
        self._written: set[Gap] = set()
        """Runs in which the samples may differ from those of the file."""
        self._shares = Shares(source.recording)

    @property
    def skeleton(self) -> Skeleton:
        """The bones; none while they are still to be found."""
        return NO_SKELETON if self.found_skeleton is None else self.found_skeleton

    def set_skeleton(self, skeleton: Skeleton) -> None:
        """Take the bones that were found after the document was opened."""
        self.found_skeleton = skeleton
        self.skeleton_changed.emit()

    def get_ready(self) -> None:
        """Prepare for the first edit, in a thread."""
        self._samples.prepare()

    @property
    def repairable(self) -> bool:
        """Whether there are markers and frames; some files hold analog data or events alone."""
        return self.original.points.size > 0

    @property
    def points(self) -> NDArray[np.float64]:
        """Current coordinates, shape (frames, markers, 3); a read-only view that edits change."""
        view = self._samples.current.view()
        view.flags.writeable = False
        return view

    @property
    def state(self) -> NDArray[np.uint8]:
        """Current `SampleState` of every sample, shape (frames, markers); a read-only view."""
        return self._states.array

    @property
    def gaps(self) -> list[Gap]:
        """The gaps that are open now, by marker and start; not to be changed."""
        return self._states.gaps

    @property
    def fillable(self) -> list[Gap]:
        """The open gaps of markers that are seen at all, by marker and start; not to be changed."""
        return self._states.fillable[0]

    @property
    def fillable_corners(self) -> NDArray[np.int64]:
        """Marker, start and stop of these gaps, shape (gaps, 3); not to be changed."""
        return self._states.fillable[1]

    def gaps_of(self, marker: int) -> list[Gap]:
        """Return the open gaps of one marker, by start."""
        return self._states.gaps_of(marker)

    def never_of(self, marker: int) -> list[Gap]:
        """Return the gaps of one marker that shall never be filled, by start."""
        return self._states.as_gaps(marker, SampleState.NEVER)

    @property
    def never(self) -> list[Gap]:
        """The gaps that shall never be filled, by marker and start."""
        markers = range(self.original.markers)
        return [gap for marker in markers for gap in self.never_of(marker)]

    def never_reason(self, gap: Gap) -> str:
        """Return why a gap shall never be filled."""
        return self._reasons.get(gap, NEVER_FILLED)

    @property
    def set_aside(self) -> dict[Gap, str]:
        """The open gaps that the user has looked at and left so, with the reasons."""
        # Mostly there are none, and ten thousand gaps to look through.
        gaps = self.gaps if self._reasons else []
        return {gap: self._reasons[gap] for gap in gaps if gap in self._reasons}

    def open_reason(self, gap: Gap) -> str | None:
        """Return why an open gap stays so: the user's reason, else that of a fill."""
        return self._reasons.get(gap, self.left_open.get(gap))

    def gap_near(self, marker: int, frame: float, reach: float = 0.0) -> Gap | None:
        """Return the gap of a marker, open or not, at a frame or nearest within a reach."""
        repaired = (gap for gap in self.repairs if gap.marker == marker)
        near = (
            gap
            for gap in (*self.gaps_of(marker), *repaired, *self.never_of(marker))
            if gap.start - reach <= frame < gap.stop + reach
        )
        return min(near, key=lambda gap: abs((gap.start + gap.stop) / 2.0 - frame), default=None)

    def is_earlier(self, gap: Gap) -> bool:
        """Say whether a gap's repair is the one that the file had when it was opened."""
        repair = self._earlier.get(gap)
        now = self.repairs.get(gap)
        # Where its donors are called otherwise it is another object, with the same patch.
        return repair is not None and now is not None and now.patch is repair.patch

    @property
    def stale(self) -> list[Gap]:
        """The gaps that were filled before what is believed changed, by marker and start.

        Repairs that the file had when it was opened stay as they are.
        """
        base = self.base_revision
        return sorted(
            gap
            for gap, repair in self.repairs.items()
            if repair.base != base and not self.is_earlier(gap)
        )

    def leave_open(self, reasons: Mapping[Gap, str]) -> None:
        """Note that a fill left gaps open, and why."""
        self.left_open |= reasons
        self.left_open_changed.emit()

    def runs(self, marker: int, state: SampleState) -> NDArray[np.int64]:
        """Return the (start, stop) runs of a marker in a state, shape (runs, 2)."""
        return self._states.runs(marker, state)

    def snapshot(self) -> Recording:
        """Return the current samples as a recording of its own."""
        return self.share().recording()

    def share(self) -> SharedRecording:
        """Return the current samples for a background job; all of a revision get the same."""
        return self._shares.get(Layer.CURRENT, self.revision, lambda: self._written, self.points)

    def share_with(self, edits: Sequence[Edit]) -> SharedRecording:
        """Return the samples as they would be after some edits for a background job."""
        if not edits:
            return self.share()
        points = self.points.copy()
        for edit in edits:
            points[edit.gap.start : edit.gap.stop, edit.gap.marker] = edit.values
        return self._shares.make(self._written.union(edit.gap for edit in edits), points)

    @property
    def base(self) -> Recording:
        """What fills are computed from: measured samples that are believed, where they belong.

        After a correction it is another object.
        """
        return self._believed.recording

    @property
    def labels(self) -> tuple[str, ...]:
        """What the markers are called now."""
        return self.original.labels

    def rename(self, labels: Mapping[int, str]) -> None:
        """Give markers other labels. For undo commands alone."""
        former, new = self.labels, list(self.labels)
        for marker, label in labels.items():
            new[marker] = label
        self.original = replace(self.original, labels=tuple(new))
        self._believed.rename(tuple(new))
        self.names = short_names(new)
        calls = new_names(former, new)
        self.repairs.update({gap: made.renamed(calls) for gap, made in self.repairs.items()})
        # Workers find markers by their labels.
        self._shares.rename(new)
        self.names_changed.emit()

    @property
    def doubts(self) -> Doubts:
        """The runs that are set aside, with the reasons; not to be changed."""
        return self._believed.doubts

    @property
    def doubted(self) -> NDArray[np.bool_]:
        """Which samples are set aside, shape (frames, markers); not to be changed."""
        return self._believed.doubted

    @property
    def layers(self) -> Layers:
        """A snapshot of what was exchanged and set aside."""
        return self._believed.layers

    def stored(self, run: Gap) -> NDArray[np.float64]:
        """Return what was measured in a run, bad samples included, shape (frames, 3)."""
        return self._believed.stored(run)

    def share_base(self) -> SharedRecording:
        """Return `base` for a background job."""
        if self.base is self.original:
            return self.share_original()
        return self._shares.get(
            Layer.BASE,
            self.base_revision,
            lambda: set(self._believed.touched()),
            self.base.points,
        )

    def new_base_revision(self) -> int:
        """Return a number for a state of `base` that was not before."""
        self._newest_base += 1
        return self._newest_base

    def share_original(self) -> SharedRecording:
        """Return the measured samples as the file has them for a background job."""
        return self._shares.get(
            Layer.ORIGINAL, 0, lambda: self.source.repaired, self.original.points
        )

    def read(self, gap: Gap) -> Edit:
        """Return what a run holds now, as the edit that would restore it."""
        return next(self.contents((gap,), places_of((gap,))).edits())

    def contents(self, runs: Sequence[Gap], places: Places) -> Contents:
        """Return what runs hold now.

        Parameters
        ----------
        runs : sequence of Gap
            Which.
        places : Places
            Where their samples are.
        """
        return Contents(
            tuple(runs),
            places,
            self.points[places],
            self.state[places],
            tuple(map(self.repairs.get, runs)),
            tuple(map(self._reasons.get, runs)),
            tuple(map(self.smoothed.get, runs)),
        )

    def apply(self, new: Contents) -> None:
        """Write runs of samples, and the reasons of gaps. For undo commands alone."""
        # What is smoothed keeps what it has beneath.
        beneath = [made is None for made in new.smoothed]
        _set(self._reasons, compress(zip(new.gaps, new.reasons, strict=True), beneath))
        new = self._with_doubts(new)
        if np.array_equal(new.states, self.state[new.places]) and new.absent.all():
            self.left_open_changed.emit()
            return
        self._samples.writable()[new.places] = new.values
        self._states.write(new.places, new.states, {gap.marker for gap in new.gaps})
        _set(self.repairs, compress(zip(new.gaps, new.repairs, strict=True), beneath))
        _set(self.smoothed, zip(new.gaps, new.smoothed, strict=True))
        self._written.update(new.gaps)
        self.revision += 1
        self.samples_changed.emit(new.gaps)

    def correct(self, correction: Correction, revision: int) -> None:
        """Exchange samples and set runs aside, or the like backwards. For undo commands alone.

        Parameters
        ----------
        correction : Correction
            What to do. None of the samples is filled, and none of the gaps shall never be.
        revision : int
            Of `base` after it.
        """
        self._believed.apply(correction)
        self.base_revision = revision
        frames, markers = places = places_of(correction.runs)
        present = self.base.present[places]
        self._samples.writable()[places] = self.base.points[places]
        states = np.where(present, SampleState.MEASURED, SampleState.MISSING).astype(np.uint8)
        states[self._believed.doubted[frames, markers]] = SampleState.BAD
        self._states.write(places, states, set(markers.tolist()))
        self._written.update(correction.runs)
        self.left_open.clear()
        self.revision += 1
        self.base_changed.emit()
        self.samples_changed.emit(correction.runs)

    def _with_doubts(self, new: Contents) -> Contents:
        """Return contents in which what is set aside is no ordinary missing sample."""
        doubted = self._believed.doubted[new.places] & (new.states == SampleState.MISSING)
        if not doubted.any():
            return new
        return replace(new, states=np.where(doubted, np.uint8(SampleState.BAD), new.states))

    def unsaved(self) -> Unsaved:
        """Return what may differ from the file, for saving.

        Measured samples that an open gap covers are not among it: the file keeps them.
        """
        frames, markers = places = places_of(self._written)
        covered = np.isin(self.state[places], ABSENT) & self.base.present[places]
        rest = frames[~covered], markers[~covered]
        return Unsaved(
            layers=self.layers,
            places=rest,
            values=self._samples.current[rest],
            repairs=dict(self.repairs),
            never={gap: self.never_reason(gap) for gap in self.never},
            set_aside=self.set_aside,
            smoothed=dict(self.smoothed),
            labels=self.labels,
        )

    def repair_rows(self) -> list[RepairRow]:
        """Return what was repaired and how well, for reports."""
        made = [self.repairs[gap] for gap in sorted(self.repairs)]
        return repair_rows([(one.patch, one.method, one.donors) for one in made], self.original)


def _earlier_repairs(source: Source) -> Iterator[tuple[Gap, Repair]]:
    """Yield the repairs that the file has had: their values, and their error over the whole gap."""
    mm = source.recording.mm
    for gap, record in zip(source.repaired, source.repairs, strict=True):
        values = source.recording.points[gap.start : gap.stop, gap.marker].copy()
        patch = Patch.stated(gap, values, record.expected_error_mm / mm, record.r90_mm / mm)
        yield gap, Repair(record.method, record.parameters, patch, record.donors)


def _earlier_smoothing(source: Source) -> Iterator[tuple[Gap, Smoothed]]:
    for run, entry in source.smoothed.items():
        rms = entry.rms_change_mm / source.recording.mm
        yield run, Smoothed(entry.method, entry.parameters, entry.chosen, rms)


def _set(known: dict[Gap, T], values: Iterable[tuple[Gap, T | None]]) -> None:
    """Set what is known of gaps; None is nothing."""
    for gap, value in values:
        if value is None:
            known.pop(gap, None)
        else:
            known[gap] = value
