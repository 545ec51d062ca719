"""Small dialogs: an error, the gaps that stayed open."""

import platform
from collections.abc import Callable, Sequence

import numpy as np
import PySide6
from PySide6.QtCore import QCoreApplication, Qt
from PySide6.QtWidgets import (
    QDialog,
    QDialogButtonBox,
    QGridLayout,
    QHeaderView,
    QMessageBox,
    QSpacerItem,
    QTableWidget,
    QTableWidgetItem,
    QVBoxLayout,
    QWidget,
)

from mocapmend import __version__
from mocapmend.errors import MocapmendError
from mocapmend.log import log_path
from mocapmend.views.engine_texts import shown
from mocapmend.views.tables import dress, frames_text
from mocapmend.views.text_scale import fit_text
from mocapmend_algorithms import Gap, Recording
from mocapmend_algorithms.fill.contract import Unfilled

translate = QCoreApplication.translate
TABLE_SIZE = (720, 520)
MESSAGE_CHARACTERS = 70
"""How wide a message is at least."""


def environment() -> str:
    """Return the versions that a bug report needs."""
    return (
        f"mocapmend {__version__}, Python {platform.python_version()}, "
        f"PySide6 {PySide6.__version__}, numpy {np.__version__}, {platform.platform()}"
    )


def error_box(parent: QWidget | None, error: Exception) -> QMessageBox:
    """Make the one dialog that reports an error: a sentence, what to do, and details to copy."""
    box = QMessageBox(parent)
    box.setIcon(QMessageBox.Icon.Warning)
    box.setWindowTitle("mocapmend")
    box.setTextFormat(Qt.TextFormat.PlainText)
    if isinstance(error, MocapmendError):
        box.setText(shown(error.what))
        box.setInformativeText("\n".join(part for part in (error.where, shown(error.todo)) if part))
    else:
        box.setText(
            translate(
                "Dialogs", "Something went wrong inside the program. Your recording is unchanged."
            )
        )
        box.setInformativeText(
            translate("Dialogs", "The log file has the details:") + f"\n{log_path()}"
        )
        box.setDetailedText(f"{type(error).__name__}: {error}\n\n{environment()}")
    widen(box)
    return box


def widen(box: QMessageBox) -> None:
    """Give a message room for a path in one line: else its first, short sentence is the measure."""
    layout = box.layout()
    assert isinstance(layout, QGridLayout)
    least = box.fontMetrics().averageCharWidth() * MESSAGE_CHARACTERS
    layout.addItem(QSpacerItem(least, 0), layout.rowCount(), 0, 1, layout.columnCount())


def left_open_dialog(
    parent: QWidget,
    recording: Recording,
    unfilled: Sequence[Unfilled],
    go_to: Callable[[Gap], None],
) -> QDialog:
    """Make the list of the gaps that a fill left open, with the reasons.

    A double-click, or Enter, goes to a gap; the list stays, so that one can follow the other.
    """
    first = recording.first_frame
    rows = [
        (
            recording.labels[entry.gap.marker],
            frames_text(entry.gap, first),
            shown(entry.reason),
        )
        for entry in unfilled
    ]
    headers = (
        translate("Dialogs", "Marker"),
        translate("Dialogs", "Frames"),
        translate("Dialogs", "Why it stayed open"),
    )
    dialog = table_dialog(parent, translate("Dialogs", "Gaps that stayed open"), headers, rows)
    dialog.setModal(False)
    table = dialog.findChild(QTableWidget)
    assert table is not None
    table.setToolTip(translate("Dialogs", "Double-click a gap to go there"))
    table.activated.connect(lambda index: go_to(unfilled[index.row()].gap))
    return dialog


def table_dialog(
    parent: QWidget, title: str, headers: Sequence[str], rows: Sequence[Sequence[str]]
) -> QDialog:
    """Make a dialog that shows a table."""
    dialog = QDialog(parent)
    dialog.setWindowTitle(title)
    dialog.setAttribute(Qt.WidgetAttribute.WA_DeleteOnClose)
    fit_text(dialog, *TABLE_SIZE)
    table = QTableWidget(len(rows), len(headers))
    table.setHorizontalHeaderLabels(list(headers))
    table.setAccessibleName(title)
    dress(table)
    for row, texts in enumerate(rows):
        for column, text in enumerate(texts):
            table.setItem(row, column, QTableWidgetItem(text))
    if rows:
        table.selectRow(0)
    table.resizeColumnsToContents()
    table.horizontalHeader().setSectionResizeMode(len(headers) - 1, QHeaderView.ResizeMode.Stretch)
    buttons = QDialogButtonBox(QDialogButtonBox.StandardButton.Close)
    buttons.rejected.connect(dialog.reject)
    layout = QVBoxLayout(dialog)
    layout.addWidget(table)
    layout.addWidget(buttons)
    return dialog
