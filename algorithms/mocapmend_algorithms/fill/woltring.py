"""Quintic smoothing spline of one marker across a gap (Woltring's GCVSPL).

W86 = Woltring 1986, A Fortran package for generalized, cross-validatory spline smoothing and
differentiation, Advances in Engineering Software 8(2):104-113. The curve s minimises

    sum over samples of (y - s)^2  +  p * integral of (s''')^2,

which makes it a natural quintic spline. p is chosen by generalised cross-validation (Craven and
Wahba 1979; W86's mode 2), or by the noise of the samples where that is known (the unbiased risk;
W86's mode 3), one p for the three axes.

W86 smooths the whole trajectory; here measured samples are never changed. The curve is fitted to
the samples near the gap and serves inside it alone; what it leaves over at the two edge samples
is carried into the gap linearly.
"""

from collections.abc import Sequence
from dataclasses import dataclass
from functools import lru_cache, partial

import numpy as np

from mocapmend_algorithms.arrays import FloatArray, IntArray
from mocapmend_algorithms.fill.contract import FillResult
from mocapmend_algorithms.fill.window import Edges, WindowMethod, edges_option, fill_windows
from mocapmend_algorithms.gaps import Gap
from mocapmend_algorithms.params import option
from mocapmend_algorithms.progress import Progress
from mocapmend_algorithms.recording import Recording

REACH = 20
LEAST = 6
"""W86 asks for twice the order of the penalty."""
NULL_SPACE = 3
"""The curves without a penalty: parabolas."""
PER_DECADE = 4
GAUSS = np.sqrt(0.6) * np.array([-1.0, 0.0, 1.0]), np.array([5.0, 8.0, 5.0]) / 18
"""Three points integrate the squared third derivative, piecewise quartic, exactly."""


@dataclass(frozen=True)
class WoltringParams:
    """Parameters of `woltring`."""

    smoothing: float | None = option(
        None,
        label="Measurement noise",
        text="Standard deviation of a measured coordinate: so much is smoothed away before the "
        "curve enters the gap; 0 smooths nothing. Automatic: generalised cross-validation.",
        minimum=0.0,
        maximum=1000.0,
        unit="mm",
    )
    edges: Edges = edges_option()


def woltring(
    recording: Recording, gaps: Sequence[Gap], params: WoltringParams, progress: Progress, /
) -> FillResult:
    """Fill gaps with a quintic smoothing spline.

    Parameters
    ----------
    recording : Recording
        Not changed.
    gaps : sequence of Gap
        The gaps to fill; each looks at the 20 nearest samples on either side.
    params : WoltringParams
        With `smoothing` None, the smoothing is chosen anew for each gap and each self-test.
    progress : Progress
        Called before each gap.

    Returns
    -------
    FillResult
    """
    noise = None if params.smoothing is None else params.smoothing / recording.mm
    method = WindowMethod.single(
        partial(_solve, noise=noise), "a quintic curve", params.edges, reach=REACH, least=LEAST
    )
    return fill_windows(recording, gaps, method, progress)


@dataclass(frozen=True, eq=False)
class Spline:
    """The natural quintic smoothing spline of given knots, whatever the samples.

    With A(p) the smoother at the knots, A(p) = modes / (1 + p penalties) modes^T.

    Attributes
    ----------
    modes : ndarray, shape (knots, knots)
        Orthonormal curves at the knots (Demmler and Reinsch), one per column.
    penalties : ndarray, shape (knots,)
        Their integral of the squared third derivative, 0 for parabolas.
    inside : ndarray, shape (length, knots)
        The interpolating spline at the missing frames per unit sample.
    """

    modes: FloatArray
    penalties: FloatArray
    inside: FloatArray

    def grid(self) -> FloatArray:
        """Return the smoothing parameters to choose from: from next to none to a parabola."""
        bent = self.penalties[self.penalties > 0]
        low, high = -3 - np.log10(bent.max()), 3 - np.log10(bent.min())
        return np.logspace(low, high, int(PER_DECADE * (high - low)) + 1)


@lru_cache(maxsize=32)
def spline(knots: tuple[int, ...], length: int) -> Spline:
    """Work out the smoothing spline of given knots.

    Parameters
    ----------
    knots : tuple of int
        Frames of the observed samples, ascending, counted from the first missing frame; at least
        six.
    length : int
        Number of missing frames.

    Returns
    -------
    Spline
    """
    from scipy.interpolate import make_interp_spline

    at = np.array(knots, dtype=np.float64)
    natural = [(3, 0.0), (4, 0.0)]
    ends = [(order, np.zeros(at.size)) for order, _ in natural]
    curves = make_interp_spline(at, np.eye(at.size), k=5, bc_type=(ends, ends))
    half, middle = np.diff(at) / 2, (at[1:] + at[:-1]) / 2
    places = (middle[:, None] + half[:, None] * GAUSS[0]).ravel()
    weights = np.sqrt(2 * half[:, None] * GAUSS[1]).ravel()
    # The singular values' squares are the penalties: half the digits would be lost by squaring.
    _, values, modes = np.linalg.svd(weights[:, None] * curves(places, 3), full_matrices=False)
    penalties = np.where(np.arange(at.size) < at.size - NULL_SPACE, values**2, 0.0)
    return Spline(modes.T, penalties, curves(np.arange(length)))


def choose_smoothing(
    spline: Spline, values: FloatArray, noise: float | None
) -> tuple[FloatArray, FloatArray]:
    """Choose the smoothing parameter for each of many windows with the same knots.

    Parameters
    ----------
    spline : Spline
        That of the knots.
    values : ndarray, shape (knots, windows, 3)
        The samples.
    noise : float or None
        Standard deviation of a coordinate; None for generalised cross-validation.

    Returns
    -------
    chosen : ndarray, shape (windows,)
        The p that minimises the criterion on `spline.grid()`.
    criteria : ndarray, shape (grid, windows)
        RSS / tr(I - A)^2, or RSS - 2 x 3 noise^2 tr(I - A), with RSS over all axes.
    """
    grid = spline.grid()
    size = np.einsum("kn,kwa->nwa", spline.modes, values)
    square = np.sum(size**2, axis=2)
    left = 1 - 1 / (1 + np.multiply.outer(grid, spline.penalties))
    residual, trace = left**2 @ square, left.sum(axis=1)[:, None]
    criteria = residual / trace**2 if noise is None else residual - 6 * noise**2 * trace
    return grid[np.argmin(criteria, axis=0)], criteria


def _solve(knots: IntArray, values: FloatArray, length: int, *, noise: float | None) -> FloatArray:
    made = spline(tuple(knots.tolist()), length)
    after = int(np.searchsorted(knots, 0))
    edges = [after - 1, after]
    # A constant passes unchanged, so taking one out first costs nothing and saves digits.
    around = (values - values[after]).reshape(knots.size, -1, 3)
    chosen, _ = choose_smoothing(made, around, noise)
    shrink = 1 / (1 + np.multiply.outer(made.penalties, chosen))
    size = np.einsum("kn,kwa->nwa", made.modes, around) * shrink[:, :, None]
    smooth = made.modes @ size.reshape(knots.size, -1)
    left_over = (around.reshape(knots.size, -1) - smooth)[edges]
    share = ((np.arange(length) - knots[after - 1]) / (knots[after] - knots[after - 1]))[:, None]
    bridge = (1 - share) * left_over[0] + share * left_over[1]
    filled: FloatArray = values[after] + made.inside @ smooth + bridge
    return filled
