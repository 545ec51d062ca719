"""The pictures of every screen, in both languages and at several scales."""

import json
import os
import subprocess
import sys
import tempfile
from pathlib import Path
from typing import NamedTuple

from mocapmend.views.appearance import SIZES

DOCS = Path(__file__).resolve().parent.parent
LANGUAGES = ("en", "zh_CN")
LARGEST = SIZES[-1]


class Display(NamedTuple):
    """A screen, in its pixels, and how many of them the window takes for one of its own.

    The text is so many times as large as the system has it.
    """

    name: str
    width: int
    height: int
    scale: float
    text: float = 1.0


DISPLAYS = (
    Display("1280x720", 1280, 720, 1.0),
    Display("4k", 3840, 2160, 2.0),
    Display("4k-at-1.5", 3840, 2160, 1.5),
    Display("1280x720-large", 1280, 720, 1.0, LARGEST),
    Display("4k-large", 3840, 2160, 2.0, LARGEST),
)


def make(folder: Path) -> None:
    """Take all pictures, one process after the other: scale and language are of a process."""
    for display in DISPLAYS:
        for language in LANGUAGES:
            there = folder.resolve() / f"{language}-{display.name}"
            there.mkdir(parents=True, exist_ok=True)
            print(there, flush=True)
            _walk(there, language, display)


def _walk(folder: Path, language: str, display: Display) -> None:
    size = (round(display.width / display.scale), round(display.height / display.scale))
    with tempfile.TemporaryDirectory() as home:
        screen = {"name": "screen", "x": 0, "y": 0, "logicalDpi": 96, "dpr": 1}
        screen |= {"width": display.width, "height": display.height}
        screens = Path(home) / "screens.json"
        screens.write_text(json.dumps({"screens": [screen]}), encoding="utf-8")
        environment = os.environ | {
            "QT_QPA_PLATFORM": f"offscreen:configfile={screens}",
            "QT_SCALE_FACTOR": str(display.scale),
            # What the file dialogs list must not be somebody's own.
            "HOME": home,
            "XDG_DATA_HOME": home,
        }
        numbers = map(str, (*size, display.text))
        subprocess.run(
            [sys.executable, "-m", "screens.walk", str(folder), language, *numbers],
            cwd=DOCS,
            env=environment,
            check=True,
        )
