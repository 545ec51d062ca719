"""Arrangements of the panes that the user has given names."""

from base64 import b64decode, b64encode
from typing import TYPE_CHECKING

from PySide6.QtCore import QObject
from PySide6.QtWidgets import QInputDialog, QMenu

from mocapmend.settings import LAYOUTS

if TYPE_CHECKING:
    from mocapmend.views.main_window import MainWindow


class Layouts(QObject):
    """Saves, shows and deletes layouts.

    Parameters
    ----------
    window : MainWindow
        Whose panes are arranged.
    """

    def __init__(self, window: "MainWindow") -> None:
        super().__init__(window)
        self._window = window

    @property
    def names(self) -> list[str]:
        """The names of all layouts, in order."""
        return sorted(self._kept(), key=str.casefold)

    def _kept(self) -> dict[str, object]:
        kept: dict[str, object] = self._window.settings.get(LAYOUTS)
        return kept

    def ask_and_save(self) -> None:
        """Let the user name the layout of the panes, and remember it; an old one is replaced."""
        name, go = QInputDialog.getText(
            self._window, self.tr("Save this layout"), self.tr("Name of the layout:")
        )
        if go and name.strip():
            self.save(name.strip())

    def save(self, name: str) -> None:
        """Remember where the panes are, under a name."""
        workspace = self._window.workspace
        if workspace is None or not workspace.arranged:
            return
        state = b64encode(workspace.layout_state()).decode()
        self._window.settings.set(LAYOUTS, {**self._kept(), name: state})
        self._window.say(self.tr("Layout saved: {0}").format(name))

    def choose(self, name: str) -> None:
        """Put the panes where a layout has them."""
        workspace = self._window.workspace
        if workspace is None:
            return
        state = self._kept().get(name)
        try:
            raw = b64decode(state) if isinstance(state, str) else b""
        except ValueError:
            raw = b""
        if not workspace.restore_layout(raw):
            text = self.tr("The layout {0} is of another version and does not fit: save it anew.")
            self._window.say(text.format(name))

    def delete(self, name: str) -> None:
        """Forget a layout."""
        kept = self._kept()
        kept.pop(name, None)
        self._window.settings.set(LAYOUTS, kept)
        self._window.say(self.tr("Layout deleted: {0}").format(name))

    def fill(self, menu: QMenu, possible: bool) -> None:  # noqa: FBT001 - says if it is enabled
        """Put an entry per layout at the end of a menu, and a menu to delete them."""
        names = self.names
        if not names:
            return
        menu.addSeparator()
        for name in names:
            action = menu.addAction(name.replace("&", "&&"))
            action.setEnabled(possible)
            action.triggered.connect(lambda _=False, name=name: self.choose(name))
        delete = menu.addMenu(self.tr("Delete"))
        for name in names:
            action = delete.addAction(name.replace("&", "&&"))
            action.triggered.connect(lambda _=False, name=name: self.delete(name))
