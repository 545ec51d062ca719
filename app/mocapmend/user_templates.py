"""The user's own skeleton templates: TOML files in a folder of theirs."""

import tomllib
from pathlib import Path

import platformdirs

from mocapmend.errors import MocapmendError
from mocapmend.files.opening import open_file
from mocapmend_algorithms.skeleton import Template, parse_template

MOST_BYTES = 1_000_000
MOST_FILES = 200


def folder() -> Path:
    """Return the folder; it need not exist."""
    return platformdirs.user_data_path("mocapmend", appauthor=False) / "skeletons"


def load(where: Path | None = None) -> tuple[tuple[Template, ...], tuple[str, ...]]:
    """Read the user's templates.

    Parameters
    ----------
    where : Path, optional
        Their folder; `folder()` by default.

    Returns
    -------
    templates : tuple of Template
        Those that are right, in the order of their file names.
    complaints : tuple of str
        A sentence for each file that is left out.
    """
    templates, complaints = [], []
    for path in _files(where or folder()):
        try:
            templates.append(_read(path))
        except (MocapmendError, ValueError) as error:
            why = error.what.rstrip(".") if isinstance(error, MocapmendError) else str(error)
            complaints.append(f"The skeleton template {path} is left out: {why}.")
    return tuple(templates), tuple(complaints)


def _files(where: Path) -> list[Path]:
    try:
        return sorted(where.glob("*.toml"))[:MOST_FILES]
    except OSError:
        return []


def _read(path: Path) -> Template:
    with open_file(path) as (stream, stamp):
        if stamp.size > MOST_BYTES:
            raise ValueError("it is larger than 1 MB")
        raw = stream.read()
    try:
        data = tomllib.loads(raw.decode("utf-8"))
    except UnicodeDecodeError:
        raise ValueError("it is not UTF-8 text") from None
    except RecursionError:
        raise ValueError("it is nested too deeply") from None
    except tomllib.TOMLDecodeError as error:
        raise ValueError(f"it is not TOML: {error}") from None
    return parse_template(data)
