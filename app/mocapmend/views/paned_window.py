"""A window of panes around a middle: where they are, and how that is remembered."""

from collections.abc import Sequence
from itertools import pairwise

from PySide6.QtCore import QByteArray, Qt, QTimer
from PySide6.QtWidgets import QDockWidget, QMainWindow, QTabWidget, QWidget

from mocapmend.settings import LAYOUT, Settings
from mocapmend.theme import Theme
from mocapmend.views.pane_titles import PaneTitles
from mocapmend.views.pane_widths import PaneWidths

LAYOUT_VERSION = 6


class PanedWindow(QMainWindow):
    """A part of the program's window that has panes of its own."""

    def __init__(self, settings: Settings, theme: Theme) -> None:
        super().__init__()
        self._settings = settings
        self._panes: list[QDockWidget] = []
        self._put_away: list[QWidget] = []
        self._first_layout = QByteArray()
        self.setWindowFlags(Qt.WindowType.Widget)
        self.setDockNestingEnabled(True)
        self.setTabPosition(Qt.DockWidgetArea.AllDockWidgetAreas, QTabWidget.TabPosition.North)
        bottom = Qt.DockWidgetArea.BottomDockWidgetArea
        self.setCorner(Qt.Corner.BottomLeftCorner, bottom)
        self.setCorner(Qt.Corner.BottomRightCorner, bottom)
        PaneWidths(self)
        self.titles = PaneTitles(self, theme)

    # --- panes -------------------------------------------------------------------------------

    def panes(self) -> list[QDockWidget]:
        """Return the panes around the middle, in the order in which they were made."""
        return self._panes

    def dock(self, name: str, title: str, content: QWidget, area: Qt.DockWidgetArea) -> QDockWidget:
        """Make a pane; its name is what its place is remembered by."""
        pane = QDockWidget(title)
        pane.setObjectName(name)
        pane.setWidget(content)
        # A pane behind another one would take the keyboard unseen.
        pane.visibilityChanged.connect(content.setEnabled)
        self.addDockWidget(area, pane)
        self._panes.append(pane)
        self.titles.add(pane)
        return pane

    def share_place(self, panes: Sequence[QDockWidget]) -> None:
        """Put panes behind each other, the first one in front."""
        for before, pane in pairwise(panes):
            self.tabifyDockWidget(before, pane)
        self.titles.fit()
        panes[0].raise_()

    def show_pane(self, content: QWidget) -> None:
        """Bring a pane to the front and give it the keyboard."""
        if self.raise_pane(content):
            # Later: what was behind another pane is enabled when it is seen.
            QTimer.singleShot(0, content, content.setFocus)

    def raise_pane(self, content: QWidget) -> bool:
        """Bring a pane to the front; return whether there is one of that content."""
        for pane in self._panes:
            if pane.widget() is content:
                pane.show()
                pane.raise_()
                return True
        return False

    # --- layouts -----------------------------------------------------------------------------

    @property
    def arranged(self) -> bool:
        """Whether the panes are where the user had them last."""
        return not self._first_layout.isEmpty()

    def remember_first_layout(self) -> None:
        """Note where the panes are when the program is new, and put them where they were last."""
        self._first_layout = self.saveState(LAYOUT_VERSION)
        self.restore_last_layout()

    def restore_first_layout(self) -> None:
        """Put all panes back where they were when the program was new."""
        self.restore_layout(bytes(self._first_layout.data()))

    def restore_last_layout(self) -> None:
        """Put all panes where they were last, once it is known where they belong."""
        if self.arranged:
            self.restore_layout(self._settings.get(LAYOUT))

    def save_layout(self) -> None:
        """Remember where the panes are."""
        if self.arranged:
            self._settings.set(LAYOUT, self.layout_state())

    def layout_state(self) -> bytes:
        """Return where the panes are."""
        return bytes(self.saveState(LAYOUT_VERSION).data())

    def restore_layout(self, state: bytes) -> bool:
        """Put the panes where `layout_state` had them; False if it is of another version."""
        restored = self.restoreState(state, LAYOUT_VERSION)
        self.titles.fit()
        return restored

    # --- windows that belong to it -----------------------------------------------------------

    def put_windows_away(self) -> None:
        """Hide panes that float and dialogs: they do not go with what they belong to."""
        children = Qt.FindChildOption.FindDirectChildrenOnly
        self._put_away = [
            each
            for each in self.findChildren(QWidget, options=children)
            if each.isWindow() and each.isVisible()
        ]
        for window in self._put_away:
            window.hide()

    def bring_windows_back(self) -> None:
        """Show again what was put away."""
        for window in self._put_away:
            window.show()
        self._put_away = []
