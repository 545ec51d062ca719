"""The tour: a few callouts beside the real widgets, which work meanwhile."""

from collections.abc import Callable
from dataclasses import dataclass
from typing import TYPE_CHECKING

from PySide6.QtCore import QEvent, QObject, Qt, QTimer
from PySide6.QtGui import QKeyEvent
from PySide6.QtWidgets import QApplication, QWidget

from mocapmend.actions import key_texts
from mocapmend.settings import TOUR_SHOWN
from mocapmend.views.callout import Callout
from mocapmend.views.samples import sample_recordings

if TYPE_CHECKING:
    from mocapmend.views.main_window import MainWindow


@dataclass(frozen=True)
class Step:
    """A stop of the tour.

    Attributes
    ----------
    text : str
        What the user reads.
    target : callable
        Returns the widget of a window that it is about, or None.
    done_by : tuple of str
        Ids of the actions that end the step.
    """

    text: str
    target: "Callable[[MainWindow], QWidget | None]"
    done_by: tuple[str, ...] = ()


class Tour(QObject):
    """Leads a window through the main job once; every step can be left out.

    Parameters
    ----------
    window : MainWindow
        Is shown.
    """

    def __init__(self, window: "MainWindow") -> None:
        super().__init__(window)
        self._window = window
        self._index = -1
        self._steps = self._make_steps()
        self._callout = Callout(window, window.theme)
        self._callout.next_button.clicked.connect(self._go_on)
        self._callout.skip_button.clicked.connect(self.end)
        window.appearance.changed.connect(self._take_theme)
        window.documents.switched.connect(self._see_document)
        for name in {name for step in self._steps for name in step.done_by}:
            window.actions_by_id[name].triggered.connect(self._see_action)

    @property
    def step(self) -> int:
        """Number of the step that is shown, from 0."""
        return self._index

    @property
    def callout(self) -> Callout:
        """What is shown."""
        return self._callout

    def begin(self) -> None:
        """Show the first step; it counts as shown to this user from now on."""
        self._window.settings.set(TOUR_SHOWN, value=True)
        # Escape must end it wherever the keyboard is.
        app = QApplication.instance()
        assert app is not None
        app.installEventFilter(self)
        self._show(0 if self._window.workspace is None else 1)

    def end(self) -> None:
        """Go away."""
        app = QApplication.instance()
        assert app is not None
        app.removeEventFilter(self)
        self._callout.hide()
        self._callout.deleteLater()
        self.deleteLater()

    def eventFilter(self, watched: QObject, event: QEvent) -> bool:
        if event.type() not in (QEvent.Type.ShortcutOverride, QEvent.Type.KeyPress):
            return False
        if not isinstance(event, QKeyEvent) or event.key() != Qt.Key.Key_Escape:
            return False
        if not isinstance(watched, QWidget) or watched.window() is not self._window:
            return False
        event.accept()
        if event.type() == QEvent.Type.KeyPress:
            self.end()
        return True

    # --- going on ----------------------------------------------------------------------------

    def _show(self, index: int) -> None:
        if index >= len(self._steps):
            self.end()
            return
        self._index = index
        step = self._steps[index]
        last = index == len(self._steps) - 1
        self._callout.show_step(
            step.text,
            self.tr("Step {0} of {1}").format(index + 1, len(self._steps)),
            self.tr("Open a sample")
            if index == 0
            else self.tr("Done")
            if last
            else self.tr("Next"),
        )
        target, workspace = step.target(self._window), self._window.workspace
        if target is not None and workspace is not None:
            workspace.raise_pane(target)
        # Later: what was just opened or raised has its place then.
        QTimer.singleShot(0, self, self._place)

    def _place(self) -> None:
        self._callout.point_at(self._steps[self._index].target(self._window))

    def _go_on(self) -> None:
        if self._index == 0:
            self._window.open(sample_recordings()[0][0])
        else:
            self._show(self._index + 1)

    def _see_document(self) -> None:
        if self._window.workspace is None:
            self._show(0)
        else:
            # What it has pointed at is out of sight, or gone.
            self._show(max(1, self._index))

    def _see_action(self) -> None:
        if self.sender().objectName() in self._steps[self._index].done_by:
            self._show(self._index + 1)

    def _take_theme(self) -> None:
        self._callout.set_theme(self._window.theme)

    # --- the steps ---------------------------------------------------------------------------

    def _key(self, name: str) -> str:
        texts = key_texts(self._window.actions_by_id[name])
        return texts[0] if texts else "—"

    def _make_steps(self) -> list[Step]:
        return [
            Step(
                self.tr("Welcome. Open a recording: drop a file here, or begin with a sample."),
                lambda window: window.welcome.samples,
            ),
            Step(
                self.tr(
                    "Each lane is a marker, orange is where it is missing. "
                    "Press {0} to go to the next gap, or double-click one."
                ).format(self._key("next_gap")),
                _pane("timeline"),
                ("next_gap", "previous_gap"),
            ),
            Step(
                self.tr(
                    "The bold curve is the proposed repair with its 90 % band. "
                    "Nothing is changed yet. {0} shows another method."
                ).format(self._key("next_method")),
                _pane("trajectories"),
                ("next_method", "previous_method"),
            ),
            Step(
                self.tr(
                    "Here is how far off the repair is expected to be. {0} applies it, {1} takes "
                    "it back, and {2} repairs all gaps up to the limit."
                ).format(self._key("apply"), self._key("undo"), self._key("fill_all")),
                _pane("repair"),
                ("apply", "apply_next", "fill_all"),
            ),
            Step(
                self.tr(
                    "The Report tab compares before and after ({0}), the History tab goes back to "
                    "any step ({1})."
                ).format(self._key("show_report"), self._key("show_history")),
                _pane("timeline"),
                ("show_report", "show_history"),
            ),
            Step(
                self.tr(
                    "{0} writes a repaired copy in which nothing else changes, and proves it. "
                    "{1} finds everything that the program can do."
                ).format(self._key("export"), self._key("palette")),
                lambda window: window.toolbar.widgetForAction(window.actions_by_id["export"]),
                ("export", "palette"),
            ),
        ]


def _pane(name: str) -> "Callable[[MainWindow], QWidget | None]":
    """Return what finds a part of the recording that is seen."""
    return lambda window: None if window.workspace is None else getattr(window.workspace, name)
