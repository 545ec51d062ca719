"""The repair pane: the current gap, the method and what it promises, and filling all at once."""

from collections.abc import Sequence
from html import escape
from typing import Any

import numpy as np
from PySide6.QtCore import Qt, QTimer, Signal
from PySide6.QtGui import QAction
from PySide6.QtWidgets import (
    QCheckBox,
    QDoubleSpinBox,
    QFormLayout,
    QGroupBox,
    QHBoxLayout,
    QLabel,
    QPushButton,
    QScrollArea,
    QSpinBox,
    QVBoxLayout,
    QWidget,
)

from mocapmend.document import Document
from mocapmend.settings import (
    LIMIT_ERROR,
    LIMIT_GAP,
    MAX_ERROR_MM,
    MAX_GAP_MS,
    METHOD,
    Settings,
)
from mocapmend.views.action_button import ActionButton
from mocapmend.views.method_box import MethodBox
from mocapmend.views.params_form import ParamsForm
from mocapmend.viewstate import Preview, ViewState
from mocapmend_algorithms import Gap
from mocapmend_algorithms.fill.contract import Patch
from mocapmend_algorithms.fill.registry import method_label

PANEL_WIDTH = 270
MOST_DONORS = 6
"""That are listed: the methods name the best ones first."""


class RepairPanel(QScrollArea):
    """Shows what can be done about the current gap; doing it is the window's job.

    Signals
    -------
    method_chosen : str, object
        Method id and parameters.
    rebuilt :
        There are new fields.
    """

    method_chosen = Signal(str, object)
    rebuilt = Signal()

    def __init__(
        self,
        document: Document,
        view: ViewState,
        settings: Settings,
        actions: dict[str, QAction],
        parent: QWidget | None = None,
    ) -> None:
        super().__init__(parent)
        self._document = document
        self._view = view
        self._settings = settings
        self._names = dict(zip(document.original.labels, document.names, strict=True))
        self.setWidgetResizable(True)
        self.setFrameShape(QScrollArea.Shape.NoFrame)
        self.setFocusPolicy(Qt.FocusPolicy.NoFocus)
        self.setHorizontalScrollBarPolicy(Qt.ScrollBarPolicy.ScrollBarAlwaysOff)
        body = QWidget()
        layout = QVBoxLayout(body)
        layout.setContentsMargins(8, 2, 8, 2)
        layout.setSpacing(4)
        layout.addWidget(self._make_gap_box(actions))
        layout.addWidget(self._make_all_box(actions))
        layout.addStretch(1)
        self.setWidget(body)
        room = self.verticalScrollBar().sizeHint().width() + 2
        self.setMinimumWidth(max(PANEL_WIDTH, body.minimumSizeHint().width() + room))
        self._show_method()
        view.selection_changed.connect(self._offer_donors)
        view.gap_changed.connect(self._offer_donors)
        view.gap_changed.connect(self._show_gap)
        view.preview_changed.connect(self._show_gap)
        document.samples_changed.connect(self._show_gap)
        self._show_gap()

    # --- what it asks for --------------------------------------------------------------------

    def method(self) -> tuple[str, Any]:
        """Return the chosen method id and its parameters."""
        return self._method.method.id, self._form.params()

    def step_method(self, step: int) -> None:
        """Choose the next or the previous method of the list."""
        self._method.step(step)

    def max_gap(self) -> int | None:
        """Return the longest gap that filling all may fill, in frames; None for any."""
        return self._max_gap.value() if self._limit_gap.isChecked() else None

    def max_error_mm(self) -> float:
        """Return the largest expected error that filling all may accept, in mm."""
        return self._max_error.value() if self._limit_error.isChecked() else float("inf")

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
            QTimer.singleShot(0, self, lambda: self.ensureWidgetVisible(last))

    # --- parts -------------------------------------------------------------------------------

    def _make_gap_box(self, actions: dict[str, QAction]) -> QGroupBox:
        box = QGroupBox(self.tr("Current gap"))
        layout = _tight(box)
        self._title = QLabel()
        self._title.setWordWrap(True)
        self._title.setTextFormat(Qt.TextFormat.PlainText)
        steps = QHBoxLayout()
        steps.addWidget(ActionButton(actions["previous_gap"], self.tr("◀ Previous gap")))
        steps.addWidget(ActionButton(actions["next_gap"], self.tr("Next gap ▶")))
        self._method = MethodBox(self._settings.get(METHOD))
        self._method.currentIndexChanged.connect(self._choose_method)
        self._form = ParamsForm({name: label for label, name in self._names.items()})
        self._form.changed.connect(self._announce)
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
        layout.addWidget(self._method)
        layout.addWidget(self._promise)
        # Above the parameters: where it stays whatever the method, and in sight in a small window.
        layout.addLayout(decide)
        layout.addWidget(self._form)
        return box

    def _make_all_box(self, actions: dict[str, QAction]) -> QGroupBox:
        box = QGroupBox(self.tr("All gaps, with this method"))
        layout = _tight(box)
        rate = self._document.original.rate
        self._limit_gap = QCheckBox(self.tr("length"))
        # A length that an older version remembers was always a limit.
        old = self._settings.chosen(MAX_GAP_MS) and not self._settings.chosen(LIMIT_GAP)
        self._limit_gap.setChecked(old or self._settings.get(LIMIT_GAP))
        self._limit_gap.toggled.connect(lambda on: self._settings.set(LIMIT_GAP, on))
        self._max_gap = QSpinBox()
        self._max_gap.setRange(0, max(1, self._document.original.frames))
        self._max_gap.setPrefix("≤ ")
        self._max_gap.setAccessibleName(self.tr("Longest gap in frames"))
        remembered = self._settings.get(MAX_GAP_MS) * rate / 1000.0 + 1e-6
        self._max_gap.setValue(int(min(remembered, self._max_gap.maximum())))
        self._max_gap.valueChanged.connect(self._remember_limit)
        self._max_gap.setEnabled(self._limit_gap.isChecked())
        self._limit_gap.toggled.connect(self._max_gap.setEnabled)
        self._limit_error = QCheckBox(self.tr("expected error"))
        self._limit_error.setChecked(self._settings.get(LIMIT_ERROR))
        self._limit_error.toggled.connect(lambda on: self._settings.set(LIMIT_ERROR, on))
        self._max_error = QDoubleSpinBox()
        self._max_error.setRange(0.1, 1000.0)
        self._max_error.setDecimals(1)
        self._max_error.setPrefix("≤ ")
        self._max_error.setSuffix(" mm")
        self._max_error.setAccessibleName(self.tr("Largest expected error in mm"))
        self._max_error.setValue(self._settings.get(MAX_ERROR_MM))
        self._max_error.setEnabled(self._limit_error.isChecked())
        self._max_error.valueChanged.connect(lambda mm: self._settings.set(MAX_ERROR_MM, mm))
        self._limit_error.toggled.connect(self._max_error.setEnabled)
        self._limit_error.toggled.connect(self._show_gap)
        self._max_error.valueChanged.connect(self._show_gap)
        form = QFormLayout()
        form.addRow(self._limit_gap, self._max_gap)
        form.addRow(self._limit_error, self._max_error)
        self._outcome = QLabel()
        self._outcome.setWordWrap(True)
        self.left_open = QPushButton(self.tr("Show what stayed open…"))
        layout.addLayout(form)
        self._fill_all = ActionButton(actions["fill_all"], self.tr("Fill all"))
        layout.addWidget(self._fill_all)
        layout.addWidget(self._outcome)
        layout.addWidget(self.left_open)
        self.show_outcome("", open_gaps=False)
        self._show_limit()
        return box

    # --- what it shows -----------------------------------------------------------------------

    def _limit_ms(self) -> float:
        return 1000.0 * self._max_gap.value() / self._document.original.rate

    def _show_limit(self) -> None:
        self._max_gap.setSuffix(self.tr(" frames ({0} ms)").format(round(self._limit_ms())))

    def _remember_limit(self) -> None:
        """Keep what the user has chosen; what a recording's rate makes of it is not a choice."""
        self._show_limit()
        self._settings.set(MAX_GAP_MS, self._limit_ms())

    def _choose_method(self) -> None:
        self._settings.set(METHOD, self._method.method.id)
        self._show_method()

    def _show_method(self) -> None:
        method = self._method.method
        self._method.setToolTip(method.help)
        self._form.show_class(method.params)
        self._announce()

    def _offer_donors(self) -> None:
        """Let the other selected markers be taken over as donors."""
        gap, labels = self._view.gap, self._document.original.labels
        own = None if gap is None else gap.marker
        self._form.set_selection([labels[m] for m in self._view.selection if m != own])

    def _announce(self) -> None:
        self.method_chosen.emit(*self.method())

    def _show_gap(self) -> None:
        gap, preview = self._view.gap, self._view.preview
        repair = None if gap is None else self._document.repairs.get(gap)
        self._title.setText(self._gap_text(gap))
        self._clear.set_possible(possible=repair is not None)
        self._apply.set_possible(possible=preview is not None and preview.patch is not None)
        if gap is None and not self._document.gaps:
            text = self.tr("No marker is missing anywhere: there is nothing to fill.")
        elif gap is None:
            text = self.tr("Press N for the next gap, or click one on the timeline.")
        elif repair is not None:
            text = self.tr("Repaired with <b>{0}</b>").format(method_label(repair.method))
            text += "<br>" + self._error_text(repair.patch) + self._donors_text(repair.donors)
        elif preview is None:
            text = self.tr("Computing the preview…")
        else:
            text = self._preview_text(preview)
        self._promise.setText(text)

    def _gap_text(self, gap: Gap | None) -> str:
        if gap is None:
            count = sum(1 for g in self._document.gaps if g.length < self._document.original.frames)
            return self.tr("{0} open gaps").format(count)
        original = self._document.original
        places = {
            "interior": "",
            "leading": self.tr(", at the start"),
            "trailing": self.tr(", at the end"),
            "whole": self.tr(", never seen"),
        }
        first, last = gap.start + original.first_frame, gap.stop - 1 + original.first_frame
        frames = (
            self.tr("frame {0}\n1 frame").format(first)
            if gap.length == 1
            else self.tr("frames {0} to {1}\n{2} frames").format(first, last, gap.length)
        )
        return self.tr("{0}: {1} ({2} ms){3}").format(
            self._document.names[gap.marker],
            frames,
            round(1000.0 * gap.length / original.rate),
            places[gap.kind(original.frames)],
        )

    def _preview_text(self, preview: Preview) -> str:
        if preview.patch is None:
            return self.tr("<b>Stays open:</b> {0}").format(escape(preview.reason))
        text = self._error_text(preview.patch)
        limit = self.max_error_mm()
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
            text += "<br>" + self.tr("Measured on {0} hidden stretches of {1}.").format(
                tests, where
            )
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
