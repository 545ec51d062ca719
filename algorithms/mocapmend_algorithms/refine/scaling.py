"""Standardising what goes into a network and what comes out."""

from dataclasses import dataclass

import numpy as np

from mocapmend_algorithms.arrays import FloatArray
from mocapmend_algorithms.refine.network import FloatArray32

LEAST_SPREAD = 1.0
"""Millimetres; the root does not move at all."""


@dataclass(frozen=True, eq=False)
class Scaling:
    """Mean and spread of each coordinate, in mm.

    Attributes
    ----------
    input_mean, input_spread : ndarray, shape (inputs, 3)
        Of joints.
    output_mean, output_spread : ndarray, shape (outputs, 3)
        Of markers.
    """

    input_mean: FloatArray
    input_spread: FloatArray
    output_mean: FloatArray
    output_spread: FloatArray

    @classmethod
    def of(cls, joints: FloatArray, markers: FloatArray) -> "Scaling":
        """Measure windows, shapes (windows, frames, inputs or outputs, 3), NaN where missing."""
        found = []
        for points in (joints, markers):
            found.append(np.nanmean(points, axis=(0, 1)))
            found.append(np.maximum(np.nanstd(points, axis=(0, 1)), LEAST_SPREAD))
        return cls(*found)

    def standardised(self, joints: FloatArray) -> FloatArray32:
        """Return what a network takes, shape (windows, frames, 3 x inputs)."""
        scaled = (joints - self.input_mean) / self.input_spread
        return np.asarray(scaled.reshape(*joints.shape[:2], -1), dtype=np.float32)

    def restored(self, outputs: FloatArray32) -> FloatArray:
        """Return mm, shape (windows, frames, outputs, 3), of what a network makes."""
        shape = (*outputs.shape[:2], *self.output_mean.shape)
        poses: FloatArray = outputs.reshape(shape) * self.output_spread + self.output_mean
        return poses
