"""Mean square errors of positions, bone lengths and smoothness (Y23, equations 1 to 5).

The paper prints sums; means over frames, markers and axes do not grow with the recording.
"""

from dataclasses import dataclass

import numpy as np

from mocapmend_algorithms.arrays import FloatArray
from mocapmend_algorithms.refine.profile import Profile


@dataclass(frozen=True)
class Errors:
    """Of poses from reference poses.

    Attributes
    ----------
    position : float
        Lp, mean square error per coordinate in mm^2.
    bones : float
        Lb, mean square deviation of bone lengths from those of the reference in mm^2.
    smoothness : float
        Ls, mean square second difference per coordinate in mm^2.
    frames : int
        How many.
    """

    position: float
    bones: float
    smoothness: float
    frames: int


def errors_of(poses: FloatArray, reference: FloatArray, profile: Profile) -> Errors:
    """Measure poses against a reference.

    Parameters
    ----------
    poses, reference : ndarray, shape (frames, outputs, 3)
        In mm, relative to the root, at 60 frames per second; NaN where the reference is missing.
    profile : Profile
        Says what the bones are.

    Returns
    -------
    Errors
        NaN where there is nothing to measure.
    """
    lengths = bone_lengths(poses, profile)
    deviation = lengths - mean_lengths(reference, profile)
    return Errors(
        _mean((poses - reference) ** 2),
        _mean(deviation**2),
        _mean(second_differences(poses) ** 2),
        len(poses),
    )


def pooled(errors: list[Errors]) -> Errors:
    """Average errors of several recordings, each frame counting the same."""
    frames = np.array([one.frames for one in errors], dtype=np.float64)
    table = np.array([[one.position, one.bones, one.smoothness] for one in errors])
    weights = np.where(np.isnan(table), 0.0, frames[:, None])
    with np.errstate(invalid="ignore"):
        position, bones, smoothness = (np.nan_to_num(table) * weights).sum(axis=0) / weights.sum(
            axis=0
        )
    return Errors(float(position), float(bones), float(smoothness), int(frames.sum()))


def bone_lengths(poses: FloatArray, profile: Profile) -> FloatArray:
    """Return the length of each bone in each frame, shape (..., bones)."""
    first, second = profile.bone_ends
    lengths: FloatArray = np.linalg.norm(poses[..., first, :] - poses[..., second, :], axis=-1)
    return lengths


def mean_lengths(poses: FloatArray, profile: Profile) -> FloatArray:
    """Return the mean length of each bone, NaN of one that is never there; shape (bones,)."""
    lengths = bone_lengths(poses, profile)
    there = ~np.isnan(lengths)
    with np.errstate(invalid="ignore"):
        means: FloatArray = np.nansum(lengths, axis=0) / there.sum(axis=0)
    return means


def second_differences(poses: FloatArray) -> FloatArray:
    """Return [1 -2 1] along the frames, each end held twice (Y23, equation 4)."""
    held = np.concatenate([poses[:1], poses[:1], poses, poses[-1:], poses[-1:]])
    return np.asarray(np.diff(held, n=2, axis=0), dtype=np.float64)


def _mean(values: FloatArray) -> float:
    there = values[~np.isnan(values)]
    return float(there.mean()) if there.size else np.nan
