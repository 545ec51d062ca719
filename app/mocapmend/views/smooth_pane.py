"""The smoothing pane: what is smoothed and how, what it would do, and what is smoothed now."""

from collections import Counter
from collections.abc import Mapping
from dataclasses import fields, replace
from html import escape
from typing import Any

from PySide6.QtCore import QEvent, Qt, QTimer, Signal
from PySide6.QtGui import QAction, QShowEvent
from PySide6.QtWidgets import (
    QComboBox,
    QFormLayout,
    QHBoxLayout,
    QLabel,
    QScrollArea,
    QVBoxLayout,
    QWidget,
)

from mocapmend import wording
from mocapmend.document import Document
from mocapmend.settings import SMOOTHER, Settings
from mocapmend.smoothing import SmoothWay, found_nothing, runs_of
from mocapmend.theme import Theme
from mocapmend.views.action_button import ActionButton
from mocapmend.views.engine_texts import find, method_text, shown, smoother_name
from mocapmend.views.params_form import ParamsForm
from mocapmend.views.repair_panel import MOST_OF_SCREEN
from mocapmend.views.residual_plot import ResidualPlot
from mocapmend.views.smooth_table import SmoothTable
from mocapmend.views.smoothing import Smoothing
from mocapmend.views.tables import frames_text
from mocapmend.viewstate import ViewState
from mocapmend_algorithms import Gap
from mocapmend_algorithms.smooth.contract import SmoothResult
from mocapmend_algorithms.smooth.registry import SMOOTHERS, SUGGESTED

MOST_LOOKED_AT = 8
"""Of the selected markers, those selected last have a preview."""
MARGIN = 8
"""Pixels at both sides."""
MOST_NAMED, MOST_LISTED = 3, 20
TOO_SHORT = "Only {0} on end: this needs at least {1}."
"""Why most stretches are left as they are."""


