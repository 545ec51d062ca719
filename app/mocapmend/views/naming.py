"""What new files are called, and which kind of file a name and a choice mean."""

import re
from collections.abc import Iterable, Mapping
from pathlib import Path

from mocapmend.files import WRITTEN


def repaired_name(name: str) -> str:
    """Return what the repaired copy of a file is called if the user does not care.

    It is of the same format where that can be written, and a C3D file elsewhere. Copies of copies
    are numbered.
    """
    end = _ending(name, WRITTEN)
    stem = name.removesuffix(end) if end else Path(name).stem
    copy = re.fullmatch(r"(.*_repaired)(?:_(\d{1,6}))?", stem)
    again = f"{stem}_repaired" if copy is None else f"{copy[1]}_{int(copy[2] or 1) + 1}"
    return again + (end or ".c3d")


def kind_of(name: str, kinds: Mapping[str, str]) -> str:
    """Return the kind of file that a name says, or "".

    Parameters
    ----------
    name : str
        Of the file.
    kinds : mapping of str to str
        The ending of each kind.
    """
    end = _ending(name, kinds.values()).lower()
    return next((kind for kind in kinds if end and kinds[kind] == end), "")


def meant(path: Path, proposed: str, kinds: Mapping[str, str], kind: str) -> Path:
    """Return the file that a user means who left or changed a name and chose a kind.

    Parameters
    ----------
    path : Path
        What the dialog says.
    proposed : str
        The name that it began with.
    kinds : mapping of str to str
        The ending of each kind.
    kind : str
        The chosen kind.
    """
    first = kind_of(proposed, kinds)
    chosen = kind in kinds and kind != first
    # A name that the user has typed says more than the kind does.
    if path.suffix and not (chosen and path.name == proposed):
        return path
    return path.with_name(
        path.name.removesuffix(_ending(path.name, kinds.values()))
        + kinds[kind if chosen else first]
    )


def _ending(name: str, ends: Iterable[str]) -> str:
    """Return the longest of some endings that a name has, as it is written there, or ""."""
    fitting = (end for end in ends if name.lower().endswith(end))
    length = len(max(fitting, key=len, default=""))
    return name[len(name) - length :]
