"""Colours of the window, light and dark, from one place.

The colours of states are those of Okabe and Ito (2008), which colour-blind people can tell apart,
darker where the ground is light; the curves of markers keep clear of them.
"""

from dataclasses import dataclass
from typing import Any, Literal

import pyqtgraph
from PySide6.QtGui import QColor, QPalette
from PySide6.QtWidgets import QApplication

from mocapmend.state import SampleState

ThemeName = Literal["dark", "light"]


@dataclass(frozen=True)
class Theme:
    """Every colour that a view paints with, as "#rrggbb" or "#aarrggbb"."""

    name: ThemeName
    window: str
    base: str
    raised: str
    text: str
    dim: str
    line: str
    edge: str
    accent: str
    on_accent: str
    playhead: str
    bone: str
    marker: str
    preview: str
    candidate: str
    companion: str
    gap_shade: str
    fill_shade: str
    smooth_shade: str
    states: tuple[tuple[SampleState, str], ...]
    curves: tuple[str, ...]

    def state_colour(self, state: SampleState) -> str:
        """Return the colour of a sample's state."""
        return dict(self.states)[state]


DARK = Theme(
    name="dark",
    window="#1f2227",
    base="#16181c",
    raised="#2b2f36",
    text="#e4e7eb",
    dim="#98a0ab",
    line="#3a3f48",
    edge="#717a88",
    accent="#3d8bfd",
    on_accent="#0b0f16",
    playhead="#ffffff",
    bone="#5f6875",
    marker="#c9d1db",
    preview="#f0e442",
    candidate="#c9b8f5",
    companion="#7d9a86",
    gap_shade="#48e69f00",
    fill_shade="#3056b4e9",
    smooth_shade="#2ccc79a7",
    states=(
        (SampleState.MEASURED, "#3b424c"),
        (SampleState.MISSING, "#e69f00"),
        (SampleState.BAD, "#d55e00"),
        (SampleState.FILLED, "#56b4e9"),
        (SampleState.NEVER, "#8a6a2b"),
        (SampleState.SMOOTHED, "#cc79a7"),
    ),
    curves=("#2fc79a", "#cc79a7", "#a9b7ff", "#e4e7eb", "#ff9d7a", "#9ad14b"),
)

LIGHT = Theme(
    name="light",
    window="#f3f4f6",
    base="#ffffff",
    raised="#e7e9ed",
    text="#1c2026",
    dim="#5e6774",
    line="#d3d7dd",
    edge="#737b87",
    accent="#0b63d6",
    on_accent="#ffffff",
    playhead="#14171b",
    bone="#87909d",
    marker="#424a56",
    preview="#a84d00",
    candidate="#6a4aa5",
    companion="#6b8672",
    gap_shade="#40e69f00",
    fill_shade="#300072b2",
    smooth_shade="#268f3b82",
    states=(
        (SampleState.MEASURED, "#d9dde3"),
        (SampleState.MISSING, "#c07c00"),
        (SampleState.BAD, "#c1121f"),
        (SampleState.FILLED, "#0072b2"),
        (SampleState.NEVER, "#9a7d40"),
        (SampleState.SMOOTHED, "#8f3b82"),
    ),
    curves=("#00805c", "#a3457a", "#4553c4", "#424a56", "#b4532a", "#5c7a00"),
)

THEMES: dict[str, Theme] = {theme.name: theme for theme in (DARK, LIGHT)}

FIELDS: tuple[Any, ...] = (
    "QCheckBox", "QRadioButton", "QLineEdit", "QAbstractSpinBox", "QComboBox", "QListWidget",
    "QMenu",
)  # fmt: skip
"""Classes of widgets that need an edge of their own to be seen; Qt takes str, and says bytes."""
FUSION_DARKENS = 140

AXIS_COLOURS = ("#e0524d", "#2f9a4c", "#4b8bf0")


def palette(theme: Theme) -> QPalette:
    """Make the palette of all standard widgets."""
    role = QPalette.ColorRole
    colours = {
        role.Window: theme.window,
        role.WindowText: theme.text,
        role.Base: theme.base,
        role.AlternateBase: theme.window,
        role.ToolTipBase: theme.raised,
        role.ToolTipText: theme.text,
        role.PlaceholderText: theme.dim,
        role.Text: theme.text,
        role.Button: theme.raised,
        role.ButtonText: theme.text,
        role.BrightText: theme.text,
        role.Highlight: theme.accent,
        role.HighlightedText: theme.on_accent,
        role.Link: theme.accent,
        role.Light: theme.raised,
        role.Midlight: theme.line,
        role.Mid: theme.line,
        role.Dark: theme.line,
        role.Shadow: theme.base,
        role.Accent: theme.accent,
    }
    result = QPalette()
    for which, colour in colours.items():
        result.setColor(which, QColor(colour))
    for which in (role.WindowText, role.Text, role.ButtonText):
        result.setColor(QPalette.ColorGroup.Disabled, which, QColor(theme.dim))
    return result


def field_palette(theme: Theme) -> QPalette:
    """Make the palette of what is typed into or ticked: Fusion's own edges are hardly seen."""
    result = palette(theme)
    # Fusion takes the edges from the window's colour and darkens it; these widgets paint no window.
    result.setColor(QPalette.ColorRole.Window, QColor(theme.edge).lighter(FUSION_DARKENS))
    return result


def apply(app: QApplication, theme: Theme) -> None:
    """Give the whole program a theme."""
    app.setStyle("Fusion")
    app.setPalette(palette(theme))
    for name in FIELDS:
        app.setPalette(field_palette(theme), name)
    pyqtgraph.setConfigOptions(background=theme.base, foreground=theme.dim, antialias=False)
