"""Training sets that parameters name: files of the user's, and those that ship with the program.

Parameters, recipes and repair records keep the name as it was given; a method gets a path. The
SHA-256 of the file goes with the record of a repair, so that a replay learns from the same file or
says that it cannot.
"""

from collections.abc import Iterator, Mapping
from contextlib import contextmanager
from dataclasses import replace
from functools import lru_cache
from pathlib import Path
from typing import Any

from mocapmend.errors import MocapmendError
from mocapmend.files.record_values import LONGEST_TEXT
from mocapmend.files.sidecar import hash_file
from mocapmend_algorithms.params import training_names
from mocapmend_algorithms.sparse.training_set import TrainingSetError
from mocapmend_resources import training as shipped

DIGEST = "_sha256"
"""Behind the name of a parameter, in records of repairs."""


@contextmanager
def usable(params: Any) -> Iterator[Any]:
    """Give a method paths where its parameters name training sets, and tell its complaints.

    Parameters
    ----------
    params : object
        A parameter dataclass.

    Yields
    ------
    object
        The same with paths; relative ones are relative to the current folder.

    Raises
    ------
    MocapmendError
        Where the code inside raises `TrainingSetError`, or a name is too long for a record.
    """
    given = _given(params)
    for name in given.values():
        if len(name) > LONGEST_TEXT:
            raise MocapmendError(
                "The name of the training set is too long to be written down with the repairs.",
                f"{name[:50]}...",
                "Move it to a folder with a shorter name.",
            )
    try:
        yield replace(params, **{key: str(path_of(name)) for key, name in given.items()})
    except TrainingSetError as error:
        raise complaint(error, ", ".join(given.values())) from error


def path_of(name: str) -> Path:
    """Return the file of a training set; a file that is named like a shipped one is ./NAME."""
    return shipped.path_of(name) if name in shipped.names() else Path(name)


def whole_paths(params: Any) -> Any:
    """Return parameters that name the same training sets from any folder, on any machine like it.

    Parameters
    ----------
    params : object
        A parameter dataclass. Sets that ship with the program keep their names.
    """
    own = {key: name for key, name in _given(params).items() if name not in shipped.names()}
    return replace(params, **{key: str(Path(name).absolute()) for key, name in own.items()})


def complaint(error: TrainingSetError, where: str, todo: str = "") -> MocapmendError:
    """Return what the user is told when a training set cannot be used or made."""
    what = str(error).rstrip(".")
    known = ", ".join(shipped.names())
    choose = "Choose a file that “mocapmend train sparse” has written"
    choose += f", or one that ships with the program: {known}." if known else "."
    return MocapmendError(f"{what[:1].upper()}{what[1:]}.", where, todo or choose)


def digests(params: Any) -> dict[str, str]:
    """Return the SHA-256 of the training sets that parameters name, for the record of a repair.

    Those of files that have gone meanwhile are left out.
    """
    found = {key + DIGEST: _digest(path_of(name)) for key, name in _given(params).items()}
    return {key: digest for key, digest in found.items() if digest is not None}


def without_digests(parameters: Mapping[str, Any]) -> dict[str, Any]:
    """Return what a record has of a method's own parameters."""
    return {key: value for key, value in parameters.items() if not key.endswith(DIGEST)}


def require_same(params: Any, recorded: Mapping[str, Any]) -> None:
    """Make sure that the training sets are those that a record was made with.

    Parameters
    ----------
    params : object
        A parameter dataclass.
    recorded : mapping
        The parameters of a record, with the SHA-256 of training sets where it has them.

    Raises
    ------
    MocapmendError
        If one has gone or is another one.
    """
    for key, name in _given(params).items():
        digest = _digest(path_of(name))
        if digest is None:
            raise MocapmendError(
                "The recipe needs a training set that is not there.",
                name,
                "Put the file in this place; a relative one is looked for in the current folder.",
            )
        if recorded.get(key + DIGEST, digest) != digest:
            raise MocapmendError(
                "This is not the training set that the recipe was made with.",
                name,
                "Put the former file back in its place.",
            )


def _given(params: Any) -> dict[str, str]:
    """Return the names of training sets by their parameters, those that are not empty."""
    values = {key: str(getattr(params, key)) for key in training_names(type(params))}
    return {key: name for key, name in values.items() if name}


def _digest(path: Path) -> str | None:
    """Return the SHA-256 of a file, None where there is none that can be read."""
    try:
        status = path.stat()
        # A pipe or a device could be read for ever.
        return _hash(path, status.st_size, status.st_mtime_ns) if path.is_file() else None
    except (OSError, ValueError, MocapmendError):
        return None


@lru_cache(maxsize=16)
def _hash(path: Path, size: int, mtime_ns: int) -> str:
    """Hash a file once for as long as it does not change: every repair has its digest."""
    return hash_file(path)
