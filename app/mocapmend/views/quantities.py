"""What a plot can show of a marker, and the numbers of it. No Qt."""

from collections.abc import Iterable, Iterator, Sequence
from dataclasses import dataclass
from enum import Enum
from typing import Literal

import numpy as np
from numpy.typing import NDArray

from mocapmend.companion import Companion
from mocapmend.document import Document
from mocapmend.files import C3DFile
from mocapmend.views.columns import Envelope, Floats
from mocapmend_algorithms import Gap

Kind = Literal["position", "motion", "residual", "bone"]
Key = tuple[Kind, tuple[int, ...]]
"""What is computed together, of which markers."""

PORTION = 500_000
"""Frames of curves that are computed at a time: some 30 ms."""


class Quantity(Enum):
    """A quantity: what is computed together with it, and its row there."""

    X = ("position", 0)
    Y = ("position", 1)
    Z = ("position", 2)
    SPEED = ("motion", 0)
    ACCELERATION = ("motion", 1)
    RESIDUAL = ("residual", 0)
    BONE = ("bone", 0)

    @property
    def kind(self) -> Kind:
        """What is computed together."""
        kind: Kind = self.value[0]
        return kind

    @property
    def row(self) -> int:
        """Which of the curves that are computed together it is."""
        row: int = self.value[1]
        return row


@dataclass(frozen=True)
class Curve:
    """A marker in a lane and the colour that it has there; of a bone also its other end."""

    marker: int
    colour: str
    other: int | None = None

    @property
    def markers(self) -> tuple[int, ...]:
        """The markers that its values come from."""
        return (self.marker,) if self.other is None else (self.marker, self.other)


def motion(points: Floats, rate: float) -> NDArray[np.float64]:
    """Return speed and acceleration by central differences.

    Parameters
    ----------
    points : ndarray, shape (frames, 3)
        A trajectory, NaN where missing.
    rate : float
        Frames per second (Hz).

    Returns
    -------
    ndarray, shape (2, frames)
        Speed and magnitude of the acceleration per second and per second squared; NaN where the
        sample or one of its neighbours is missing, and at both ends.
    """
    result = np.full((2, len(points)), np.nan)
    before, here, after = points[:-2], points[1:-1], points[2:]
    # Zero, but NaN where the sample itself is missing: the difference around it does not see that.
    known = 0.0 * here
    velocity = (after - before + known) * (0.5 * rate)
    acceleration = (after - 2.0 * here + before) * rate**2
    for row, vectors in enumerate((velocity, acceleration)):
        result[row, 1:-1] = np.sqrt(np.einsum("tk,tk->t", vectors, vectors))
    return result


