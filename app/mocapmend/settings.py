"""What the program remembers between runs: one table, typed reads, nothing pickled."""

import json
import math
import sys
from dataclasses import dataclass
from pathlib import Path
from typing import Generic, TypeVar, cast

import platformdirs
from PySide6.QtCore import QByteArray, QSettings

Value = TypeVar("Value")


@dataclass(frozen=True)
class Setting(Generic[Value]):
    """A remembered value: its key and what holds before the user has chosen."""

    key: str
    default: Value


THEME = Setting("window/theme", "system")
LANGUAGE = Setting("window/language", "system")
TEXT_SIZE = Setting("window/text_size", 1.0)
"""As a multiple of what the system has."""
TOUR_SHOWN = Setting(key="window/tour_shown", default=False)
SHORTCUTS = Setting[dict[str, object]]("keys/chosen", {})
"""Lists of keys by action id, for the actions whose keys the user has changed."""
LAYOUTS = Setting[dict[str, object]]("window/layouts", {})
"""States of the panes in base 64, by the names that the user gave them."""
GEOMETRY = Setting("window/geometry", b"")
LAYOUT = Setting("window/layout", b"")
RECENT_FILES = Setting[list[str]]("files/recent", [])
LAST_FOLDER = Setting("files/last_folder", "")
LABELLED_FILES = Setting[list[str]]("labels/recordings", [])
"""The labelled recordings that labels were learned from last."""
KEEP_NAMES = Setting(key="labels/keep_names", default=True)
LEAST_CONFIDENCE = Setting("labels/least_confidence", 0.5)
METHOD = Setting("repair/method", "auto")
LIMIT_GAP = Setting(key="repair/limit_gap", default=False)
MAX_GAP_MS = Setting("repair/max_gap_ms", 200.0)
LIMIT_ERROR = Setting(key="repair/limit_error", default=True)
MAX_ERROR_MM = Setting("repair/max_error_mm", 20.0)
PLOTS = Setting("plots/shown", ["plot_position"])
SAME_SCALE = Setting(key="plots/same_scale", default=False)
RANKING = Setting(key="queue/ranking", default=True)
SEARCHING = Setting(key="queue/searching", default=True)
"""Whether bad samples are looked for in the background."""
FIX_FIRST = Setting(key="repair/fix_first", default=False)
"""Whether bad samples are put right before all gaps are filled."""
COMPARE = Setting(key="repair/compare", default=True)
SMOOTHER = Setting("smooth/method", "gcv")
REFINE_NETWORK = Setting("refine/network", "")
"""Name or path of the network that was used last."""
REFINE_FILES = Setting[list[str]]("refine/files", [])
"""Networks of the user's own that were used lately, the last one first."""
REFINE_STRIDE = Setting("refine/stride", "60")
REFINE_FILTER = Setting(key="refine/filter", default=True)
REFINE_CUTOFF = Setting("refine/cutoff_hz", 6.0)
TRAIL_SECONDS = Setting("view/trail_seconds", 0.5)
SHOWN = {
    name: Setting(f"view/{name}", default)
    for name, default in (
        ("follow", True),
        ("labels", False),
        ("trails", True),
        ("all_trails", False),
        ("sticks", True),
        ("segments", False),
        ("ground", True),
        ("plates", True),
        ("before_after", False),
        ("measure", False),
        ("companion", True),
    )
}
"""What the views show, by the id of the action that switches it."""
PLAY_SPEED = Setting("play/speed", 1.0)
MOST_MISSING_FIRST = Setting(key="timeline/most_missing_first", default=False)

RECENT_LIMIT = 10


class Settings:
    """Reads and writes the table's values; what cannot be read counts as not chosen yet."""

    def __init__(self, store: QSettings | None = None) -> None:
        self._store = store if store is not None else QSettings()

    @property
    def journal_folder(self) -> Path:
        """Where edits are kept until they are exported: beside the settings if those are a file."""
        name = self._store.fileName()
        native = self._store.format() == QSettings.Format.NativeFormat
        # The registry is no file, and the preferences of all programs share one folder.
        if not name or (native and sys.platform in {"win32", "darwin"}):
            return platformdirs.user_data_path("mocapmend", appauthor=False) / "journal"
        return Path(name).parent / "journal"

    def get(self, setting: Setting[Value]) -> Value:
        """Return the remembered value, or the default."""
        value = _decode(self._store.value(setting.key), setting.default)
        return cast("Value", setting.default if value is None else value)

    def chosen(self, setting: Setting[Value]) -> bool:
        """Say whether a value was remembered."""
        return _decode(self._store.value(setting.key), setting.default) is not None

    def set(self, setting: Setting[Value], value: Value) -> None:
        """Remember a value."""
        raw = QByteArray(value) if isinstance(value, bytes) else json.dumps(value)
        self._store.setValue(setting.key, raw)

    def remember_file(self, path: str) -> None:
        """Put a file at the head of the recent files."""
        recent = [path, *(known for known in self.get(RECENT_FILES) if known != path)]
        self.set(RECENT_FILES, recent[:RECENT_LIMIT])

    def forget_file(self, path: str) -> None:
        """Take a file out of the recent files."""
        self.set(RECENT_FILES, [known for known in self.get(RECENT_FILES) if known != path])


def _decode(raw: object, default: object) -> object:
    """Return a stored value of the default's type, or None when it is not one."""
    if isinstance(default, bytes):
        return bytes(raw.data()) if isinstance(raw, QByteArray) else None
    try:
        value = json.loads(raw) if isinstance(raw, str) else None
    except ValueError:
        return None
    if isinstance(default, float):
        if not isinstance(value, (int, float)) or isinstance(value, bool):
            return None
        return float(value) if math.isfinite(value) else None
    if isinstance(value, list) and not all(isinstance(item, str) for item in value):
        return None
    return value if type(value) is type(default) else None
