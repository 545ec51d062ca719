"""What a report needs to know beside the samples, gathered from the open document."""

import numpy as np

from mocapmend.commands import EditSamples
from mocapmend.document import Document
from mocapmend.report import About, EditRow, PutRight, SmoothRow, method_text, put_right
from mocapmend.state import SampleState
from mocapmend_algorithms.fill.contract import Unfilled


class ReportFacts:
    """The facts of a document; the workspace adds what only it knows.

    Attributes
    ----------
    proof : tuple of str
        What the checks of an export that holds the present edits found.
    """

    def __init__(self, document: Document) -> None:
        self._document = document
        self.proof: tuple[str, ...] = ()

    def unfilled(self) -> list[Unfilled]:
        """Return the reasons of the gaps that are open still."""
        document = self._document
        known = ((gap, document.open_reason(gap)) for gap in document.gaps)
        left = [Unfilled(gap, reason) for gap, reason in known if reason is not None]
        return left + [Unfilled(gap, document.never_reason(gap)) for gap in document.never]

    def about(self) -> About:
        """Return what the report says about its making."""
        document = self._document
        source = document.source
        # The fills of one step share their parameters: there may be thousands of them.
        made = {(one.method, id(one.params)): one for one in document.repairs.values()}
        used = {method_text(one.method, one.params) for one in made.values()}
        return About(
            file=source.path.name,
            methods=tuple(sorted(used)),
            warnings=source.warnings,
            earlier=sum(map(document.is_earlier, document.repairs)),
            earlier_program="" if source.provenance is None else source.provenance.program,
            proof=self.proof,
            edits=self.edits(),
            put_right=self.put_right(),
        )

    def put_right(self) -> PutRight:
        """Return what was set aside, exchanged and smoothed."""
        document = self._document
        mm = document.original.mm
        smoothed = (
            SmoothRow.of(run, made.method, made.params, made.chosen, made.rms * mm)
            for run, made in document.smoothed.items()
        )
        moves, before = document.layers.moves, document.source.moves
        return put_right(document.doubts, moves, smoothed, moved_before=before)

    def edits(self) -> tuple[EditRow, ...]:
        """Return the steps that hold, those that were undone left out."""
        stack = self._document.undo_stack
        return tuple(self._edit(i) for i in range(stack.index()))

    def undone(self) -> tuple[EditRow, ...]:
        """Return the steps that were undone and can be made again."""
        stack = self._document.undo_stack
        return tuple(self._edit(i) for i in range(stack.index(), stack.count()))

    def _edit(self, index: int) -> EditRow:
        command = self._document.undo_stack.command(index)
        assert isinstance(command, EditSamples)
        corrected = () if command.correction is None else command.correction.runs
        runs = {*(edit.gap for edit in command.edits), *corrected}
        # What is smoothed keeps its fills. All at once: of ten thousand one by one would be felt.
        filled = [edit.states for edit in command.edits if edit.repair and edit.smoothed is None]
        states = np.concatenate([np.empty(0, np.uint8), *filled])
        return EditRow(
            text=command.text(),
            markers=len({run.marker for run in runs}),
            runs=len(runs),
            filled=int(np.count_nonzero(states == SampleState.FILLED)),
            cleared=command.cleared,
        )
