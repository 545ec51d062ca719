"""Profiles of refinement networks, one TOML file each, and trained networks, one archive each.

CREDITS.md says what the networks were trained on.
"""

import tomllib
from importlib.resources import files
from pathlib import Path
from typing import Any

SUFFIX = ".npz"
PROFILE = ".toml"
FOLDER = Path(str(files(__name__)))


def names() -> tuple[str, ...]:
    """Return the names of the networks that ship with the program, in order."""
    return tuple(sorted(path.stem for path in FOLDER.glob(f"*{SUFFIX}")))


def path_of(name: str) -> Path:
    """Return where a network is.

    Raises
    ------
    KeyError
        If none of this name ships with the program.
    """
    if name not in names():
        raise KeyError(f"there is no network {name!r}")
    return FOLDER / f"{name}{SUFFIX}"


def profiles() -> dict[str, dict[str, Any]]:
    """Return what the files of the profiles hold, by their ids."""
    found = sorted(FOLDER.glob(f"*{PROFILE}"))
    return {path.stem: tomllib.loads(path.read_text("utf-8")) for path in found}
