"""What the user does to the time: events, the selected frames, the visible range, playback."""

from PySide6.QtCore import QObject, Signal

from mocapmend.document import Document
from mocapmend.navigation import neighbour_frame
from mocapmend.settings import MOST_MISSING_FIRST, PLAY_SPEED, Settings
from mocapmend.views.event_lane import whole_frame
from mocapmend.views.player import Player
from mocapmend.views.timeline import Timeline
from mocapmend.viewstate import ViewState


class TimeActions(QObject):
    """Moves the shared cursor of a document's views.

    Signals
    -------
    message : str
        Something the user should read in passing.
    """

    message = Signal(str)

    def __init__(
        self,
        document: Document,
        view: ViewState,
        player: Player,
        timeline: Timeline,
        settings: Settings,
        parent: QObject,
    ) -> None:
        super().__init__(parent)
        self._view = view
        self._timeline = timeline
        self._settings = settings
        frames = {whole_frame(event) for event in document.source.events}
        self._events = sorted(frame for frame in frames if 0 <= frame < view.frames)
        player.set_speed(settings.get(PLAY_SPEED))
        player.speed_changed.connect(self._remember_speed)

    def step_event(self, step: int) -> None:
        """Go to the next (1) or previous (-1) event of the file."""
        frame = neighbour_frame(self._events, self._view.frame, step)
        if frame is None:
            self.message.emit(self.tr("This recording has no events."))
        else:
            self._view.set_frame(frame)
            self._view.keep_in_view()

    def select_from_here(self) -> None:
        """Begin the selected frames at the playhead; without an end they go to the last frame."""
        frame, span = self._view.frame, self._view.span
        end = span[1] if span is not None and span[1] > frame else self._view.frames
        self._view.set_span((frame, end))

    def select_to_here(self) -> None:
        """End the selected frames with the playhead's; without a begin they start at the first."""
        frame, span = self._view.frame, self._view.span
        start = span[0] if span is not None and span[0] <= frame else 0
        self._view.set_span((start, frame + 1))

    def zoom_to_span(self) -> None:
        """Show the selected frames."""
        span = self._view.span
        if span is None:
            self.message.emit(self.tr("No frames are selected: drag with Shift, or press I and O."))
        else:
            self._view.set_visible(*span)

    def frame_gap(self) -> None:
        """Show the current gap or problem so that it takes a third of the time axis."""
        current = self._view.suspect or self._view.gap
        if current is None:
            self.message.emit(self.tr("No gap or problem is chosen: press N for the next one."))
        else:
            self._view.frame_span(current.start, current.stop)

    def turn_page(self, step: int) -> None:
        """Show what comes after (1) or before (-1) the visible range."""
        start, stop = self._view.visible
        self._view.pan(step * (stop - start))

    def set_most_missing_first(self, on: bool) -> None:  # noqa: FBT001 - a slot of toggled(bool)
        """Order the timeline's lanes, this time and from now on."""
        self._settings.set(MOST_MISSING_FIRST, on)
        self._timeline.set_most_missing_first(on)

    def _remember_speed(self, speed: float) -> None:
        self._settings.set(PLAY_SPEED, speed)
