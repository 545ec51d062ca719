"""Files of joints, of markers and of networks that fit the profiles of the program."""

import csv
from pathlib import Path

import numpy as np

from mocapmend.files import write_new_c3d
from mocapmend_algorithms.arrays import FloatArray
from mocapmend_algorithms.recording import Recording
from mocapmend_algorithms.refine.model import Model, encode_model
from mocapmend_algorithms.refine.network import Shape
from mocapmend_algorithms.refine.profile import Profile
from mocapmend_algorithms.refine.scaling import Scaling

RATE = 30.0
FRAMES = 150
ASIDE = 20.0
"""Millimetres between an output and the input that it is nearest to."""


def body(profile: Profile, frames: int, seed: int = 0) -> tuple[FloatArray, FloatArray]:
    """Return joints and markers of a body that sways, z up, mm."""
    rng = np.random.default_rng(seed)
    rest = np.random.default_rng(99).normal([0, 0, 900], 300, (len(profile.inputs), 3))
    for side, x in ((profile.left, 150.0), (profile.right, -150.0)):
        rest[list(side), 0] = x
    t = np.arange(frames)[:, None, None] / RATE
    speed, phase = rng.uniform(0.3, 1.2, rest.shape), rng.uniform(0, 6, rest.shape)
    joints = rest + 60 * np.sin(2 * np.pi * speed * t + phase)
    near = nearest(profile)
    markers = joints[:, near] + np.random.default_rng(7).normal(0, ASIDE, (len(near), 3))
    return joints, markers


def nearest(profile: Profile) -> list[int]:
    """Return an input for each output: the one that it matches, else the root's first."""
    matches = {output: source for source, output in profile.matches}
    return [matches.get(output, profile.input_root[0]) for output in range(len(profile.outputs))]


def write_pair(
    folder: Path,
    profile: Profile,
    name: str = "walk",
    *,
    seed: int = 0,
    lag: int = 0,
    hole: tuple[int, int, int] | None = None,
) -> tuple[Path, Path]:
    """Write a recording of the inputs, y up, and one of the outputs, z up; return their paths."""
    joints, markers = body(profile, FRAMES, seed)
    if hole is not None:
        joint, start, stop = hole
        joints[start:stop, joint] = np.nan
    paths = folder / f"{name}.c3d", folder / f"{name}_reference.c3d"
    seen = np.ascontiguousarray(joints[..., [1, 2, 0]])
    write_new_c3d(Recording(seen, profile.inputs, RATE, up="+y"), paths[0])
    write_new_c3d(Recording(np.ascontiguousarray(markers[lag:]), profile.outputs, RATE), paths[1])
    return paths


def write_pairs(folder: Path, profile: Profile, count: int) -> Path:
    """Write some pairs and the list of them; performers and repetitions are numbered from 0."""
    path = folder / "pairs.csv"
    with path.open("w", newline="") as stream:
        table = csv.writer(stream)
        table.writerow(["recording", "reference", "performer", "movement", "repetition"])
        for number in range(count):
            pair = write_pair(folder, profile, str(number), seed=number)
            table.writerow([pair[0].name, pair[1].name, number, 0, number])
    return path


def model_of(profile: Profile, *, copies: bool = False) -> Model:
    """Return an untrained network, or one that gives each output the input it is nearest to."""
    inputs, outputs = len(profile.inputs), len(profile.outputs)
    shape = Shape(3 * inputs, 3 * outputs, 1, 3, 3, skip=True, perceptual=False)
    rng = np.random.default_rng(0)
    weights = {
        name: np.asarray(0.0 if copies else 0.2, np.float32)
        * rng.standard_normal(size).astype(np.float32)
        for name, size in shape.expected().items()
    }
    if copies:
        for output, source in enumerate(nearest(profile)):
            for axis in range(3):
                weights["skip.weight"][3 * output + axis, 3 * source + axis] = 1.0
    scaling = Scaling(
        np.zeros((inputs, 3)), np.full((inputs, 3), 100.0),
        np.zeros((outputs, 3)), np.full((outputs, 3), 100.0),
    )  # fmt: skip
    return Model(profile, shape, scaling, weights, {"about": "random weights"})


def write_model(path: Path, profile: Profile, *, copies: bool = False) -> Path:
    """Write such a network."""
    path.write_bytes(encode_model(model_of(profile, copies=copies)))
    return path
