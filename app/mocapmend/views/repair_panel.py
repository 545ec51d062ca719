"""The repair pane: the current gap, its repairs side by side, and filling all at once."""

from collections.abc import Sequence
from html import escape
from typing import Any

import numpy as np
from PySide6.QtCore import QEvent, Qt, QTimer, Signal
from PySide6.QtGui import QAction, QShowEvent
from PySide6.QtWidgets import (
    QGroupBox,
    QHBoxLayout,
    QLabel,
    QPushButton,
    QScrollArea,
    QVBoxLayout,
    QWidget,
)

from mocapmend.document import Document
from mocapmend.files.records import NO_REASON
from mocapmend.names import new_names, with_donors
from mocapmend.prospects import Preview, Way
from mocapmend.settings import COMPARE, METHOD, Settings
from mocapmend.suspects import Suspects
from mocapmend.trimming import hidden
from mocapmend.views.action_button import ActionButton
from mocapmend.views.candidate_list import CandidateList
from mocapmend.views.engine_texts import method_name, method_text, shown
from mocapmend.views.fix_first import FixFirst
from mocapmend.views.limits_box import LimitsBox
from mocapmend.views.method_box import MethodBox
from mocapmend.views.params_form import ParamsForm
from mocapmend.views.suspect_box import SuspectBox
from mocapmend.viewstate import ViewState
from mocapmend_algorithms import Gap
from mocapmend_algorithms.fill.contract import Patch
from mocapmend_algorithms.fill.registry import METHODS

PANEL_WIDTH = 270
MOST_OF_SCREEN = 0.32
"""Of its width, that the panel takes for itself."""
MOST_DONORS = 6
"""That are listed: the methods name the best ones first."""


