"""Which files a batch is about, and where their repaired copies go."""

import os
from collections.abc import Iterator
from dataclasses import dataclass
from fnmatch import fnmatchcase
from pathlib import Path, PurePath

from mocapmend.batch.ledger import NAME as LEDGER
from mocapmend.batch.results import Problem
from mocapmend.batch.seeing import is_there
from mocapmend.errors import MocapmendError
from mocapmend.files import FORMATS, WRITTEN, same_file
from mocapmend.files.sidecar import SUFFIX as SIDECAR

OTHERWISE = ".c3d"
REPORT = ".html"


@dataclass(frozen=True)
class Found:
    """A file of the folder.

    Attributes
    ----------
    file : str
        Its path within the folder, with "/" between folders.
    path : Path
        Where it is.
    output : str
        Its copy's path within the output folder.
    problem : Problem or None
        Why it cannot be repaired.
    """

    file: str
    path: Path
    output: str
    problem: Problem | None = None


def find(
    folder: Path, out: Path, pattern: str, *, recursive: bool, reserved: frozenset[str]
) -> list[Found]:
    """Find the files to repair, in the same order everywhere.

    Parameters
    ----------
    folder : Path
        Where to look. Links to files are followed, those to folders are not.
    out : Path
        Where the copies go. What is there is no input, where it lies within the folder, nor is
        what another batch has written there.
    pattern : str
        What the names of the files look like, in upper or lower case.
    recursive : bool
        Whether to look into the folders in it too.
    reserved : frozenset of str
        Names in the output folder that no copy may have.

    Raises
    ------
    MocapmendError
        If the folder cannot be read, or if the output folder is the same one.
    """
    if not os.path.isdir(folder):  # noqa: PTH112 - swallows errors
        there = is_there(folder)
        raise MocapmendError(
            "This is a file, not a folder." if there else "There is no such folder.",
            str(folder),
            "Choose the folder that the recordings are in.",
        )
    if same_file(folder, out):
        raise MocapmendError(
            "This is the folder of the recordings themselves.", str(out), "Choose another one."
        )
    listed = sorted(
        _walk(folder, out, pattern, recursive=recursive), key=lambda item: PurePath(item[0]).parts
    )
    inputs = {_place(path) for _, path, problem in listed if problem is None}
    taken = {os.path.normcase(name) for name in reserved}
    found = []
    for file, path, unusable in listed:
        output = output_name(file)
        mine = {os.path.normcase(output), os.path.normcase(output + REPORT)}
        problem = unusable or _clash(out / output, inputs)
        if problem is None and mine & taken:
            problem = Problem(
                "Another file of the output folder will have this name.",
                output,
                "Rename the recording.",
            )
        if problem is None:
            taken |= mine
        found.append(Found(file, path, output, problem))
    return found


def output_name(file: str) -> str:
    """Return the name of a copy: the file's own, or one that ends in a format that is written."""
    suffix = PurePath(file).suffix.lower()
    known = {end for item in FORMATS for end in item.suffixes}
    # A name without a known ending is taken for a C3D file, and so is that of its copy.
    return file if suffix in WRITTEN or suffix not in known else file + OTHERWISE


def _walk(
    folder: Path, out: Path, pattern: str, *, recursive: bool
) -> Iterator[tuple[str, Path, Problem | None]]:
    """Yield the files that match, and the folders that cannot be read."""
    own = os.path.realpath(out)
    errors: list[OSError] = []
    for top, folders, names in os.walk(folder, onerror=errors.append):
        here = Path(top)
        folders[:] = [
            name
            for name in folders
            if recursive and not _hidden(name, "") and not _is_output(here / name, own)
        ]
        for name in names:
            path = here / name
            if fnmatchcase(name.lower(), pattern.lower()) and not _hidden(name, pattern):
                yield path.relative_to(folder).as_posix(), path, _no_file(path)
    for error in errors:
        where = Path(error.filename)
        if where == folder:
            raise MocapmendError(
                f"The folder cannot be read: {error.strerror}.", str(folder), "Choose another one."
            ) from error
        problem = Problem(
            f"The folder cannot be read: {error.strerror}.", str(where), "Change its permissions."
        )
        yield where.relative_to(folder).as_posix(), where, problem


def _is_output(folder: Path, own: str) -> bool:
    """Say whether copies are in a folder: this batch's, or those of another one."""
    return os.path.realpath(folder) == own or is_there(folder / LEDGER)


def _hidden(name: str, pattern: str) -> bool:
    """Say whether a name is none of a recording, unless the pattern asks for such names."""
    return (name.startswith(".") and not pattern.startswith(".")) or name.endswith(SIDECAR)


def _no_file(path: Path) -> Problem | None:
    if os.path.islink(path) and not is_there(path):  # noqa: PTH114 - swallows errors
        return Problem("The link leads nowhere.", str(path), "Remove it, or mend it.")
    return None


def _place(path: Path) -> str:
    return os.path.normcase(os.path.realpath(path))


def _clash(out: Path, inputs: set[str]) -> Problem | None:
    if _place(out) in inputs or _place(out.with_name(out.name + REPORT)) in inputs:
        return Problem(
            "The repaired copy would replace a recording.", str(out), "Choose another folder."
        )
    return None
