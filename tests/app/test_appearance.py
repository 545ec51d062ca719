"""The theme follows the user or the system, and the text has the size that the user wants."""

from collections.abc import Callable, Iterator
from pathlib import Path

import pytest
from PySide6.QtCore import Qt
from PySide6.QtGui import QGuiApplication, QPalette
from PySide6.QtWidgets import QApplication, QLabel, QTableView
from pytestqt.qtbot import QtBot

from mocapmend.document import Document
from mocapmend.settings import TEXT_SIZE, THEME, Settings
from mocapmend.theme import DARK, LIGHT
from mocapmend.views.appearance import SIZES, Appearance
from mocapmend.views.main_window import MainWindow
from mocapmend.views.recovery_dialog import RecoveryDialog
from mocapmend.views.report_plots import ReportPlot
from mocapmend.views.shortcuts_dialog import ShortcutsDialog

SCHEMES = Qt.ColorScheme


@pytest.fixture(autouse=True)
def _normal_text() -> Iterator[None]:
    """Give the program its font back for other tests."""
    font = QApplication.font()
    yield
    QApplication.setFont(font)


@pytest.fixture
def system(monkeypatch: pytest.MonkeyPatch) -> Callable[[Qt.ColorScheme], None]:
    """Return a function that makes the system light or dark."""

    class Hints:
        scheme = SCHEMES.Unknown
        colorSchemeChanged = QGuiApplication.styleHints().colorSchemeChanged  # noqa: N815

        def colorScheme(self) -> Qt.ColorScheme:  # noqa: N802
            return self.scheme

    hints = Hints()
    monkeypatch.setattr(QGuiApplication, "styleHints", lambda: hints)

    def change(scheme: Qt.ColorScheme) -> None:
        hints.scheme = scheme
        hints.colorSchemeChanged.emit(scheme)

    return change


def ground() -> str:
    return QApplication.palette().color(QPalette.ColorRole.Base).name()


def test_at_first_it_is_as_the_system_else_dark(
    settings: Settings, system: Callable[[Qt.ColorScheme], None], qtbot: QtBot
) -> None:
    appearance = Appearance(settings)
    assert appearance.theme is DARK
    system(SCHEMES.Light)
    assert appearance.theme is LIGHT
    assert Appearance(settings).theme is LIGHT
    system(SCHEMES.Dark)
    assert appearance.theme is DARK


def test_a_chosen_theme_does_not_follow_the_system(
    settings: Settings, system: Callable[[Qt.ColorScheme], None], qtbot: QtBot
) -> None:
    appearance = Appearance(settings)
    appearance.choose("dark")
    system(SCHEMES.Light)
    assert appearance.theme is DARK
    assert Appearance(settings).theme is DARK
    appearance.choose("system")
    assert appearance.theme is LIGHT
    settings.set(THEME, "nonsense")
    assert appearance.choice == "system"


def test_the_window_changes_its_colours(
    open_in: Callable[[Path], MainWindow], gait: Path, settings: Settings
) -> None:
    window = open_in(gait)
    actions = window.actions_by_id
    assert actions["theme_system"].isChecked()
    actions["theme_light"].trigger()
    assert ground() == LIGHT.base
    assert window.workspace is not None
    assert window.workspace.scene._theme is LIGHT
    assert not actions["theme_system"].isChecked()
    assert settings.get(THEME) == "light"
    actions["theme_dark"].trigger()
    assert ground() == DARK.base


def test_the_text_gets_larger_and_smaller_and_normal(
    window: MainWindow, settings: Settings, qtbot: QtBot
) -> None:
    normal = QApplication.font().pointSizeF()
    for key in (Qt.Key.Key_Plus, Qt.Key.Key_Equal):
        qtbot.keyClick(window, key, Qt.KeyboardModifier.ControlModifier)
    assert QApplication.font().pointSizeF() == pytest.approx(normal * 1.3)
    assert settings.get(TEXT_SIZE) == 1.3
    title = next(each for each in window.findChildren(QLabel) if each.text() == "mocapmend")
    for label, size in ((window.statusBar(), 1.3), (title, 1.3 * 2.4)):
        expected = pytest.approx(normal * size)
        qtbot.waitUntil(lambda label=label, e=expected: label.font().pointSizeF() == e)
    qtbot.keyClick(window, Qt.Key.Key_Minus, Qt.KeyboardModifier.ControlModifier)
    assert settings.get(TEXT_SIZE) == 1.15
    qtbot.keyClick(window, Qt.Key.Key_0, Qt.KeyboardModifier.ControlModifier)
    assert QApplication.font().pointSizeF() == normal


