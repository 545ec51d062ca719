"""What a journal tells: which edits of what, and how far they were undone and exported."""

import zlib
from dataclasses import dataclass, field
from pathlib import Path

import numpy as np

from mocapmend import __version__
from mocapmend.errors import MocapmendError
from mocapmend.files import Source, Stamp
from mocapmend.journal.file import Event, JournalFile, Record

FORMAT = 1


@dataclass(frozen=True)
class Subject:
    """The recording that was edited.

    Attributes
    ----------
    path : Path
        Where it was, from the root.
    stamp : Stamp
        Of the file when it was read.
    checksum : int
        CRC-32 of its coordinates: a file that was only copied or touched has the same.
    """

    path: Path
    stamp: Stamp
    checksum: int

    @classmethod
    def of(cls, source: Source) -> "Subject":
        """Describe a recording as it was read."""
        return cls(source.path.absolute(), source.stamp, _checksum(source))

    def matches(self, source: Source) -> bool:
        """Say whether a file still is what was edited."""
        if self.stamp.size != source.stamp.size:
            return False
        return self.stamp == source.stamp or self.checksum == _checksum(source)

    def event(self) -> Event:
        """Return the first event of a journal."""
        return {
            "journal": FORMAT,
            "program": __version__,
            "recording": str(self.path),
            "size": self.stamp.size,
            "mtime_ns": self.stamp.mtime_ns,
            "checksum": self.checksum,
        }


@dataclass
class History:
    """The undo history of a recording, as its journal has it.

    Attributes
    ----------
    subject : Subject
        The recording, where it was last.
    steps : list of (dict, bytes)
        The undo commands, see `edits.encode`.
    index : int
        How many of them are done; the others were undone.
    clean : int
        How many were done when the edits were exported; -1 when no undoing leads there.
    end : int
        Bytes of the journal up to what it tells last.
    damaged : bool
        Whether there is more, which cannot be read.
    """

    subject: Subject
    steps: list[Record] = field(default_factory=list)
    index: int = 0
    clean: int = 0
    end: int = 0
    damaged: bool = False

    @property
    def unsaved(self) -> bool:
        """Whether there is something to recover."""
        return self.index != self.clean

    def add(self, record: Record) -> None:
        """Take note of a record.

        Raises
        ------
        KeyError, TypeError or ValueError
            If it is none, or cannot follow what was before.
        """
        event, _ = record
        if "step" in event:
            if self.clean > self.index:
                self.clean = -1
            del self.steps[self.index :]
            self.steps.append(record)
            self.index += 1
        elif "journal" in event:
            self.subject = _subject(event)
        elif "clean" in event:
            self.clean = self._position(event["clean"])
        else:
            self.index = self._position(event["index"])

    def _position(self, value: object) -> int:
        if type(value) is not int or not 0 <= value <= len(self.steps):
            raise ValueError(f"no position in the history: {value!r}")
        return value


def read_history(file: JournalFile) -> History | None:
    """Read a journal; None when not even its first record was written.

    Raises
    ------
    MocapmendError
        If it is damaged from the beginning, or of another version of the program.
    """
    history: History | None = None
    try:
        for record, end in file.records():
            if history is None:
                history = History(_subject(record[0]))
            else:
                history.add(record)
            history.end = end
    except OSError as error:
        raise MocapmendError(
            f"The saved edits cannot be read: {error.strerror}.", str(file.path)
        ) from error
    except (KeyError, TypeError, ValueError) as error:
        raise unusable(file.path) from error
    if history is None and file.damaged:
        raise unusable(file.path)
    if history is not None:
        history.damaged = file.damaged
    return history


def unusable(path: Path) -> MocapmendError:
    """Return the error for a journal that this program cannot use."""
    return MocapmendError(
        "The saved edits are damaged, or of another version of the program.",
        str(path),
        "Try the version that made them.",
    )


def _subject(event: Event) -> Subject:
    numbers = [event[name] for name in ("journal", "size", "mtime_ns", "checksum")]
    path = event["recording"]
    if not (isinstance(path, str) and all(type(number) is int for number in numbers)):
        raise TypeError("a recording with values of other types")
    version, size, mtime_ns, checksum = numbers
    if version != FORMAT:
        raise ValueError(f"a journal of format {version}")
    return Subject(Path(path), Stamp(size, mtime_ns), checksum)


def _checksum(source: Source) -> int:
    return zlib.crc32(np.ascontiguousarray(source.recording.points).data)
