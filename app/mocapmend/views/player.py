"""Playback in real time: frames are skipped where the screen is slower, never slowed down."""

from PySide6.QtCore import QElapsedTimer, QObject, Qt, QTimer, Signal

from mocapmend.viewstate import ViewState

SPEEDS = (0.1, 0.25, 0.5, 1.0, 2.0, 4.0)
TICK_MS = 15


class Player(QObject):
    """Moves the playhead with the clock and stops at the end."""

    playing_changed = Signal(bool)
    speed_changed = Signal(float)

    def __init__(self, view: ViewState, rate: float, parent: QObject | None = None) -> None:
        super().__init__(parent)
        self._view = view
        self._rate = rate
        self.speed = 1.0
        self._clock = QElapsedTimer()
        self._origin = 0
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
        """Play, from the start when at the end; or pause."""
        if self.playing:
            self.pause()
            return
        if self._view.frame >= self._view.frames - 1:
            self._view.set_frame(0)
        self._begin()
        self._timer.start()
        self.playing_changed.emit(True)  # noqa: FBT003 - a signal's argument

    def pause(self) -> None:
        """Stop where the playhead is."""
        if self.playing:
            self._timer.stop()
            self.playing_changed.emit(False)  # noqa: FBT003 - a signal's argument

    def set_speed(self, speed: float) -> None:
        """Play at a multiple of real time."""
        self.speed = speed
        self._begin()
        self.speed_changed.emit(speed)

    def step_speed(self, step: int) -> None:
        """Go to the next faster (1) or slower (-1) speed of `SPEEDS`."""
        nearest = min(range(len(SPEEDS)), key=lambda k: abs(SPEEDS[k] - self.speed))
        self.set_speed(SPEEDS[max(0, min(len(SPEEDS) - 1, nearest + step))])

    def _begin(self) -> None:
        self._origin = self._shown = self._view.frame
        self._clock.start()

    def _tick(self) -> None:
        if self._view.frame != self._shown:
            # The user has scrubbed: go on from there.
            self._begin()
        elapsed = self._clock.nsecsElapsed() / 1e9
        frame = self._origin + int(elapsed * self._rate * self.speed)
        self._view.set_frame(frame)
        self._view.keep_in_view()
        self._shown = self._view.frame
        if frame >= self._view.frames - 1:
            self.pause()
