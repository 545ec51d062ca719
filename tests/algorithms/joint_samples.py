"""Skeletons that move, made for tests: the 31 joints with bones of constant length."""

import numpy as np
from scipy.spatial.transform import Rotation

from mocapmend_algorithms import Recording
from mocapmend_algorithms.sparse.body import PARTS, find_body

NAMES = tuple(name for part in PARTS for name in part)


def directions(frames, seed, rate):
    """Let each bone swing about an axis of its own, in rhythms that come again."""
    rng = np.random.default_rng(seed)
    time = np.arange(frames)[:, None] / rate
    rest = rng.normal(size=(len(NAMES), 3))
    axes = rng.normal(size=(len(NAMES), 3))
    axes /= np.linalg.norm(axes, axis=1, keepdims=True)
    phases = rng.uniform(0, 2 * np.pi, len(NAMES))
    angles = 0.5 * np.sin(2 * np.pi * 0.9 * time + phases)
    angles += 0.2 * np.sin(2 * np.pi * 0.37 * time + 2 * phases)
    turned = np.stack(
        [Rotation.from_rotvec(angles[:, [j]] * axes[j]).apply(rest[j]) for j in range(len(NAMES))],
        axis=1,
    )
    return turned / np.linalg.norm(turned, axis=2, keepdims=True)


def walker(frames=300, *, seed=0, size=1.0, unit="cm", rate=100.0, prefix=""):
    """Make a recording of the 31 joints that wanders and turns."""
    rng = np.random.default_rng(1)
    lengths = size * rng.uniform(5.0, 40.0, len(NAMES)) * {"cm": 1.0, "mm": 10.0}[unit]
    labels = tuple(prefix + name for name in NAMES)
    points = np.zeros((frames, len(NAMES), 3))
    empty = Recording(points + np.arange(31)[:, None], labels, rate, unit, "+y")
    parents = find_body(empty, empty.present).parents
    away = directions(frames, seed, rate) * lengths[:, None]
    for joint, parent in enumerate(parents.tolist()):
        if parent >= 0:
            points[:, joint] = points[:, parent] + away[:, joint]
    time = np.arange(frames) / rate
    heading = Rotation.from_rotvec(np.outer(0.3 * time, [0, 1, 0])).as_matrix()
    points = points @ heading.swapaxes(1, 2)
    points += np.stack([50 * time, 0 * time, 30 * time], axis=1)[:, None]
    return Recording(points, labels, rate, unit, "+y")


def hidden(recording, markers, start, stop):
    """Take markers out of some frames."""
    points = recording.points.copy()
    points[start:stop, markers] = np.nan
    return recording.with_points(points)
