"""Writes the journal of one recording while it is edited.

An edit is on the disk before it is made. A step of thousands of runs takes too long for that: a
thread brings it there, once the window has shown what it changes, and before anything else can be
noted. So a crash costs at most the last edit.
"""

import logging
import time
from collections.abc import Callable, Mapping, Sequence
from pathlib import Path
from threading import Event, Thread

from mocapmend.believed import Correction
from mocapmend.edits import Edit
from mocapmend.errors import MocapmendError
from mocapmend.files import Source
from mocapmend.journal.edits import encode
from mocapmend.journal.file import JournalFile, Record
from mocapmend.journal.history import History, Subject

log = logging.getLogger(__name__)

AT_ONCE = 500
"""Runs of a step that are written while the user waits."""
RESPITE_S = 0.2
"""How long the thread leaves the processor to the window when such a step is made."""


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
        Called with the error when the journal cannot be written, in the thread that notes edits.
    """

    def __init__(
        self, folder: Path, source: Source, tell: Callable[[MocapmendError], object]
    ) -> None:
        self._folder = folder
        self._source = source
        self._tell = tell
        self._file: JournalFile | None = None
        self._subject: Subject | None = None
        self._describing: Thread | None = None
        self._writing: Thread | None = None
        self._waited_for = Event()
        self._error: OSError | None = None
        self._index = 0
        self._off = False

    def get_ready(self) -> None:
        """Describe the recording in a thread: its checksum takes a while, and an edit needs it."""
        if self._describing is None:
            self._describing = Thread(target=self._describe, name="journal")
            self._describing.start()

    def resume(self, file: JournalFile, history: History) -> None:
        """Go on with the journal whose edits were recovered."""
        self._file = file
        self._index = history.index
        subject = self._described()
        try:
            file.keep(history.end)
            if subject != history.subject:
                file.append(subject.event())
        except OSError as error:
            self._give_up(error)

    def push(
        self,
        text: str,
        edits: Sequence[Edit],
        correction: Correction | None = None,
        labels: Mapping[int, str] | None = None,
    ) -> None:
        """Note an undo command before it is done; the edits are never changed after."""
        self._write(lambda: encode(text, edits, correction, labels), later=len(edits) > AT_ONCE)
        self._index += 1

    def move(self, index: int) -> None:
        """Note that the user has undone or redone, up to a position in the history."""
        if index != self._index:
            self._write(lambda: ({"index": index}, b""))
            self._index = index

    def export(self, clean: bool) -> None:  # noqa: FBT001 - a slot of cleanChanged(bool)
        """Note, if it is so, that a file has what is done at this position in the history."""
        if clean:
            index = self._index
            self._write(lambda: ({"clean": index}, b""))

    def wait(self) -> None:
        """Wait until what was noted is on the disk, and tell it if that could not be done."""
        if self._writing is not None:
            self._waited_for.set()
            self._writing.join()
            self._writing = None
        if self._error is not None:
            error, self._error = self._error, None
            self._give_up(error)

    def poll(self) -> bool:
        """Say whether what was noted is on the disk, or could not be: then that is told."""
        if self._writing is not None and self._writing.is_alive():
            return False
        self.wait()
        return True

    def discard(self) -> None:
        """Delete the journal and write no more: the edits are exported or given up."""
        self.wait()
        if self._file is not None:
            self._file.discard()
        self._off = True

    def close(self) -> None:
        """Let go of the journal and write no more: the edits can be recovered."""
        self.wait()
        if self._file is not None:
            self._file.close()
        self._off = True

    def _describe(self) -> None:
        self._subject = Subject.of(self._source)

    def _described(self) -> Subject:
        """Return the recording's description, once it is complete."""
        self.get_ready()
        assert self._describing is not None
        self._describing.join()
        assert self._subject is not None
        return self._subject

    def _write(self, make: Callable[[], Record], *, later: bool = False) -> None:
        self.wait()
        if self._off:
            return
        if later:
            self._waited_for.clear()
            self._writing = Thread(target=self._append_later, args=(make,), name="journal")
            self._writing.start()
        else:
            self._append(make)
            self.wait()

    def _append_later(self, make: Callable[[], Record]) -> None:
        self._waited_for.wait(RESPITE_S)
        self._append(make)

    def _append(self, make: Callable[[], Record]) -> None:
        try:
            if self._file is None:
                self._file = JournalFile.create(self._folder)
                self._file.append(self._described().event())
            self._file.append(*make())
        except OSError as error:
            self._error = error

    def _give_up(self, error: OSError) -> None:
        """Write no more."""
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
