"""Undo commands: they hold the runs before and after, never a copy of the whole."""

from collections.abc import Mapping, Sequence
from weakref import ref

import numpy as np
from PySide6.QtGui import QUndoCommand

from mocapmend.believed import Correction
from mocapmend.beneath import changes_smoothing_alone, without_smoothing
from mocapmend.document import Document
from mocapmend.edits import Contents, Edit


class EditSamples(QUndoCommand):
    """One undoable step that writes any number of runs: samples, or why they stay missing.

    It may correct samples and rename markers too.

    Parameters
    ----------
    document : Document
        Whose samples are written.
    edits : sequence of Edit
        What the runs shall hold.
    text : str
        What the user reads in the menu and in the history.
    correction : Correction, optional
        What is exchanged or set aside after that.
    labels : mapping of int to str, optional
        What markers are called from now on.

    Attributes
    ----------
    edits : tuple of Edit
        What it writes.
    unsmoothed : list of Edit
        Those of them that take smoothing off, because what else changes needs it.
    correction : Correction or None
        What it exchanges and sets aside.
    labels : dict of int to str
        What it calls markers.
    cleared : int
        Samples that it sets missing.
    """

    def __init__(
        self,
        document: Document,
        edits: Sequence[Edit],
        text: str,
        correction: Correction | None = None,
        labels: Mapping[int, str] | None = None,
    ) -> None:
        super().__init__(text)
        # The document has the stack that this is on. If they kept each other, it would be left to
        # Python's garbage collector to delete both, in an order at which Qt may crash.
        self._document = ref(document)
        # The last layer goes first, and comes back with undoing.
        self.unsmoothed = _unsmoothed(document, edits, correction) if document.smoothed else []
        self.edits = (*self.unsmoothed, *edits)
        self._after = Contents.of(self.edits)
        self._before = document.contents(self._after.gaps, self._after.places)
        self.correction = correction
        self.labels = dict(labels or {})
        self._former_labels = {marker: document.labels[marker] for marker in self.labels}
        self._bases = document.base_revision, document.base_revision
        if correction is not None:
            self._bases = document.base_revision, document.new_base_revision()
        self.cleared = int(np.count_nonzero(self._after.absent & ~self._before.absent))
        if correction is not None:
            self.cleared += sum(run.length for run in correction.doubts.come)

    def redo(self) -> None:
        """Write the new runs."""
        document = self._opened()
        _write(document, self._after)
        if self.correction is not None:
            document.correct(self.correction, self._bases[1])
        if self.labels:
            document.rename(self.labels)

    def undo(self) -> None:
        """Write the old runs back."""
        document = self._opened()
        if self.labels:
            document.rename(self._former_labels)
        if self.correction is not None:
            document.correct(self.correction.inverse, self._bases[0])
        _write(document, self._before)

    def _opened(self) -> Document:
        document = self._document()
        assert document is not None
        return document


def _unsmoothed(
    document: Document, edits: Sequence[Edit], correction: Correction | None
) -> list[Edit]:
    alone = [edit.gap for edit in edits if changes_smoothing_alone(document, edit)]
    kept = set(alone)
    runs = [edit.gap for edit in edits if edit.gap not in kept]
    if correction is not None:
        runs += correction.runs
    off = without_smoothing(document, runs, alone)
    return [edit for edit in off if edit.gap not in kept]


def _write(document: Document, contents: Contents) -> None:
    if contents.gaps:
        document.apply(contents)
