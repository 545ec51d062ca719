"""What networks are held against: regressions on joints that were smoothed in the usual ways."""

from collections.abc import Mapping, Sequence

import numpy as np

from mocapmend.refine.measuring import Predict, Smooth, butterworth, ridge_on
from mocapmend_algorithms import no_progress
from mocapmend_algorithms.arrays import FloatArray
from mocapmend_algorithms.gaps import Gap
from mocapmend_algorithms.recording import Recording
from mocapmend_algorithms.refine.measures import Errors, pooled, second_differences
from mocapmend_algorithms.refine.preparing import RATE
from mocapmend_algorithms.refine.profile import Profile
from mocapmend_algorithms.refine.train.pairs import Pair

WINDOW, DEGREE = 15, 3
"""Of Savitzky and Golay's filter: a quarter of a second."""
NOISE_MM = 5.0
RIDGE = "ridge on Butterworth"


def as_it_is(joints: FloatArray) -> FloatArray:
    """Smooth nothing."""
    return joints


def savitzky_golay(joints: FloatArray) -> FloatArray:
    """Fit cubic parabolas to a quarter of a second."""
    from scipy.signal import savgol_filter

    if len(joints) < WINDOW:
        return joints
    return np.asarray(savgol_filter(joints, WINDOW, DEGREE, axis=0), dtype=np.float64)


def kalman(joints: FloatArray) -> FloatArray:
    """Smooth with a constant-velocity Kalman smoother.

    The noise is given: it is not white, and an estimate from the samples finds none.
    """
    from mocapmend_algorithms.smooth.kalman_smoother import KalmanSmootherParams, kalman_smoother

    labels = tuple(map(str, range(joints.shape[1])))
    recording = Recording(np.ascontiguousarray(joints), labels, RATE)
    moving = np.flatnonzero(np.ptp(joints, axis=0).any(axis=1)).tolist()
    runs = [Gap(marker, 0, len(joints)) for marker in moving]
    done = kalman_smoother(recording, runs, KalmanSmootherParams(noise_mm=NOISE_MM), no_progress)
    return done.applied(recording).points


SMOOTHED: Mapping[str, Smooth] = {
    "ridge on raw": as_it_is,
    RIDGE: butterworth,
    "ridge on Savitzky-Golay": savitzky_golay,
    "ridge on Kalman smoother": kalman,
}


def rivals(pairs: Sequence[Pair], profile: Profile) -> dict[str, Predict]:
    """Fit the regressions."""
    return {name: ridge_on(smooth, pairs, profile) for name, smooth in SMOOTHED.items()}


def raw_errors(pairs: Sequence[Pair], profile: Profile) -> Errors:
    """Measure the sensor's own joints against the markers that they lie near.

    They have no bones in common with the markers.
    """
    inputs, outputs = zip(*profile.matches, strict=True)
    found = []
    for pair in pairs:
        own, wanted = pair.joints[:, list(inputs)], pair.markers[:, list(outputs)]
        position = float(np.nanmean((own - wanted) ** 2))
        rough = float(np.mean(second_differences(own) ** 2))
        found.append(Errors(position, np.nan, rough, len(own)))
    return pooled(found)
