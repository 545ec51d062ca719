"""What paired recordings of a new performer tell of the errors that a network makes with them.

A network does not know how a new body is built, nor where exactly its markers sit: much of its
error is the same all the time. The mean error of each marker, as seen from the body, is subtracted.
"""

from collections.abc import Sequence

import numpy as np

from mocapmend_algorithms.arrays import FloatArray
from mocapmend_algorithms.refine.preparing import RATE, turned
from mocapmend_algorithms.refine.profile import Profile

SECOND = round(RATE)


def mean_error(
    joints: Sequence[FloatArray],
    poses: Sequence[FloatArray],
    markers: Sequence[FloatArray],
    profile: Profile,
) -> FloatArray:
    """Return the mean error of poses as seen from the body.

    Parameters
    ----------
    joints : sequence of ndarray, shape (frames, inputs, 3)
        Prepared joints of each recording: they say where the body faces.
    poses : sequence of ndarray, shape (frames, outputs, 3)
        What was made of them, in mm.
    markers : sequence of ndarray, shape (frames, outputs, 3)
        The truth; NaN where missing.
    profile : Profile
        Says what is left and right.

    Returns
    -------
    ndarray, shape (outputs, 3)
        In mm; 0 for markers of which nothing is known.
    """
    errors = [
        turned(made - truth, -facing(seen, profile))
        for seen, made, truth in zip(joints, poses, markers, strict=True)
    ]
    every = np.concatenate(errors)
    known = ~np.isnan(every)
    mean: FloatArray = np.nansum(every, axis=0) / np.maximum(known.sum(axis=0), 1)
    return mean


def corrected(
    joints: FloatArray, poses: FloatArray, error: FloatArray, profile: Profile
) -> FloatArray:
    """Subtract a mean error, shape (outputs, 3), from poses; see `mean_error`."""
    shift = turned(np.broadcast_to(error, poses.shape), facing(joints, profile))
    result: FloatArray = poses - shift
    return result


def facing(joints: FloatArray, profile: Profile) -> FloatArray:
    """Return where the body faces in each frame, averaged over a second; radians about z.

    Parameters
    ----------
    joints : ndarray, shape (frames, inputs, 3)
        Prepared joints.
    profile : Profile
        Says what is left and right.

    Returns
    -------
    ndarray, shape (frames,)
        0 where left lies along x.
    """
    from scipy.ndimage import uniform_filter1d

    across = joints[:, list(profile.left)].mean(axis=1) - joints[:, list(profile.right)].mean(
        axis=1
    )
    smooth = uniform_filter1d(across, SECOND, axis=0, mode="nearest")
    angles: FloatArray = np.arctan2(smooth[:, 1], smooth[:, 0])
    return angles
