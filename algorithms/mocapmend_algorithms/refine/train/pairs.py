"""Pairs of recordings to learn from: what the cheap sensor saw, and what was true."""

from dataclasses import dataclass

import numpy as np

from mocapmend_algorithms.arrays import FloatArray
from mocapmend_algorithms.recording import Recording
from mocapmend_algorithms.refine.aligning import LEAST_SHARED, align_in_time
from mocapmend_algorithms.refine.preparing import RATE, UP, RefineError, prepare
from mocapmend_algorithms.refine.profile import Profile
from mocapmend_algorithms.refine.reference import Reference
from mocapmend_algorithms.sparse.training_set import turn_up


@dataclass(frozen=True, eq=False)
class Pair:
    """One movement seen twice, at 60 frames per second, z up, in mm relative to the roots.

    Attributes
    ----------
    joints : ndarray, shape (frames, inputs, 3)
        Complete.
    markers : ndarray, shape (frames, outputs, 3)
        In the axes of the joints; NaN where missing.
    performer, movement, repetition : int
        Who did what, and which time; to split by.
    """

    joints: FloatArray
    markers: FloatArray
    performer: int = 0
    movement: int = 0
    repetition: int = 0


def make_pair(
    recording: Recording,
    truth: Recording,
    profile: Profile,
    known: tuple[float, FloatArray] | None = None,
    *,
    performer: int = 0,
    movement: int = 0,
    repetition: int = 0,
) -> Pair:
    """Bring two recordings of one movement to the same times and axes.

    Parameters
    ----------
    recording, truth : Recording
        With the inputs and the outputs of the profile.
    profile : Profile
        What is learnt.
    known : (float, ndarray of shape (3, 3)), optional
        The lag in seconds (what the truth shows at t, the recording shows at t + lag), and the
        rotation that turns vectors of the recording, as it has them, into those of the truth. By
        default those that fit best; see `align_in_time`.
    performer, movement, repetition : int
        See `Pair`.

    Raises
    ------
    RefineError
        If markers lack, or there is less than half a second in common.
    """
    prepared = prepare(recording, profile)
    reference = Reference.of(truth, profile)
    if known is None:
        inputs, outputs = zip(*profile.matches, strict=True)
        markers = reference.at(np.arange(reference.frames) / RATE)
        found = align_in_time(prepared.joints[:, list(inputs)], markers[:, list(outputs)])
        lag, rotation = found.seconds, found.rotation
    else:
        lag, rotation = known[0], known[1] @ turn_up(UP, recording.up)
    first = max(0, int(np.ceil(lag * RATE)))
    last = min(len(prepared.joints) - 1, int(np.floor((reference.seconds + lag) * RATE)))
    if last - first + 1 < LEAST_SHARED:
        raise RefineError("recording and reference have less than half a second in common")
    markers = reference.at(np.arange(first, last + 1) / RATE - lag) @ rotation
    return Pair(prepared.joints[first : last + 1], markers, performer, movement, repetition)
