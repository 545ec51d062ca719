"""Playback in real time: frames are skipped where the screen is slower, never slowed down."""

from collections.abc import Callable
from time import perf_counter

from PySide6.QtCore import QObject, Qt, QTimer, Signal

from mocapmend.viewstate import ViewState

SPEEDS = (0.1, 0.25, 0.5, 1.0, 2.0, 4.0)
TICK_MS = 15


class Player(QObject):
    """Moves the playhead with the clock; stops at the end, or begins again.

    Parameters
    ----------
    view : ViewState
        Whose playhead is moved.
    rate : float
        Frames per second of the recording.
    parent : QObject, optional
        The owner.
    clock : callable
        Returns a time in seconds.
    """

    playing_changed = Signal(bool)
    speed_changed = Signal(float)

    def __init__(
        self,
        view: ViewState,
        rate: float,
        parent: QObject | None = None,
        clock: Callable[[], float] = perf_counter,
    ) -> None:
        super().__init__(parent)
        self._view = view
        self._rate = rate
        self.speed = 1.0
        self.loop = False
        self._clock = clock
        self._began = 0.0
        self._origin = 0.0
        self._shown = 0
        self._timer = QTimer(self)
        self._timer.setTimerType(Qt.TimerType.PreciseTimer)
        self._timer.setInterval(TICK_MS)
        self._timer.timeout.connect(self._tick)

    @property
    def playing(self) -> bool:
        """Whether the playhead moves by itself."""
        return self._timer.isActive()

    def toggle(self) -> None:
        """Play, from the start when at the end or outside of what is looped; or pause."""
        if self.playing:
            self.pause()
            return
        first, end = self._bounds()
        if self._view.frame >= end - 1 or (self.loop and self._view.frame < first):
            self._view.set_frame(first)
            self._view.keep_in_view()
        self._begin(self._view.frame)
        self._timer.start()
        self.playing_changed.emit(True)  # noqa: FBT003 - a signal's argument

    def pause(self) -> None:
        """Stop where the playhead is."""
        if self.playing:
            self._timer.stop()
            self.playing_changed.emit(False)  # noqa: FBT003 - a signal's argument

    def set_speed(self, speed: float) -> None:
        """Play at the multiple of real time, of `SPEEDS`, that is nearest to a wish."""
        # Before the speed changes, for the time until now has passed at the old one.
        self._begin(self._position())
        self.speed = min(SPEEDS, key=lambda known: abs(known - speed))
        self.speed_changed.emit(self.speed)

    def step_speed(self, step: int) -> None:
        """Go to the next faster (1) or slower (-1) speed of `SPEEDS`."""
        index = SPEEDS.index(self.speed) + step
        self.set_speed(SPEEDS[max(0, min(len(SPEEDS) - 1, index))])

    def set_loop(self, on: bool) -> None:  # noqa: FBT001 - a slot of toggled(bool)
        """Begin again at the end: of the selected frames, or of the recording."""
        self.loop = on

    def _bounds(self) -> tuple[int, int]:
        """Return what is played: first frame and end."""
        if self.loop and self._view.span is not None:
            return self._view.span
        return 0, self._view.frames

    def _begin(self, position: float) -> None:
        self._origin, self._began = position, self._clock()
        self._shown = self._view.frame

    def _position(self) -> float:
        """Return where playback is, between frames too; where the user has scrubbed to, if so."""
        if not self.playing or self._view.frame != self._shown:
            return float(self._view.frame)
        return self._origin + (self._clock() - self._began) * self._rate * self.speed

    def _tick(self) -> None:
        position = self._position()
        first, end = self._bounds()
        if self._view.frame != self._shown:
            self._begin(position)
        if self.loop and position >= end:
            # The clock goes on: nothing is lost from one round to the next.
            again = first + (position - end) % (end - first)
            self._origin += again - position
            position = again
        self._view.set_frame(int(position))
        self._view.keep_in_view()
        self._shown = self._view.frame
        if not self.loop and position >= end - 1:
            self.pause()
