"""Bodies in motion, with nothing wrong, for the tests of the detectors."""

import numpy as np

from mocapmend_algorithms import Recording, no_progress
from mocapmend_algorithms.problems.registry import detector
from mocapmend_algorithms.skeleton import skeleton_from_distances

SHAPE = np.array(
    [
        [[0, 0, 0], [150, 0, 20], [0, 130, 0], [140, 120, -60], [70, 60, 110]],
        [[0, 0, 0], [60, 0, 150], [-50, 40, 190], [10, -60, 280], [60, 50, 330]],
        [[0, 0, 0], [90, 10, -120], [-40, 60, -160], [30, -50, -260], [0, 70, -330]],
    ],
    dtype=float,
)
"""Of three segments: trunk, arm and leg; five markers each, in mm."""
LABELS = tuple(f"{part}{k}" for part in ("TRUNK", "ARM", "LEG") for k in range(5))


def body(seconds=6.0, *, rate=120.0, noise=0.1, unit="mm", seed=0, speed=1.0):
    """Three segments that swing on a walking trunk; 15 markers."""
    rng = np.random.default_rng(seed)
    t = speed * np.arange(round(seconds * rate)) / rate
    walk = np.stack((900.0 * t, 60.0 * np.sin(2.1 * t), 1000.0 + 30.0 * np.sin(6.0 * t)), axis=1)
    parts = []
    for number, shape in enumerate(SHAPE):
        angle = 0.7 * np.sin((2.6 + 0.5 * number) * t + number) if number else 0.1 * np.sin(t)
        turned = shape[None] @ _turns(angle)
        joint = np.array([0.0, 90.0 * (number - 1), 260.0 * (number == 1) - 120.0 * (number == 2)])
        parts.append(walk[:, None] + joint + turned)
    points = np.concatenate(parts, axis=1) + noise * rng.normal(size=(len(t), 15, 3))
    scale = {"mm": 1.0, "cm": 0.1, "m": 0.001}[unit]
    return Recording(points * scale, LABELS, rate, unit)


def _turns(angle):
    turn = np.zeros((len(angle), 3, 3))
    turn[:, 0, 0] = turn[:, 2, 2] = np.cos(angle)
    turn[:, 0, 2], turn[:, 2, 0] = np.sin(angle), -np.sin(angle)
    turn[:, 1, 1] = 1.0
    return turn


def changed(recording, change):
    """Return a recording after a function has changed a copy of its points, in mm."""
    points = recording.points * recording.mm
    change(points)
    return recording.with_points(points / recording.mm)


def found_by(name, recording, **params):
    """Run a detector with some parameters."""
    way = detector(name)
    skeleton = skeleton_from_distances(recording, no_progress)
    return way.function(recording, skeleton, way.params(**params), no_progress)


def spans(runs):
    """Return where the runs are."""
    return [(run.marker, run.start, run.stop) for run in runs]
