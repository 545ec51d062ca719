"""Profiles of refinement networks, one TOML file each, and trained networks, one archive each.

CREDITS.md says what the networks were trained on.
"""

import tomllib
from importlib.resources import files
from pathlib import Path
from typing import Any

from mocapmend_resources.archives import names_in, path_in

PROFILE = ".toml"
FOLDER = Path(str(files(__name__)))


def names() -> tuple[str, ...]:
    """Return the names of the networks that ship with the program."""
    return names_in(FOLDER)


def path_of(name: str) -> Path:
    """Return where a network is; `KeyError` if none of this name ships with the program."""
    return path_in(FOLDER, name)


def profiles() -> dict[str, dict[str, Any]]:
    """Return what the files of the profiles hold, by their ids."""
    found = sorted(FOLDER.glob(f"*{PROFILE}"))
    return {path.stem: tomllib.loads(path.read_text("utf-8")) for path in found}
