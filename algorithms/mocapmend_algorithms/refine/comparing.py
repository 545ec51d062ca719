"""Holding refined poses against a reference that was recorded beside them."""

from dataclasses import dataclass

import numpy as np

from mocapmend_algorithms.arrays import FloatArray
from mocapmend_algorithms.recording import Recording
from mocapmend_algorithms.refine.aligning import Alignment, align_in_time, in_common
from mocapmend_algorithms.refine.measures import Errors, errors_of
from mocapmend_algorithms.refine.preparing import RATE
from mocapmend_algorithms.refine.profile import Profile
from mocapmend_algorithms.refine.reference import Reference


@dataclass(frozen=True, eq=False)
class Comparison:
    """How far refined poses are from a reference.

    Attributes
    ----------
    alignment : Alignment
        How they were brought together: the lag and rotation that fit best.
    errors : Errors
        Lp, Lb and Ls over the frames in common.
    rms : ndarray, shape (outputs,)
        Root mean square distance of each marker in mm, NaN where the reference has none.
    truth : Errors
        The same of the reference itself: its Lb is what bone lengths vary by anyway.
    """

    alignment: Alignment
    errors: Errors
    rms: FloatArray
    truth: Errors


def compare(poses: FloatArray, reference: Recording, profile: Profile) -> Comparison:
    """Measure refined poses against a reference.

    Parameters
    ----------
    poses : ndarray, shape (frames, outputs, 3)
        In mm relative to the root, z up, at 60 frames per second.
    reference : Recording
        Of the same movement, with the outputs of the profile among its labels.
    profile : Profile
        What they are.

    Raises
    ------
    RefineError
        If the reference lacks outputs, or has less than half a second in common with them.
    """
    truth = Reference.of(reference, profile)
    markers = truth.at(np.arange(truth.frames) / RATE)
    found = align_in_time(poses, markers)
    ours, theirs = in_common(found.lag, len(poses), len(markers))
    own, wanted = poses[ours], markers[theirs] @ found.rotation
    distance = np.linalg.norm(own - wanted, axis=2)
    there = ~np.isnan(distance)
    with np.errstate(invalid="ignore"):
        rms: FloatArray = np.sqrt(np.nansum(distance**2, axis=0) / there.sum(axis=0))
    return Comparison(
        found, errors_of(own, wanted, profile), rms, errors_of(wanted, wanted, profile)
    )
