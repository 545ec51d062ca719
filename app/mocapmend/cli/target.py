"""Where `repair` may write: nothing is lost by mistake, and nobody waits for a refusal."""

import argparse
import os
from pathlib import Path

from mocapmend.cli.usage import UsageError
from mocapmend.errors import MocapmendError
from mocapmend.files import same_file


def choose(arguments: argparse.Namespace) -> Path:
    """Return where the repaired recording goes, after checking it and the report's place.

    Raises
    ------
    UsageError
        If the arguments contradict each other.
    MocapmendError
        If something is in the way.
    """
    source: Path = arguments.file
    out: Path | None = arguments.output
    report: Path | None = arguments.report
    if arguments.in_place:
        if out is not None and not same_file(out, source):
            raise UsageError("--in-place replaces IN itself: give no other OUT")
        out = source
    elif out is None:
        raise UsageError("give -o OUT for the repaired copy, or --in-place to replace IN")
    else:
        if same_file(out, source):
            raise MocapmendError(
                "This is the recording itself.",
                str(out),
                "Choose another name, or add --in-place to replace it.",
            )
        _check_place(out, overwrite=arguments.overwrite)
    if report is not None:
        if same_file(report, source) or same_file(report, out):
            raise MocapmendError(
                "The report would replace the recording.", str(report), "Choose another name."
            )
        _check_place(report, overwrite=arguments.overwrite)
    return out


def _check_place(path: Path, *, overwrite: bool) -> None:
    if path.is_dir():
        raise MocapmendError("This is a folder, not a file.", str(path), "Name a file in it.")
    if path.exists() and not overwrite:
        raise MocapmendError(
            "There is already a file of this name.",
            str(path),
            "Choose another name, or add --overwrite to replace it.",
        )
    folder = Path(os.path.realpath(path)).parent
    if not folder.is_dir():
        raise MocapmendError(
            "The folder does not exist.", str(folder), "Create it or choose another."
        )
    if not os.access(folder, os.W_OK):
        raise MocapmendError(
            "You may not write into this folder.", str(folder), "Choose another one."
        )