def test_the_size_has_limits_and_is_remembered(window: MainWindow, settings: Settings) -> None:
    normal = QApplication.font().pointSizeF()
    for _ in range(20):
        window.appearance.step_text(1)
    assert window.appearance.text_size == SIZES[-1]
    QApplication.setFont(window.font())
    assert Appearance(settings).text_size == SIZES[-1]
    for _ in range(20):
        window.appearance.step_text(-1)
    assert window.appearance.text_size == SIZES[0]
    settings.set(TEXT_SIZE, 100.0)
    assert Appearance(settings).text_size == SIZES[-1]
    assert QApplication.font().pointSizeF() == pytest.approx(2.0 * normal)


def test_tables_and_panes_grow_with_their_text(
    open_in: Callable[[Path], MainWindow], gait: Path, qtbot: QtBot
) -> None:
    window = open_in(gait)
    # Room to grow: at 1280 pixels the middle has the least that it can do with.
    window.resize(1900, 900)
    assert window.workspace is not None
    window.workspace.show_pane(window.workspace.markers)
    table: QTableView = window.workspace.markers.table
    qtbot.waitUntil(lambda: window.workspace.arranged)
    pane = window.workspace.panes()[0]
    height, width, room = table.rowHeight(0), table.columnWidth(1), pane.width()
    for _ in range(3):
        window.appearance.step_text(1)
    qtbot.waitUntil(lambda: table.rowHeight(0) >= height * 1.3)
    qtbot.waitUntil(lambda: pane.width() >= room * 1.3)
    assert table.columnWidth(1) >= width * 1.3
    window.appearance.step_text(0)
    qtbot.waitUntil(lambda: (table.rowHeight(0), table.columnWidth(1)) == (height, width))


@pytest.fixture
def largest(settings: Settings) -> Settings:
    """Return settings with the largest text."""
    settings.set(TEXT_SIZE, SIZES[-1])
    return settings


def test_the_window_fits_a_small_screen_with_the_largest_text(
    largest: Settings, open_in: Callable[[Path], MainWindow], gait: Path, qtbot: QtBot
) -> None:
    window = open_in(gait)
    assert window.workspace is not None
    qtbot.waitUntil(lambda: window.workspace.arranged)
    window.actions_by_id["plot_bone"].setChecked(True)
    least = window.minimumSizeHint()
    assert least.width() <= 1280
    assert least.height() <= 720


def test_dialogs_grow_with_the_text_but_not_beyond_the_screen(
    window: MainWindow, qtbot: QtBot
) -> None:
    normal = RecoveryDialog(window, []).size()
    window.appearance.step_text(1)
    grown = RecoveryDialog(window, []).size()
    assert grown.width() > normal.width()
    assert grown.height() > normal.height()
    for _ in SIZES:
        window.appearance.step_text(1)
    room = window.screen().availableSize()
    assert RecoveryDialog(window, []).size().boundedTo(room) == RecoveryDialog(window, []).size()
    assert ShortcutsDialog(window.shortcuts, window).width() < room.width()


def test_icons_grow_with_the_text_and_are_drawn_in_their_size(window: MainWindow) -> None:
    normal = window.toolbar.iconSize()
    for _ in SIZES:
        window.appearance.step_text(1)
    assert window.toolbar.iconSize() == SIZES[-1] * normal
    assert window.transport.button.iconSize() == SIZES[-1] * normal
    drawn = window.actions_by_id["open"].icon().availableSizes()
    assert window.toolbar.iconSize() * window.devicePixelRatioF() in drawn


def test_titles_in_the_report_are_as_large_as_other_texts(document: Document, qtbot: QtBot) -> None:
    plot = ReportPlot(document, "%")
    qtbot.addWidget(plot)
    plot.say("title", "#ffffff")
    for size in (9.0, 18.0):
        font = plot.font()
        font.setPointSizeF(size)
        plot.setFont(font)
        assert f"font-size:{size:g}pt" in plot.getPlotItem().titleLabel.item.toHtml()
