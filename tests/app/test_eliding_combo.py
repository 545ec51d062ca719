"""A text that has no room is shortened, not cut."""

import pytest
from PySide6.QtWidgets import QStyleOptionComboBox, QStylePainter
from pytestqt.qtbot import QtBot

from mocapmend.views.eliding_combo import ElidingCombo


@pytest.mark.parametrize(("width", "whole"), [(400, True), (90, False)])
def test_what_is_chosen_is_shortened_where_it_has_no_room(
    qtbot: QtBot, monkeypatch: pytest.MonkeyPatch, width: int, whole: bool
) -> None:
    combo = ElidingCombo()
    qtbot.addWidget(combo)
    text = "Never to be filled by anybody"
    combo.addItem(text)
    combo.resize(width, 28)
    combo.show()
    drawn: list[str] = []

    def draw(_painter: object, _element: object, option: QStyleOptionComboBox) -> None:
        drawn.append(option.currentText)

    monkeypatch.setattr(QStylePainter, "drawControl", draw)
    combo.grab()
    (shown,) = drawn
    assert (shown == text) is whole
    assert shown.endswith("…") is not whole
    assert combo.currentText() == text
