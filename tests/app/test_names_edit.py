"""A list of markers: typed, completed, or taken from the selection."""

import pytest
from PySide6.QtCore import Qt
from pytestqt.qtbot import QtBot

from mocapmend.views.names_edit import NamesEdit

KNOWN = {"LASI": "Ann:LASI", "RASI": "Ann:RASI", "LPSI": "Ann:LPSI", "A,B": "Ann:A,B"}


@pytest.fixture
def field(qtbot: QtBot) -> NamesEdit:
    made = NamesEdit((), KNOWN)
    qtbot.addWidget(made)
    made.show()
    made.edit.setFocus()
    qtbot.waitUntil(made.edit.hasFocus)
    return made


@pytest.fixture
def told(field: NamesEdit) -> list[tuple[str, ...]]:
    """Return the lists that were told, as they come."""
    lists: list[tuple[str, ...]] = []
    field.changed.connect(lambda: lists.append(field.labels()))
    return lists


def test_names_become_labels_when_the_text_is_finished(
    field: NamesEdit, told: list[tuple[str, ...]], qtbot: QtBot
) -> None:
    qtbot.keyClicks(field.edit, 'LASI, Bob:X, "A,B", LASI')
    assert told == []
    qtbot.keyClick(field.edit, Qt.Key.Key_Return)
    assert told == [("Ann:LASI", "Bob:X", "Ann:A,B")]
    qtbot.keyClick(field.edit, Qt.Key.Key_Return)
    assert len(told) == 1, "nothing has changed"
    field.edit.clear()
    assert told[-1] == ()


def test_labels_are_shown_by_their_names(qtbot: QtBot) -> None:
    field = NamesEdit(("Ann:RASI", "Bob:X", "Ann:A,B"), KNOWN)
    qtbot.addWidget(field)
    assert field.edit.text() == 'RASI, Bob:X, "A,B"'
    assert field.labels() == ("Ann:RASI", "Bob:X", "Ann:A,B")


def test_the_last_name_is_completed(
    field: NamesEdit, told: list[tuple[str, ...]], qtbot: QtBot
) -> None:
    qtbot.keyClicks(field.edit, "RASI, ps")
    popup = field.edit.completer().popup()
    qtbot.waitUntil(popup.isVisible)
    model = popup.model()
    assert [model.index(row, 0).data() for row in range(model.rowCount())] == ["LPSI"]
    qtbot.keyClick(popup, Qt.Key.Key_Down)
    qtbot.keyClick(popup, Qt.Key.Key_Return)
    qtbot.waitUntil(lambda: told == [("Ann:RASI", "Ann:LPSI")])
    assert field.edit.text() == "RASI, LPSI"
    qtbot.keyClicks(field.edit, ", a,")
    assert field.edit.text() == "RASI, LPSI, a,"


def test_a_completed_name_with_a_comma_stays_one_name(field: NamesEdit, qtbot: QtBot) -> None:
    qtbot.keyClicks(field.edit, "LPSI,a")
    popup = field.edit.completer().popup()
    qtbot.waitUntil(popup.isVisible)
    model = popup.model()
    rows = [model.index(row, 0).data() for row in range(model.rowCount())]
    assert rows == ["A,B", "LASI", "RASI"]
    qtbot.keyClick(popup, Qt.Key.Key_Down)
    qtbot.keyClick(popup, Qt.Key.Key_Return)
    qtbot.waitUntil(lambda: field.labels() == ("Ann:LPSI", "Ann:A,B"))


def test_the_selection_is_taken_over(
    field: NamesEdit, told: list[tuple[str, ...]], qtbot: QtBot
) -> None:
    assert not field.take.isEnabled()
    field.set_selection(("Ann:RASI", "Ann:A,B"))
    assert "RASI" in field.take.toolTip()
    qtbot.mouseClick(field.take, Qt.MouseButton.LeftButton)
    assert told == [("Ann:RASI", "Ann:A,B")]
    assert field.edit.text() == 'RASI, "A,B"'
    field.set_selection(())
    assert not field.take.isEnabled()
    assert field.labels() == ("Ann:RASI", "Ann:A,B")
