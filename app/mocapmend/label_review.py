"""Proposed labels and what the user decides about them. No Qt."""

from collections.abc import Iterator, Sequence
from dataclasses import replace
from enum import Enum, auto

from mocapmend_algorithms import Recording
from mocapmend_algorithms.gaps import overlap
from mocapmend_algorithms.labelling import LabelChanges, Labelled, Labelling, changes


class Decision(Enum):
    """What the user has said about a proposal."""

    NONE = auto()
    ACCEPTED = auto()
    REJECTED = auto()


class LabelReview:
    """The proposals for a recording: those that the user has not decided on go by confidence.

    At no frame two pieces have the same label: a piece that gets another's label takes it away.

    Parameters
    ----------
    labelling : Labelling
        The proposals.
    least : float
        Proposals below this confidence are not used, unless the user accepts them.

    Attributes
    ----------
    rows : list of int
        Which of the proposals are to be looked at, the least sure first: those for pieces whose
        names nobody has given.
    """

    def __init__(self, labelling: Labelling, least: float) -> None:
        self.labels = labelling.labels
        self.least = least
        self._labelling = labelling
        self._now = list(labelling.proposals)
        self._decided = [Decision.NONE] * len(self._now)
        wanted = (k for k, proposal in enumerate(self._now) if not proposal.kept)
        self.rows = sorted(wanted, key=lambda k: self._now[k].confidence)

    def __len__(self) -> int:
        return len(self.rows)

    def proposal(self, row: int) -> Labelled:
        """Return what is proposed in a row, or what the user has chosen there."""
        return self._now[self.rows[row]]

    def decision(self, row: int) -> Decision:
        """Return what the user has said about a row."""
        return self._decided[self.rows[row]]

    def label(self, row: int) -> str | None:
        """Return the label of a row; None where the piece is no marker."""
        return self._name(self.proposal(row).label)

    def used(self, row: int) -> bool:
        """Say whether a row's label would be given."""
        return self._is_used(self.rows[row])

    def decide(self, row: int, decision: Decision) -> None:
        """Note what the user says about a row."""
        self._decided[self.rows[row]] = decision

    def choose(self, row: int, label: int | None) -> None:
        """Take another label for a row, which is accepted by that.

        Pieces of the same time that have this label get none.
        """
        chosen = self.rows[row]
        for k in self._rivals(chosen, label):
            self._now[k] = replace(self._now[k], label=None, kept=False)
            self._decided[k] = Decision.NONE
        self._now[chosen] = replace(self._now[chosen], label=label)
        self._decided[chosen] = Decision.ACCEPTED

    def choices(self, row: int) -> tuple[list[int], list[int]]:
        """Return the labels that no other piece has while a row's piece is there, and the rest."""
        chosen = self.rows[row]
        taken = {self._now[k].label for k in self._meeting(chosen)}
        every = range(len(self.labels))
        return [k for k in every if k not in taken], [k for k in every if k in taken]

    def counts(self) -> tuple[int, int]:
        """Return how many rows have a label that would be given, and how many there are."""
        return sum(self.used(row) and self.label(row) is not None for row in range(len(self))), len(
            self
        )

    def changes(self, recording: Recording) -> LabelChanges:
        """Return what makes the labels true that would be given to a recording."""
        proposals = tuple(
            replace(proposal, confidence=1.0 if self._is_used(k) else 0.0)
            for k, proposal in enumerate(self._now)
        )
        labelling = replace(self._labelling, proposals=proposals)
        return changes(labelling, recording, least_confidence=0.5)

    def names_at(self, frame: int) -> dict[int, str]:
        """Return what points would be called in a frame, as far as that is proposed."""
        found = {}
        for k in self.rows:
            proposal = self._now[k]
            piece, name = proposal.piece, self._name(proposal.label)
            if piece.start <= frame < piece.stop and name is not None and self._is_used(k):
                found[piece.point] = name
        return found

    def _name(self, label: int | None) -> str | None:
        return None if label is None else self.labels[label]

    def _is_used(self, k: int) -> bool:
        proposal, decided = self._now[k], self._decided[k]
        if proposal.kept or decided is Decision.ACCEPTED:
            return True
        return decided is Decision.NONE and proposal.confidence >= self.least

    def _rivals(self, chosen: int, label: int | None) -> Sequence[int]:
        if label is None:
            return ()
        return [k for k in self._meeting(chosen) if self._now[k].label == label]

    def _meeting(self, chosen: int) -> Iterator[int]:
        """Yield the pieces that share frames with another one."""
        own = self._now[chosen].piece
        for k, proposal in enumerate(self._now):
            if k != chosen and overlap(own, proposal.piece):
                yield k
