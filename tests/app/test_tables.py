"""Columns of a table share its room."""

from PySide6.QtWidgets import QTableWidget
from pytestqt.qtbot import QtBot

from mocapmend.views.tables import narrow


def test_the_stretched_column_stays_legible(qtbot: QtBot) -> None:
    table = QTableWidget(1, 3)
    qtbot.addWidget(table)
    narrow(table, {1: 80, 2: 60})
    table.resize(150, 80)
    table.grab()
    sizes = [table.horizontalHeader().sectionSize(column) for column in range(3)]
    assert sizes == [60, 80, 60]
    table.resize(500, 80)
    table.grab()
    assert table.horizontalHeader().sectionSize(0) > 300
