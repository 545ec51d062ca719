"""Poses relative to the body: where it stands and faces is taken out, and put back."""

from dataclasses import dataclass
from typing import Literal

import numpy as np

from mocapmend_algorithms.arrays import FloatArray
from mocapmend_algorithms.recording import UpAxis
from mocapmend_algorithms.sparse.heading import headings, mean_pose, turned

Frame = Literal["body", "place", "world"]
"""What poses are relative to: where the body is and faces, where it is, or nothing."""


@dataclass(frozen=True, eq=False)
class Stance:
    """Where bodies are and which way they face, frame by frame.

    Attributes
    ----------
    centre : ndarray, shape (frames, 3)
        Mean of the markers that it is told by.
    heading : ndarray, shape (frames,)
        How far the body is turned about the vertical, in radians.
    up : str
        The vertical axis.
    """

    centre: FloatArray
    heading: FloatArray
    up: UpAxis

    def to_body(self, points: FloatArray) -> FloatArray:
        """Express points, shape (frames, points, 3), relative to the body."""
        return turned(points - self.centre[:, None], -self.heading, self.up)

    def to_world(self, points: FloatArray) -> FloatArray:
        """Put points of the body, shape (frames, points, 3), back into the world."""
        placed: FloatArray = turned(points, self.heading, self.up) + self.centre[:, None]
        return placed


def stance(points: FloatArray, reference: FloatArray, up: UpAxis, frame: Frame) -> Stance:
    """Find where a body is in each frame, and how far it is turned from a reference.

    Parameters
    ----------
    points : ndarray, shape (frames, markers, 3)
        Finite.
    reference : ndarray, shape (markers, 3)
        A pose of the same markers.
    up : str
        The vertical axis.
    frame : str
        What is wanted of it; the rest is 0.

    Returns
    -------
    Stance
    """
    frames = points.shape[0]
    centre = np.zeros((frames, 3)) if frame == "world" else points.mean(axis=1)
    heading = headings(points, reference, up) if frame == "body" else np.zeros(frames)
    return Stance(centre, heading, up)


def usual_pose(points: FloatArray, up: UpAxis, frame: Frame) -> FloatArray:
    """Return the mean of poses, shape (poses, markers, 3), relative to what a frame says."""
    if frame == "body":
        return mean_pose(points, up)
    mean: FloatArray = stance(points, points[0], up, frame).to_body(points).mean(axis=0)
    return mean
