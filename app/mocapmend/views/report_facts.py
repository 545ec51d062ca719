"""What a report needs to know beside the samples, gathered from the open document."""

from collections import Counter

import numpy as np

from mocapmend.changes import renames
from mocapmend.commands import EditSamples
from mocapmend.document import Document
from mocapmend.refine.judging import Judged
from mocapmend.report import (
    About,
    EditRow,
    PutRight,
    Refining,
    SmoothRow,
    method_text,
    put_right,
    refining,
)
from mocapmend.state import SampleState
from mocapmend_algorithms.fill.contract import Unfilled


class ReportFacts:
    """The facts of a document; the workspace adds what only it knows.

    Attributes
    ----------
    proof : tuple of str
        What the checks of an export that holds the present edits found.
    given, beside : Judged or None
        How far a refined recording is from the reference that was given when it was made, and
        from the recording that it is compared with, where that can be one.
    """

    def __init__(self, document: Document) -> None:
        self._document = document
        self.proof: tuple[str, ...] = ()
        self.given: Judged | None = None
        self.beside: Judged | None = None

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
            refining=self.refining(),
        )

    def refining(self) -> Refining | None:
        """Return how a network has made the recording, None where none has."""
        given, beside = self.given, self.beside
        # Of the same reference, what was measured on the network's own poses is more exact.
        same = given is not None and beside is not None and given.reference == beside.reference
        judged = given if beside is None or same else beside
        return refining(self._document.source.provenance, judged)

    def put_right(self) -> PutRight:
        """Return what was set aside, exchanged and smoothed."""
        document = self._document
        mm = document.original.mm
        smoothed = (
            SmoothRow.of(run, made.method, made.params, made.chosen, made.rms * mm)
            for run, made in document.smoothed.items()
        )
        return put_right(
            document.doubts,
            document.layers.moves,
            smoothed,
            self._found_as(),
            moved_before=document.source.moves,
            renamed=renames(document.source, document.labels),
        )

    def _found_as(self) -> Counter[str]:
        """Count the problems that were exchanged since the file was opened, by their detectors."""
        stack = self._document.undo_stack
        corrections = (self._command(i).correction for i in range(stack.index()))
        return Counter(kind for made in corrections if made for kind in made.found_as)

    def edits(self) -> tuple[EditRow, ...]:
        """Return the steps that hold, those that were undone left out."""
        stack = self._document.undo_stack
        return tuple(self._edit(i) for i in range(stack.index()))

    def undone(self) -> tuple[EditRow, ...]:
        """Return the steps that were undone and can be made again."""
        stack = self._document.undo_stack
        return tuple(self._edit(i) for i in range(stack.index(), stack.count()))

    def _edit(self, index: int) -> EditRow:
        command = self._command(index)
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

    def _command(self, index: int) -> EditSamples:
        command = self._document.undo_stack.command(index)
        assert isinstance(command, EditSamples)
        return command
