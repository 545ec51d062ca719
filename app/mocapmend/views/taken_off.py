"""Tells when a step takes smoothing off because it changes what lies beneath."""

from PySide6.QtCore import QObject, QTimer, Signal
from PySide6.QtGui import QUndoStack

from mocapmend.commands import EditSamples


class TakenOff(QObject):
    """Watches the steps, and adds what they take off to what is told of them.

    Signals
    -------
    message : str
        Something the user should read in passing.
    """

    message = Signal(str)

    def __init__(self, stack: QUndoStack, parent: QObject | None = None) -> None:
        super().__init__(parent)
        self._stack = stack
        self._index = stack.index()
        self._note = ""
        # What else is told of a step comes right after it: it shall not be written over.
        self._alone = QTimer(self)
        self._alone.setSingleShot(True)
        self._alone.setInterval(0)
        self._alone.timeout.connect(self._say_alone)
        stack.indexChanged.connect(self._look)

    def say(self, text: str) -> None:
        """Tell something, and with it what the last step took off."""
        note, self._note = self._note, ""
        self._alone.stop()
        if text or note:
            self.message.emit(" ".join(filter(None, (text, note))))

    def _say_alone(self) -> None:
        self.say("")

    def _look(self, index: int) -> None:
        done, self._index = index > self._index, index
        command = self._stack.command(index - 1) if done else None
        off = _gone(command) if isinstance(command, EditSamples) else 0
        if off:
            self._note = self.tr(
                "Smoothing that depends on this was taken off, stretches: {0}. Smooth again at the "
                "end."
            ).format(off)
            self._alone.start()


def _gone(command: EditSamples) -> int:
    """Return how many runs a step takes smoothing off, those that it smooths anew left out."""
    anew = [edit.gap for edit in command.edits if edit.smoothed is not None]
    return sum(
        not any(
            run.marker == edit.gap.marker
            and run.start <= edit.gap.start
            and edit.gap.stop <= run.stop
            for run in anew
        )
        for edit in command.unsmoothed
    )