class SmoothPane(QScrollArea):
    """Shows what can be smoothed; `Smoothing` does it.

    Signals
    -------
    rebuilt :
        There are new fields.
    """

    rebuilt = Signal()

    def __init__(
        self,
        document: Document,
        view: ViewState,
        smoothing: Smoothing,
        settings: Settings,
        theme: Theme,
        actions: Mapping[str, QAction],
        parent: QWidget | None = None,
    ) -> None:
        super().__init__(parent)
        self._document = document
        self._view = view
        self._smoothing = smoothing
        self._settings = settings
        self._params: dict[str, Any] = {}
        """By method id: what the user has changed lasts as long as the recording is open."""
        self.setWidgetResizable(True)
        self.setFrameShape(QScrollArea.Shape.NoFrame)
        self.setFocusPolicy(Qt.FocusPolicy.NoFocus)
        self.method = self._make_methods()
        self.markers = QComboBox()
        self.markers.setAccessibleName(self.tr("Which markers"))
        self.markers.addItems([self.tr("Selected markers"), self.tr("All markers")])
        self.time = QComboBox()
        self.time.setAccessibleName(self.tr("Which frames"))
        self.time.addItems([self.tr("Whole recording"), self.tr("Selected frames")])
        self._apply = ActionButton(actions["smooth"], self.tr("Smooth"))
        self._take_off = ActionButton(actions["unsmooth"], self.tr("Take off"))
        self.form = ParamsForm()
        self.table = SmoothTable(document)
        self.plot = ResidualPlot(theme)
        self._now, self._note = _text_label(), _text_label()
        self._arrange()
        self._connect()
        self._show_method()
        self._show_span()

    # --- what it asks for --------------------------------------------------------------------

    @property
    def way(self) -> SmoothWay:
        """The chosen method and its parameters."""
        return SmoothWay(str(self.method.currentData()), self.form.params())

    @property
    def span(self) -> tuple[int, int] | None:
        """The frames that are chosen; None for the whole recording."""
        return self._view.span if self.time.currentIndex() == 1 else None

    def runs(self) -> list[Gap]:
        """Return what is to be smoothed."""
        return runs_of(self._document.state, self._chosen(), self.span)

    def apply(self) -> None:
        """Smooth what is chosen."""
        self._smoothing.apply(self.way, self.runs())

    def take_off(self) -> None:
        """Take the smoothing off what is chosen."""
        start, stop = self.span or (0, self._document.original.frames)
        self._smoothing.take_off([Gap(marker, start, stop) for marker in self._chosen()])

    def set_theme(self, theme: Theme) -> None:
        """Paint with other colours from now on."""
        self.plot.set_theme(theme)

    def _chosen(self) -> tuple[int, ...]:
        if self.markers.currentIndex() == 1:
            return tuple(range(self._document.original.markers))
        return self._view.selection

    # --- parts -------------------------------------------------------------------------------

    def _make_methods(self) -> QComboBox:
        box = QComboBox()
        box.setAccessibleName(self.tr("Smoothing method"))
        for smoother in SMOOTHERS.values():
            box.addItem(method_text(smoother.label), smoother.id)
            box.setItemData(
                box.count() - 1, method_text(smoother.help), Qt.ItemDataRole.ToolTipRole
            )
        remembered = self._settings.get(SMOOTHER)
        box.setCurrentIndex(box.findData(remembered if remembered in SMOOTHERS else SUGGESTED))
        return box

    def _arrange(self) -> None:
        scope = QFormLayout()
        scope.setVerticalSpacing(3)
        scope.addRow(self.tr("Method"), self.method)
        scope.addRow(self.tr("Smooth"), self.markers)
        scope.addRow(self.tr("In"), self.time)
        decide = QHBoxLayout()
        decide.addWidget(self._apply)
        decide.addWidget(self._take_off)
        body = QWidget()
        layout = QVBoxLayout(body)
        layout.setContentsMargins(MARGIN, 6, MARGIN, 6)
        layout.setSpacing(5)
        layout.addLayout(scope)
        # Above the parameters: where they stay whatever the method.
        layout.addLayout(decide)
        layout.addWidget(self._now)
        layout.addWidget(self.table)
        layout.addWidget(self._note)
        layout.addWidget(self.form)
        layout.addWidget(self.plot)
        layout.addStretch(1)
        self.setWidget(body)
        self._body = body
        self.setFocusProxy(self.method)

    def _connect(self) -> None:
        view, smoothing = self._view, self._smoothing
        self.method.currentIndexChanged.connect(self._choose_method)
        self.markers.currentIndexChanged.connect(self.refresh)
        self.time.currentIndexChanged.connect(self.refresh)
        self.form.changed.connect(self._take_params)
        self.form.rebuilt.connect(self.rebuilt)
        self.plot.picked.connect(self._give_cutoff)
        view.selection_changed.connect(self.refresh)
        view.span_changed.connect(self._show_span)
        self._document.samples_changed.connect(self.refresh)
        for show in (self._show_outlook, self._show_now):
            self._document.names_changed.connect(show)
        smoothing.looked.connect(self._show_outlook)
        smoothing.started.connect(self._show_possible)
        smoothing.ended.connect(self._show_possible)

    # --- what the user chooses ---------------------------------------------------------------

    def _choose_method(self) -> None:
        self._settings.set(SMOOTHER, str(self.method.currentData()))
        self._show_method()

    def _show_method(self) -> None:
        smoother = SMOOTHERS[str(self.method.currentData())]
        self.method.setToolTip(method_text(smoother.help))
        self.form.show_params(self._params.get(smoother.id, smoother.params()))
        self.refresh()

    def _take_params(self) -> None:
        self._params[self.way.method] = self.way.params
        self.refresh()

    def _give_cutoff(self, hz: float) -> None:
        way = self.way
        self._params[way.method] = replace(way.params, cutoff_hz=hz)
        self._show_method()

    def _show_span(self) -> None:
        """Offer the selected frames, where there are some."""
        span, first = self._view.span, self._document.original.first_frame
        text = self.tr("Selected frames")
        if span is not None:
            text = self.tr("Frames {0} – {1}").format(span[0] + first, span[1] - 1 + first)
        self.time.setItemText(1, text)
        item = self.time.model().index(1, 0)
        flags = Qt.ItemFlag.ItemIsEnabled | Qt.ItemFlag.ItemIsSelectable
        self.time.model().itemFromIndex(item).setFlags(  # type: ignore[attr-defined]
            Qt.ItemFlag.NoItemFlags if span is None else flags
        )
        if span is None:
            self.time.setCurrentIndex(0)
        self.refresh()

    # --- what it shows -----------------------------------------------------------------------

    def _take_room(self) -> None:
        """Be as wide as what is in it, unless that is much of the screen: then it is scrolled."""
        room = self.verticalScrollBar().sizeHint().width() + 2
        # The table has room also while there is nothing in it.
        table = self.table.minimumSizeHint().width() + 2 * MARGIN
        wanted = max(self._body.minimumSizeHint().width(), table) + room
        around = max(self.screen().size().width(), self.window().width())
        self.setMinimumWidth(min(wanted, round(MOST_OF_SCREEN * around)))

    def showEvent(self, event: QShowEvent) -> None:
        self._take_room()
        super().showEvent(event)

    def changeEvent(self, event: QEvent) -> None:
        super().changeEvent(event)
        if event.type() == QEvent.Type.EnabledChange:
            # A pane is enabled when it comes in sight.
            self.refresh()
        elif event.type() == QEvent.Type.FontChange and self.widget() is not None:
            # Later, when the fields have the new text too.
            QTimer.singleShot(0, self, self._take_room)

    def refresh(self) -> None:
        """Look at what smoothing would do to the selected markers, while the pane is in sight."""
        self._show_now()
        self._show_possible()
        if not self.isEnabled() or not self.isVisible():
            self._smoothing.look_away()
            return
        looked_at = self._view.selection[-MOST_LOOKED_AT:]
        runs = runs_of(self._document.state, looked_at, self.span)
        self._smoothing.look_ahead(self.way, runs, self._view.marker)

    def _show_possible(self) -> None:
        self._apply.set_possible(possible=self._smoothing.job is None and bool(self._chosen()))
        smoothed = {run.marker for run in self._document.smoothed}
        self._take_off.set_possible(possible=not smoothed.isdisjoint(self._chosen()))

    def _show_now(self) -> None:
        """Say how the current marker is smoothed."""
        document, marker = self._document, self._view.marker
        made = [
            (run, made) for run, made in sorted(document.smoothed.items()) if run.marker == marker
        ]
        if marker is None or not made:
            self._now.hide()
            return
        first, frames = document.original.first_frame, document.original.frames
        lines = [self.tr("<b>{0} is smoothed</b>").format(escape(document.names[marker]))]
        for run, how in made[:MOST_NAMED]:
            text = self.tr("{0}, {1} Hz, moved by {2} mm RMS").format(
                escape(smoother_name(how.method)),
                wording.cutoffs(how.chosen.get("cutoff_hz", ())) or "–",
                f"{how.rms * document.original.mm:.2f}",
            )
            if run.length < frames:
                text = f"{run.start + first} – {run.stop - 1 + first}: {text}"
            lines.append(text)
        if len(made) > MOST_NAMED:
            lines.append(self.tr("and {0} more stretches").format(len(made) - MOST_NAMED))
        self._now.setText("<br>".join(lines))
        self._now.show()

    def _show_outlook(self) -> None:
        outlook = self._smoothing.outlook
        result = None if outlook is None else outlook.result
        self.table.show_result(result, self._smoothing.is_applied)
        self.table.setVisible(result is not None and bool(result.runs))
        curve = None if outlook is None else outlook.curve
        chosen = () if result is None else self._cutoffs_of(result, self._view.marker)
        self.plot.show_curve(curve, chosen, self._document.original.mm)
        self.plot.setVisible(curve is not None)
        notes = [note for note in self._notes(result) if note]
        self._note.setText("<br>".join(notes))
        self._note.setVisible(bool(notes))
        self._note.setToolTip(self._list_untouched(result))

    def _cutoffs_of(self, result: SmoothResult, marker: int | None) -> tuple[float, ...]:
        of_marker = (done for done in result.runs if done.run.marker == marker)
        done = next(of_marker, None)
        return () if done is None else tuple(done.chosen.get("cutoff_hz", ()))

    def _notes(self, result: SmoothResult | None) -> list[str]:
        """Return what there is to know besides the numbers."""
        if result is None:
            if self._smoothing.refused:
                return [escape(self._smoothing.refused)]
            if not self._view.selection:
                return [self.tr("Select a marker to see what smoothing would do to it.")]
            return [self.tr("Computing the preview…") if self._smoothing.busy else ""]
        notes = []
        hidden = len(self._view.selection) - MOST_LOOKED_AT
        if hidden > 0:
            notes.append(
                self.tr("Preview of the {0} markers selected last.").format(MOST_LOOKED_AT)
            )
        rate, params = self._document.original.rate, self.way.params
        idle = [done for done in result.runs if found_nothing(done, params, rate)]
        if idle:
            named = ", ".join(self._document.names[done.run.marker] for done in idle[:MOST_NAMED])
            more = ", …" if len(idle) > MOST_NAMED else ""
            text = self.tr(
                "<b>Next to nothing was found to smooth</b> in {0}: the cut-off is close to half "
                "of the frame rate ({1} Hz)."
            ).format(escape(named) + more, f"{rate / 2:g}")
            notes.append(f"{text} {self._remedy()}")
        return notes + self._untouched(result)

    def _remedy(self) -> str:
        names = {field.name for field in fields(self.way.params)}
        if "cutoff_hz" in names:
            return self.tr("If you see jitter all the same, give a cut-off.")
        if "window_ms" in names:
            return self.tr("If you see jitter all the same, give a window.")
        return self.tr("If you see jitter all the same, give the measurement noise.")

    def _untouched(self, result: SmoothResult) -> list[str]:
        """Return how many stretches are left as they are, those that are too short as one."""
        reasons: Counter[str] = Counter()
        for entry in result.untouched:
            found = find(entry.reason)
            if found is not None and found[0] == TOO_SHORT:
                reasons[self.tr("Fewer than {0} samples on end.").format(found[1][1])] += 1
            else:
                reasons[shown(entry.reason)] += 1
        text = self.tr("Left as they are: stretches {0}. {1}")
        return [text.format(n, escape(why)) for why, n in reasons.most_common(MOST_NAMED)]

    def _list_untouched(self, result: SmoothResult | None) -> str:
        """Return where these stretches are."""
        entries = () if result is None else result.untouched
        first, names = self._document.original.first_frame, self._document.names
        lines = [
            f"{names[one.stretch.marker]} {frames_text(one.stretch, first)}: {shown(one.reason)}"
            for one in entries[:MOST_LISTED]
        ]
        return "\n".join([*lines, "…"] if len(entries) > MOST_LISTED else lines)


def _text_label() -> QLabel:
    label = QLabel()
    label.setWordWrap(True)
    label.setTextFormat(Qt.TextFormat.RichText)
    label.setAlignment(Qt.AlignmentFlag.AlignTop)
    return label
