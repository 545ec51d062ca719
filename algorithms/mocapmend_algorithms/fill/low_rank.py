"""Missing markers from the correlation of all markers (principal components).

GF16 = Gløersen and Federolf 2016, "Predicting missing marker trajectories in human motion data
using marker intercorrelations", PLoS ONE 11(3):e0152616, and F13 = Federolf 2013, PLoS ONE
8(10):e78689, whose equation 1 is the reconstruction. Written anew; the steps and constants are
those of the authors' published program (PredictMissingMarkers, as M. Tits has passed it on).

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
R1 does so once, with all markers that have a gap anywhere set to zero. R2 treats each marker
with gaps by itself: other markers with gaps help only if they are nearer than half the mean
distance and present throughout the gap.

Deviations: in step 4 the published program multiplies by all inner products between the two
bases; those off the diagonal change their sign with that of an eigenvector, which is arbitrary,
so only the diagonal, their mean over all signs, is kept. Step 1 uses all markers that predict, not
only those without any gap in the recording. R2's overlap is judged gap by gap and not for all gaps
of a marker together, and where fewer than 3 markers can help by its rule, all that are present
throughout the gap do. Where too few frames are complete, the markers that are missing most are left
out (R1 fills them in further rounds). At most 3000 complete frames are used. The residual at the
edges is carried into the gap, which the paper does not do (`meet_edges`).
"""

from collections.abc import Sequence
from dataclasses import dataclass
from functools import partial
from typing import Any

import numpy as np

from mocapmend_algorithms.arrays import BoolArray, FloatArray, IntArray, evenly
from mocapmend_algorithms.fill.company import (
    LEAST_FRAMES,
    mean_distances,
    seen_together,
)
from mocapmend_algorithms.fill.contract import FillResult
from mocapmend_algorithms.fill.edges import (
    EdgeParams,
    Modelled,
    meet_edges,
    obstacle,
    with_edges,
)
from mocapmend_algorithms.fill.params import option
from mocapmend_algorithms.fill.punch import fill_with_bands
from mocapmend_algorithms.gaps import Gap
from mocapmend_algorithms.progress import Progress
from mocapmend_algorithms.recording import Recording

LEAST_HELPERS = 3
MOST_FRAMES = 3000
STILL_MM = 1e-3
"""A coordinate that varies less stands still: its scale is no measure of anything."""
LEAST_WEIGHT = 1e-9
"""As good as none, but it can be divided by."""
CHUNK = 4096
"""Frames predicted at a time, so that long gaps need little memory."""


@dataclass(frozen=True)
class PcaR1Params(EdgeParams):
    """Parameters of `pca-r1`."""

    weight_scale_mm: float = option(
        200.0,
        label="Distance scale",
        text="Markers much farther away than this from the missing one hardly count.",
        minimum=10.0,
        maximum=10000.0,
        unit="mm",
    )
    missing_weight: float = option(
        0.02,
        label="Weight of the missing marker",
        text="How much the missing marker itself shapes the components, 1 = as much as a marker "
        "at its place.",
        minimum=1e-6,
        maximum=1.0,
    )
    components: float = option(
        99.0,
        label="Components",
        text="Share of the sum of the singular values that the components kept make up.",
        minimum=50.0,
        maximum=99.9999,
        unit="%",
    )


@dataclass(frozen=True)
class PcaR2Params(PcaR1Params):
    """Parameters of `pca-r2`."""

    near: float = option(
        0.5,
        label="Near markers",
        text="Markers with gaps of their own help only if they are nearer than this share of the "
        "mean distance of all markers.",
        minimum=0.0,
        maximum=10.0,
    )


def pca_r1(
    recording: Recording, gaps: Sequence[Gap], params: PcaR1Params, progress: Progress, /
) -> FillResult:
    """Fill all gaps at once from the markers that have none (GF16, strategy R1).

    Parameters
    ----------
    recording : Recording
        Not changed.
    gaps : sequence of Gap
        The gaps to fill.
    params : PcaR1Params
        See there.
    progress : Progress
        Called often.

    Returns
    -------
    FillResult
        With the number of markers (`helpers`), `components` and `complete_frames` in the notes.
        Gaps stay open where fewer than 3 markers are without gaps, or fewer than 10 frames are
        complete.
    """
    return fill_with_bands(recording, gaps, partial(_fill, params=params, group=_r1), progress)


def pca_r2(
    recording: Recording, gaps: Sequence[Gap], params: PcaR2Params, progress: Progress, /
) -> FillResult:
    """Fill each marker's gaps from the markers that are present in them (GF16, strategy R2).

    Parameters
    ----------
    recording : Recording
        Not changed.
    gaps : sequence of Gap
        The gaps to fill.
    params : PcaR2Params
        See there.
    progress : Progress
        Called often.

    Returns
    -------
    FillResult
        With the number of markers (`helpers`), `components` and `complete_frames` in the notes.
        Gaps stay open where fewer than 3 markers help, or fewer than 10 frames are complete.
    """
    return fill_with_bands(recording, gaps, partial(_fill, params=params, group=_r2), progress)


