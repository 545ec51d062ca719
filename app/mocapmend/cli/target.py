"""Where a command may write: nothing is lost by mistake, and nobody waits for a refusal."""

import argparse
import os
from pathlib import Path

from mocapmend.cli.usage import UsageError
from mocapmend.errors import MocapmendError
from mocapmend.files import same_file


def add_arguments(parser: argparse.ArgumentParser) -> None:
    """Let a command that repairs say where its result goes."""
    add_output(parser, "the repaired copy: a C3D, TRC, CSV or NumPy file, by its ending")
    parser.add_argument("--in-place", action="store_true", help="replace the recording itself")


def add_output(parser: argparse.ArgumentParser, text: str) -> None:
    """Let a command say where its result goes, which is never the recording itself."""
    parser.add_argument("-o", "--output", type=Path, metavar="OUT", help=text)
    parser.add_argument(
        "--overwrite", action="store_true", help="replace what is there of the names given"
    )
    parser.add_argument(
        "--accept-truncated",
        action="store_true",
        help="save a recording that ends before it should",
    )


def choose(arguments: argparse.Namespace, *others: Path | None) -> Path:
    """Return where the repaired recording goes, after checking it and the other files' places.

    Parameters
    ----------
    arguments : argparse.Namespace
        Of `add_arguments` or `add_output`, with the recording as `file`.
    *others : Path or None
        What else will be written.

    Raises
    ------
    UsageError
        If the arguments contradict each other.
    MocapmendError
        If something is in the way.
    """
    source: Path = arguments.file
    out: Path | None = arguments.output
    may_replace = "in_place" in arguments
    if may_replace and arguments.in_place:
        if out is not None and not same_file(out, source):
            raise UsageError("--in-place replaces IN itself: give no other OUT")
        out = source
    elif out is None:
        raise UsageError(
            "give -o OUT for the repaired copy, or --in-place to replace IN"
            if may_replace
            else "give -o OUT for the new file"
        )
    else:
        if same_file(out, source):
            raise MocapmendError(
                "This is the recording itself.",
                str(out),
                "Choose another name"
                + (", or add --in-place to replace it." if may_replace else "."),
            )
        check_place(out, overwrite=arguments.overwrite)
    taken = [source, out]
    for other in others:
        if other is None:
            continue
        if any(same_file(other, path) for path in taken):
            raise MocapmendError(
                "Two of the files would have the same name.", str(other), "Choose another name."
            )
        check_place(other, overwrite=arguments.overwrite)
        taken.append(other)
    return out


def check_place(path: Path, *, overwrite: bool) -> None:
    """Make sure that a file can be written here.

    Raises
    ------
    MocapmendError
        If something is in the way.
    """
    # These swallow errors: one need not be allowed to look there.
    if os.path.isdir(path):  # noqa: PTH112
        raise MocapmendError("This is a folder, not a file.", str(path), "Name a file in it.")
    if os.path.exists(path) and not overwrite:  # noqa: PTH110
        raise MocapmendError(
            "There is already a file of this name.",
            str(path),
            "Choose another name, or add --overwrite to replace it.",
        )
    folder = Path(os.path.realpath(path)).parent
    if not os.path.isdir(folder):  # noqa: PTH112
        raise MocapmendError(
            "The folder does not exist.", str(folder), "Create it or choose another."
        )
    if not os.access(folder, os.W_OK):
        raise MocapmendError(
            "You may not write into this folder.", str(folder), "Choose another one."
        )