class RepairPanel(QScrollArea):
    """Shows what can be done about the current gap or problem; doing it is the window's job.

    Signals
    -------
    ways_changed :
        Another method is chosen, others are compared, or the parameters are others.
    rebuilt :
        There are new fields.
    """

    ways_changed = Signal()
    rebuilt = Signal()

    def __init__(
        self,
        document: Document,
        view: ViewState,
        suspects: Suspects,
        settings: Settings,
        actions: dict[str, QAction],
        parent: QWidget | None = None,
    ) -> None:
        super().__init__(parent)
        self._document = document
        self._view = view
        self._settings = settings
        self._params: dict[str, Any] = {}
        """By method id: what the user has changed lasts as long as the recording is open."""
        self._labels = document.labels
        self._names = dict(zip(document.labels, document.names, strict=True))
        self.setWidgetResizable(True)
        self.setFrameShape(QScrollArea.Shape.NoFrame)
        self.setFocusPolicy(Qt.FocusPolicy.NoFocus)
        body = QWidget()
        layout = QVBoxLayout(body)
        layout.setContentsMargins(8, 2, 8, 2)
        layout.setSpacing(4)
        self._gap_box = self._make_gap_box(actions)
        self._suspect_box = SuspectBox(document, view, suspects, actions)
        layout.addWidget(self._gap_box)
        layout.addWidget(self._suspect_box)
        layout.addWidget(self._make_all_box(actions))
        layout.addStretch(1)
        self.setWidget(body)
        self._body = body
        self._take_room()
        self._show_method()
        view.selection_changed.connect(self._offer_donors)
        view.gap_changed.connect(self._offer_donors)
        view.gap_changed.connect(self._show_gap)
        view.suspect_changed.connect(self._show_either)
        view.preview_changed.connect(self._show_gap)
        view.picked.connect(self._pick)
        document.samples_changed.connect(self._show_gap)
        document.left_open_changed.connect(self._show_gap)
        document.names_changed.connect(self._rename)
        self._show_gap()

    def _take_room(self) -> None:
        """Be as wide as what is in it, unless that is much of the screen: then it is scrolled."""
        room = self.verticalScrollBar().sizeHint().width() + 2
        wanted = self._body.minimumSizeHint().width() + room
        around = max(self.screen().size().width(), self.window().width())
        self.setMinimumWidth(max(PANEL_WIDTH, min(wanted, round(MOST_OF_SCREEN * around))))

    def showEvent(self, event: QShowEvent) -> None:
        self._take_room()
        super().showEvent(event)

    def changeEvent(self, event: QEvent) -> None:
        super().changeEvent(event)
        if event.type() == QEvent.Type.FontChange and self.widget() is not None:
            # Later, when the fields have the new text too.
            QTimer.singleShot(0, self, self._take_room)

    # --- what it asks for --------------------------------------------------------------------

    def method(self) -> Way:
        """Return the chosen method and its parameters."""
        return Way(self._method.method.id, self._form.params())

    def compared(self) -> list[Way]:
        """Return the methods that are compared, in the order of their numbers."""
        if not self._settings.get(COMPARE):
            return []
        chosen = self.method()
        return [
            chosen if name == chosen.method else Way(name, self._params_of(name))
            for name in self._candidates.methods
        ]

    def step_method(self, step: int) -> None:
        """Choose the next or the previous method of the list."""
        self._method.step(step)

    def choose_way(self, way: Way) -> None:
        """Choose a method with other parameters than its own."""
        self._params[way.method] = way.params
        if way.method == self._method.method.id:
            self._show_method()
        else:
            self._choose(way.method)

    def pick_candidate(self, number: int) -> None:
        """Choose the method with a number of the comparison, counted from 1."""
        if number <= len(self._candidates.methods):
            self._choose(self._candidates.methods[number - 1])

    def set_comparing(self, on: bool) -> None:  # noqa: FBT001 - a slot of toggled(bool)
        """Compute the repairs by other methods too, or the chosen one alone."""
        self._settings.set(COMPARE, on)
        self._candidates.setVisible(on)
        self.ways_changed.emit()

    @property
    def takes_donors(self) -> bool:
        """Whether the chosen method lets the user name donors."""
        return hasattr(self._form.params(), "donors")

    def show_problem(self) -> None:
        """Show what is known of the current bad samples by now."""
        self._suspect_box.refresh()

    def show_filling(self, *, running: bool) -> None:
        """Tell whether filling all is going on."""
        self._fill_all.set_possible(possible=not running)

    def show_outcome(self, text: str, *, open_gaps: bool) -> None:
        """Say what filling all has done."""
        self._outcome.setText(text)
        self._outcome.setVisible(bool(text))
        self.left_open.setVisible(open_gaps)
        if text:
            # Later, when the layout has made room for it.
            last = self.left_open if open_gaps else self._outcome
            QTimer.singleShot(0, self, lambda: self._show_end(last))

    def _show_end(self, last: QWidget) -> None:
        """Scroll down to what is last, never sideways."""
        sideways = self.horizontalScrollBar().value()
        self.ensureWidgetVisible(last)
        self.horizontalScrollBar().setValue(sideways)

    # --- parts -------------------------------------------------------------------------------

    def _make_gap_box(self, actions: dict[str, QAction]) -> QGroupBox:
        box = QGroupBox(self.tr("Current gap"))
        layout = _tight(box)
        self._title = QLabel()
        self._title.setWordWrap(True)
        self._title.setTextFormat(Qt.TextFormat.PlainText)
        steps = QHBoxLayout()
        steps.addWidget(ActionButton(actions["previous_gap"], self.tr("◀ Previous")))
        steps.addWidget(ActionButton(actions["next_gap"], self.tr("Next ▶")))
        self._method = MethodBox(self._settings.get(METHOD))
        self._method.currentIndexChanged.connect(self._choose_method)
        self._candidates = CandidateList(self._document, self._view, self._method.method.id)
        if not self._settings.get(COMPARE):
            self._candidates.hide()
        self._candidates.picked.connect(self._choose)
        self._form = ParamsForm(self._markers())
        self._form.changed.connect(self._take_params)
        self._form.rebuilt.connect(self.rebuilt)
        self._promise = QLabel()
        self._promise.setWordWrap(True)
        self._promise.setTextFormat(Qt.TextFormat.RichText)
        self._promise.setMinimumHeight(self._promise.fontMetrics().height() * 4)
        self._promise.setToolTip(
            self.tr(
                "Root mean square of the 3-D error, and the radius that holds 90 % of the errors, "
                "on stretches of this recording that were hidden for the test."
            )
        )
        self._promise.setAlignment(Qt.AlignmentFlag.AlignTop)
        self._apply = ActionButton(actions["apply"], self.tr("Apply"))
        self._clear = ActionButton(actions["clear_fill"], self.tr("Reopen the gap"))
        decide = QHBoxLayout()
        decide.addWidget(self._apply)
        decide.addWidget(self._clear)
        layout.addWidget(self._title)
        layout.addLayout(steps)
        layout.addWidget(self._candidates)
        layout.addWidget(self._method)
        # Above the parameters: where they stay whatever the method, in sight in a small window.
        layout.addLayout(decide)
        layout.addWidget(self._promise)
        layout.addWidget(self._form)
        return box

    def _make_all_box(self, actions: dict[str, QAction]) -> QGroupBox:
        box = QGroupBox(self.tr("All gaps, with this method"))
        layout = _tight(box)
        self.limits = LimitsBox(self._document.original, self._settings)
        self.limits.changed.connect(self._show_gap)
        self.fix_first = FixFirst(self._settings)
        self._outcome = QLabel()
        self._outcome.setWordWrap(True)
        self.left_open = QPushButton(self.tr("Show what stayed open…"))
        self._fill_all = ActionButton(actions["fill_all"], self.tr("Fill all"))
        doing = QHBoxLayout()
        doing.addWidget(ActionButton(actions["plan"], self.tr("Plan…")))
        doing.addWidget(self._fill_all)
        layout.addWidget(self.limits)
        layout.addWidget(self.fix_first)
        layout.addLayout(doing)
        layout.addWidget(self._outcome)
        layout.addWidget(self.left_open)
        self.show_outcome("", open_gaps=False)
        return box

    # --- what it shows -----------------------------------------------------------------------

    def _choose(self, method: str) -> None:
        self._method.setCurrentIndex(self._method.findData(method))

    def _choose_method(self) -> None:
        self._settings.set(METHOD, self._method.method.id)
        self._show_method()

    def _show_method(self) -> None:
        method = self._method.method
        self._method.setToolTip(method_text(method.help))
        self._candidates.choose(method.id)
        self._form.show_params(self._params_of(method.id))
        self._offer_donors()
        self.ways_changed.emit()

    def _params_of(self, method: str) -> Any:
        return self._params.get(method, METHODS[method].params())

    def _take_params(self) -> None:
        way = self.method()
        self._params[way.method] = way.params
        self.ways_changed.emit()

    def _pick(self, marker: int) -> None:
        """Take a marker that was clicked as a donor, or no longer."""
        gap = self._view.gap
        if gap is None or marker != gap.marker:
            self._form.pick(self._document.original.labels[marker])

    def _markers(self) -> dict[str, str]:
        """Return the labels of the markers by what they are called here."""
        return {name: label for label, name in self._names.items()}

    def _rename(self) -> None:
        """Follow other names; what was said about donors goes on to mean the same markers."""
        document = self._document
        calls = new_names(self._labels, document.labels)
        # The form may hold what it has not told yet.
        self._params[self._method.method.id] = self._form.params()
        self._params = {key: with_donors(params, calls) for key, params in self._params.items()}
        self._labels = document.labels
        self._names = dict(zip(document.labels, document.names, strict=True))
        self._form.set_markers(self._markers())
        self._show_method()
        self._show_gap()

    def _offer_donors(self) -> None:
        """Let the other selected markers be taken over as donors."""
        gap, labels = self._view.gap, self._document.original.labels
        own = None if gap is None else gap.marker
        self._form.set_selection([labels[m] for m in self._view.selection if m != own])

    def _show_either(self) -> None:
        """Show the box of the gap, or that of the bad samples."""
        self._gap_box.setVisible(self._view.suspect is None)

    def _show_gap(self) -> None:
        gap, preview = self._view.gap, self._view.preview
        repair = None if gap is None else self._document.repairs.get(gap)
        self._title.setText(self._gap_text(gap))
        self._clear.set_possible(possible=repair is not None)
        self._apply.set_possible(possible=preview is not None and preview.patch is not None)
        if gap is None and not (self._document.gaps or self._document.never):
            text = self.tr("No marker is missing anywhere: there is nothing to fill.")
        elif gap is None:
            text = self.tr("Press N for the next gap, or click one on the timeline.")
        elif gap in self._document.never_of(gap.marker):
            text = self.tr("<b>Never to be filled.</b> Shift+X makes it a gap again.")
            text += self._reason_text(self._document.never_reason(gap))
        elif repair is not None:
            text = self.tr("Repaired with <b>{0}</b>").format(method_name(repair.method))
            text += "<br>" + self._error_text(repair.patch) + self._donors_text(repair.donors)
        elif preview is None:
            text = self.tr("Computing the preview…")
        else:
            text = self._preview_text(preview)
            text += self._reason_text(self._document.set_aside.get(gap))
        self._promise.setText(text)

    def _reason_text(self, reason: str | None) -> str:
        """Return a line about why the user keeps a gap open, where there is more to say."""
        if reason is None or reason in NO_REASON:
            return ""
        return "<br>" + self.tr("Kept open: {0}").format(escape(shown(reason)))

    def _gap_text(self, gap: Gap | None) -> str:
        if gap is None:
            return self.tr("Open gaps: {0}").format(len(self._document.fillable))
        original = self._document.original
        places = {
            "interior": "",
            "leading": self.tr(", at the start"),
            "trailing": self.tr(", at the end"),
            "whole": self.tr(", never seen"),
        }
        first, last = gap.start + original.first_frame, gap.stop - 1 + original.first_frame
        ms = round(1000.0 * gap.length / original.rate)
        frames = (
            self.tr("frame {0} ({1} ms)").format(first, ms)
            if gap.length == 1
            else self.tr("frames {0} – {1}: {2} ({3} ms)").format(first, last, gap.length, ms)
        )
        # The name has its own line: else the buttons below move with its length.
        text = f"{self._document.names[gap.marker]}\n{frames}{places[gap.kind(original.frames)]}"
        before, after = hidden(self._document, gap)
        if before or after:
            text += "\n" + self.tr("{0} + {1} measured frames at its ends cut off").format(
                before, after
            )
        return text

    def _preview_text(self, preview: Preview) -> str:
        if preview.patch is None:
            return self.tr("<b>Stays open:</b> {0}").format(escape(shown(preview.reason)))
        text = self._error_text(preview.patch)
        limit = self.limits.max_error_mm()
        if preview.patch.expected_error * self._document.original.mm > limit:
            text += "<br>" + self.tr("<b>⚠ Above the limit of {0} mm</b>").format(f"{limit:g}")
        text += self._donors_text(preview.donors)
        if preview.note.get("curve"):
            text += "<br>" + self.tr("A cubic spline: the other markers say less about this gap.")
        tests = preview.note.get("self_tests")
        if tests:
            where = (
                self.tr("all markers")
                if preview.note.get("tested_on") == "all markers"
                else self.tr("this marker")
            )
            one, more = (
                self.tr("Measured on 1 hidden stretch of {1}."),
                self.tr("Measured on {0} hidden stretches of {1}."),
            )
            text += "<br>" + (one if tests == 1 else more).format(tests, where)
        return text

    def _error_text(self, patch: Patch) -> str:
        mm = self._document.original.mm
        error, radius = patch.expected_error * mm, patch.typical_r90 * mm
        if not np.isfinite(error):
            return self.tr("Expected error <b>unknown</b>: too little of the recording to test on")
        text = self.tr("Expected error <b>{0} mm</b>").format(f"{error:.1f}")
        if np.isfinite(radius):
            text += self.tr(", 90 % within {0} mm").format(f"{radius:.1f}")
        return text

    def _donors_text(self, donors: Sequence[str]) -> str:
        if not donors:
            return ""
        names = [escape(self._names.get(label, label)) for label in donors[:MOST_DONORS]]
        listed = ", ".join(names) + (", …" if len(donors) > MOST_DONORS else "")
        return "<br>" + self.tr("Donors: {0}").format(listed)


def _tight(box: QWidget) -> QVBoxLayout:
    """Lay out a box so that all of the pane fits into a small window."""
    layout = QVBoxLayout(box)
    layout.setContentsMargins(9, 6, 9, 6)
    layout.setSpacing(4)
    return layout
