"""Undo commands: they hold the runs before and after, never a copy of the whole."""

from collections.abc import Sequence
from weakref import ref

import numpy as np
from PySide6.QtGui import QUndoCommand

from mocapmend.document import Document
from mocapmend.edits import Contents, Edit


class EditSamples(QUndoCommand):
    """One undoable step that writes any number of runs: samples, or why they stay missing.

    Parameters
    ----------
    document : Document
        Whose samples are written.
    edits : sequence of Edit
        What the runs shall hold.
    text : str
        What the user reads in the menu and in the history.

    Attributes
    ----------
    edits : tuple of Edit
        What it writes.
    cleared : int
        Samples that it sets missing.
    """

    def __init__(self, document: Document, edits: Sequence[Edit], text: str) -> None:
        super().__init__(text)
        # The document has the stack that this is on. If they kept each other, it would be left to
        # Python's garbage collector to delete both, in an order at which Qt may crash.
        self._document = ref(document)
        self.edits = tuple(edits)
        self._after = Contents.of(self.edits)
        self._before = document.contents(self._after.gaps, self._after.places)
        self.cleared = int(np.count_nonzero(self._after.absent & ~self._before.absent))

    def redo(self) -> None:
        """Write the new runs."""
        self._write(self._after)

    def undo(self) -> None:
        """Write the old runs back."""
        self._write(self._before)

    def _write(self, contents: Contents) -> None:
        document = self._document()
        assert document is not None
        document.apply(contents)
