"""How markers predict missing ones by principal components (GF16 and F13: see `pca`).

1. The mean of the markers that predict is subtracted frame by frame (GF16, coordinates that move
   with the subject).
2. Each coordinate is scaled to unit variance over the complete frames and multiplied by its
   marker's weight exp(-d^2 / (2 s^2)), d its mean distance from the missing marker, s = 200 mm;
   the missing marker's own weight is 0.02 (GF16).
3. Principal components of the complete frames, once as they are and once with the missing markers
   set to zero. Both keep as many components as the more demanding one needs for 99 % of the sum
   of the singular values.
4. The components of the zeroed data are paired with those of the complete data, in their order. An
   incomplete frame, zero where markers are missing, is expressed in the former, each of its scores
   counts by how far the pair agrees (their inner product), and what the latter say at the missing
   markers is scaled back (F13 eq. 1, GF16).

Deviations: in step 4 the published program multiplies by all inner products between the two
bases; those off the diagonal change their sign with that of an eigenvector, which is arbitrary,
so only the diagonal, their mean over all signs, is kept. Step 1 uses all markers that predict, not
only those without any gap in the recording. At most 3000 complete frames are used.
"""

from dataclasses import dataclass
from typing import Any

import numpy as np

from mocapmend_algorithms.arrays import BoolArray, FloatArray, evenly
from mocapmend_algorithms.fill.edges import Modelled, with_edges
from mocapmend_algorithms.fill.pca_groups import Group
from mocapmend_algorithms.gaps import Gap
from mocapmend_algorithms.recording import Recording

MOST_FRAMES = 3000
STILL_MM = 1e-3
"""A coordinate that varies less stands still: its scale is no measure of anything."""
LEAST_WEIGHT = 1e-9
"""As good as none, but it can be divided by."""
CHUNK = 4096
"""Frames predicted at a time, so that long gaps need little memory."""


@dataclass(frozen=True, eq=False)
class Basis:
    """A linear map from the helpers' coordinates to the missing markers'.

    Attributes
    ----------
    group : Group
        Whose.
    map : ndarray, shape (3 helpers, 3 missing)
        Of coordinates relative to the helpers' mean and to `helper_means`.
    helper_means, missing_means : ndarray, shape (3 helpers,) and (3 missing,)
        Over the complete frames.
    notes : dict
        For the diagnostics.
    """

    group: Group
    map: FloatArray
    helper_means: FloatArray
    missing_means: FloatArray
    notes: dict[str, Any]

    @classmethod
    def learn(
        cls,
        recording: Recording,
        group: Group,
        *,
        weight_scale_mm: float,
        missing_weight: float,
        share: float,
    ) -> "Basis":
        """Find the components.

        Parameters
        ----------
        recording : Recording
            Not changed.
        group : Group
            With at least one helper and one complete frame.
        weight_scale_mm : float
            The distance s in step 2.
        missing_weight : float
            The missing markers' own weight.
        share : float
            Of the sum of the singular values, that the components must make up.

        Returns
        -------
        Basis
        """
        helpers, complete = group.helpers.size, group.complete
        markers = np.concatenate((group.helpers, group.missing))
        points = recording.points[np.ix_(evenly(complete, MOST_FRAMES), markers)]
        points = points - points[:, :helpers].mean(axis=1, keepdims=True)
        flat = points.reshape(points.shape[0], -1)
        means = flat.mean(axis=0)
        scale = np.maximum(flat.std(axis=0), STILL_MM / recording.mm)
        weights = np.exp(-0.5 * (group.distances * recording.mm / weight_scale_mm) ** 2)
        weights = np.append(weights, np.full(group.missing.size, missing_weight))
        scale /= np.repeat(np.maximum(weights, LEAST_WEIGHT), 3)
        scaled = (flat - means) / scale
        coefficients, components = reconstruction(scaled.T @ scaled, 3 * helpers, share)
        return cls(
            group,
            coefficients / scale[: 3 * helpers, None] * scale[3 * helpers :],
            means[: 3 * helpers],
            means[3 * helpers :],
            {"helpers": helpers, "components": components, "complete_frames": complete.size},
        )

    def say(self, recording: Recording, observed: BoolArray, gap: Gap) -> Modelled:
        """Say where a missing marker is in its gap and beside it."""
        at = 3 * int(np.searchsorted(self.group.missing, gap.marker))
        columns = self.map[:, at : at + 3]
        start, stop = with_edges(observed, gap)
        values = np.empty((stop - start, 3))
        for first in range(start, stop, CHUNK):
            last = min(first + CHUNK, stop)
            helpers = recording.points[first:last, self.group.helpers]
            centre = helpers.mean(axis=1)
            around = (helpers - centre[:, None]).reshape(last - first, -1) - self.helper_means
            values[first - start : last - start] = around @ columns + centre
        return Modelled(values + self.missing_means[at : at + 3], self.notes)


def reconstruction(gram: FloatArray, known: int, share: float) -> tuple[FloatArray, int]:
    """Return how known columns predict missing ones by principal components (F13 eq. 1).

    Parameters
    ----------
    gram : ndarray, shape (columns, columns)
        Cross products of the scaled columns over complete rows; the known ones come first.
    known : int
        Number of known columns.
    share : float
        Of the sum of the singular values, that the components must make up.

    Returns
    -------
    coefficients : ndarray, shape (known, columns - known)
        Missing = known @ coefficients.
    components : int
        How many were kept.
    """
    full_values, full = _components(gram)
    zero_values, zeroed = _components(gram[:known, :known])
    kept = min(max(_enough(full_values, share), _enough(zero_values, share)), known)
    zeroed, full = zeroed[:, :kept], full[:, :kept]
    agreement = np.sum(zeroed * full[:known], axis=0)
    coefficients: FloatArray = zeroed * agreement @ full[known:].T
    return coefficients, kept


def _components(gram: FloatArray) -> tuple[FloatArray, FloatArray]:
    """Return singular values, descending, and right singular vectors from cross products."""
    values, vectors = np.linalg.eigh(gram)
    return np.sqrt(np.clip(values[::-1], 0, None)), vectors[:, ::-1]


def _enough(values: FloatArray, share: float) -> int:
    return int(np.count_nonzero(np.cumsum(values) < share * values.sum())) + 1
