"""Journals that no running program holds: what a crash has left."""

import logging
from dataclasses import dataclass
from pathlib import Path

from mocapmend.errors import MocapmendError
from mocapmend.files import Source, same_file
from mocapmend.journal.file import SUFFIX, JournalFile
from mocapmend.journal.history import Subject, read_history
from mocapmend_algorithms import Progress

log = logging.getLogger(__name__)


@dataclass(frozen=True)
class Abandoned:
    """Edits that were not exported when the program ended.

    Attributes
    ----------
    journal : Path
        The file that has them.
    subject : Subject
        The recording.
    edits : int
        Number of undo commands that were done.
    time : float
        Of the last event, in seconds since 1970.
    """

    journal: Path
    subject: Subject
    edits: int
    time: float

    def belongs_to(self, source: Source) -> bool:
        """Say whether this is the recording, also where it was moved."""
        same = self.subject.stamp == source.stamp
        return same or same_file(self.subject.path, source.path)


def find_abandoned(folder: Path, progress: Progress) -> list[Abandoned]:
    """Find edits that can be recovered, the newest first; remnants without any are deleted.

    Parameters
    ----------
    folder : Path
        Where journals are; need not exist.
    progress : Progress
        Called for every journal; may cancel.
    """
    paths = [path for path in folder.glob("*" + SUFFIX) if path.is_file()]
    found = []
    for number, path in enumerate(paths):
        progress(number / len(paths))
        try:
            abandoned = _examine(path)
        except (MocapmendError, OSError) as error:
            # Of a newer version perhaps: its edits are not ours to delete.
            log.warning("journal passed over: %s", error)
        else:
            if abandoned is not None:
                found.append(abandoned)
    return sorted(found, key=lambda each: each.time, reverse=True)


def discard(journal: Path) -> None:
    """Delete a journal unless a program holds it.

    Raises
    ------
    MocapmendError
        If it cannot be opened.
    """
    try:
        file = JournalFile.claim(journal)
    except OSError as error:
        raise MocapmendError(
            f"The saved edits cannot be discarded: {error.strerror}.", str(journal)
        ) from error
    if file is not None:
        file.discard()


def _examine(path: Path) -> Abandoned | None:
    file = JournalFile.claim(path)
    if file is None:
        return None
    try:
        history = read_history(file)
        if history is None or not (history.unsaved or history.damaged):
            file.discard()
            return None
        return Abandoned(path, history.subject, history.index, path.stat().st_mtime)
    finally:
        file.close()
