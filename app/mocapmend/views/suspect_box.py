"""The current run of bad samples: what it is, how sure that is, and what can be done about it."""

import math
from html import escape

from PySide6.QtCore import Qt
from PySide6.QtGui import QAction
from PySide6.QtWidgets import QGridLayout, QGroupBox, QLabel, QVBoxLayout

from mocapmend.document import Document
from mocapmend.fixing import is_fixable
from mocapmend.ranking import Status
from mocapmend.suspects import Suspects, place_of
from mocapmend.unsure_labels import UNSURE
from mocapmend.views.action_button import ActionButton
from mocapmend.views.engine_texts import method_name
from mocapmend.views.suspect_texts import (
    deviation_text,
    reason_text,
    score_text,
    title_text,
)
from mocapmend.viewstate import ViewState
from mocapmend_algorithms.problems import BadRun
from mocapmend_algorithms.problems.registry import DETECTORS


class SuspectBox(QGroupBox):
    """Shows the current bad run; hidden while there is none."""

    def __init__(
        self,
        document: Document,
        view: ViewState,
        suspects: Suspects,
        actions: dict[str, QAction],
    ) -> None:
        super().__init__()
        self.setTitle(self.tr("Current problem"))
        self._document = document
        self._view = view
        self._suspects = suspects
        self._title = QLabel()
        self._title.setTextFormat(Qt.TextFormat.PlainText)
        self._about = QLabel()
        self._about.setTextFormat(Qt.TextFormat.RichText)
        for label in (self._title, self._about):
            label.setWordWrap(True)
        self.fix = ActionButton(actions["fix_problem"], self.tr("Fix"))
        self.dismiss = ActionButton(actions["dismiss_problem"], self.tr("No problem"))
        self._believe = ActionButton(actions["believe"], self.tr("Believe again"))
        self._fix_kind = ActionButton(actions["fix_kind"], self.tr("Fix this kind"))
        buttons = QGridLayout()
        buttons.addWidget(ActionButton(actions["previous_gap"], self.tr("◀ Previous")), 0, 0)
        buttons.addWidget(ActionButton(actions["next_gap"], self.tr("Next ▶")), 0, 1)
        buttons.addWidget(self.fix, 1, 0)
        buttons.addWidget(self.dismiss, 1, 1)
        buttons.addWidget(self._fix_kind, 2, 0)
        buttons.addWidget(ActionButton(actions["fix_all"], self.tr("Fix all")), 2, 1)
        layout = QVBoxLayout(self)
        layout.setContentsMargins(9, 6, 9, 6)
        layout.setSpacing(4)
        layout.addWidget(self._title)
        # Above the text, which is longer or shorter: buttons stay under the mouse.
        layout.addLayout(buttons)
        layout.addWidget(self._believe)
        layout.addWidget(self._about)
        view.suspect_changed.connect(self.refresh)
        view.preview_changed.connect(self.refresh)
        document.names_changed.connect(self.refresh)
        self.refresh()

    def refresh(self) -> None:
        """Show what is known of the current bad run by now."""
        run = self._view.suspect
        self.setVisible(run is not None)
        if run is None:
            return
        self._title.setText(f"{title_text(run, self._document.names)}\n{self._frames_text(run)}")
        status = self._suspects.status(run)
        lines = [
            ", ".join(filter(None, (score_text(run), deviation_text(run, self._document.original))))
        ]
        if run.reason:
            lines.append(escape(reason_text(run)))
        label = run.kind == UNSURE
        outlook = self._label_text(run, status) if label else self._outlook(run, status)
        lines += [outlook, self._fill_text()]
        self._about.setText("<br>".join(filter(None, lines)))
        fixed = status is Status.FIXED
        self.fix.setText(self.tr("Accept") if label else self.tr("Fix"))
        self.fix.set_possible(possible=label or (not fixed and is_fixable(run)))
        self.dismiss.setText(self._dismiss_text(run, status))
        self.dismiss.set_possible(possible=label or not fixed)
        self._fix_kind.set_possible(possible=not (label or fixed))
        self._believe.setVisible(place_of(run) in self._document.doubts)

    def _dismiss_text(self, run: BadRun, status: Status | None) -> str:
        if run.kind == UNSURE:
            return self.tr("Reject")
        if status is Status.DISMISSED:
            return self.tr("A problem after all")
        return self.tr("No problem")

    def _label_text(self, run: BadRun, status: Status | None) -> str:
        """Say what a piece would be called, and what the user has decided."""
        label = self._suspects.labels.label(run)
        if status is Status.DISMISSED:
            return self.tr("<b>Rejected:</b> it stays as it is.")
        if label is None:
            return self.tr("<b>Accepting</b> says that it is no marker.")
        text = self.tr("<b>Accepting</b> gives it the label {0} when the labels are applied.")
        if status is Status.FIXED:
            text = self.tr("<b>Accepted:</b> it gets the label {0} when the labels are applied.")
        return text.format(escape(label))

    def _outlook(self, run: BadRun, status: Status | None) -> str:
        """Say what has become of a run, or what fixing it would do."""
        if status is Status.FIXED:
            return self.tr("<b>Fixed.</b>")
        if status is Status.DISMISSED:
            return self.tr("<b>You hold it for no problem.</b>")
        if not is_fixable(run):
            return self.tr("It fits no marker: exchange it by hand, or say it is no problem.")
        if DETECTORS[run.kind].remedy == "exchange":
            return self.tr("<b>Fixing</b> exchanges the two: dashed lines show how it will be.")
        return self.tr("<b>Fixing</b> sets the samples aside: they become a gap, to be filled.")

    def _fill_text(self) -> str:
        """Say how well the gap could be filled that it becomes."""
        preview = self._view.preview
        if preview is None or preview.patch is None:
            return ""
        error = preview.expected_error * self._document.original.mm
        name = escape(method_name(preview.method))
        if math.isnan(error):
            return self.tr("To be filled with {0}, as shown.").format(name)
        text = self.tr("To be filled with {0}, as shown: expected error {1} mm.")
        return text.format(name, f"{error:.1f}")

    def _frames_text(self, run: BadRun) -> str:
        original = self._document.original
        first, last = run.start + original.first_frame, run.stop - 1 + original.first_frame
        ms = round(1000.0 * run.length / original.rate)
        if run.length == 1:
            return self.tr("frame {0} ({1} ms)").format(first, ms)
        return self.tr("frames {0} – {1}: {2} ({3} ms)").format(first, last, run.length, ms)
