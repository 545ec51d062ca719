"""What a batch has done so far: a file in the output folder to which lines are added.

A line is written before a file is begun and another when it is done, so that after a crash it is
known which copies are whole, and which files were made by a batch at all. Nothing is ever changed
in it; a line that is cut, or that something else has written, is passed over.
"""

import json
import os
from collections.abc import Mapping
from contextlib import suppress
from dataclasses import asdict, dataclass
from pathlib import Path
from typing import Any

from mocapmend.batch.results import Finished, Row, Seen, made
from mocapmend.errors import MocapmendError

NAME = "mocapmend-batch.jsonl"
KEY = "mocapmend_batch"
FORMAT = 1


@dataclass(frozen=True)
class Entry:
    """What the ledger knows of a file that was done.

    Attributes
    ----------
    key : str
        Of the plan and the program, see `Task`.
    row : Row
        What was said of it.
    input, output : Seen
        The file and its repaired copy.
    """

    key: str
    row: Row
    input: Seen
    output: Seen


class Ledger:
    """The ledger of an output folder.

    Parameters
    ----------
    folder : Path
        The output folder; it exists.

    Attributes
    ----------
    done : dict of str to Entry
        By file, what was done last.
    begun : set of str
        Files that were begun after that, and whose end nobody has seen.

    Raises
    ------
    MocapmendError
        If it cannot be read or written.
    """

    def __init__(self, folder: Path) -> None:
        self._path = folder / NAME
        try:
            self._stream = self._path.open("a+b")
            self._stream.seek(0)
            raw = self._stream.read()
        except OSError as error:
            raise self._cannot(error) from error
        self.done: dict[str, Entry] = {}
        self.begun: set[str] = set()
        for line in raw.splitlines():
            self._learn(line)
        if raw and not raw.endswith(b"\n"):
            self._append(b"")

    def begin(self, file: str) -> None:
        """Note that a file's copy is going to be written."""
        self._append(_encode({"begun": file}))

    def finish(self, finished: Finished, key: str) -> None:
        """Note that a file is done."""
        seen = {"input": finished.input, "output": finished.output}
        line = {
            "done": finished.row.file,
            "key": key,
            **{name: None if item is None else asdict(item) for name, item in seen.items()},
            "row": finished.row.as_json(),
        }
        self._append(_encode(line))
        try:
            os.fsync(self._stream.fileno())
        except OSError as error:
            raise self._cannot(error) from error

    def fail(self, file: str) -> None:
        """Note that a file has failed, and that its copy is what it was before."""
        self._append(_encode({"failed": file}))

    def close(self) -> None:
        """Give the file back; what could not be written was said when it was to be."""
        with suppress(OSError):
            self._stream.close()

    def _learn(self, line: bytes) -> None:
        """Take in what a line says, if it is one of ours."""
        try:
            data = json.loads(line)
            if data[KEY] != FORMAT:
                return
            if "begun" in data:
                self.begun.add(str(data["begun"]))
                return
            if "failed" in data:
                self.begun.discard(str(data["failed"]))
                return
            row, given, copy = data["row"], data["input"], data["output"]
            entry = Entry(str(data["key"]), Row.from_json(row), made(Seen, given), made(Seen, copy))
            if entry.row.file != data["done"]:
                return
            self.done[entry.row.file] = entry
            self.begun.discard(entry.row.file)
        except (ValueError, KeyError, TypeError, RecursionError):
            return

    def _append(self, line: bytes) -> None:
        try:
            self._stream.write(line + b"\n")
            self._stream.flush()
        except OSError as error:
            raise self._cannot(error) from error

    def _cannot(self, error: OSError) -> MocapmendError:
        return MocapmendError(
            f"The output folder cannot be written: {error.strerror}.",
            str(self._path.parent),
            "Choose another one.",
        )


def _encode(data: Mapping[str, Any]) -> bytes:
    return json.dumps({KEY: FORMAT, **data}).encode("ascii")
