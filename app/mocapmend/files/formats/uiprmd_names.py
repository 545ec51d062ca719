"""Which two files of UI-PRMD belong together: their names differ in one word."""

import re
from pathlib import Path

from mocapmend.errors import MocapmendError

POSITIONS, ANGLES = "positions", "angles"
TODO = (
    "Put the two files into the same folder, or into the folders Positions and Angles, under names "
    "as m01_s01_e01_positions.txt and m01_s01_e01_angles.txt."
)


def partner(path: Path, kind: str, wanted: str) -> Path:
    """Find the file of angles that belongs to one of positions, or the other way round.

    Parameters
    ----------
    path : Path
        Of a file.
    kind, wanted : str
        What it holds and what the other one does: `POSITIONS` and `ANGLES`, in either order.

    Raises
    ------
    MocapmendError
        If its name does not say it, or there is no such file.
    """
    name = _exchanged(path.name, kind, wanted)
    if name is None:
        raise MocapmendError(
            "A recording of UI-PRMD's Kinect is two files, and the name of this one does not say "
            "which is the other.",
            str(path),
            TODO,
        )
    folders = [path.parent]
    # The folder has no name where the program was started in it.
    folder = path.absolute().parent
    beside = _exchanged(folder.name, kind, wanted)
    if beside is not None:
        folders.append(folder.with_name(beside))
    found = next((folder / name for folder in folders if (folder / name).is_file()), None)
    if found is None:
        raise MocapmendError(
            f"A recording of UI-PRMD's Kinect is two files, and the other one is not there: "
            f"{name}.",
            str(path),
            TODO,
        )
    return found


def _exchanged(text: str, old: str, new: str) -> str | None:
    """Put one word in the place of another, in capitals as that; None if it is not there."""
    places = list(re.finditer(old, text, re.IGNORECASE | re.ASCII))
    if not places:
        return None
    last = places[-1]
    if last[0].isupper():
        new = new.upper()
    elif last[0][0].isupper():
        new = new.capitalize()
    return text[: last.start()] + new + text[last.end() :]
