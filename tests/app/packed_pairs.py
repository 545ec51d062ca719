"""A small archive of pairs as that of UI-PRMD is packed."""

from pathlib import Path

import numpy as np
from refine_files import body
from scipy.spatial.transform import Rotation

from mocapmend_algorithms.arrays import FloatArray
from mocapmend_algorithms.refine.profile import Profile

SECONDS = 3.0
TURN = Rotation.from_euler("xz", [90, 80], degrees=True).as_matrix()
"""From the Kinect's axes, y up, to Vicon's, z up."""


def packed(recordings: list[FloatArray]) -> tuple[np.ndarray, np.ndarray, np.ndarray]:
    """Return first frames and the two byte planes of recordings, shape (frames, points, 3), mm."""
    firsts, coded = [], []
    for recording in recordings:
        rows = np.rint(recording * 10).astype(np.int64).reshape(len(recording), -1)
        steps = np.diff(rows, axis=0)
        second = np.diff(np.vstack([np.zeros_like(steps[:1]), steps]), axis=0)
        firsts.append(rows[0])
        coded.append((second << 1) ^ (second >> 63))
    planes = np.concatenate(coded).T
    low, high = (planes % 256).astype(np.uint8), (planes // 256).astype(np.uint8)
    return np.array(firsts, np.int32), low, high


def write_packed(
    path: Path, profile: Profile, *, performers: int = 2, repetitions: int = 3, lag: float = 0.125
) -> Path:
    """Write pairs of each performer and repetition; one more is marked as not to be used."""
    keys, kinect, vicon = [], [], []
    for performer in range(performers):
        for repetition in range(repetitions):
            joints, markers = body(profile, 700, seed=10 * performer + repetition)
            # 30 samples a second for the one, 100 for the other: the body is slower for it.
            kinect.append(joints[: round(SECONDS * 30)] @ TURN)
            vicon.append(resampled(markers, 30 * lag)[: round(SECONDS * 100)])
            keys.append([0, 1, performer + 1, repetition + 1])
    # The last is marked as useless.
    keys.append([1, 1, 1, 1])
    kinect.append(np.zeros_like(kinect[0]))
    vicon.append(np.zeros_like(vicon[0]))
    k0, kb0, kb1 = packed(kinect)
    v0, vb0, vb1 = packed(vicon)
    np.savez_compressed(
        path,
        keys=np.array(keys, np.int16),
        nk=np.array([len(one) for one in kinect], np.int32),
        nv=np.array([len(one) for one in vicon], np.int32),
        K0=k0, V0=v0, Kb0=kb0, Kb1=kb1, Vb0=vb0, Vb1=vb1,
        lag_s=np.full(len(keys), lag, np.float32),
        R=np.array([TURN] * len(keys), np.float32),
        use=np.array([True] * (len(keys) - 1) + [False]),
    )  # fmt: skip
    return path


def resampled(markers: FloatArray, start: float) -> FloatArray:
    """Return what 30 samples a second show from a frame on, at 100 a second."""
    from scipy.interpolate import CubicSpline

    times = start + np.arange(round(SECONDS * 100)) * 0.3
    spline = CubicSpline(np.arange(len(markers)), markers)
    return np.asarray(spline(times))
