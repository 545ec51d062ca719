"""Keys that belong to the widget that has the focus, although an action has them too."""

from PySide6.QtCore import QEvent, QObject, Qt
from PySide6.QtGui import QKeyEvent
from PySide6.QtWidgets import (
    QAbstractButton,
    QAbstractSpinBox,
    QComboBox,
    QLineEdit,
    QPushButton,
    QTabBar,
    QWidget,
)

_ENTER = {Qt.Key.Key_Return, Qt.Key.Key_Enter}
_DONE = _ENTER | {Qt.Key.Key_Escape}
_CLAIMED: dict[type[QWidget], set[Qt.Key]] = {
    QAbstractSpinBox: _DONE | {Qt.Key.Key_Home, Qt.Key.Key_End},
    QLineEdit: _DONE,
    QPushButton: _ENTER | {Qt.Key.Key_Space},
    QAbstractButton: {Qt.Key.Key_Space},
    QComboBox: {Qt.Key.Key_Space},
    QTabBar: {Qt.Key.Key_Left, Qt.Key.Key_Right},
}
"""Which keys a kind of widget keeps; the first kind that fits counts."""


class KeyGuard(QObject):
    """Lets keys do to a focused button or field what they do everywhere.

    Space and Enter press a button, Enter commits a number or a text and Escape leaves it; after
    that the focus goes back to the window, so that its shortcuts work again. The wheel turns a
    field that has the focus and scrolls over any other.
    """

    def guard(self, root: QWidget) -> None:
        """Watch all buttons, combo boxes and fields below a widget."""
        for kind in _CLAIMED:
            for widget in root.findChildren(kind):
                widget.installEventFilter(self)
                if widget.focusPolicy() == Qt.FocusPolicy.WheelFocus:
                    widget.setFocusPolicy(Qt.FocusPolicy.StrongFocus)

    def eventFilter(self, watched: QObject, event: QEvent) -> bool:
        if not isinstance(watched, QWidget):
            return False
        if event.type() == QEvent.Type.Wheel and not watched.hasFocus():
            event.ignore()
            return True
        if not isinstance(event, QKeyEvent):
            return False
        plain = event.modifiers() & ~Qt.KeyboardModifier.KeypadModifier
        if plain != Qt.KeyboardModifier.NoModifier:
            return False
        if event.type() == QEvent.Type.ShortcutOverride:
            field = self._field(watched)
            claimed = next((keys for kind, keys in _CLAIMED.items() if isinstance(field, kind)), ())
            if event.key() in claimed:
                event.accept()
                return True
        elif event.type() == QEvent.Type.KeyPress and event.key() in _DONE:
            return self._finish(self._field(watched), event)
        return False

    @staticmethod
    def _field(watched: QWidget) -> QWidget:
        """Return what takes the keys: the text of a list that can be typed in has no focus."""
        edit = watched.lineEdit() if isinstance(watched, QComboBox) else None
        return watched if edit is None else edit

    @staticmethod
    def _finish(watched: QWidget, event: QKeyEvent) -> bool:
        """Press a button by Enter; leave a field after Enter or Escape."""
        if isinstance(watched, QPushButton) and event.key() in _ENTER:
            watched.click()
            return True
        if isinstance(watched, QAbstractSpinBox):
            if event.key() in _ENTER:
                watched.interpretText()
            watched.window().setFocus()
            return True
        if isinstance(watched, QLineEdit):
            if event.key() == Qt.Key.Key_Escape:
                watched.clear()
            watched.window().setFocus()
            return True
        return False
