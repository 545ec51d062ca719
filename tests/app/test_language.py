"""The window is in the language that the user wants."""

import pytest
from PySide6.QtCore import QCoreApplication, QLocale
from PySide6.QtWidgets import QApplication, QDialogButtonBox
from pytestqt.qtbot import QtBot

from mocapmend.actions import menu_name
from mocapmend.settings import LANGUAGE, Settings
from mocapmend.views import language
from mocapmend.views.main_window import MainWindow


@pytest.mark.parametrize(
    ("languages", "expected"),
    [
        ([], "en"),
        (["C"], "en"),
        (["en-US", "zh-CN"], "en"),
        (["de-DE"], "en"),
        (["zh-CN"], "zh_CN"),
        (["zh-Hans-CN", "zh", "en-US"], "zh_CN"),
        (["zh"], "zh_CN"),
        (["zh-SG"], "zh_CN"),
        (["zh-TW"], "en"),
        (["zh-Hant-HK"], "en"),
    ],
)
def test_language_of_the_system(languages: list[str], expected: str) -> None:
    assert language.of_system(languages) == expected


@pytest.mark.parametrize("stored", ["", "xx", "zh"])
def test_unknown_languages_count_as_not_chosen(settings: Settings, stored: str) -> None:
    settings.set(LANGUAGE, stored)
    assert language.wanted(settings) == language.SYSTEM


@pytest.mark.parametrize("choice", language.CHOICES)
def test_choice_is_remembered_and_told(window: MainWindow, choice: str) -> None:
    before = window.menuBar().actions()[0].text()
    window.actions_by_id[f"language_{choice}"].trigger()
    assert window.settings.get(LANGUAGE) == choice
    assert "next start" in window.statusBar().currentMessage()
    checked = [c for c in language.CHOICES if window.actions_by_id[f"language_{c}"].isChecked()]
    assert checked == [choice]
    assert window.menuBar().actions()[0].text() == before


def test_english_needs_no_translation(qapp: QApplication, settings: Settings) -> None:
    settings.set(LANGUAGE, "en")
    locale = QLocale()
    try:
        assert language.install(qapp, settings) == "en"
        assert QLocale().language() == QLocale.Language.English
    finally:
        QLocale.setDefault(locale)
    assert QCoreApplication.translate("Actions", "Open…") == "Open…"


def test_system_language_is_taken_where_none_is_chosen(
    chinese: None, settings: Settings, qapp: QApplication, monkeypatch: pytest.MonkeyPatch
) -> None:
    class System:
        def uiLanguages(self) -> list[str]:  # noqa: N802
            return ["zh-CN"]

    monkeypatch.setattr(QLocale, "system", System)
    settings.set(LANGUAGE, "system")
    assert language.install(qapp, settings) == "zh_CN"


def test_window_in_chinese(chinese: None, settings: Settings, qtbot: QtBot) -> None:
    settings.set(LANGUAGE, "zh_CN")
    window = MainWindow(settings)
    qtbot.addWidget(window)
    titles = [action.text() for action in window.menuBar().actions()]
    assert titles[0] == "文件(&F)"
    assert menu_name("File") == "文件"
    assert window.actions_by_id["open"].text() == "打开…"
    assert window.actions_by_id["language_zh_CN"].isChecked()
    buttons = QDialogButtonBox(QDialogButtonBox.StandardButton.Close)
    qtbot.addWidget(buttons)
    assert "关闭" in buttons.button(QDialogButtonBox.StandardButton.Close).text()


def test_menu_name_in_english_has_no_mark() -> None:
    assert menu_name("Plots") == "Plots"
