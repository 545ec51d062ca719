"""The trajectory plots with a row of switches for what they show."""

from collections.abc import Mapping

from PySide6.QtCore import Qt
from PySide6.QtGui import QAction
from PySide6.QtWidgets import QComboBox, QToolBar, QVBoxLayout, QWidget

from mocapmend.document import Document
from mocapmend.settings import PLOTS, SAME_SCALE, Settings
from mocapmend.theme import Theme
from mocapmend.views.frame_icons import draw_extension
from mocapmend.views.quantities import Quantity
from mocapmend.views.trajectories import Trajectories
from mocapmend.viewstate import ViewState

CHOICES: dict[str, tuple[Quantity, ...]] = {
    "plot_position": (Quantity.X, Quantity.Y, Quantity.Z),
    "plot_speed": (Quantity.SPEED,),
    "plot_acceleration": (Quantity.ACCELERATION,),
    "plot_residual": (Quantity.RESIDUAL,),
    "plot_bone": (Quantity.BONE,),
}
"""The quantities that an action switches on and off, in the order of the plots."""
SETS = (
    {"plot_position"},
    {"plot_speed", "plot_acceleration"},
    {"plot_residual"},
    {"plot_bone"},
)
"""What a key goes through: positions, motion, residuals, bone lengths."""


class PlotPane(QWidget):
    """Chooses what the trajectory plots show."""

    def __init__(
        self,
        document: Document,
        view: ViewState,
        settings: Settings,
        theme: Theme,
        actions: Mapping[str, QAction],
        parent: QWidget | None = None,
    ) -> None:
        super().__init__(parent)
        self._document = document
        self._view = view
        self._settings = settings
        self._actions = actions
        self._chosen = {name for name in CHOICES if name in settings.get(PLOTS)}
        self.trajectories = Trajectories(document, view, theme)
        self._bones = self._make_bones()
        self._bar = self._make_bar()
        draw_extension(self._bar, theme)
        layout = QVBoxLayout(self)
        layout.setContentsMargins(0, 0, 0, 0)
        layout.setSpacing(0)
        layout.addWidget(self._bar)
        layout.addWidget(self._bones)
        layout.addWidget(self.trajectories, 1)
        view.selection_changed.connect(self._offer_bones)
        document.skeleton_changed.connect(self._offer_bones)
        document.names_changed.connect(self._offer_bones)
        self._offer_bones()
        self._show_choice()
        for name in CHOICES:
            actions[name].setChecked(name in self._chosen)
        actions["same_scale"].setChecked(settings.get(SAME_SCALE))

    def show_plots(self, name: str, on: bool) -> None:  # noqa: FBT001 - a slot of toggled(bool)
        """Switch the plots of an action on or off, and remember it."""
        chosen = self._chosen | {name} if on else self._chosen - {name}
        if chosen != self._chosen:
            self._chosen = chosen
            self._settings.set(PLOTS, [name for name in CHOICES if name in chosen])
            self._show_choice()

    def step_plots(self, step: int) -> None:
        """Show the next (1) or previous (-1) set of plots; the first from any other choice."""
        at = SETS.index(self._chosen) if self._chosen in SETS else -step
        wanted = SETS[(at + step) % len(SETS)]
        # On before off: without any the hint would flash.
        for name in sorted(CHOICES, key=lambda name: name not in wanted):
            self._actions[name].setChecked(name in wanted)

    def set_same_scale(self, on: bool) -> None:  # noqa: FBT001 - a slot of toggled(bool)
        """Make x, y and z comparable or let each fill its plot, and remember it."""
        self._settings.set(SAME_SCALE, on)
        self.trajectories.set_same_scale(on)

    def step_bone(self, step: int) -> None:
        """Plot the length of the next (1) or previous (-1) bone of the current marker."""
        self._actions["plot_bone"].setChecked(True)
        count = self._bones.count()
        if count:
            self._bones.setCurrentIndex((self._bones.currentIndex() + step) % count)

    def set_theme(self, theme: Theme) -> None:
        """Paint with other colours from now on."""
        self.trajectories.set_theme(theme)
        draw_extension(self._bar, theme)

    # --- making ------------------------------------------------------------------------------

    def _make_bones(self) -> QComboBox:
        bones = QComboBox()
        bones.setAccessibleName(self.tr("Bone"))
        bones.setToolTip(self.tr("The two markers whose distance is plotted (B for the next)"))
        bones.setPlaceholderText(self.tr("no bone here"))
        bones.setSizeAdjustPolicy(QComboBox.SizeAdjustPolicy.AdjustToMinimumContentsLengthWithIcon)
        bones.setMinimumContentsLength(10)
        bones.setFocusPolicy(Qt.FocusPolicy.TabFocus)
        bones.currentIndexChanged.connect(self._plot_bone)
        return bones

    def _make_bar(self) -> QToolBar:
        bar = QToolBar()
        bar.setToolButtonStyle(Qt.ToolButtonStyle.ToolButtonTextOnly)
        short = {
            "plot_position": self.tr("XYZ"),
            "plot_speed": self.tr("Speed"),
            "plot_acceleration": self.tr("Accel."),
            "plot_residual": self.tr("Residual"),
            "plot_bone": self.tr("Bone"),
            "same_scale": self.tr("1:1"),
        }
        for name in CHOICES:
            bar.addAction(self._actions[name])
        bar.addAction(self._actions["same_scale"])
        for name, text in short.items():
            self._actions[name].setIconText(text)
        return bar

    # --- showing -----------------------------------------------------------------------------

    def _show_choice(self) -> None:
        quantities = [q for name, some in CHOICES.items() if name in self._chosen for q in some]
        self._bones.setVisible("plot_bone" in self._chosen)
        self.trajectories.set_quantities(tuple(quantities))

    def _offer_bones(self) -> None:
        """List the two markers selected last, and the bones of the current one."""
        before = self._pair(self._bones.currentIndex())
        selection, marker = self._view.selection, self._view.marker
        last_two = selection[-2:] if len(selection) > 1 else None
        bones = [bone for bone in self._document.skeleton.bones if marker in bone]
        pairs: dict[frozenset[int], tuple[int, ...]] = {}
        for pair in bones if last_two is None else (last_two, *bones):
            pairs.setdefault(frozenset(pair), pair)
        names = self._document.names
        self._bones.blockSignals(True)  # noqa: FBT003 - Qt's own signature
        self._bones.clear()
        for one, other in pairs.values():
            self._bones.addItem(f"{names[one]} – {names[other]}", (one, other))
        offered = list(pairs.values())
        kept = offered.index(before) if last_two is None and before in offered else 0
        self._bones.setCurrentIndex(kept if offered else -1)
        self._bones.blockSignals(False)  # noqa: FBT003 - Qt's own signature
        self._plot_bone()

    def _pair(self, index: int) -> tuple[int, int] | None:
        data = self._bones.itemData(index)
        return None if data is None else (data[0], data[1])

    def _plot_bone(self) -> None:
        self.trajectories.set_bone(self._pair(self._bones.currentIndex()))
