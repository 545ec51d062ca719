"""Complete poses to tell incomplete ones by: of the recording itself, or of a training set."""

from collections.abc import Callable
from dataclasses import dataclass

import numpy as np

from mocapmend_algorithms.arrays import BoolArray, FloatArray, IntArray, evenly
from mocapmend_algorithms.fill.company import few_frames, seen_together
from mocapmend_algorithms.recording import Recording
from mocapmend_algorithms.sparse.training_set import TrainingSet


@dataclass(frozen=True, eq=False)
class KnownPoses:
    """Complete poses of some markers.

    Attributes
    ----------
    markers : ndarray of int
        Of the recording, ascending.
    poses : ndarray, shape (poses, markers, 3)
        In the recording's unit, with its vertical axis.
    few : str
        Why they do not do for the marker that they were asked for; empty where they do.
    """

    markers: IntArray
    poses: FloatArray
    few: str = ""


Library = Callable[[BoolArray, int], KnownPoses]
"""From the samples that may be used, and the marker that is missing, to known poses."""


def of_recording(recording: Recording, most: int) -> Library:
    """Look for poses in a recording itself.

    Parameters
    ----------
    recording : Recording
        Not changed.
    most : int
        Poses at most, evenly spread.

    Returns
    -------
    Library
        Of the frames that show the missing marker and those that are often seen with it.
    """

    def library(observed: BoolArray, marker: int) -> KnownPoses:
        seen = np.flatnonzero(observed.any(axis=0))
        markers, complete = seen_together(observed, seen, marker)
        poses = recording.points[np.ix_(evenly(complete, most), markers)]
        return KnownPoses(markers, poses, few_frames(complete.size))

    return library


def of_training_set(training: TrainingSet, recording: Recording, most: int) -> Library:
    """Look for poses in a training set.

    Parameters
    ----------
    training : TrainingSet
        Whose poses.
    recording : Recording
        Which they are to tell.
    most : int
        Poses at most, evenly spread.

    Returns
    -------
    Library
        Of the training set's markers; the recording's others are not looked at.

    Raises
    ------
    TrainingSetError
        If the recording lacks one of its markers.
    """
    places = training.places_of(recording.labels)
    order = np.argsort(places)
    poses = np.concatenate(training.motions(recording.up))
    chosen = poses[evenly(np.arange(poses.shape[0]), most)][:, order] / recording.mm

    def library(_: BoolArray, marker: int) -> KnownPoses:
        few = "" if marker in places else "the training set does not have this marker"
        return KnownPoses(places[order], chosen, few)

    return library
