"""Which command a command line means, and what becomes of its errors."""

import argparse
import difflib
import logging
import sys
from collections.abc import Sequence
from importlib import import_module
from pathlib import Path

from mocapmend import __version__, log
from mocapmend.cli.console import Console, abandon_stdout, prepare_streams
from mocapmend.cli.usage import UsageError
from mocapmend.errors import MocapmendError

DONE, FAILED, INTERRUPTED = 0, 1, 130
COMMANDS = {
    "info": "say what a file holds",
    "gaps": "list the gaps of a file",
    "problems": "list the samples of a file that are there but wrong",
    "repair": "fill gaps and write a repaired copy",
    "batch": "repair many files by one plan, on all cores or on a cluster",
    "label": "propose labels for points without names, from labelled recordings",
    "report": "write a report on a recording that was repaired earlier",
    "replay": "make the edits of a recipe again",
    "convert": "write a recording in another format",
    "refine": "turn the joints of a Kinect into the markers of a motion-capture system",
    "train": "make what methods learn from: train sparse, train refine",
    "check": "prove that a repaired C3D file differs from its original in repaired samples alone",
    "bench": "measure speed and accuracy: bench io, bench gui, bench gaps, bench problems",
}
PARTS = {
    "train": {
        "sparse": "gather what the sparse methods learn from",
        "refine": "train a network that refines recordings of a cheap sensor",
    },
}
"""Commands of several parts: each is a module of its own."""
_HELP = """\
commands (mocapmend COMMAND --help says more):
{commands}

A recording that is named like a command opens as ./NAME.
Exit code: 0 done, 1 the job could not be done, 2 wrong usage.
"""

logger = logging.getLogger(__name__)


def main(argv: Sequence[str] | None = None) -> int:
    """Do what a command line says.

    Parameters
    ----------
    argv : sequence of str, optional
        Its arguments, by default those of the process.

    Returns
    -------
    int
        The exit code.

    Raises
    ------
    SystemExit
        With code 2 for wrong usage, and with 0 after --help.
    """
    arguments = list(sys.argv[1:] if argv is None else argv)
    command = arguments.pop(0) if arguments[:1] and arguments[0] in COMMANDS else "window"
    console = Console(command, as_json="--json" in arguments)
    prepare_streams()
    log.set_up()
    try:
        try:
            code = _run(command, arguments, console)
        except MocapmendError as error:
            logger.info("%s: %s", command, error)
            console.fail(error)
            code = FAILED
        except BrokenPipeError:
            raise
        except Exception as error:
            logger.exception("unexpected error in %s", command)
            console.fail(_unexpected(error))
            code = FAILED
        console.close()
    except KeyboardInterrupt:
        console.warn("Interrupted.")
        return INTERRUPTED
    except BrokenPipeError:
        abandon_stdout()
        return FAILED
    return code


def _run(command: str, arguments: list[str], console: Console) -> int:
    if command == "window":
        return _window(arguments, console)
    if command == "bench":
        return _bench(arguments)
    if command in PARTS:
        command = f"{command} {_part(command, arguments[:1])}"
        console.command, arguments = command, arguments[1:]
    module = import_module("mocapmend.cli." + command.replace(" ", "."))
    parser = argparse.ArgumentParser(
        prog=f"mocapmend {command}", description=module.__doc__, allow_abbrev=False
    )
    module.add_arguments(parser)
    parser.add_argument("--json", action="store_true", help="print one JSON document on stdout")
    try:
        code: int = module.run(parser.parse_args(arguments), console)
    except UsageError as error:
        parser.error(str(error))
    return code


def _part(command: str, arguments: list[str]) -> str:
    """Read which part of a command is asked for, without loading one."""
    parser = argparse.ArgumentParser(
        prog=f"mocapmend {command}",
        description=import_module(f"mocapmend.cli.{command}").__doc__,
        epilog=f"mocapmend {command} PART --help says more.",
        allow_abbrev=False,
    )
    parts = parser.add_subparsers(dest="part", metavar="PART", required=True)
    for name, text in PARTS[command].items():
        parts.add_parser(name, help=text, add_help=False)
    chosen: str = parser.parse_args(arguments).part
    return chosen


def _window(arguments: list[str], console: Console) -> int:
    width = max(map(len, COMMANDS))
    listed = "\n".join(f"  {name:{width}}  {text}" for name, text in COMMANDS.items())
    parser = argparse.ArgumentParser(
        prog="mocapmend",
        usage="%(prog)s [FILE]\n       %(prog)s COMMAND ...\n       %(prog)s --version [--json]",
        description="Inspect and repair optical motion-capture recordings. "
        "Without a command, the window opens.",
        epilog=_HELP.format(commands=listed),
        formatter_class=argparse.RawDescriptionHelpFormatter,
        allow_abbrev=False,
    )
    parser.add_argument("files", nargs="*", type=Path, metavar="FILE", help="a recording to open")
    parser.add_argument("--version", action="store_true", help="print the version")
    parser.add_argument("--json", action="store_true", help=argparse.SUPPRESS)
    parsed = parser.parse_args(arguments)
    if parsed.version:
        console.command = "version"
        console.say(f"mocapmend {__version__}")
        console.result(version=__version__)
        return DONE
    if parsed.json:
        parser.error("--json goes with a command")
    if mistake := _mistake(parsed.files):
        parser.error(mistake)
    return _open_window(parsed.files[0] if parsed.files else None)


def _mistake(files: Sequence[Path]) -> str:
    """Say why these cannot be recordings to open; empty where they can."""
    several = len(files) > 1
    first = str(files[0]) if files else ""
    if first and "." not in first and not files[0].exists():
        meant = difflib.get_close_matches(first, COMMANDS, n=1, cutoff=0.75)
        if meant:
            return f"there is no command and no file {first!r}; did you mean {meant[0]!r}?"
        if several:
            return f"there is no command and no file {first!r}"
    return "the window opens one recording at a time" if several else ""


def _open_window(file: Path | None) -> int:
    # Nothing but the window may load Qt.
    try:
        from mocapmend.views.application import run
    except ImportError as error:
        logger.exception("the window cannot be loaded")
        raise MocapmendError(
            f"The window cannot be opened: {error}.",
            todo="Install the missing system library, or use the commands (mocapmend --help).",
        ) from error
    return run(file)


def _bench(arguments: list[str]) -> int:
    try:
        from mocapmend.bench import main as run
    except ImportError as error:
        raise MocapmendError(
            f"The benchmarks are not there: {error}.", todo="Install a version that has them."
        ) from error
    code: int = run(arguments)
    return code


def _unexpected(error: Exception) -> MocapmendError:
    return MocapmendError(
        f"Something went wrong inside the program ({type(error).__name__}: {error}).",
        str(log.log_path()),
        "This log file has the details: please report it.",
    )
