"""Columns of a table share its room."""

from PySide6.QtWidgets import QTableWidget
from pytestqt.qtbot import QtBot

from mocapmend.views.tables import narrow


def test_the_stretched_column_stays_legible(qtbot: QtBot) -> None:
    table = QTableWidget(1, 3)
    qtbot.addWidget(table)
    table.verticalHeader().hide()
    narrow(table, {1: 80, 2: 60})
    table.show()

    def first() -> int:
        return table.horizontalHeader().sectionSize(0)

    table.resize(500, 80)
    qtbot.waitUntil(lambda: first() > 300)
    table.resize(150, 80)
    qtbot.waitUntil(lambda: first() == 60)
