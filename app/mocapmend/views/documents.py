"""The open recordings, each in a tab of its own."""

from collections import Counter
from collections.abc import Callable, Iterator
from pathlib import Path
from typing import TYPE_CHECKING, cast

from PySide6.QtCore import Qt, Signal
from PySide6.QtWidgets import QTabWidget, QWidget

if TYPE_CHECKING:
    from mocapmend.document import Document
    from mocapmend.files import Source
    from mocapmend.views.workspace import Workspace

LONGEST = 40
"""Characters of a file name that a tab shows."""


class Documents(QTabWidget):
    """Tabs of workspaces; the bar is only seen where there is a choice.

    Signals
    -------
    switched :
        Another workspace is the current one, or none is.
    counted :
        A workspace was added or removed.
    """

    switched = Signal()
    counted = Signal()

    def __init__(self, parent: QWidget | None = None) -> None:
        super().__init__(parent)
        self._shown: Workspace | None = None
        self.setDocumentMode(True)
        self.setTabsClosable(True)
        self.setMovable(True)
        self.setTabBarAutoHide(True)
        self.setElideMode(Qt.TextElideMode.ElideMiddle)
        self.tabBar().setAccessibleName(self.tr("Open recordings"))
        self.currentChanged.connect(self._follow)

    def __iter__(self) -> "Iterator[Workspace]":
        """Iterate over the workspaces, in the order of their tabs."""
        return iter([self.at(index) for index in range(self.count())])

    @property
    def current(self) -> "Workspace | None":
        """The workspace that is seen."""
        return self.at(self.currentIndex()) if self.count() else None

    def at(self, index: int) -> "Workspace":
        """Return the workspace of a tab."""
        return cast("Workspace", self.widget(index))

    def first(self, belongs: "Callable[[Source], bool]") -> "Workspace | None":
        """Return the first workspace whose recording fits, if one does."""
        return next((each for each in self if belongs(each.document.source)), None)

    def of_file(self, path: Path) -> "Workspace | None":
        """Return the workspace of a file that is open."""
        # What reads files is loaded when the first is opened.
        from mocapmend.files import same_file

        return self.first(lambda source: same_file(source.path, path))

    def of(self, document: "Document") -> "Workspace | None":
        """Return the workspace of a document, if it is still open."""
        return next((each for each in self if each.document is document), None)

    def add(self, workspace: "Workspace", instead_of: "Workspace | None" = None) -> None:
        """Show a workspace in a new tab, or in place of another one; that one is not ended."""
        place = -1 if instead_of is None else self.indexOf(instead_of)
        self.insertTab(place if place >= 0 else self.currentIndex() + 1, workspace, "")
        workspace.document.undo_stack.cleanChanged.connect(self._show_names)
        self.setCurrentWidget(workspace)
        self._show_names()
        self.counted.emit()

    def remove(self, workspace: "Workspace") -> None:
        """Take a workspace away."""
        self.removeTab(self.indexOf(workspace))
        self._show_names()
        self.counted.emit()

    def step(self, tabs: int) -> None:
        """Go to the next (1) or previous (-1) tab, round the ends."""
        if self.count():
            self.setCurrentIndex((self.currentIndex() + tabs) % self.count())

    def _follow(self) -> None:
        if self._shown is not None and self.indexOf(self._shown) >= 0:
            self._shown.leave()
        self._shown = self.current
        if self._shown is not None:
            self._shown.enter()
        self.switched.emit()

    def _show_names(self) -> None:
        names = Counter(each.document.source.path.name for each in self)
        for index, each in enumerate(self):
            path = each.document.source.path
            name = shortened(path.name)
            if names[path.name] > 1:
                name = f"{name} — {shortened(path.resolve().parent.name)}"
            mark = "" if each.saved else " *"
            self.setTabText(index, name.replace("&", "&&") + mark)
            self.setTabToolTip(index, str(path))


def shortened(name: str) -> str:
    """Return a name without its middle, if it is too long for a tab: ends tell files apart."""
    return name if len(name) <= LONGEST else f"{name[: LONGEST // 2]}…{name[-LONGEST // 2 :]}"
