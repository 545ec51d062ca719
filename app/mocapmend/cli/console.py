"""What a command prints: results on stdout, everything else on stderr."""

import json
import math
import os
import shutil
import sys
import time
from collections.abc import Sequence
from io import TextIOWrapper
from typing import Any
from unicodedata import combining, east_asian_width

from mocapmend.errors import MocapmendError

SCHEMA = 1
"""Version of the JSON output, see the schema in the resources; raised when it changes."""
STEP_S = 0.1


class Console:
    """The streams of one command.

    Parameters
    ----------
    command : str
        Its name.
    as_json : bool
        Whether stdout gets one JSON document and nothing else.
    """

    def __init__(self, command: str, *, as_json: bool) -> None:
        self.command = command
        self.as_json = as_json
        self._title = ""
        self._next = 0.0
        self._line = ""

    def say(self, text: str) -> None:
        """Print a line of the result for people."""
        if not self.as_json:
            self._clear()
            sys.stdout.write(f"{printable(text)}\n")

    def table(self, headers: Sequence[str], rows: Sequence[Sequence[str]]) -> None:
        """Print a table; headers that begin with ">" are of right-aligned columns."""
        for line in aligned(headers, rows):
            self.say(line)

    def result(self, **content: Any) -> None:
        """Print the result as JSON if that was asked for."""
        if self.as_json:
            self._clear()
            document = {"schema": SCHEMA, "command": self.command, **content}
            sys.stdout.write(json.dumps(without_nan(document), allow_nan=False, indent=1) + "\n")

    def warn(self, text: str) -> None:
        """Print a message on stderr."""
        self._clear()
        sys.stderr.write(f"mocapmend: {printable(text)}\n")

    def fail(self, error: MocapmendError) -> None:
        """Report that the job could not be done."""
        self.warn(str(error))
        self.result(error={"what": error.what, "where": error.where, "todo": error.todo})

    def start(self, title: str) -> None:
        """Name what `progress` is about from now on."""
        self._title = title
        self._next = 0.0

    def progress(self, fraction: float, /) -> None:
        """Show how far the job is, where somebody looks."""
        self.status(f"{self._title} {100 * fraction:3.0f} %")

    @property
    def changes_lines(self) -> bool:
        """Whether stderr is a terminal, where a line can take another one's place."""
        return sys.stderr.isatty()

    def status(self, line: str) -> None:
        """Show a line that the next one takes the place of, where somebody looks."""
        now = time.monotonic()
        if now < self._next or not self.changes_lines:
            return
        self._next = now + STEP_S
        # A line that is wrapped cannot be taken back.
        line = fitting(printable(line), shutil.get_terminal_size().columns - 1)
        sys.stderr.write("\r" + line + " " * (columns_of(self._line) - columns_of(line)))
        sys.stderr.flush()
        self._line = line

    def note(self, text: str) -> None:
        """Print a line on stderr that says how the job goes on."""
        self._clear()
        sys.stderr.write(f"{printable(text)}\n")
        sys.stderr.flush()

    def _clear(self) -> None:
        """Take the progress line away before anything else is printed."""
        if self._line:
            sys.stderr.write("\r" + " " * columns_of(self._line) + "\r")
            sys.stderr.flush()
            self._line = ""

    def close(self) -> None:
        """Take the progress line away and bring everything to its reader."""
        self._clear()
        # A program without a console has no stdout.
        if sys.stdout is not None:
            sys.stdout.flush()


def prepare_streams() -> None:
    """Let no character of a label or a file name fail to print."""
    for stream in (sys.stdout, sys.stderr):
        if isinstance(stream, TextIOWrapper):
            stream.reconfigure(errors="backslashreplace")


def abandon_stdout() -> None:
    """Give up stdout when its reader has gone, so that Python does not try again at its end."""
    nowhere = os.open(os.devnull, os.O_WRONLY)
    os.dup2(nowhere, sys.stdout.fileno())
    os.close(nowhere)


def printable(text: str) -> str:
    """Replace what could control a terminal: labels come from files."""
    return "".join(c if c.isprintable() or c == "\n" else "\N{REPLACEMENT CHARACTER}" for c in text)


def columns_of(text: str) -> int:
    """Return how many columns of a terminal a text takes: signs of East Asia take two."""
    return sum(
        0 if combining(sign) else 1 + (east_asian_width(sign) in {"W", "F"}) for sign in text
    )


def fitting(line: str, columns: int) -> str:
    """Cut a line that is wider than some columns."""
    while columns_of(line) > columns:
        line = line[:-1]
    return line


def without_nan(value: Any) -> Any:
    """Replace numbers that JSON does not have by None."""
    if isinstance(value, float):
        return value if math.isfinite(value) else None
    if isinstance(value, dict):
        return {key: without_nan(item) for key, item in value.items()}
    if isinstance(value, (list, tuple)):
        return [without_nan(item) for item in value]
    return value


def aligned(headers: Sequence[str], rows: Sequence[Sequence[str]]) -> list[str]:
    """Lay out a table with two spaces between the columns."""
    right = [header.startswith(">") for header in headers]
    lines = [[header.removeprefix(">") for header in headers], *rows]
    widths = [max(map(len, column)) for column in zip(*lines, strict=True)]
    return [
        "  ".join(
            cell.rjust(width) if to_right else cell.ljust(width)
            for cell, width, to_right in zip(line, widths, right, strict=True)
        ).rstrip()
        for line in lines
    ]
