"""What the user looks at: frame, selection, gap and preview. All views read it, none owns it."""

from collections.abc import Mapping

from PySide6.QtCore import QObject, Signal

from mocapmend.companion import Companion
from mocapmend.prospects import Preview
from mocapmend_algorithms import Gap
from mocapmend_algorithms.corrections import Exchange
from mocapmend_algorithms.problems import BadRun
from mocapmend_algorithms.smooth.contract import SmoothedRun

__all__ = ["Preview", "ViewState"]

LEAST_VISIBLE = 10.0
"""Frames that the plots and the timeline show at the closest."""


class ViewState(QObject):
    """The shared cursor of all views of a document.

    While `picking`, a click on a marker does not select it but is told by `picked`.
    """

    candidates_changed = Signal(tuple)
    proposed_changed = Signal()
    picking_changed = Signal(bool)
    picked = Signal(int)
    frame_changed = Signal(int)
    selection_changed = Signal(tuple)
    gap_changed = Signal(object)
    suspect_changed = Signal(object)
    exchange_changed = Signal(object)
    preview_changed = Signal(object)
    smoothing_changed = Signal(tuple)
    companion_changed = Signal()
    range_changed = Signal(float, float)
    span_changed = Signal(object)

    def __init__(self, frames: int, parent: QObject | None = None) -> None:
        super().__init__(parent)
        self.frames = frames
        self.frame = 0
        self.selection: tuple[int, ...] = ()
        self.gap: Gap | None = None
        self.suspect: BadRun | None = None
        self.exchange: Exchange | None = None
        """What is shown as it would be, before the user does it."""
        self.preview: Preview | None = None
        self.smoothing: tuple[SmoothedRun, ...] = ()
        self.candidates: tuple[tuple[int, Preview], ...] = ()
        self.companion: Companion | None = None
        """Another recording that is shown beside this one."""
        self.picking = False
        self.proposed: Mapping[int, str] = {}
        """By marker: what it would be called in the current frame."""
        self.visible = (0.0, float(max(1, frames)))
        self.span: tuple[int, int] | None = None

    @property
    def marker(self) -> int | None:
        """The current marker: the last one selected."""
        return self.selection[-1] if self.selection else None

    def set_frame(self, frame: int) -> None:
        """Move the playhead; frames outside the recording go to its ends."""
        frame = max(0, min(self.frames - 1, frame))
        if frame != self.frame:
            self.frame = frame
            self.frame_changed.emit(frame)

    def select(self, markers: tuple[int, ...]) -> None:
        """Select markers, the current one last."""
        if markers != self.selection:
            self.selection = markers
            self.selection_changed.emit(markers)
            self.set_exchange(None)
            # Nobody shall repair a gap of a marker that is out of sight.
            if self.gap is not None and self.gap.marker not in markers:
                self.set_gap(None)
            if self.suspect is not None and self.suspect.marker not in markers:
                self.set_suspect(None)

    def toggle(self, marker: int) -> None:
        """Add a marker to the selection, or take it out."""
        rest = tuple(other for other in self.selection if other != marker)
        self.select(rest if len(rest) < len(self.selection) else (*rest, marker))

    def set_gap(self, gap: Gap | None) -> None:
        """Make a gap the one that is worked on."""
        if gap != self.gap:
            self.gap = gap
            self.set_preview(None)
            self.set_candidates(())
            self.gap_changed.emit(gap)
        if gap is not None:
            self.set_suspect(None)

    def set_suspect(self, run: BadRun | None) -> None:
        """Make a run of bad samples the one that is worked on."""
        if run != self.suspect:
            self.suspect = run
            self.suspect_changed.emit(run)
        if run is not None:
            self.set_gap(None)

    def set_exchange(self, exchange: Exchange | None) -> None:
        """Show two markers as they would be after an exchange, or no more."""
        if exchange != self.exchange:
            self.exchange = exchange
            self.exchange_changed.emit(exchange)

    def go_to_suspect(self, run: BadRun) -> None:
        """Show bad samples as `go_to` shows a gap; of a swap both markers are selected."""
        wanted = (run.marker,) if run.other is None else (run.other, run.marker)
        if self.selection != wanted:
            self.select(wanted)
        self.set_suspect(run)
        self.set_frame((run.start + run.stop - 1) // 2)
        self.frame_span(run.start, run.stop)

    def go_to(self, gap: Gap) -> None:
        """Show a gap: its marker selected, the playhead in its middle, its surroundings in view."""
        if gap.marker != self.marker:
            self.select((gap.marker,))
        self.set_gap(gap)
        self.set_frame((gap.start + gap.stop - 1) // 2)
        self.frame_span(gap.start, gap.stop)

    def frame_span(self, start: int, stop: int) -> None:
        """Choose the visible range so that a run takes about a third of it."""
        margin = max(stop - start, 15)
        self.set_visible(start - margin, stop + margin)

    def keep_in_view(self) -> None:
        """Turn the page when the playhead has left the visible range."""
        start, stop = self.visible
        if self.frame >= stop:
            self.set_visible(self.frame, self.frame + stop - start)
        elif self.frame < start:
            self.set_visible(self.frame + 1 - (stop - start), self.frame + 1)

    def set_span(self, span: tuple[int, int] | None) -> None:
        """Select a run of frames, first and end; kept inside the recording, None if it is empty."""
        if span is not None:
            span = max(0, span[0]), min(self.frames, span[1])
            span = span if span[0] < span[1] else None
        if span != self.span:
            self.span = span
            self.span_changed.emit(span)

    def set_preview(self, preview: Preview | None) -> None:
        """Show a repair without applying it, or none."""
        if preview is not self.preview:
            self.preview = preview
            self.preview_changed.emit(preview)

    def set_smoothing(self, runs: tuple[SmoothedRun, ...]) -> None:
        """Show smoothed runs without applying them, or none."""
        if runs != self.smoothing:
            self.smoothing = runs
            self.smoothing_changed.emit(runs)

    def set_companion(self, companion: Companion | None) -> None:
        """Show another recording beside this one, or none."""
        if companion is not self.companion:
            self.companion = companion
            self.companion_changed.emit()

    @property
    def others(self) -> tuple[tuple[int, Preview], ...]:
        """The candidates besides the preview, with their numbers."""
        return tuple(pair for pair in self.candidates if pair[1] is not self.preview)

    def set_candidates(self, candidates: tuple[tuple[int, Preview], ...]) -> None:
        """Show repairs of the current gap side by side, each with its number."""
        if candidates != self.candidates:
            self.candidates = candidates
            self.candidates_changed.emit(candidates)

    def set_proposed(self, names: Mapping[int, str]) -> None:
        """Show other names for some markers without renaming them."""
        if names != self.proposed:
            self.proposed = names
            self.proposed_changed.emit()

    def set_picking(self, on: bool) -> None:  # noqa: FBT001 - a slot of toggled(bool)
        """Let clicks on markers choose donors, or select again."""
        if on != self.picking:
            self.picking = on
            self.picking_changed.emit(on)

    def click(self, marker: int | None, *, add: bool = False) -> None:
        """Do what a click on a marker, or beside all of them, means just now.

        Parameters
        ----------
        marker : int or None
            What was hit.
        add : bool
            Whether the click adds to the selection, or takes out of it.
        """
        if self.picking:
            if marker is not None:
                self.picked.emit(marker)
        elif marker is None:
            if not add:
                self.select(())
        elif add:
            self.toggle(marker)
        else:
            self.select((marker,))

    def set_visible(self, start: float, stop: float) -> None:
        """Choose the frames that the plots and the timeline show; kept inside the recording."""
        whole = float(max(1, self.frames))
        width = min(max(stop - start, LEAST_VISIBLE), whole)
        start = min(max(start, 0.0), whole - width)
        visible = (start, start + width)
        if visible != self.visible:
            self.visible = visible
            self.range_changed.emit(*visible)

    def zoom(self, factor: float, centre: float) -> None:
        """Scale the visible range around a frame: factors below 1 come closer."""
        start, stop = self.visible
        self.set_visible(centre - (centre - start) * factor, centre + (stop - centre) * factor)

    def pan(self, frames: float) -> None:
        """Move the visible range."""
        start, stop = self.visible
        self.set_visible(start + frames, stop + frames)
