"""The report's page on a refined recording: the network, and how far a reference is away."""

from collections.abc import Sequence
from math import isnan

from PySide6.QtCore import Qt
from PySide6.QtWidgets import (
    QHBoxLayout,
    QLabel,
    QScrollArea,
    QTableWidget,
    QTableWidgetItem,
    QWidget,
)

from mocapmend.refine.judging import Judged
from mocapmend.report import Refining
from mocapmend.report.refining_text import MEANINGS, cautions
from mocapmend.views.engine_texts import shown
from mocapmend.views.tables import RIGHT, align_right, dress, narrow
from mocapmend.views.text_scale import scaled


class RefinementPage(QWidget):
    """What is to be known on the left; the figures beside it, where there is a reference."""

    def __init__(self, parent: QWidget | None = None) -> None:
        super().__init__(parent)
        self.text = QLabel()
        self.text.setTextFormat(Qt.TextFormat.PlainText)
        self.text.setWordWrap(True)
        self.text.setAlignment(Qt.AlignmentFlag.AlignTop)
        self.text.setTextInteractionFlags(
            Qt.TextInteractionFlag.TextSelectableByMouse
            | Qt.TextInteractionFlag.TextSelectableByKeyboard
        )
        self.text.setAccessibleName(self.tr("How the recording was refined"))
        scrolled = QScrollArea()
        scrolled.setFrameShape(QScrollArea.Shape.NoFrame)
        scrolled.setWidgetResizable(True)
        scrolled.setWidget(self.text)
        scrolled.setFocusPolicy(Qt.FocusPolicy.NoFocus)
        self.errors = self._table(
            self.tr("Errors against the reference"),
            (self.tr("Recording"), "Lp (mm²)", "Lb (mm²)", "Ls (mm²)"),
        )
        self.errors.setToolTip(shown(MEANINGS))
        titles = (self.tr("Marker"), self.tr("RMS distance (mm)"))
        self.distances = self._table(self.tr("Distances from the reference"), titles)
        self._figures = QWidget()
        figures = QHBoxLayout(self._figures)
        figures.setContentsMargins(0, 0, 0, 0)
        figures.addWidget(self.errors, 3)
        figures.addWidget(self.distances, 2)
        layout = QHBoxLayout(self)
        layout.setContentsMargins(0, 0, 0, 0)
        layout.addWidget(scrolled, 2)
        layout.addWidget(self._figures, 3)
        self.setFocusProxy(self.text)

    def show_refining(self, done: Refining | None) -> None:
        """Show what is known now."""
        judged = None if done is None else done.judged
        self._figures.setVisible(judged is not None)
        if done is None:
            return
        lines = [*self._facts(done), "", *(shown(text) for text in cautions(done))]
        self.text.setText("\n".join(lines))
        if judged is not None:
            self._show_errors(judged)
            self._show_distances(judged)

    def _facts(self, done: Refining) -> list[str]:
        stride, cutoff = done.settings
        filtered = self.tr("output filter {0}").format(cutoff)
        lines = [
            self.tr("Network: {0}").format(done.network),
            shown(done.profile),
            self.tr("Stride {0}, {1}").format(
                stride, filtered if cutoff else self.tr("no output filter")
            ),
        ]
        if done.calibrations:
            text = self.tr("Calibrated by recordings of the same person: {0}")
            lines.append(text.format(done.calibrations))
        if done.judged is not None:
            text = self.tr("Reference: {0}, {1} frames at 60 Hz, lag {2} ms")
            lag = f"{1000 * done.judged.lag:+.0f}"
            lines.append(text.format(done.judged.reference, done.judged.refined.frames, lag))
        return lines

    def _table(self, name: str, titles: tuple[str, ...]) -> QTableWidget:
        table = QTableWidget(0, len(titles))
        table.setHorizontalHeaderLabels(list(titles))
        align_right(table, range(1, len(titles)))
        table.setAccessibleName(name)
        dress(table)
        advance = table.fontMetrics().horizontalAdvance
        narrow(table, {k: advance(t) + scaled(table, 24) for k, t in enumerate(titles) if k}, 0)
        return table

    def _show_errors(self, judged: Judged) -> None:
        _fill(
            self.errors,
            [
                (name, f"{e.position:.0f}", f"{e.bones:.1f}", f"{e.smoothness:.3f}")
                for name, e in (
                    (self.tr("refined"), judged.refined),
                    (self.tr("reference itself"), judged.truth),
                )
            ],
        )

    def _show_distances(self, judged: Judged) -> None:
        rows = [(name, "–" if isnan(mm) else f"{mm:.1f}") for name, mm in judged.rms]
        _fill(self.distances, rows)


def _fill(table: QTableWidget, rows: Sequence[tuple[str, ...]]) -> None:
    """Show other rows; numbers stand at the right."""
    table.setRowCount(len(rows))
    for row, texts in enumerate(rows):
        for column, text in enumerate(texts):
            item = QTableWidgetItem(text)
            if column:
                item.setTextAlignment(RIGHT)
            table.setItem(row, column, item)
