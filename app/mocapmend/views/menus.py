"""The menu bar: the table of actions, and the lists that are made when they are looked at."""

from collections.abc import Sequence
from pathlib import Path
from typing import TYPE_CHECKING

from PySide6.QtCore import QObject
from PySide6.QtGui import QAction, QActionGroup
from PySide6.QtWidgets import QMenu

from mocapmend.action_table import ACTIONS, MENUS, ActionSpec
from mocapmend.actions import menu_title, submenu_of
from mocapmend.views import appearance, language

if TYPE_CHECKING:
    from mocapmend.views.main_window import MainWindow


class Menus(QObject):
    """The menus of a window.

    Parameters
    ----------
    window : MainWindow
        Has the actions and the open recordings.
    """

    def __init__(self, window: "MainWindow") -> None:
        super().__init__(window)
        self._window = window
        self._menus: dict[str, QMenu] = {}
        bar = window.menuBar()
        for name in MENUS:
            self._menus[name] = bar.addMenu(menu_title(name))
        for spec in ACTIONS:
            if spec.starts_group:
                self._menus.get(_path(spec), self._menus[spec.menu]).addSeparator()
            self._menu_of(spec).addAction(window.actions_by_id[spec.id])
        self._group("theme", appearance.CHOICES)
        self._group("language", language.CHOICES)
        layouts = window.actions_by_id["first_layout"].associatedObjects()
        self.layouts = next(each for each in layouts if isinstance(each, QMenu))
        self._fixed = len(self.layouts.actions())
        self.layouts.aboutToShow.connect(self._fill_layouts)
        self.recent = QMenu(self.tr("Open recent"), window)
        self.recent.setToolTipsVisible(True)
        self.recent.aboutToShow.connect(self._fill_recent)
        self._menus["File"].insertMenu(window.actions_by_id["export"], self.recent)
        self.panes = self._menus["View"].addMenu(self.tr("Panes"))
        self.panes.aboutToShow.connect(self._fill_panes)

    def _group(self, name: str, choices: Sequence[str]) -> None:
        """Make one of several actions the chosen one."""
        group = QActionGroup(self)
        for choice in choices:
            group.addAction(self._window.actions_by_id[f"{name}_{choice}"])

    def _menu_of(self, spec: ActionSpec) -> QMenu:
        if not spec.submenu:
            return self._menus[spec.menu]
        path = _path(spec)
        if path not in self._menus:
            self._menus[path] = self._menus[spec.menu].addMenu(submenu_of(spec))
        return self._menus[path]

    def _fill_recent(self) -> None:
        self.recent.clear()
        recent = self._window.recent
        for text in recent.paths:
            name, there = Path(text).name.replace("&", "&&"), text not in recent.gone
            action = QAction(name if there else self.tr("{0} (gone)").format(name), self.recent)
            action.setToolTip(text)
            action.setEnabled(there)
            action.triggered.connect(lambda _=False, text=text: self._window.open(Path(text)))
            self.recent.addAction(action)
        if not recent.paths:
            self.recent.addAction(self.tr("None yet")).setEnabled(False)
            return
        self.recent.addSeparator()
        if recent.gone.intersection(recent.paths):
            self.recent.addAction(self.tr("Remove files that are gone"), recent.forget_gone)
        self.recent.addAction(self.tr("Clear the list"), self._forget_all)
        recent.look()

    def _forget_all(self) -> None:
        self._window.recent.forget(*self._window.recent.paths)

    def _fill_layouts(self) -> None:
        for action in self.layouts.actions()[self._fixed :]:
            self.layouts.removeAction(action)
            action.deleteLater()
        self._window.layouts.fill(
            self.layouts, self._window.actions_by_id["first_layout"].isEnabled()
        )

    def _fill_panes(self) -> None:
        self.panes.clear()
        workspace = self._window.workspace
        if workspace is None or not workspace.panes():
            self.panes.addAction(self.tr("None without markers")).setEnabled(False)
            return
        for pane in workspace.panes():
            self.panes.addAction(pane.toggleViewAction())
        self.panes.addSeparator()
        self.panes.addAction(self._window.actions_by_id["first_layout"])


def _path(spec: ActionSpec) -> str:
    """Return the name under which an action's submenu is kept."""
    return f"{spec.menu}/{spec.submenu}"
