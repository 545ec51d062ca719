"""Training sets of the sparse methods, one NumPy archive each; CREDITS.md says what they are."""

from importlib.resources import files
from pathlib import Path

from mocapmend_resources.archives import names_in, path_in

FOLDER = Path(str(files(__name__)))


def names() -> tuple[str, ...]:
    """Return the names of the training sets that ship with the program."""
    return names_in(FOLDER)


def path_of(name: str) -> Path:
    """Return where a training set is; `KeyError` if none of this name ships with the program."""
    return path_in(FOLDER, name)