@dataclass(frozen=True, eq=False)
class _Group:
    """Gaps that one decomposition fills.

    Attributes
    ----------
    helpers, missing : ndarray of int
        Markers that predict and markers set to zero.
    distances : ndarray, shape (helpers,)
        From the (nearest) missing marker.
    complete : ndarray of int
        Frames that show them all.
    gaps : list of Gap
        Of the missing markers.
    few : str
        What few markers do where there are too few helpers, to say why the gaps stay open.
    """

    helpers: IntArray
    missing: IntArray
    distances: FloatArray
    complete: IntArray
    gaps: list[Gap]
    few: str


def _r1(
    recording: Recording, observed: BoolArray, gaps: Sequence[Gap], params: PcaR1Params
) -> list[_Group]:
    helpers = np.flatnonzero(observed.all(axis=0))
    rest = np.setdiff1d(np.flatnonzero(observed.any(axis=0)), helpers)
    groups = []
    while gaps and rest.size:
        most_seen = rest[np.argmax(np.count_nonzero(observed[:, rest], axis=0))]
        missing, complete = seen_together(observed, rest, int(most_seen))
        rest = np.setdiff1d(rest, missing)
        away = [mean_distances(recording, observed, marker) for marker in missing.tolist()]
        among = [gap for gap in gaps if gap.marker in missing]
        distances = np.min(away, axis=0)[helpers]
        groups.append(_Group(helpers, missing, distances, complete, among, "have no gap at all"))
    return groups


def _r2(
    recording: Recording, observed: BoolArray, gaps: Sequence[Gap], params: PcaR2Params
) -> list[_Group]:
    seen, whole = observed.any(axis=0), observed.all(axis=0)
    distances: dict[int, FloatArray] = {}
    groups: dict[tuple[int, bytes], _Group] = {}
    for gap in gaps:
        marker = gap.marker
        if marker not in distances:
            distances[marker] = mean_distances(recording, observed, marker)
        away = distances[marker]
        near = away <= params.near * np.mean(away[seen])
        start, stop = with_edges(observed, gap)
        there: BoolArray = np.asarray(seen & observed[start:stop].all(axis=0))
        helps: BoolArray = np.asarray(there & (whole | near))
        if np.count_nonzero(helps) < LEAST_HELPERS:
            helps = there
        key = marker, helps.tobytes()
        if key not in groups:
            candidates = np.append(np.flatnonzero(helps), marker)
            together, complete = seen_together(observed, candidates, marker)
            helpers = np.setdiff1d(together, [marker])
            few = "are seen throughout the gap"
            missing = np.array([marker])
            groups[key] = _Group(helpers, missing, away[helpers], complete, [], few)
        groups[key].gaps.append(gap)
    return list(groups.values())


def _fill(
    recording: Recording,
    observed: BoolArray,
    gaps: Sequence[Gap],
    progress: Progress,
    /,
    *,
    params: Any,
    group: Any,
) -> FillResult:
    said: dict[Gap, Modelled | str] = {gap: obstacle(observed, gap, params) for gap in gaps}
    groups = group(recording, observed, [gap for gap in gaps if not said[gap]], params)
    for done, one in enumerate(groups):
        progress(done / len(groups))
        basis = _Basis.learn(recording, one, params)
        for gap in one.gaps:
            said[gap] = basis if isinstance(basis, str) else basis.say(recording, observed, gap)
    progress(1.0)
    return meet_edges(recording, observed, gaps, said, params)


@dataclass(frozen=True, eq=False)
class _Basis:
    """A linear map from the helpers' coordinates to the missing markers'.

    Attributes
    ----------
    group : _Group
        Whose.
    map : ndarray, shape (3 helpers, 3 missing)
        Of coordinates relative to the helpers' mean and to `means`.
    helper_means, missing_means : ndarray, shape (3 helpers,) and (3 missing,)
        Over the complete frames.
    notes : dict
        For the diagnostics.
    """

    group: _Group
    map: FloatArray
    helper_means: FloatArray
    missing_means: FloatArray
    notes: dict[str, Any]

    @classmethod
    def learn(cls, recording: Recording, group: _Group, params: PcaR1Params) -> "_Basis | str":
        """Find the components; where there is too little to learn from, say so."""
        helpers, complete = group.helpers.size, group.complete
        if complete.size < LEAST_FRAMES:
            return (
                f"only {complete.size} frames show the marker and those that predict it: this "
                f"method needs {LEAST_FRAMES}"
            )
        if helpers < LEAST_HELPERS:
            return f"of the other markers, {helpers} {group.few}: this method needs {LEAST_HELPERS}"
        markers = np.concatenate((group.helpers, group.missing))
        points = recording.points[np.ix_(evenly(complete, MOST_FRAMES), markers)]
        points = points - points[:, :helpers].mean(axis=1, keepdims=True)
        flat = points.reshape(points.shape[0], -1)
        means = flat.mean(axis=0)
        scale = np.maximum(flat.std(axis=0), STILL_MM / recording.mm)
        weights = np.exp(-0.5 * (group.distances * recording.mm / params.weight_scale_mm) ** 2)
        weights = np.append(weights, np.full(group.missing.size, params.missing_weight))
        scale /= np.repeat(np.maximum(weights, LEAST_WEIGHT), 3)
        scaled = (flat - means) / scale
        coefficients, components = reconstruction(
            scaled.T @ scaled, 3 * helpers, params.components / 100
        )
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
