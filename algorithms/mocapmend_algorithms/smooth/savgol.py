"""Savitzky-Golay filter: a polynomial is fitted around each sample.

Savitzky and Golay 1964, Analytical Chemistry 36(8):1627-1639, by `scipy.signal.savgol_filter`. At
the ends the polynomial of the last whole window serves. Where no window is given it is the one
with the least generalised cross-validation score (Craven and Wahba 1979), as of `gcv`: the filter
multiplies a sample by the middle one of its weights, so their trace is known.
"""

from collections.abc import Sequence
from dataclasses import dataclass
from functools import lru_cache, partial
from typing import Any

import numpy as np

from mocapmend_algorithms.arrays import FloatArray
from mocapmend_algorithms.params import option
from mocapmend_algorithms.progress import Progress
from mocapmend_algorithms.recording import Recording
from mocapmend_algorithms.smooth.contract import Run, SmoothResult
from mocapmend_algorithms.smooth.stretches import check_runs, smooth_runs

LONGEST_S = 0.5
STEP = 1.1
"""Between windows to choose from, where that is more than two frames."""
POINTS = 2048
"""Frequencies at which the response is looked at."""


@dataclass(frozen=True)
class SavgolParams:
    """Parameters of `savgol`."""

    window_ms: float | None = option(
        None,
        label="Window",
        text="How long the stretch is that a polynomial is fitted to, around each sample: the "
        "nearest odd number of frames. Automatic: the one with the best cross-validation score, "
        "up to half a second.",
        minimum=1.0,
        maximum=60_000.0,
        unit="ms",
    )
    order: int = option(
        3,
        label="Order",
        text="Of the polynomial. Higher follows impacts better and smooths less.",
        minimum=1,
        maximum=9,
    )


def savgol(
    recording: Recording, runs: Sequence[Run], params: SavgolParams, progress: Progress, /
) -> SmoothResult:
    """Smooth runs with a moving polynomial.

    Parameters
    ----------
    recording : Recording
        Not changed.
    runs : sequence of Run
        Where samples may change; pieces shorter than the window stay as they are.
    params : SavgolParams
        With `window_ms` None, the window is chosen for each axis by cross-validation.
    progress : Progress
        Called before each run.

    Returns
    -------
    SmoothResult
        `chosen` holds per axis the `window_frames` and the `cutoff_hz` at which such a window
        halves the power.

    Raises
    ------
    ValueError
        If the order is below 1 or the window too short for it, or the runs are outside the
        recording or overlap.
    """
    check_runs(recording, runs)
    windows = _windows(params, recording.rate)
    return smooth_runs(
        recording,
        runs,
        method="savgol",
        params=params,
        least=windows[0],
        smooth=partial(_smooth, windows=windows, order=params.order, rate=recording.rate),
        progress=progress,
    )


def odd_frames(window_ms: float, rate: float) -> int:
    """Return the odd number of frames that is nearest to a window."""
    return 2 * round((window_ms / 1000 * rate - 1) / 2) + 1


@lru_cache(maxsize=256)
def half_power(window: int, order: int) -> float:
    """Return the first frequency at which a window halves the power, as a share of the rate."""
    from scipy.signal import freqz, savgol_coeffs

    frequencies, response = freqz(savgol_coeffs(window, order), worN=POINTS, fs=1.0)
    below = np.flatnonzero(np.abs(response) <= np.sqrt(0.5))
    return float(frequencies[below[0]]) if below.size else 0.5


def _windows(params: SavgolParams, rate: float) -> list[int]:
    """Return the windows to choose from, in frames, ascending."""
    if params.order < 1:
        raise ValueError(f"order must be at least 1, not {params.order}")
    # The next odd number above order + 1: with less, the polynomial meets every sample.
    shortest = params.order + 2 + (params.order + 1) % 2
    if params.window_ms is None:
        return _several(shortest, odd_frames(1000 * LONGEST_S, rate))
    window = odd_frames(params.window_ms, rate)
    if window < shortest:
        raise ValueError(
            f"window_ms must be at least {1000 * (shortest - 1) / rate:g} ms at {rate:g} Hz: "
            f"order {params.order} needs {shortest} frames, "
            f"and {params.window_ms:g} ms are {max(window, 1)}"
        )
    return [window]


def _several(shortest: int, longest: int) -> list[int]:
    windows = [shortest]
    while windows[-1] < longest:
        windows.append(max(windows[-1] + 2, 2 * round(STEP * windows[-1] / 2) + 1))
    return windows


def _smooth(
    samples: list[FloatArray], *, windows: Sequence[int], order: int, rate: float
) -> tuple[list[FloatArray], dict[str, Any]]:
    from scipy.signal import savgol_coeffs, savgol_filter

    shortest = min(len(one) for one in samples)
    fitting = [window for window in windows if window <= shortest]
    tried = [[savgol_filter(one, window, order, axis=0) for one in samples] for window in fitting]
    squares = np.array(
        [
            sum(
                np.sum((one - curve) ** 2, axis=0) for one, curve in zip(samples, some, strict=True)
            )
            for some in tried
        ]
    )
    taken = np.array([savgol_coeffs(window, order)[window // 2] for window in fitting])
    best = np.argmin(squares / (1 - taken[:, None]) ** 2, axis=0).tolist()
    smoothed = [
        np.stack([tried[place][piece][:, axis] for axis, place in enumerate(best)], axis=1)
        for piece in range(len(samples))
    ]
    chosen = [fitting[place] for place in best]
    cutoffs = [half_power(window, order) * rate for window in chosen]
    return smoothed, {"window_frames": chosen, "cutoff_hz": cutoffs}
