"""The row of buttons under the menus."""

from collections.abc import Mapping

from PySide6.QtCore import Qt
from PySide6.QtGui import QAction
from PySide6.QtWidgets import QToolBar, QWidget

from mocapmend.theme import Theme
from mocapmend.views.icons import icon

ICONS = (
    "open", "export", "undo", "redo", "previous_gap", "next_gap", "apply", "fill_all",
    "play", "follow", "labels", "trails",
)  # fmt: skip
BUTTONS = (
    "open", "export", None, "undo", "redo", None, "previous_gap", "next_gap", "apply", "fill_all",
    None, "follow", "labels", "trails", None,
)  # fmt: skip


def fill_toolbar(bar: QToolBar, actions: Mapping[str, QAction], last: QWidget) -> None:
    """Put the buttons of some actions into a tool bar, and a widget behind them."""
    bar.setObjectName("tools")
    bar.setMovable(False)
    bar.setContextMenuPolicy(Qt.ContextMenuPolicy.PreventContextMenu)
    for name in BUTTONS:
        if name is None:
            bar.addSeparator()
        else:
            bar.addAction(actions[name])
    bar.addWidget(last)


def draw_icons(actions: Mapping[str, QAction], theme: Theme, scale: float) -> None:
    """Give the actions that have icons those of a theme, for text of some size."""
    for name in ICONS:
        actions[name].setIcon(icon(name, theme, scale))
