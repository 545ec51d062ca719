"""The networks that refine: those that ship with the program, and files of the user's."""

from pathlib import Path

from mocapmend.errors import MocapmendError
from mocapmend_algorithms.refine.model import Model, ModelError, read_model
from mocapmend_resources import refine as shipped

DEFAULT = "kinect22-pig39"
SUFFIX = ".npz"


def names() -> tuple[str, ...]:
    """Return the names of the networks that ship with the program."""
    return shipped.names()


def path_of(name: str) -> Path:
    """Return the file of a network; a file that is named like a shipped one is ./NAME."""
    return shipped.path_of(name) if name in shipped.names() else Path(name)


def load_model(name: str) -> Model:
    """Read a network by its name or path.

    Raises
    ------
    MocapmendError
        If it cannot be used.
    """
    try:
        return read_model(path_of(name))
    except ModelError as error:
        what = str(error)
        raise MocapmendError(
            f"{what[:1].upper()}{what[1:]}.",
            name,
            "Choose a file that “mocapmend train refine” has written, or one that ships with the "
            f"program: {', '.join(names())}.",
        ) from error
