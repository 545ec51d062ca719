"""Proposed labels that somebody should look at, as problems beside the bad samples. No Qt."""

from collections.abc import Iterator

import numpy as np

from mocapmend.document import Document
from mocapmend.label_review import Decision, LabelReview
from mocapmend.ranking import Status
from mocapmend_algorithms.labelling import Labelled
from mocapmend_algorithms.problems import BadRun

UNSURE = "unsure-labels"
"""Stands where a bad run has the id of its detector."""
_STATUS = {
    Decision.NONE: Status.FOUND,
    Decision.ACCEPTED: Status.FIXED,
    Decision.REJECTED: Status.DISMISSED,
}


class UnsureLabels:
    """The pieces of a review whose labels are too unsure to be given, and those decided upon.

    Parameters
    ----------
    document : Document
        The recording.
    """

    def __init__(self, document: Document) -> None:
        self._document = document
        self._review: LabelReview | None = None
        self._runs: list[BadRun] = []
        """By row of the review."""
        self._row_of: dict[BadRun, int] = {}

    def take(self, review: LabelReview | None) -> None:
        """Take note of other proposals, or that there are none for the recording as it is."""
        if review is not self._review:
            self._review = review
            rows = range(0 if review is None else len(review))
            self._runs = [] if review is None else [self._run_of(review, row) for row in rows]
            self._row_of = {run: row for row, run in enumerate(self._runs)}

    def listed(self) -> Iterator[tuple[BadRun, Status]]:
        """Yield the pieces to be looked at, and what the user has said about them."""
        known = ((run, self.status(run)) for run in self._runs)
        return ((run, status) for run, status in known if status is not None)

    def status(self, run: BadRun) -> Status | None:
        """Return what the user has said about a piece; None where it is not listed."""
        review, row = self._review, self.row(run)
        if review is None or row is None:
            return None
        decision = review.decision(row)
        unsure = decision is not Decision.NONE or run.score < review.least
        return _STATUS[decision] if unsure else None

    def row(self, run: BadRun | None) -> int | None:
        """Return the review's row of a piece."""
        return None if run is None else self._row_of.get(run)

    def run(self, row: int) -> BadRun | None:
        """Return the piece of a row of the review, where it is listed."""
        if self._review is None:
            return None
        run = self._runs[row]
        return None if self.status(run) is None else run

    def label(self, run: BadRun) -> str | None:
        """Return what is proposed for a piece by now; None for no marker."""
        review, row = self._review, self.row(run)
        return None if review is None or row is None else review.label(row)

    def decide(self, run: BadRun, decision: Decision) -> None:
        """Note what the user says about a piece."""
        review, row = self._review, self.row(run)
        if review is not None and row is not None:
            review.decide(row, decision)

    @property
    def left(self) -> int:
        """How many of them nothing was said about."""
        return sum(status is Status.FOUND for _, status in self.listed())

    def _run_of(self, review: LabelReview, row: int) -> BadRun:
        proposal = review.proposal(row)
        piece = proposal.piece
        off = (1.0 - proposal.confidence) * self._nearest(proposal)
        return BadRun(
            UNSURE, piece.point, piece.start, piece.stop, proposal.confidence, off, proposal.reason
        )

    def _nearest(self, proposal: Labelled) -> float:
        """Return how far the nearest other point is: so far off is a marker with its label."""
        piece = proposal.piece
        points = self._document.base.points[(piece.start + piece.stop - 1) // 2]
        distances = np.linalg.norm(points - points[piece.point], axis=1)
        distances[piece.point] = np.nan
        known = distances[~np.isnan(distances)]
        return float(known.min()) if len(known) else float("nan")
