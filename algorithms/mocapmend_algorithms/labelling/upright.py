"""Recordings in millimetres with z up, whatever they are written in."""

from mocapmend_algorithms.arrays import FloatArray
from mocapmend_algorithms.recording import Recording, UpAxis

BASES: dict[str, tuple[int, int, int]] = {"x": (1, 2, 0), "y": (2, 0, 1), "z": (0, 1, 2)}
"""Cyclic orders of the axes, which keep left and right apart, with the vertical one last."""


def upright(recording: Recording) -> FloatArray:
    """Return the points of a recording in mm, z up.

    Returns
    -------
    ndarray, shape (frames, points, 3)
        NaN where missing; a turned copy, not a mirrored one.
    """
    return turned_upright(recording.points, recording.up) * recording.mm


def turned_upright(points: FloatArray, up: UpAxis) -> FloatArray:
    """Turn points, shape (..., 3), so that z points up."""
    turned: FloatArray = points[..., BASES[up[1]]].copy()
    if up[0] == "-":
        turned[..., 1:] *= -1.0
    return turned
