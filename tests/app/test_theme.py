"""Colours can be read: contrast as WCAG 2 defines it, in both themes."""

from itertools import combinations

import pytest
from PySide6.QtCore import Qt
from PySide6.QtGui import QColor
from PySide6.QtWidgets import (
    QApplication,
    QCheckBox,
    QLineEdit,
    QListWidget,
    QListWidgetItem,
    QMenu,
    QSpinBox,
    QWidget,
)
from pytestqt.qtbot import QtBot

from mocapmend.state import SampleState
from mocapmend.theme import AXIS_COLOURS, DARK, LIGHT, Theme, apply

BOTH = pytest.mark.parametrize("theme", [DARK, LIGHT], ids=["dark", "light"])
READABLE, ENHANCED, GRAPHICS = 4.5, 7.0, 3.0


def luminance(colour: str) -> float:
    """Return the relative luminance."""
    parts = (QColor(colour).redF(), QColor(colour).greenF(), QColor(colour).blueF())
    linear = [c / 12.92 if c <= 0.04045 else ((c + 0.055) / 1.055) ** 2.4 for c in parts]
    return 0.2126 * linear[0] + 0.7152 * linear[1] + 0.0722 * linear[2]


def contrast(one: str, other: str) -> float:
    dark, light = sorted((luminance(one), luminance(other)))
    return (light + 0.05) / (dark + 0.05)


def grounds(theme: Theme) -> tuple[str, ...]:
    return theme.window, theme.base, theme.raised


def test_contrast_is_that_of_the_standard() -> None:
    assert contrast("#000000", "#ffffff") == pytest.approx(21.0)
    assert contrast("#767676", "#ffffff") == pytest.approx(4.54, abs=0.01)


@BOTH
def test_text_is_read_easily(theme: Theme) -> None:
    assert min(contrast(theme.text, ground) for ground in grounds(theme)) >= ENHANCED


@BOTH
def test_dimmed_text_is_read(theme: Theme) -> None:
    assert min(contrast(theme.dim, ground) for ground in grounds(theme)) >= READABLE


@BOTH
def test_links_and_selected_text_are_read(theme: Theme) -> None:
    assert contrast(theme.accent, theme.window) >= READABLE
    assert contrast(theme.accent, theme.base) >= READABLE
    assert contrast(theme.on_accent, theme.accent) >= READABLE


@BOTH
def test_what_is_drawn_is_seen_on_its_ground(theme: Theme) -> None:
    drawn = {
        "playhead": theme.playhead,
        "bone": theme.bone,
        "marker": theme.marker,
        "preview": theme.preview,
        "companion": theme.companion,
        **{f"curve {k}": colour for k, colour in enumerate(theme.curves)},
        **{f"axis {k}": colour for k, colour in enumerate(AXIS_COLOURS)},
    }
    weak = {name: contrast(colour, theme.base) for name, colour in drawn.items()}
    assert {name: value for name, value in weak.items() if value < GRAPHICS} == {}


@BOTH
@pytest.mark.parametrize("kind", [QCheckBox, QLineEdit, QSpinBox, QListWidget, QMenu])
def test_fields_have_an_edge_that_is_seen(
    qtbot: QtBot, qapp: QApplication, theme: Theme, kind: type[QWidget]
) -> None:
    apply(qapp, theme)
    field = kind()
    qtbot.addWidget(field)
    if isinstance(field, QListWidget):
        item = QListWidgetItem(field)
        item.setCheckState(Qt.CheckState.Unchecked)
    if isinstance(field, QMenu):
        field.addAction("M").setCheckable(True)
    ground, image = theme.window, field.grab().toImage()
    seen = {image.pixelColor(x, y).name() for x in range(13) for y in range(image.height())}
    assert max(contrast(colour, ground) for colour in seen) >= GRAPHICS


@BOTH
def test_states_stand_out(theme: Theme) -> None:
    """Measured samples are the ground of a lane: the others stand out from it."""
    states = dict(theme.states)
    measured = states.pop(SampleState.MEASURED)
    for state, colour in states.items():
        assert contrast(colour, theme.base) >= GRAPHICS, state
        assert contrast(colour, measured) >= 2.0, state
    assert contrast(measured, theme.base) >= 1.3


@BOTH
def test_states_are_different_colours(theme: Theme) -> None:
    for (_, one), (_, other) in combinations(theme.states, 2):
        assert one != other
