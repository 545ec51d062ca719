"""Where the 3D view looks from, and what that does to points. No Qt."""

import math
from dataclasses import dataclass, field

import numpy as np
from numpy.typing import NDArray

from mocapmend_algorithms.recording import UpAxis

Array = NDArray[np.float64]

FIELD_OF_VIEW = np.radians(35.0)
NEAR = 0.05  # share of the distance to the target

VIEWS = {
    "front": (-90.0, 8.0),
    "back": (90.0, 8.0),
    "left": (180.0, 8.0),
    "right": (0.0, 8.0),
    "top": (-90.0, 89.9),
    "oblique": (-60.0, 18.0),
}
"""Yaw and pitch of the fixed views in degrees; "front" looks along the second ground axis."""


def upright(up: UpAxis) -> Array:
    """Return the rotation, shape (3, 3), that brings a file's up axis to +z."""
    axis = "xyz".index(up[1])
    vertical = np.zeros(3)
    vertical[axis] = 1.0 if up[0] == "+" else -1.0
    first = np.zeros(3)
    first[(axis + 1) % 3] = 1.0
    return np.stack((first, np.cross(vertical, first), vertical))


@dataclass
class Camera:
    """A perspective camera that circles a target; angles in degrees, lengths in the file's unit."""

    target: Array = field(default_factory=lambda: np.zeros(3))
    distance: float = 1.0
    yaw: float = VIEWS["oblique"][0]
    pitch: float = VIEWS["oblique"][1]

    def look(self, view: str) -> None:
        """Turn to one of the fixed `VIEWS`."""
        self.yaw, self.pitch = VIEWS[view]

    def orbit(self, yaw: float, pitch: float) -> None:
        """Circle the target by angles in degrees."""
        self.yaw = (self.yaw + yaw + 180.0) % 360.0 - 180.0
        self.pitch = float(np.clip(self.pitch + pitch, -89.9, 89.9))

    def zoom(self, factor: float) -> None:
        """Scale the distance to the target."""
        self.distance = max(self.distance * factor, 1e-6)

    def pan(self, right: float, up: float, size: int) -> None:
        """Move the target across the picture by pixels; `size` is the shorter side of the view."""
        per_pixel = 2.0 * self.distance * np.tan(FIELD_OF_VIEW / 2.0) / max(1, size)
        axes = self._axes()
        self.target = self.target - (axes[0] * right - axes[1] * up) * per_pixel

    def project(self, points: Array, width: int, height: int) -> tuple[Array, Array]:
        """Project upright points, shape (n, 3).

        Returns
        -------
        pixels : ndarray, shape (n, 2)
            Picture coordinates, y down; NaN for missing points and those behind the camera.
        depth : ndarray, shape (n,)
            Distance along the view in the file's unit.
        """
        view = (points - self.target) @ self._axes().T
        depth = view[:, 2] + self.distance
        with np.errstate(invalid="ignore"):
            seen = depth > NEAR * self.distance
        focal = min(width, height) / (2.0 * np.tan(FIELD_OF_VIEW / 2.0))
        scale = np.where(seen, focal / np.where(seen, depth, 1.0), np.nan)
        pixels = np.empty((len(points), 2))
        pixels[:, 0] = width / 2.0 + view[:, 0] * scale
        pixels[:, 1] = height / 2.0 - view[:, 1] * scale
        return pixels, depth

    def turned(self, direction: Array) -> Array:
        """Return how far a direction points right, up and into the picture."""
        return np.asarray(self._axes() @ direction)

    def _axes(self) -> Array:
        """Return the picture's right, up and into-the-picture directions as rows."""
        yaw, pitch = math.radians(self.yaw), math.radians(self.pitch)
        across, along = math.cos(yaw), math.sin(yaw)
        level, rise = math.cos(pitch), math.sin(pitch)
        return np.array(
            [
                [-along, across, 0.0],
                [-rise * across, -rise * along, level],
                [-level * across, -level * along, -rise],
            ]
        )
