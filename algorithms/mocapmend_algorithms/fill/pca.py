"""Missing markers from the correlation of all markers (principal components).

GF16 = Gløersen and Federolf 2016, "Predicting missing marker trajectories in human motion data
using marker intercorrelations", PLoS ONE 11(3):e0152616, and F13 = Federolf 2013, PLoS ONE
8(10):e78689. Written anew; the steps and constants are those of the authors' published program
(PredictMissingMarkers, as M. Tits has passed it on). `pca_groups` chooses the markers that
predict, by strategy R1 or R2, `pca_basis` learns from them; both list where they deviate.

A deviation of the methods as a whole: the residual at the edges is carried into the gap, which the
paper does not do (`meet_edges`).
"""

from collections.abc import Callable, Sequence
from dataclasses import dataclass
from functools import partial

from mocapmend_algorithms.arrays import BoolArray
from mocapmend_algorithms.fill.company import few_frames, few_helpers
from mocapmend_algorithms.fill.contract import FillResult
from mocapmend_algorithms.fill.edges import EdgeParams, Modelled, meet_edges, obstacle
from mocapmend_algorithms.fill.pca_basis import Basis
from mocapmend_algorithms.fill.pca_groups import LEAST_HELPERS, Group, r1, r2
from mocapmend_algorithms.fill.punch_bands import fill_with_bands
from mocapmend_algorithms.fill.punch_errors import BareFill
from mocapmend_algorithms.gaps import Gap
from mocapmend_algorithms.params import option
from mocapmend_algorithms.progress import Progress
from mocapmend_algorithms.recording import Recording


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
    fill = partial(_fill, params=params, choose=r1, few="have no gap at all")
    return fill_with_bands(recording, gaps, fill, progress)


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
    return fill_with_bands(recording, gaps, bare_r2(params), progress)


def bare_r2(params: PcaR2Params) -> BareFill:
    """Return the fill of `pca_r2` without a word on its errors."""
    choose = partial(r2, near=params.near)
    return partial(_fill, params=params, choose=choose, few="are seen throughout the gap")


def _fill(
    recording: Recording,
    observed: BoolArray,
    gaps: Sequence[Gap],
    progress: Progress,
    /,
    *,
    params: PcaR1Params,
    choose: Callable[[Recording, BoolArray, Sequence[Gap]], list[Group]],
    few: str,
) -> FillResult:
    said: dict[Gap, Modelled | str] = {gap: obstacle(observed, gap, params) for gap in gaps}
    groups = choose(recording, observed, [gap for gap in gaps if not said[gap]])
    for done, group in enumerate(groups):
        progress(done / len(groups))
        reason = few_frames(group.complete.size) or few_helpers(
            group.helpers.size, LEAST_HELPERS, few
        )
        if reason:
            said |= dict.fromkeys(group.gaps, reason)
            continue
        basis = Basis.learn(
            recording,
            group,
            weight_scale_mm=params.weight_scale_mm,
            missing_weight=params.missing_weight,
            share=params.components / 100,
        )
        said |= {gap: basis.say(recording, observed, gap) for gap in group.gaps}
    progress(1.0)
    return meet_edges(recording, observed, gaps, said, params)
