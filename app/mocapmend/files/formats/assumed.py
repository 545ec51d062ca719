"""What files of joints do not state and is assumed: length unit, axis that points up, rate."""

from collections.abc import Sequence

import numpy as np
from numpy.typing import NDArray

from mocapmend.files.formats.kinematics import Joint, bones_of
from mocapmend.files.space import FEWEST_MARKERS, guess_up
from mocapmend_algorithms.recording import UpAxis

RATE = 120.0
"""Of most recordings of joints (Hz), CMU's among them."""
COMMON_RATES = (
    *(5.0, 10.0, 15.0, 20.0, 24.0, 25.0, 29.97, 30.0, 48.0, 50.0, 59.94, 60.0, 72.0, 90.0, 100.0),
    *(120.0, 144.0, 150.0, 200.0, 240.0, 250.0, 300.0, 500.0, 1000.0),
)
RATE_BOUNDS = 0.01, 100_000.0
SAME_RATE = 0.03
LIKE_RATE = 0.15

CM_PER_INCH = 2.54
CMU_UNIT = 1 / 0.45
"""Inches per length unit of CMU's recordings."""
BODY_REACH_METRES = 1.3
"""From the pelvis of a person to the end of the longest chain of joints."""
METRES = {"m": 1.0, "in": 0.0254, "cm": 0.01, "mm": 0.001, "cmu": CMU_UNIT * 0.0254}
SAMPLED_FRAMES = 200


def body_unit(
    points: NDArray[np.float64], joints: Sequence[Joint], warnings: list[str]
) -> tuple[str, float]:
    """Guess the unit from the length of the longest chain of bones.

    Returns
    -------
    unit : str
        A key of `MM_PER_UNIT`.
    factor : float
        What the file's lengths have to be multiplied by.
    """
    reach = _reach(points, joints)
    unit = "cm"
    if reach > 0:
        unit = min(METRES, key=lambda name: abs(np.log(reach * METRES[name] / BODY_REACH_METRES)))
    if unit == "cmu":
        warnings.append(
            "The file states no length unit; 1/0.45 inch, as in CMU's recordings, is assumed "
            "from the size of the skeleton, and lengths are converted to cm."
        )
        return "cm", CMU_UNIT * CM_PER_INCH
    warnings.append(
        f"The file states no length unit; {unit} is assumed from the size of the skeleton."
    )
    return unit, 1.0


def _reach(points: NDArray[np.float64], joints: Sequence[Joint]) -> float:
    """Measure the longest chain from a root to its end, over some frames."""
    bones = np.array(bones_of(joints), dtype=np.intp).reshape(-1, 2)
    some = points[:: max(len(points) // SAMPLED_FRAMES, 1)]
    lengths = np.linalg.norm(some[:, bones[:, 1]] - some[:, bones[:, 0]], axis=2)
    seen = np.isfinite(lengths)
    mean = np.where(seen, lengths, 0.0).sum(axis=0) / np.maximum(seen.sum(axis=0), 1)
    chains = np.zeros(len(joints))
    for (parent, joint), length in zip(bones, mean, strict=True):
        chains[joint] = chains[parent] + length
    return float(chains.max(initial=0.0))


def up_axis(points: NDArray[np.float64], rest: NDArray[np.float64], warnings: list[str]) -> UpAxis:
    """Return +y, the habit of these formats, unless motion and rest pose agree on another axis."""
    up: UpAxis = "+y"
    if len(rest[0]) >= FEWEST_MARKERS and guess_up(points) == guess_up(rest):
        up = guess_up(rest)
    warnings.append(f"The file does not say which axis points up; {up} is assumed.")
    return up


def rate_of(frame_time: str, warnings: list[str]) -> float:
    """Return the rate (Hz) that a frame time means, which is mostly rounded: 0.0083 is 120 Hz.

    Of the common rates that the stated digits may stand for, rounded or cut, the nearest is taken
    where it is near.
    """
    try:
        seconds = float(frame_time)
    except ValueError:
        seconds = 0.0
    if not (seconds > 0 and RATE_BOUNDS[0] <= 1 / seconds <= RATE_BOUNDS[1]):
        warnings.append(f"The file states no usable frame time; {RATE:g} Hz is assumed.")
        return RATE
    rate = 1 / seconds
    _, _, digits = frame_time.lower().partition("e")[0].partition(".")
    near = [
        common
        for common in COMMON_RATES
        if abs(1 / common - seconds) < 10.0 ** -len(digits) and abs(common / rate - 1) <= LIKE_RATE
    ]
    nearest = min(near, key=lambda common: abs(common - rate), default=rate)
    if abs(nearest / rate - 1) <= SAME_RATE:
        return nearest
    warnings.append(
        f"The frame time {seconds:g} s may be a rounded 1/{nearest:g} s; {rate:g} Hz is used."
    )
    return rate
