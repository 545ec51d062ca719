"""Undo commands: they hold the runs before and after, never a copy of the whole."""

from collections.abc import Sequence
from weakref import ref

from PySide6.QtGui import QUndoCommand

from mocapmend.document import Document, Edit
from mocapmend.written import places_of


class EditSamples(QUndoCommand):
    """One undoable step that writes any number of runs.

    Parameters
    ----------
    document : Document
        Whose samples are written.
    edits : sequence of Edit
        What the runs shall hold.
    text : str
        What the user reads in the menu and in the history.
    """

    def __init__(self, document: Document, edits: Sequence[Edit], text: str) -> None:
        super().__init__(text)
        # The document has the stack that this is on. If they kept each other, it would be left to
        # Python's garbage collector to delete both, in an order at which Qt may crash.
        self._document = ref(document)
        self._after = tuple(edits)
        runs = [edit.gap for edit in edits]
        self._places = places_of(runs)
        # Of ten thousand runs the edits are not made before they are needed.
        self._read = document.read_runs(runs, self._places)
        self._before: tuple[Edit, ...] = ()

    @property
    def edits(self) -> tuple[Edit, ...]:
        """What it writes."""
        return self._after

    def redo(self) -> None:
        """Write the new runs."""
        self._write(self._after)

    def undo(self) -> None:
        """Write the old runs back."""
        self._before = self._before or tuple(self._read)
        self._write(self._before)

    def _write(self, edits: Sequence[Edit]) -> None:
        document = self._document()
        assert document is not None
        document.apply(edits, self._places)
