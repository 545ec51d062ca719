"""Buttons that Qt makes itself are drawn in the colours of the theme."""

import pytest
from PySide6.QtCore import QSize
from PySide6.QtGui import QColor, QIcon
from PySide6.QtWidgets import QAbstractButton, QDockWidget, QMainWindow, QToolBar, QToolButton
from pytestqt.qtbot import QtBot

from mocapmend.theme import DARK, LIGHT
from mocapmend.views.frame_icons import EXTENSION, TITLE_BUTTONS, TitleIcons, draw_extension


def is_of(icon: QIcon, colour: str) -> bool:
    """Say whether an icon has opaque pixels of a colour."""
    image = icon.pixmap(QSize(20, 20)).toImage()
    places = [(x, y) for x in range(image.width()) for y in range(image.height())]
    return any(image.pixelColor(x, y) == QColor(colour) for x, y in places)


def test_what_has_no_room_is_behind_a_button_that_is_seen(qtbot: QtBot) -> None:
    bar = QToolBar()
    qtbot.addWidget(bar)
    for theme in (DARK, LIGHT):
        draw_extension(bar, theme)
        button = bar.findChild(QToolButton, EXTENSION)
        assert isinstance(button, QToolButton)
        assert is_of(button.icon(), theme.text)


@pytest.mark.parametrize("name", TITLE_BUTTONS)
def test_title_buttons_follow_the_theme_and_stay_when_the_pane_floats(
    qtbot: QtBot, name: str
) -> None:
    window = QMainWindow()
    qtbot.addWidget(window)
    pane = QDockWidget("pane", window)
    button = pane.findChild(QAbstractButton, name)
    assert isinstance(button, QAbstractButton)
    titles = TitleIcons(pane, DARK)
    assert is_of(button.icon(), DARK.text)
    titles.set_theme(LIGHT)
    assert is_of(button.icon(), LIGHT.text)
    pane.setFloating(True)
    assert is_of(button.icon(), LIGHT.text)
