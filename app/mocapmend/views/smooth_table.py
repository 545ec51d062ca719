"""What smoothing would do to each of the selected markers: cut-offs, and how far samples move."""

from collections.abc import Callable

from PySide6.QtCore import QEvent, QSize, Qt, QTimer
from PySide6.QtWidgets import QAbstractItemView, QTableWidget, QTableWidgetItem, QWidget

from mocapmend import wording
from mocapmend.document import Document
from mocapmend.views.labels import LabelDelegate
from mocapmend.views.tables import RIGHT, align_right, dress, narrow
from mocapmend_algorithms import Gap
from mocapmend_algorithms.smooth.contract import SmoothResult

MOST_ROWS = 4
"""That are seen at once."""
LEAST_NAME = "✔ MMMMM"
"""What must be left for the names of markers."""


class SmoothTable(QTableWidget):
    """One row per smoothed run; those that are applied have a tick."""

    def __init__(self, document: Document, parent: QWidget | None = None) -> None:
        super().__init__(0, 4, parent)
        self._document = document
        titles = [self.tr("Marker"), self.tr("Cut-off (Hz)"), self.tr("RMS mm"), self.tr("Max mm")]
        tips = [
            self.tr("✔: smoothed in this way already"),
            self.tr("Of x, y and z: motion faster than this is taken for noise"),
            self.tr("How far samples would be moved: root mean square"),
            self.tr("The largest distance that a sample would be moved"),
        ]
        self.setHorizontalHeaderLabels(titles)
        for column, tip in enumerate(tips):
            item = self.horizontalHeaderItem(column)
            assert item is not None
            item.setToolTip(tip)
        align_right(self, {1, 2, 3})
        self.setAccessibleName(self.tr("What smoothing would do"))
        self.setSelectionMode(QAbstractItemView.SelectionMode.SingleSelection)
        self.setHorizontalScrollBarPolicy(Qt.ScrollBarPolicy.ScrollBarAlwaysOff)
        dress(self)
        self.setItemDelegateForColumn(0, LabelDelegate(self))
        advance = self.fontMetrics().horizontalAdvance
        widest = {1: "00.0 00.0 00.0", 2: "00.00", 3: "000.0"}
        # Room for the margins.
        narrow(
            self,
            {
                column: max(advance(text), advance(titles[column])) + 12
                for column, text in widest.items()
            },
        )

    def show_result(self, result: SmoothResult | None, applied: Callable[[Gap], bool]) -> None:
        """List another result, or none."""
        runs = () if result is None else result.runs
        mm, names = self._document.original.mm, self._document.names
        self.setRowCount(len(runs))
        for row, done in enumerate(runs):
            tick = "✔ " if applied(done.run) else ""
            texts = (
                tick + names[done.run.marker],
                wording.cutoffs(done.chosen.get("cutoff_hz", ())),
                f"{done.rms * mm:.2f}",
                f"{done.largest * mm:.1f}",
            )
            for column, text in enumerate(texts):
                item = QTableWidgetItem(text)
                if column:
                    item.setTextAlignment(RIGHT)
                item.setToolTip(text)
                self.setItem(row, column, item)
        self._fit()

    def minimumSizeHint(self) -> QSize:
        columns = sum(map(self.columnWidth, range(1, self.columnCount())))
        name = self.fontMetrics().horizontalAdvance(LEAST_NAME)
        bar = self.verticalScrollBar().sizeHint().width()
        return QSize(columns + name + bar, super().minimumSizeHint().height())

    def changeEvent(self, event: QEvent) -> None:
        super().changeEvent(event)
        if event.type() == QEvent.Type.FontChange:
            # Later, when the rows have their new height.
            QTimer.singleShot(0, self, self._fit)

    def _fit(self) -> None:
        rows = min(self.rowCount(), MOST_ROWS)
        height = rows * self.verticalHeader().defaultSectionSize()
        self.setFixedHeight(self.horizontalHeader().sizeHint().height() + height + 4)
