"""A person as a Kinect sees one, in files as data sets have them, with numbers made up."""

from collections.abc import Sequence

import numpy as np
from numpy.typing import NDArray
from scipy.spatial.transform import Rotation

FloatArray = NDArray[np.float64]

REST_25 = np.array([
    [0.00, 0.00, 3.00], [0.00, 0.30, 2.97], [0.00, 0.60, 2.95], [0.00, 0.75, 2.94],
    [-0.18, 0.48, 2.96], [-0.22, 0.22, 2.95], [-0.24, -0.02, 2.90], [-0.24, -0.09, 2.88],
    [0.18, 0.48, 2.96], [0.22, 0.22, 2.95], [0.24, -0.02, 2.90], [0.24, -0.09, 2.88],
    [-0.08, -0.03, 2.98], [-0.10, -0.40, 2.96], [-0.11, -0.78, 3.00], [-0.12, -0.83, 2.90],
    [0.08, -0.03, 2.98], [0.10, -0.40, 2.96], [0.11, -0.78, 3.00], [0.12, -0.83, 2.90],
    [0.00, 0.53, 2.95],
    [-0.24, -0.16, 2.86], [-0.20, -0.10, 2.85], [0.24, -0.16, 2.86], [0.20, -0.10, 2.85],
])  # fmt: skip
"""The joints of a Kinect v2 (m), y up."""

REST_39 = np.array([
    [100, 60, 1700], [100, -60, 1700], [-60, 70, 1690], [-60, -70, 1690],
    [-80, 0, 1480], [-110, 0, 1300], [70, 0, 1420], [90, 0, 1260], [-110, -90, 1350],
    [0, 190, 1440], [0, 220, 1300], [0, 240, 1160], [10, 250, 1050], [30, 260, 930],
    [-20, 280, 930], [10, 270, 850],
    [0, -190, 1440], [0, -220, 1300], [0, -240, 1160], [10, -250, 1050], [30, -260, 930],
    [-20, -280, 930], [10, -270, 850],
    [80, 130, 1000], [80, -130, 1000], [-110, 50, 1020], [-110, -50, 1020],
    [20, 150, 750], [0, 150, 500], [0, 150, 300], [-20, 140, 90], [-70, 120, 50], [120, 130, 50],
    [20, -150, 750], [0, -150, 500], [0, -150, 300], [-20, -140, 90], [-70, -120, 50],
    [120, -130, 50],
], float)  # fmt: skip
"""The markers of UI-PRMD's Vicon system (mm), z up."""

PARENTS_22 = (-1, 0, 1, 2, 3, 4, 2, 6, 7, 8, 2, 10, 11, 12, 0, 14, 15, 16, 0, 18, 19, 20)
OFFSETS_22 = np.array([
    [-5.0, 92.0, -257.0], [0, 29, 0], [0, 22, 0], [0, 0.7, 0], [0, 6.6, 0], [0, 20.7, 0],
    [1.4, 0.7, 0], [14, 0, 0], [28, 0, 0], [25, 0, 0], [-1.7, 0.4, 0], [-15, 0, 0], [-28, 0, 0],
    [-26, 0, 0], [7.7, 1.6, 3.4], [0, -39, 0], [0, -41, 0], [0, 0, 14], [-7.7, 0.9, 3.4],
    [0, -38, 0], [0, -41, 0], [0, 0, 15],
])  # fmt: skip
"""From each joint of UI-PRMD's Kinect to its parent (cm), in the frame of that."""
STILL_22 = [5, 17, 21]


def person(frames: int = 40, rest: FloatArray = REST_25) -> FloatArray:
    """Let all joints sway, by numbers with few digits."""
    size = 0.01 if rest is REST_25 else 10.0
    time = np.arange(frames)[:, None, None]
    sway = size * np.sin(0.1 * time + np.arange(rest.size).reshape(rest.shape))
    return np.round(rest + sway, 6)


def rows(values: FloatArray, separator: str = ",", end: str = "") -> str:
    """Write numbers without a header, NaN as nothing."""
    flat = values.reshape(len(values), -1).tolist()
    lines = [separator.join("" if np.isnan(x) else repr(x) for x in row) + end for row in flat]
    return "\n".join([*lines, ""])


def with_states(points: FloatArray, states: FloatArray | None = None) -> FloatArray:
    """Put the states of tracking behind the positions, as KIMORE has them."""
    states = np.full(points.shape[:2], 2.0) if states is None else states
    return np.concatenate([points, states[..., None]], axis=2)


def with_orientations(points: FloatArray) -> FloatArray:
    """Put quaternions behind the positions, as KERAAL has them; ends of the body have none."""
    turned = Rotation.random(points.shape[0] * points.shape[1], random_state=4).as_quat()
    turned = turned.reshape(*points.shape[:2], 4)
    turned[:, [3, 15, 19, 21, 22, 23, 24]] = 0
    return np.concatenate([points, turned], axis=2)


def led_by(column: Sequence[float] | FloatArray, values: FloatArray) -> FloatArray:
    """Begin each line with a number."""
    return np.column_stack([column, values.reshape(len(values), -1)])


def uiprmd(frames: int = 30) -> tuple[FloatArray, FloatArray]:
    """Return offsets (cm) and angles (degrees) of UI-PRMD's Kinect, shape (frames, 22, 3) each."""
    rng = np.random.default_rng(5)
    offsets = np.round(OFFSETS_22 * (1 + 0.01 * rng.random((frames, 1, 1))), 6)
    angles = np.round(np.cumsum(rng.normal(0, 4, (frames, 22, 3)), axis=0), 6)
    angles[:, STILL_22] = 0
    return offsets, angles


def uiprmd_positions(offsets: FloatArray, angles: FloatArray) -> FloatArray:
    """Place the joints (mm) with rotations of scipy: R = Rz(z) Rx(x) Ry(y) along the chain."""
    points, turned = np.empty_like(offsets), []
    for joint, parent in enumerate(PARENTS_22):
        own = Rotation.from_euler("ZXY", angles[:, joint][:, [2, 0, 1]], degrees=True)
        if parent < 0:
            points[:, joint] = offsets[:, joint]
            turned.append(own)
        else:
            points[:, joint] = points[:, parent] + turned[parent].apply(offsets[:, joint])
            turned.append(turned[parent] * own)
    return 10 * points
