"""Buttons that Qt makes itself are drawn in the colours of the theme."""

from icon_colours import is_of
from PySide6.QtWidgets import QToolBar, QToolButton
from pytestqt.qtbot import QtBot

from mocapmend.theme import DARK, LIGHT
from mocapmend.views.frame_icons import EXTENSION, draw_extension


def test_what_has_no_room_is_behind_a_button_that_is_seen(qtbot: QtBot) -> None:
    bar = QToolBar()
    qtbot.addWidget(bar)
    for theme in (DARK, LIGHT):
        draw_extension(bar, theme)
        button = bar.findChild(QToolButton, EXTENSION)
        assert isinstance(button, QToolButton)
        assert is_of(button.icon(), theme.text)
