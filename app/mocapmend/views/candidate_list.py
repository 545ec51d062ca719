"""The repairs of the current gap side by side: number, method, expected error."""

import math

from PySide6.QtCore import QItemSelectionModel, Qt, Signal
from PySide6.QtWidgets import (
    QAbstractItemView,
    QSizePolicy,
    QTableWidget,
    QTableWidgetItem,
    QWidget,
)

from mocapmend.document import Document
from mocapmend.prospects import Preview
from mocapmend.views.engine_texts import method_name, shown
from mocapmend.views.tables import RIGHT, dress, narrow
from mocapmend.viewstate import ViewState

METHODS = ("auto", "local-frame", "pca-r2", "rigid", "kalman", "cubic", "linear")
"""Compared for every gap: quick ones of each kind. Their places are the keys that choose them."""


class CandidateList(QTableWidget):
    """One row per method that is compared, and one for the chosen one if it is another.

    Signals
    -------
    picked : str
        Method id that the user wants.
    """

    picked = Signal(str)

    def __init__(
        self, document: Document, view: ViewState, chosen: str, parent: QWidget | None = None
    ) -> None:
        super().__init__(0, 3, parent)
        self._document = document
        self._view = view
        self._following = False
        self._methods: tuple[str, ...] = ()
        self.setHorizontalHeaderLabels([self.tr("Key"), self.tr("Method"), self.tr("Error")])
        self.setAccessibleName(self.tr("Repairs of the current gap"))
        self.setSelectionMode(QAbstractItemView.SelectionMode.SingleSelection)
        self.setHorizontalScrollBarPolicy(Qt.ScrollBarPolicy.ScrollBarAlwaysOff)
        self.setVerticalScrollBarPolicy(Qt.ScrollBarPolicy.ScrollBarAlwaysOff)
        self.setSizePolicy(QSizePolicy.Policy.Expanding, QSizePolicy.Policy.Fixed)
        self.setFocusPolicy(Qt.FocusPolicy.TabFocus)
        dress(self)
        self.horizontalHeader().hide()
        advance = self.fontMetrics().horizontalAdvance
        narrow(self, {0: advance("9") + 14, 2: advance("★ 0000.0 mm") + 12}, stretched=1)
        self.itemSelectionChanged.connect(self._lead)
        view.gap_changed.connect(self._show)
        view.preview_changed.connect(self._show)
        view.candidates_changed.connect(self._show)
        self.choose(chosen)

    @property
    def methods(self) -> tuple[str, ...]:
        """The methods that are compared, in the order of their numbers."""
        return self._methods

    def choose(self, method: str) -> None:
        """Mark a method; one that is not compared gets a row of its own at the end."""
        self._methods = METHODS if method in METHODS else (*METHODS, method)
        self._following = True
        self.setRowCount(len(self._methods))
        for row, name in enumerate(self._methods):
            texts = (str(row + 1), method_name(name), "")
            for column, text in enumerate(texts):
                item = QTableWidgetItem(text)
                if column == 2:
                    item.setTextAlignment(RIGHT)
                self.setItem(row, column, item)
        place = self.model().index(self._methods.index(method), 0)
        flags = QItemSelectionModel.SelectionFlag
        self.selectionModel().setCurrentIndex(place, flags.ClearAndSelect | flags.Rows)
        self._following = False
        self._fit()
        self._show()

    def _fit(self) -> None:
        height = self.verticalHeader().defaultSectionSize() * self.rowCount()
        self.setFixedHeight(height + 2 * self.frameWidth())

    def _lead(self) -> None:
        row = self.currentRow()
        if not self._following and 0 <= row < len(self._methods):
            self.picked.emit(self._methods[row])

    def _show(self) -> None:
        known = dict(self._view.candidates)
        errors = [p.expected_error for p in known.values() if not math.isnan(p.expected_error)]
        least = min(errors, default=math.nan)
        for row, name in enumerate(self._methods):
            text, tip = self._text(known.get(row + 1), least)
            item = self.item(row, 2)
            assert item is not None
            item.setText(text)
            for column in range(3):
                cell = self.item(row, column)
                assert cell is not None
                cell.setToolTip(tip or method_name(name))

    def _text(self, preview: Preview | None, least: float) -> tuple[str, str]:
        """Return what stands in the last column, and the tool tip."""
        gap = self._view.gap
        if gap is None or gap not in self._document.gaps_of(gap.marker):
            return "", ""
        if preview is None:
            return "…", self.tr("Not computed yet")
        if preview.patch is None:
            return "—", shown(preview.reason)
        error = preview.expected_error
        if math.isnan(error):
            return "?", self.tr("Too little of the recording to test on")
        text = f"{error * self._document.original.mm:.1f} mm"
        if error == least:
            return f"★ {text}", self.tr("The least expected error of these")
        return text, ""
