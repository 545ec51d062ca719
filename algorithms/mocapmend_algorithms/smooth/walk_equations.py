"""The Rauch-Tung-Striebel smoother of a marker that is seen in every frame, as one system.

A coordinate is the integral, once or twice, of a velocity or an acceleration that changes at
random: x_t = F x_(t-1) + w, w ~ N(0, q Q), and a frame shows y_t = [1, 0, ...] x_t + v,
v ~ N(0, r). Nothing is assumed of the first state. The smoothed states minimise

    sum of v^2 / (r / q)  +  sum of w' Q^-1 w,

a banded system of equations; the smoother is its solution by elimination forwards and
substitution backwards (Bell 1994, The iterated Kalman smoother as a Gauss-Newton method, SIAM
J. Optim. 4(3):626-636, section 2). Times are in frames: only r / q matters to the curve.
"""

from dataclasses import dataclass
from math import factorial

import numpy as np

from mocapmend_algorithms.arrays import FloatArray


@dataclass(frozen=True, eq=False)
class Walk:
    """The smoother of so many frames for one ratio of the noises.

    Parameters are those of `walk`.

    Attributes
    ----------
    factor : ndarray, shape (2 states, frames x states)
        Cholesky factor of the system, by diagonals, the main one first.
    states : int
        2 with a velocity, 3 with an acceleration.
    ratio : float
        r / q.
    """

    factor: FloatArray
    states: int
    ratio: float

    def positions(self, samples: FloatArray) -> FloatArray:
        """Return the smoothed samples, shape (frames, columns)."""
        from scipy.linalg import cho_solve_banded

        seen = np.zeros((self.factor.shape[1], samples.shape[1]))
        seen[:: self.states] = samples / self.ratio
        solved: FloatArray = cho_solve_banded((self.factor, True), seen, check_finite=False)
        return solved[:: self.states]

    @property
    def log_determinant(self) -> float:
        """Logarithm of the determinant of the system."""
        return float(2 * np.sum(np.log(self.factor[0])))


def walk(frames: int, states: int, ratio: float) -> Walk:
    """Make a smoother.

    Parameters
    ----------
    frames : int
        At least as many as states.
    states : int
        2 with a velocity, 3 with an acceleration.
    ratio : float
        r / q, measurement variance over the density of the process noise, times in frames.

    Returns
    -------
    Walk
    """
    from scipy.linalg import cholesky_banded

    ahead = transition(states)
    inverse = np.linalg.inv(process(states))
    after = np.zeros((states, states))
    after[0, 0] = 1 / ratio
    before, across = ahead.T @ inverse @ ahead, -inverse @ ahead
    diagonals = np.zeros((2 * states, frames, states))
    for row in range(states):
        for column in range(row + 1):
            band = diagonals[row - column, :, column]
            band += after[row, column]
            band[:-1] += before[row, column]
            band[1:] += inverse[row, column]
        for column in range(states):
            diagonals[states + row - column, :-1, column] = across[row, column]
    bands = diagonals.reshape(2 * states, frames * states)
    factor = cholesky_banded(bands, lower=True, overwrite_ab=True, check_finite=False)
    return Walk(factor, states, ratio)


def transition(states: int) -> FloatArray:
    """Return F of one frame: [[1, 1], [0, 1]], or with an acceleration [[1, 1, 1/2], ...]."""
    return np.array(
        [[1 / factorial(k - j) if k >= j else 0.0 for k in range(states)] for j in range(states)]
    )


def process(states: int) -> FloatArray:
    """Return Q of one frame: what white noise in the last derivative adds, of unit density."""
    order = [states - 1 - j for j in range(states)]
    return np.array(
        [[1 / (factorial(j) * factorial(k) * (j + k + 1)) for k in order] for j in order]
    )
