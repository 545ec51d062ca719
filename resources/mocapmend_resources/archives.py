"""NumPy archives that ship with the program, by the names of their files."""

from pathlib import Path

SUFFIX = ".npz"


def names_in(folder: Path) -> tuple[str, ...]:
    """Return the names of the archives in a folder, in order."""
    return tuple(sorted(path.stem for path in folder.glob(f"*{SUFFIX}")))


def path_in(folder: Path, name: str) -> Path:
    """Return where an archive is.

    Raises
    ------
    KeyError
        If none of this name is there.
    """
    if name not in names_in(folder):
        raise KeyError(f"there is nothing called {name!r}")
    return folder / f"{name}{SUFFIX}"
