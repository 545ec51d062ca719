"""A Butterworth low-pass filter that goes forwards and backwards, and its response.

The samples pass a Butterworth filter in both directions, so that nothing is delayed. Two passes of
a filter of order n attenuate as one of order 2 n would, and what one pass halves in power the two
quarter. Here `order` is that of both passes together (the "fourth-order zero-lag filter" of the
field has two passes of order 2), and `cutoff` is where both passes together halve the power
(-3 dB): each pass is designed for the higher frequency that Winter's correction gives,

    tan(pi f_pass / rate) = tan(pi f_cutoff / rate) / (sqrt(2) - 1)^(1 / order).

For order 4 the factor is the 0.802 of Winter 2009, Biomechanics and Motor Control of Human
Movement, 4th ed. A program without the correction has to be given a cut-off higher by 1 / 0.802 for
the same curve.
"""

from collections.abc import Sequence
from functools import lru_cache

import numpy as np

from mocapmend_algorithms.arrays import FloatArray

PAD_PERIODS = 1.0
"""Periods of the cut-off by which the samples are continued at their ends."""
SPECTRUM = 2048
"""Frequencies by which means over all of them are taken."""


def low_pass(samples: FloatArray, cutoff: float, rate: float, order: int) -> FloatArray:
    """Filter samples forwards and backwards.

    Parameters
    ----------
    samples : ndarray, shape (samples, ...)
        Without a gap, more than one; each column is filtered.
    cutoff : float
        Where both passes together halve the power, in Hz, below half the rate.
    rate : float
        Samples per second (Hz).
    order : int
        Of both passes together, even.

    Returns
    -------
    ndarray, shape (samples, ...)
    """
    from scipy.signal import sosfiltfilt

    sections = _sections(cutoff, rate, order)
    pad = min(len(samples) - 1, int(np.ceil(PAD_PERIODS * rate / cutoff)))
    filtered: FloatArray = sosfiltfilt(sections, samples, axis=0, padlen=pad)
    return filtered


@lru_cache(maxsize=256)
def _sections(cutoff: float, rate: float, order: int) -> FloatArray:
    from scipy.signal import butter

    sections: FloatArray = butter(
        order // 2, pass_cutoff(cutoff, rate, order), fs=rate, output="sos"
    )
    return sections


def pass_cutoff(cutoff: float, rate: float, order: int) -> float:
    """Return the cut-off of each of two passes that together have the given one, in Hz."""
    correction = (np.sqrt(2) - 1) ** (1 / order)
    return float(rate / np.pi * np.arctan(np.tan(np.pi * cutoff / rate) / correction))


@lru_cache(maxsize=8)
def white_noise(
    cutoffs: tuple[float, ...], rate: float, order: int
) -> tuple[FloatArray, FloatArray]:
    """Say what the filter does to white noise.

    Parameters
    ----------
    cutoffs : tuple of float
        In Hz.
    rate, order
        As for `low_pass`.

    Returns
    -------
    taken : ndarray, shape (cutoffs,)
        Share of its power that is in the residual.
    passed : ndarray, shape (cutoffs,)
        Mean of the response over all frequencies.
    """
    share = (np.arange(SPECTRUM) + 0.5) / SPECTRUM
    passed = response(share * rate / 2, cutoffs, rate, order)
    return np.mean((1 - passed) ** 2, axis=1), np.mean(passed, axis=1)


def response(
    frequencies: FloatArray, cutoffs: Sequence[float], rate: float, order: int
) -> FloatArray:
    """Return what both passes together multiply waves by.

    Parameters
    ----------
    frequencies : ndarray, shape (frequencies,)
        In Hz, below half the rate.
    cutoffs : sequence of float
        In Hz.
    rate, order
        As for `low_pass`.

    Returns
    -------
    ndarray, shape (cutoffs, frequencies)
    """
    edges = np.tan(np.pi * np.array([pass_cutoff(one, rate, order) for one in cutoffs]) / rate)
    waves = np.tan(np.pi * frequencies / rate)
    return np.asarray(1 / (1 + (waves / edges[:, None]) ** order), dtype=np.float64)


def residual_squares(
    samples: FloatArray, cutoffs: Sequence[float], rate: float, order: int
) -> FloatArray:
    """Return the mean square of what the filter takes away, for many cut-offs at once.

    The samples are taken to go on beyond each end as they came, mirrored through it, as `low_pass`
    does: then they are a line and a sum of sines, and the filter multiplies each by its response.

    Parameters
    ----------
    samples : ndarray, shape (samples, columns)
        Without a gap, at least three.
    cutoffs : sequence of float
        In Hz.
    rate, order
        As for `low_pass`.

    Returns
    -------
    ndarray, shape (cutoffs, columns)
    """
    from scipy.fft import dst

    count = len(samples)
    line = samples[0] + np.linspace(0, 1, count)[:, None] * (samples[-1] - samples[0])
    sizes = dst((samples - line)[1:-1], type=1, axis=0, norm="ortho")
    waves = np.arange(1, count - 1) * rate / (2 * (count - 1))
    taken = 1 - response(waves, cutoffs, rate, order)
    squares: FloatArray = taken**2 @ sizes**2 / count
    return squares
