"""The residual of a Butterworth filter against its cut-off, as it is looked at.

See `residual_analysis` for what it means.
"""

from dataclasses import dataclass

import numpy as np

from mocapmend_algorithms.arrays import FloatArray
from mocapmend_algorithms.recording import Recording
from mocapmend_algorithms.smooth.butterworth import LEAST_TO_CHOOSE
from mocapmend_algorithms.smooth.contract import Run
from mocapmend_algorithms.smooth.low_pass import residual_squares, white_noise
from mocapmend_algorithms.smooth.residual_analysis import candidates, noise_variance
from mocapmend_algorithms.smooth.stretches import cut, sort_pieces


@dataclass(frozen=True, eq=False)
class ResidualCurve:
    """What filters with lower and lower cut-offs take from a run of a marker.

    Attributes
    ----------
    cutoffs : ndarray, shape (frequencies,)
        In Hz, ascending.
    residuals : ndarray, shape (frequencies, 3)
        Root mean square of what is taken of each axis, in the recording's unit.
    noise_line : ndarray, shape (frequencies, 3)
        What would be taken of white noise alone, as much as is in the samples.
    noise : ndarray, shape (3,)
        Where that line meets 0 Hz: the standard deviation of the noise.
    """

    cutoffs: FloatArray
    residuals: FloatArray
    noise_line: FloatArray
    noise: FloatArray


def residual_curve(recording: Recording, run: Run, order: int) -> ResidualCurve | None:
    """Analyse the residual of a run.

    Parameters
    ----------
    recording : Recording
        What is to be smoothed.
    run : Run
        Of one marker.
    order : int
        Of the filter, both ways together.

    Returns
    -------
    ResidualCurve or None
        None where no piece of the run is long enough to choose a cut-off.
    """
    least = max(2 * order + 1, LEAST_TO_CHOOSE)
    pieces = sort_pieces(recording, run, least)[0]
    if not pieces:
        return None
    cutoffs = candidates(recording.rate)
    squares = np.average(
        [
            residual_squares(cut(recording, run, piece), cutoffs.tolist(), recording.rate, order)
            for piece in pieces
        ],
        axis=0,
        weights=[piece.samples for piece in pieces],
    )
    taken, _ = white_noise(tuple(cutoffs), recording.rate, order)
    variance = noise_variance(squares, taken, cutoffs, recording.rate)
    return ResidualCurve(
        cutoffs=cutoffs,
        residuals=np.sqrt(squares),
        noise_line=np.sqrt(taken[:, None] * variance),
        noise=np.sqrt(variance),
    )