class Series:
    """The curves of a document's markers, computed when they are first shown.

    Parameters
    ----------
    document : Document or Companion
        Whose samples they are.
    """

    def __init__(self, document: Document | Companion) -> None:
        self._document = document
        source = document.source if isinstance(document, Document) else None
        self._residuals = source.residuals if isinstance(source, C3DFile) else None
        self._envelopes: dict[Key, Envelope] = {}
        self._drawn: dict[Key, tuple[Floats, Floats]] = {}
        self._drawn_for: tuple[float, ...] = ()

    @property
    def has_residuals(self) -> bool:
        """Whether the file's format has residuals."""
        return self._residuals is not None

    def forget(self, markers: set[int]) -> None:
        """Drop what was computed for markers whose samples have changed."""
        self._drawn.clear()
        for key in [key for key in self._envelopes if markers.intersection(key[1])]:
            del self._envelopes[key]

    def prepare(self, drawn: Iterable[tuple[Quantity, Curve]]) -> bool:
        """Compute a portion of what is to be drawn, where that is not there yet.

        Returns
        -------
        bool
            Whether it can be drawn now: few curves at once, many when all were there before.
        """
        keys = dict.fromkeys(
            key for quantity, curve in drawn for key in _needed(quantity.kind, curve.markers)
        )
        missing = [key for key in keys if key not in self._envelopes]
        at_a_time = max(1, PORTION // max(1, self._document.original.frames))
        for key in missing[:at_a_time]:
            self._envelope(key)
        return not missing or len(keys) <= at_a_time

    def value(self, quantity: Quantity, curve: Curve, frame: int) -> float:
        """Return the value of a curve at a frame, NaN where there is none."""
        if quantity is Quantity.RESIDUAL:
            known = self._residuals
            return np.nan if known is None else float(known[frame, curve.marker])
        # With the neighbours, for differences; not from all values: those may take long to make.
        start = max(0, frame - 1)
        ends = [self._document.points[start : frame + 2, marker] for marker in curve.markers]
        return float(self._compute(quantity.kind, ends)[quantity.row, frame - start])

    def rows(self, quantity: Quantity, curve: Curve) -> Floats:
        """Return all values of a curve, shape (frames,), NaN where there is none."""
        values: Floats = self._envelope((quantity.kind, curve.markers)).rows[quantity.row]
        return values

    def line(
        self, quantity: Quantity, curve: Curve, visible: tuple[float, float], width: int
    ) -> tuple[Floats, Floats]:
        """Return frames and values of the line that draws a curve; see `Envelope.lines`.

        What is computed together is kept for the next call with the same range.
        """
        if self._drawn_for != (*visible, width):
            self._drawn_for = (*visible, width)
            self._drawn.clear()
        key = (quantity.kind, curve.markers)
        if key not in self._drawn:
            self._drawn[key] = self._envelope(key).lines(*visible, width)
        frames, values = self._drawn[key]
        return frames, values[quantity.row]

    def patched(
        self, quantity: Quantity, curve: Curve, gap: Gap, patch: Floats
    ) -> tuple[Floats, Floats]:
        """Return frames and values of a curve with other samples in a run, with their neighbours.

        Empty for residuals, which samples that were not measured do not have.

        Parameters
        ----------
        quantity : Quantity
            What is plotted.
        curve : Curve
            Of which marker.
        gap : Gap
            The run.
        patch : ndarray, shape (length, 3)
            The samples.
        """
        if quantity is Quantity.RESIDUAL or gap.marker not in curve.markers:
            return np.empty(0), np.empty(0)
        # Differences reach one frame further than the neighbours that the line is drawn to.
        start, stop = max(0, gap.start - 2), min(self._document.original.frames, gap.stop + 2)
        ends: list[Floats] = [self._document.points[start:stop, marker] for marker in curve.markers]
        which = curve.markers.index(gap.marker)
        ends[which] = ends[which].copy()
        ends[which][gap.start - start : gap.stop - start] = patch
        frames = np.arange(start, stop)
        near = (frames >= gap.start - 1) & (frames <= gap.stop)
        values = self._compute(quantity.kind, ends)[quantity.row, near]
        return frames[near].astype(float), values

    def _envelope(self, key: Key) -> Envelope:
        if key not in self._envelopes:
            kind, markers = key
            if kind == "residual":
                rows: Floats = self._residuals_of(markers[0])
            elif kind == "position":
                rows = np.ascontiguousarray(self._document.points[:, markers[0]].T)
            else:
                # From rows that are there already: of all points one marker is slow to gather.
                ends = [self._envelope(("position", (marker,))).rows.T for marker in markers]
                rows = self._compute(kind, ends)
            self._envelopes[key] = Envelope(rows)
        return self._envelopes[key]

    def _residuals_of(self, marker: int) -> Floats:
        if self._residuals is None:
            return np.full((1, self._document.original.frames), np.nan)
        return np.ascontiguousarray(self._residuals[None, :, marker])

    def _compute(self, kind: Kind, ends: Sequence[Floats]) -> Floats:
        """Return the curves of a kind from the trajectories of its markers."""
        if kind == "position":
            return ends[0].T
        if kind == "motion":
            return motion(ends[0], self._document.original.rate)
        along = ends[0] - ends[1]
        return np.asarray(np.sqrt(np.einsum("tk,tk->t", along, along))[None])


def _needed(kind: Kind, markers: tuple[int, ...]) -> Iterator[Key]:
    """Yield what has to be computed for curves, the trajectories that they follow from first."""
    if kind in {"motion", "bone"}:
        yield from (("position", (marker,)) for marker in markers)
    yield kind, markers
