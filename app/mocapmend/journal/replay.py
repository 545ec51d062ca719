"""The edits of a journal, done again."""

from contextlib import ExitStack
from pathlib import Path

from mocapmend.commands import EditSamples
from mocapmend.document import Document
from mocapmend.errors import MocapmendError
from mocapmend.journal.edits import decode, decode_correction, decode_labels
from mocapmend.journal.file import JournalFile
from mocapmend.journal.history import History, read_history, unusable


def resume(path: Path, document: Document) -> tuple[JournalFile, History]:
    """Do the edits of a journal again, and hold the journal, to go on with it.

    Parameters
    ----------
    path : Path
        Of the journal.
    document : Document
        The recording as it was opened. After an error it has none of the edits.

    Raises
    ------
    MocapmendError
        If the journal does not fit the recording, cannot be read, or another program has it. It
        stays as it is.
    """
    try:
        file = JournalFile.claim(path)
    except OSError as error:
        raise MocapmendError(
            f"The saved edits cannot be read: {error.strerror}.", str(path)
        ) from error
    if file is None:
        raise MocapmendError(
            "Another window has recovered or discarded these edits.", str(document.source.path)
        )
    with ExitStack() as undone:
        undone.callback(file.close)
        history = read_history(file)
        if history is None:
            raise unusable(path)
        if not history.subject.matches(document.source):
            raise MocapmendError(
                "The recording was changed since these edits were made.",
                str(document.source.path),
                "Put the former file back and open it; the edits are kept until you discard them.",
            )
        _replay(history, document, path)
        undone.pop_all()
    return file, history


def _replay(history: History, document: Document, path: Path) -> None:
    try:
        original = document.original
        steps = [
            (
                *decode(*step, original),
                decode_correction(step[0], original),
                decode_labels(step[0], original),
            )
            for step in history.steps
        ]
    except (AttributeError, KeyError, TypeError, ValueError) as error:
        raise unusable(path) from error
    stack = document.undo_stack
    if history.clean < 0:
        stack.resetClean()
    for position, (text, edits, correction, labels) in enumerate(steps, start=1):
        stack.push(EditSamples(document, edits, text, correction, labels))
        if position == history.clean:
            stack.setClean()
    stack.setIndex(history.index)
