"""What a comparison of two files found, for the user."""

from collections.abc import Sequence
from html import escape
from pathlib import Path

from PySide6.QtCore import QCoreApplication, QSize, Qt
from PySide6.QtGui import QResizeEvent
from PySide6.QtWidgets import (
    QDialog,
    QLabel,
    QScrollArea,
    QSizePolicy,
    QTableWidget,
    QVBoxLayout,
    QWidget,
)

from mocapmend.files import CheckReport
from mocapmend.views.dialogs import table_dialog
from mocapmend.views.engine_texts import shown
from mocapmend.views.tables import RIGHT, align_right, narrow

translate = QCoreApplication.translate
MOST_LISTED = 12
NUMBERS = (1, 2, 3)
"""Columns that are aligned at the right."""


def check_dialog(parent: QWidget, original: Path, repaired: Path, found: CheckReport) -> QDialog:
    """Make the dialog: the finding, what may differ, what may not, and the changed samples."""
    rows = [
        (run.label, *map(str, (run.first_frame, run.last_frame, run.frames)))
        for run in found.changed
    ]
    headers = (
        translate("Check", "Changed marker"),
        translate("Check", "First frame"),
        translate("Check", "Last frame"),
        translate("Check", "Frames"),
    )
    title = translate("Check", "Check of {0}").format(repaired.name)
    dialog = table_dialog(parent, title, headers, rows)
    dialog.setModal(False)
    table = dialog.findChild(QTableWidget)
    assert table is not None
    _arrange(table)
    if not rows:
        table.hide()
        dialog.resize(dialog.width(), 0)
    verdict = QLabel(_verdict(original, repaired, found))
    verdict.setTextFormat(Qt.TextFormat.RichText)
    verdict.setWordWrap(True)
    verdict.setTextInteractionFlags(Qt.TextInteractionFlag.TextSelectableByMouse)
    layout = dialog.layout()
    assert isinstance(layout, QVBoxLayout)
    layout.insertWidget(0, _Scrolled(verdict))
    return dialog


class _Scrolled(QScrollArea):
    """Shows a text whole where there is room, and else a part of it."""

    def __init__(self, text: QLabel) -> None:
        super().__init__()
        self._text = text
        self.setFrameShape(QScrollArea.Shape.NoFrame)
        self.setHorizontalScrollBarPolicy(Qt.ScrollBarPolicy.ScrollBarAlwaysOff)
        self.setSizePolicy(QSizePolicy.Policy.Preferred, QSizePolicy.Policy.Maximum)
        self.setWidgetResizable(True)
        self.setWidget(text)
        text.setAlignment(Qt.AlignmentFlag.AlignTop)

    def sizeHint(self) -> QSize:
        return QSize(0, self._text.heightForWidth(self.width()))

    def resizeEvent(self, event: QResizeEvent) -> None:
        super().resizeEvent(event)
        # What is below it must not take it all.
        self.setMinimumHeight(min(self.sizeHint().height(), self.window().height() // 2))
        self.updateGeometry()


def _arrange(table: QTableWidget) -> None:
    """Give the markers the room, and align the numbers."""
    header = table.horizontalHeader()
    widths = {}
    for column in NUMBERS:
        widths[column] = 16 + max(header.sectionSizeHint(column), table.sizeHintForColumn(column))
        for row in range(table.rowCount()):
            item = table.item(row, column)
            assert item is not None
            item.setTextAlignment(RIGHT)
    align_right(table, NUMBERS)
    narrow(table, widths)


def _verdict(original: Path, repaired: Path, found: CheckReport) -> str:
    mark = "✔" if found.passed else "✘"
    parts = [
        f"<b>{mark} {escape(shown(found.sentence))}</b>",
        translate("Check", "Original: {0}<br>Copy: {1}").format(
            escape(str(original.resolve())), escape(str(repaired.resolve()))
        ),
        _list(translate("Check", "These differences are allowed:"), found.allowed),
        _list(translate("Check", "These are not:"), found.other_differences),
    ]
    return "".join(f"<p>{part}</p>" for part in parts if part)


def _list(title: str, sentences: Sequence[str]) -> str:
    if not sentences:
        return ""
    listed = [f"• {escape(shown(sentence))}" for sentence in sentences[:MOST_LISTED]]
    if len(sentences) > MOST_LISTED:
        listed.append(translate("Check", "and {0} more").format(len(sentences) - MOST_LISTED))
    return f"{title}<br>" + "<br>".join(listed)
