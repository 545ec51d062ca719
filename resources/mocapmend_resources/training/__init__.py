"""Training sets of the sparse methods, one NumPy archive each; CREDITS.md says what they are."""

from importlib.resources import files
from pathlib import Path

SUFFIX = ".npz"
FOLDER = Path(str(files(__name__)))


def names() -> tuple[str, ...]:
    """Return the names of the training sets that ship with the program, in order."""
    return tuple(sorted(path.stem for path in FOLDER.glob(f"*{SUFFIX}")))


def path_of(name: str) -> Path:
    """Return where a training set is.

    Raises
    ------
    KeyError
        If none of this name ships with the program.
    """
    if name not in names():
        raise KeyError(f"there is no training set {name!r}")
    return FOLDER / f"{name}{SUFFIX}"
