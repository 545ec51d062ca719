"""Recovery of lost markers from windows: learn once, then ask for stretches (W18, section 3)."""

from collections.abc import Sequence
from functools import cached_property

import numpy as np

from mocapmend_algorithms.arrays import FloatArray
from mocapmend_algorithms.progress import Progress
from mocapmend_algorithms.recording import UpAxis
from mocapmend_algorithms.sparse.code_model import CodeModel, CodeSettings
from mocapmend_algorithms.sparse.examples import (
    Motion,
    View,
    choose_places,
    reference_pose,
)
from mocapmend_algorithms.sparse.rows import Rows
from mocapmend_algorithms.sparse.windows import Span

LEAST_EXAMPLES = 10
MOST_POSES = 200


class Recovery:
    """Tells some markers from others.

    Parameters
    ----------
    own : Motion
        The recording.
    others : sequence of Motion
        A training set.
    rows : Rows
        Which markers are seen, and which are to be found.
    span : Span
        The frames of a window.
    up : str or None
        The vertical axis; None leaves the heading as it is.
    codes : CodeSettings
        How windows are coded.
    progress : Progress
        Called often.

    Attributes
    ----------
    examples : int
        Windows that were learned from; below `LEAST_EXAMPLES` nothing was.
    """

    def __init__(
        self,
        own: Motion,
        others: Sequence[Motion],
        rows: Rows,
        span: Span,
        up: UpAxis | None,
        codes: CodeSettings,
        progress: Progress,
    ) -> None:
        self._own = own
        markers = np.union1d(rows.helpers, rows.targets)
        chosen = choose_places(own, others, markers, span, codes.atoms + codes.examples)
        self.examples = sum(places.size for _, places in chosen)
        if self.examples < LEAST_EXAMPLES:
            return
        reference = (
            None if up is None else reference_pose(chosen, rows.helpers, span, up, MOST_POSES)
        )
        self._view = View(rows, span, up or "+z", reference)
        self._model = CodeModel(*self._view.both(chosen), codes, progress)

    @cached_property
    def doubt(self) -> FloatArray | None:
        """How unsure the found places are, from what is missed of what was learned from.

        The covariance of a coordinate in the middle of a window, shape (targets, targets), in mm
        squared. None where nothing but atoms was learned from.
        """
        left = self._model.left_over
        if not len(left):
            return None
        rows = left.reshape(len(left), len(self._view.span.offsets), -1, 3)
        middle = len(self._view.span.offsets) // 2
        missed = np.linalg.pinv(self._view.rows.signs) @ rows[:, middle]
        covariance: FloatArray = np.einsum("eti,eui->tu", missed, missed) / (3 * len(missed))
        return covariance

    def ask(self, start: int, stop: int, progress: Progress) -> FloatArray:
        """Find the lost markers in a stretch in which all helpers are seen.

        Parameters
        ----------
        start, stop : int
            The frames.
        progress : Progress
            Called often.

        Returns
        -------
        ndarray, shape (stop - start, targets, 3)
            In mm; NaN in frames that no window holds.
        """
        view, own = self._view, self._own
        places = view.span.touching(start, stop, len(own.points))
        known, angles = view.known(own, places)
        complete = np.isfinite(known).all(axis=1)
        places, known, angles = places[complete], known[complete], angles[complete]
        told = view.told(self._model(known, progress), angles)
        lost = view.span.average(told, places, start, stop)
        return view.rows.places(lost, own.points[start:stop])
