"""Undo commands: they hold the runs before and after, never a copy of the whole."""

from collections.abc import Sequence

import numpy as np
from PySide6.QtGui import QUndoCommand

from mocapmend.document import Document, Edit
from mocapmend.state import ABSENT
from mocapmend.written import places_of


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
    cleared : int
        Samples that it sets missing.
    """

    def __init__(self, document: Document, edits: Sequence[Edit], text: str) -> None:
        super().__init__(text)
        self._document = document
        self._after = tuple(edits)
        runs = [edit.gap for edit in edits]
        self._places = places_of(runs)
        # Of ten thousand runs the edits are not made before they are needed.
        self._read = document.read_runs(runs, self._places)
        self._before: tuple[Edit, ...] = ()
        there = ~np.isin(document.state[self._places], ABSENT)
        goes = np.isin(np.concatenate([edit.states for edit in edits]), ABSENT)
        self.cleared = int(np.count_nonzero(there & goes))

    @property
    def edits(self) -> tuple[Edit, ...]:
        """What it writes."""
        return self._after

    def redo(self) -> None:
        """Write the new runs."""
        self._document.apply(self._after, self._places)

    def undo(self) -> None:
        """Write the old runs back."""
        self._before = self._before or tuple(self._read)
        self._document.apply(self._before, self._places)
