"""A push button that does what an action of the menus does."""

from PySide6.QtCore import Qt
from PySide6.QtGui import QAction
from PySide6.QtWidgets import QPushButton


class ActionButton(QPushButton):
    """A push button for an action: enabled with it, and with its shortcut in the tool tip."""

    def __init__(self, action: QAction, text: str) -> None:
        super().__init__(text)
        self._action = action
        self._possible = True
        # A click must not take the keyboard from the rest of the window.
        self.setFocusPolicy(Qt.FocusPolicy.TabFocus)
        self.clicked.connect(action.trigger)
        # A method and not a lambda: the action outlives the button.
        action.changed.connect(self._follow)
        self._follow()

    def set_possible(self, *, possible: bool) -> None:
        """Say whether the action makes sense just now."""
        self._possible = possible
        self._follow()

    def _follow(self) -> None:
        self.setToolTip(self._action.toolTip())
        self.setEnabled(self._possible and self._action.isEnabled())
