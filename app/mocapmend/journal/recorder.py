"""Writes the journal of one recording while it is edited."""

import logging
import time
from collections.abc import Callable, Iterator, Sequence
from contextlib import contextmanager
from pathlib import Path

from mocapmend.document import Edit
from mocapmend.errors import MocapmendError
from mocapmend.files import Source
from mocapmend.journal.edits import encode
from mocapmend.journal.file import JournalFile, Record
from mocapmend.journal.history import History, Subject

log = logging.getLogger(__name__)


class Recorder:
    """Notes edits; the file begins with the first of them.

    A disk that cannot be written does not stop the work: it is told once, and no more is noted.

    Parameters
    ----------
    folder : Path
        Where journals are.
    source : Source
        The recording.
    tell : callable
        Called with the error when the journal cannot be written.
    """

    def __init__(
        self, folder: Path, source: Source, tell: Callable[[MocapmendError], object]
    ) -> None:
        self._folder = folder
        self._source = source
        self._tell = tell
        self._file: JournalFile | None = None
        self._index = 0
        self._off = False

    def resume(self, file: JournalFile, history: History) -> None:
        """Go on with the journal whose edits were recovered."""
        self._file = file
        self._index = history.index
        subject = Subject.of(self._source)
        with self._guarded():
            file.keep(history.end)
            if subject != history.subject:
                file.append(subject.event())

    def push(self, text: str, edits: Sequence[Edit]) -> None:
        """Note an undo command before it is done."""
        self._write(lambda: encode(text, edits))
        self._index += 1

    def move(self, index: int) -> None:
        """Note that the user has undone or redone, up to a position in the history."""
        if index != self._index:
            self._write(lambda: ({"index": index}, b""))
            self._index = index

    def export(self, clean: bool) -> None:  # noqa: FBT001 - a slot of cleanChanged(bool)
        """Note, if it is so, that a file has what is done at this position in the history."""
        if clean:
            self._write(lambda: ({"clean": self._index}, b""))

    def discard(self) -> None:
        """Delete the journal and write no more: the edits are exported or given up."""
        if self._file is not None:
            self._file.discard()
        self._off = True

    def close(self) -> None:
        """Let go of the journal and write no more: the edits can be recovered."""
        if self._file is not None:
            self._file.close()
        self._off = True

    def _write(self, make: Callable[[], Record]) -> None:
        if self._off:
            return
        with self._guarded():
            if self._file is None:
                self._file = JournalFile.create(self._folder)
                self._file.append(Subject.of(self._source).event())
            self._file.append(*make())

    @contextmanager
    def _guarded(self) -> Iterator[None]:
        """Stop writing at the first error."""
        try:
            yield
        except OSError as error:
            self._off = True
            log.warning("journal of %s: %s", self._source.path, error)
            self._tell(
                MocapmendError(
                    f"The journal cannot be written: {error.strerror}. Edits since "
                    f"{time.strftime('%H:%M')} are not protected against a crash.",
                    str(self._folder),
                    "Export them soon.",
                )
            )
