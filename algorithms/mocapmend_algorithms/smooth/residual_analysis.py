"""Residual analysis: the cut-off frequency at which a low-pass filter removes noise alone.

W09 = Winter 2009, Biomechanics and Motor Control of Human Movement, 4th ed., section 3.4.4.3. The
residual R(f) is the root mean square of what a filter with cut-off f takes away. Above the
bandwidth of the motion, what it takes is noise, and R falls along a line; where this line meets
0 Hz is the noise that is in the samples, and the cut-off is where R equals it: there, the motion
that is lost is as large as the noise that is let through.

W09 draws the line by eye through R. Here it is fitted to the square of R, as that of white noise
falls on a straight line and R itself only nearly does.
"""

from collections.abc import Callable

import numpy as np

from mocapmend_algorithms.arrays import FloatArray

LINE = 0.4, 0.75
"""Between these shares of the Nyquist frequency, what the filter takes counts as noise alone."""
CANDIDATES = 48
LOWEST_HZ = 0.5

Residuals = Callable[[float], FloatArray]
"""Tells the mean square residual of each trajectory for a cut-off in Hz."""


def candidates(rate: float) -> FloatArray:
    """Return the cut-offs to try in Hz, ascending: evenly, up to the end of the line."""
    highest = LINE[1] * rate / 2
    return np.linspace(min(LOWEST_HZ, highest / CANDIDATES), highest, CANDIDATES)


def choose_cutoffs(squares: FloatArray, frequencies: FloatArray, rate: float) -> FloatArray:
    """Choose cut-offs from residuals.

    Parameters
    ----------
    squares : ndarray, shape (frequencies, trajectories)
        Mean square of the residual.
    frequencies : ndarray, shape (frequencies,)
        The cut-offs in Hz, ascending; see `candidates`.
    rate : float
        Frames per second (Hz).

    Returns
    -------
    cutoffs : ndarray, shape (trajectories,)
        In Hz, interpolated between the candidates.
    """
    noise = noise_variance(squares, frequencies, rate)
    return np.array(
        [
            _crossing(frequencies, square, level)
            for square, level in zip(squares.T, noise, strict=True)
        ]
    )


def noise_variance(squares: FloatArray, frequencies: FloatArray, rate: float) -> FloatArray:
    """Return where the line of the noise meets 0 Hz, of each trajectory; see `choose_cutoffs`."""
    on_line = frequencies >= LINE[0] * rate / 2
    _, height = np.polyfit(frequencies[on_line], squares[on_line], 1)
    return np.asarray(np.maximum(height, 0.0), dtype=np.float64)


def _crossing(frequencies: FloatArray, square: FloatArray, level: float) -> float:
    """Return the first frequency at which the residual is down to the level."""
    below = np.flatnonzero(square <= level)
    if not below.size:
        return float(frequencies[-1])
    place = int(below[0])
    if place == 0:
        return float(frequencies[0])
    return float(
        np.interp(
            level,
            [square[place], square[place - 1]],
            [frequencies[place], frequencies[place - 1]],
        )
    )
