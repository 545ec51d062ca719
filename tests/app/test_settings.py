"""Settings are typed: what cannot be read is the default."""

import sys
from pathlib import Path

import pytest
from PySide6.QtCore import QSettings

from mocapmend.settings import (
    GEOMETRY,
    LIMIT_ERROR,
    MAX_GAP_MS,
    METHOD,
    RECENT_FILES,
    RECENT_LIMIT,
    Setting,
    Settings,
)


@pytest.mark.parametrize(
    ("setting", "value"),
    [
        (METHOD, "kalman"),
        (LIMIT_ERROR, False),
        (MAX_GAP_MS, 125.0),
        (GEOMETRY, b"\x00\xff\x01"),
        (RECENT_FILES, ["a.c3d", "步态 b.c3d"]),
    ],
)
def test_a_value_comes_back_with_its_type(
    settings: Settings, tmp_path: object, setting: Setting, value: object
) -> None:
    assert settings.get(setting) == setting.default
    settings.set(setting, value)
    settings._store.sync()
    again = Settings(QSettings(settings._store.fileName(), QSettings.Format.IniFormat))
    assert again.get(setting) == value
    assert type(again.get(setting)) is type(value)


def test_a_value_is_chosen_once_it_is_remembered(settings: Settings) -> None:
    assert not settings.chosen(MAX_GAP_MS)
    settings._store.setValue(MAX_GAP_MS.key, "nonsense")
    assert not settings.chosen(MAX_GAP_MS)
    settings.set(MAX_GAP_MS, MAX_GAP_MS.default)
    assert settings.chosen(MAX_GAP_MS)


@pytest.mark.parametrize("nonsense", ["NaN", "Infinity", "1e400", "-Infinity", "true"])
def test_a_number_is_finite(settings: Settings, nonsense: str) -> None:
    settings._store.setValue(MAX_GAP_MS.key, nonsense)
    assert settings.get(MAX_GAP_MS) == MAX_GAP_MS.default


@pytest.mark.parametrize("nonsense", ["{", "[1, 2]", "null", '"text"', "12"])
def test_nonsense_counts_as_not_chosen(settings: Settings, nonsense: str) -> None:
    for setting in (LIMIT_ERROR, RECENT_FILES, GEOMETRY):
        settings._store.setValue(setting.key, nonsense)
        assert settings.get(setting) == setting.default


def test_recent_files_are_newest_first_without_repeats(settings: Settings) -> None:
    for name in [*(f"{k}.c3d" for k in range(20)), "15.c3d"]:
        settings.remember_file(name)
    recent = settings.get(RECENT_FILES)
    assert recent[:3] == ["15.c3d", "19.c3d", "18.c3d"]
    assert len(recent) == RECENT_LIMIT
    assert len(set(recent)) == RECENT_LIMIT


def test_the_journal_is_beside_the_settings(settings: Settings, tmp_path: Path) -> None:
    assert settings.journal_folder == tmp_path / "journal"


@pytest.mark.parametrize("platform", ["win32", "darwin", "linux"])
def test_where_settings_have_no_folder_of_their_own_the_journal_has_one(
    monkeypatch: pytest.MonkeyPatch, platform: str
) -> None:
    native = Settings(QSettings("mocapmend", "mocapmend"))
    nowhere = Settings(QSettings("", QSettings.Format.IniFormat))
    monkeypatch.setattr(sys, "platform", platform)
    assert nowhere.journal_folder.parent.name == "mocapmend"
    assert native.journal_folder.is_absolute()
    assert native.journal_folder.parent.name == "mocapmend"
