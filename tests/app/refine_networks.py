"""Small networks for the window's profiles, and recordings that they fit."""

from pathlib import Path

import numpy as np
from kinect_samples import REST_25, REST_39, person, rows, uiprmd

from mocapmend.refine.profiles import profile_named
from mocapmend_algorithms.refine.model import Model, encode_model
from mocapmend_algorithms.refine.network import Shape
from mocapmend_algorithms.refine.scaling import Scaling

CARD = {
    "about": "copies joints, for tests",
    "pairs": 3,
    "performers": 2,
    "movements": 1,
    "frames": 900,
    "held_out": "repetitions 8, 9, 10",
    "measured_on": 2,
    "figures": {
        "network": {"position_mm2": 1234.0, "bones_mm2": 56.7, "smoothness_mm2": 0.891},
    },
    "new_people": {
        "held_out": "performers 8, 9, 10",
        "measured_on": 7,
        "figures": {
            "network": {"position_mm2": 2345.0, "bones_mm2": 67.8, "smoothness_mm2": 0.912},
        },
    },
}


def copying(profile: str = "kinect22-pig39") -> Model:
    """Return a network whose outputs are the joints that lie close to them, or the first one."""
    made_for = profile_named(profile)
    joints, markers = len(made_for.inputs), len(made_for.outputs)
    shape = Shape(3 * joints, 3 * markers, 1, 2, 2, skip=True, perceptual=False)
    weights = {name: np.zeros(size, np.float32) for name, size in shape.expected().items()}
    near = {output: joint for joint, output in made_for.matches}
    for output in range(markers):
        for axis in range(3):
            weights["skip.weight"][3 * output + axis, 3 * near.get(output, 0) + axis] = 1.0
    scaling = Scaling(
        np.zeros((joints, 3)), np.ones((joints, 3)), np.zeros((markers, 3)), np.ones((markers, 3))
    )
    return Model(made_for, shape, scaling, weights, CARD)


def write_network(path: Path, profile: str = "kinect22-pig39") -> Path:
    """Write it to a file."""
    path.write_bytes(encode_model(copying(profile)))
    return path


def write_kinect22(folder: Path, frames: int = 90) -> Path:
    """Write 3 s of UI-PRMD's Kinect, in two files; return the one of the positions."""
    for name, values in zip(("positions", "angles"), uiprmd(frames), strict=True):
        (folder / f"kinect_{name}.txt").write_text(rows(values))
    return folder / "kinect_positions.txt"


def write_kinect25(folder: Path) -> Path:
    """Write a recording of a Kinect v2."""
    path = folder / "v2.csv"
    path.write_text(rows(person(60, REST_25)))
    return path


def write_reference(folder: Path, frames: int = 300) -> Path:
    """Write 3 s of the 39 markers of UI-PRMD's Vicon."""
    path = folder / "vicon_positions.txt"
    path.write_text(rows(person(frames, REST_39)))
    return path
