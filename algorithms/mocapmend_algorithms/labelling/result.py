"""What labelling a recording gives."""

from dataclasses import dataclass
from typing import NamedTuple

import numpy as np
from numpy.typing import NDArray


class Piece(NamedTuple):
    """A stretch of a point without a jump: frames start to stop - 1, counted from 0, all seen."""

    point: int
    start: int
    stop: int

    @property
    def length(self) -> int:
        """Number of frames."""
        return self.stop - self.start


@dataclass(frozen=True)
class Labelled:
    """What is proposed for a piece.

    Attributes
    ----------
    piece : Piece
        Where it is.
    label : int or None
        Index into the labels of the `Labelling`; None where it is none of them, as a reflection.
    confidence : float
        How sure that is, 0 to 1: about the share of such proposals that are right.
    reason : str
        A plain sentence.
    kept : bool
        Whether it has this label already and was trusted.
    """

    piece: Piece
    label: int | None
    confidence: float
    reason: str
    kept: bool = False


@dataclass(frozen=True)
class Labelling:
    """The labels of a recording's pieces.

    Attributes
    ----------
    labels : tuple of str
        Those of the model, without a subject.
    proposals : tuple of Labelled
        One for each piece, by point and start. At no frame two pieces have the same label.
    scale : float
        Size of the body beside the model's; NaN where nothing could be labelled.
    """

    labels: tuple[str, ...]
    proposals: tuple[Labelled, ...]
    scale: float

    def by_sample(self, shape: tuple[int, int]) -> NDArray[np.int64]:
        """Return the label of each sample.

        Parameters
        ----------
        shape : tuple of int
            Frames and points of the recording.

        Returns
        -------
        ndarray of int, shape (frames, points)
            Index of the label; -1 where there is none.
        """
        found = np.full(shape, -1, np.int64)
        for proposal in self.proposals:
            if proposal.label is not None:
                piece = proposal.piece
                found[piece.start : piece.stop, piece.point] = proposal.label
        return found
