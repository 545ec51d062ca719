"""Keys that belong to the widget that has the focus, although an action has them too."""

from PySide6.QtCore import QEvent, QObject, Qt
from PySide6.QtGui import QKeyEvent
from PySide6.QtWidgets import QAbstractButton, QAbstractSpinBox, QComboBox, QWidget

_SPACE = {Qt.Key.Key_Space}
_ENTER = {Qt.Key.Key_Return, Qt.Key.Key_Enter}
_STEP = {Qt.Key.Key_Home, Qt.Key.Key_End}


class KeyGuard(QObject):
    """Lets Space press a focused button and Enter commit a number, instead of their shortcuts."""

    def guard(self, root: QWidget) -> None:
        """Watch all buttons, combo boxes and number fields below a widget."""
        for kind in (QAbstractButton, QAbstractSpinBox, QComboBox):
            for widget in root.findChildren(kind):
                widget.installEventFilter(self)

    def eventFilter(self, watched: QObject, event: QEvent) -> bool:
        """Claim a key before the shortcuts get it."""
        if event.type() == QEvent.Type.ShortcutOverride and isinstance(event, QKeyEvent):
            number = isinstance(watched, QAbstractSpinBox)
            if event.key() in (_ENTER | _STEP if number else _SPACE):
                event.accept()
                return True
        return False
