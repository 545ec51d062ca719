"""A small body, what a cheap sensor makes of it, and small networks."""

import numpy as np

from mocapmend_algorithms.arrays import FloatArray
from mocapmend_algorithms.recording import Recording
from mocapmend_algorithms.refine.model import Model
from mocapmend_algorithms.refine.network import Shape
from mocapmend_algorithms.refine.profile import Profile
from mocapmend_algorithms.refine.scaling import Scaling

PROFILE = Profile(
    id="toy",
    name="Toy, 5 joints to 6 markers",
    inputs=("Root", "LeftHip", "RightHip", "LeftHand", "RightHand"),
    outputs=("LPSI", "RPSI", "LWRA", "RWRA", "LELB", "RELB"),
    bones=((0, 1), (2, 4), (3, 5)),
    input_root=(0,),
    output_root=(0, 1),
    left=(1,),
    right=(2,),
    matches=((1, 0), (2, 1), (3, 2), (4, 3)),
)


def move(frames: int, rate: float, seed: int = 0) -> tuple[FloatArray, FloatArray]:
    """Return joints and markers of a body that waves its arms, z up, in mm, and walks along y."""
    rng = np.random.default_rng(seed)
    t = np.arange(frames) / rate
    phase = rng.uniform(0, 2 * np.pi, 2)
    root = np.stack([50 * np.sin(t), 200 * t, 900 + 20 * np.cos(2 * t)], axis=1)
    left = 0.6 * np.sin(2 * np.pi * 0.7 * t + phase[0])
    right = 0.6 * np.sin(2 * np.pi * 0.5 * t + phase[1])
    elbows, wrists = [], []
    for side, angle in ((1, left), (-1, right)):
        along = np.stack([side * np.cos(angle), np.sin(angle), 0.3 * angle], axis=1)
        along /= np.linalg.norm(along, axis=1, keepdims=True)
        shoulder = np.add(root, [side * 150, 0, 400])
        elbows.append(shoulder + 280 * along)
        wrists.append(shoulder + 530 * along)
    pelvis = [np.add(root, [side * 50, -80, 30]) for side in (1, -1)]
    hips = [np.add(root, [side * 90, 0, 0]) for side in (1, -1)]
    joints = np.stack([root, *hips, *wrists], axis=1)
    markers = np.stack([*pelvis, *wrists, *elbows], axis=1)
    return joints, markers


def turned(points: FloatArray, angle: float) -> FloatArray:
    """Turn points about z."""
    cosine, sine = np.cos(angle), np.sin(angle)
    return points @ np.array([[cosine, -sine, 0], [sine, cosine, 0], [0, 0, 1]]).T


def sensor(joints: FloatArray, rate: float = 30.0, noise: float = 0.0, seed: int = 0) -> Recording:
    """Return joints as a recording in metres with y up, as the Kinect's."""
    rng = np.random.default_rng(seed)
    seen = joints + noise * rng.standard_normal(joints.shape)
    return Recording(
        np.ascontiguousarray(seen[..., [1, 2, 0]] / 1000), PROFILE.inputs, rate, unit="m", up="+y"
    )


def network(shape: Shape, seed: int = 0) -> dict[str, np.ndarray]:
    """Return random weights."""
    rng = np.random.default_rng(seed)
    return {
        name: (0.3 * rng.standard_normal(size)).astype(np.float32)
        for name, size in shape.expected().items()
    }


def model(*, skip: bool = True, stacks: int = 2, seed: int = 0) -> Model:
    """Return a small untrained network for the toy profile."""
    shape = Shape(15, 18, stacks, 4, 3, skip, perceptual=True)
    rng = np.random.default_rng(seed)
    scaling = Scaling(
        rng.normal(0, 100, (5, 3)),
        rng.uniform(50, 150, (5, 3)),
        rng.normal(0, 100, (6, 3)),
        rng.uniform(50, 150, (6, 3)),
    )
    return Model(PROFILE, shape, scaling, network(shape, seed), {"about": "random weights"})


def copying() -> Model:
    """Return a network that makes of the joints what they are: hands for wrists and elbows."""
    shape = Shape(15, 18, 1, 2, 2, skip=True, perceptual=False)
    weights = {name: np.zeros(size, np.float32) for name, size in shape.expected().items()}
    for output, source in enumerate((1, 2, 3, 4, 3, 4)):
        for axis in range(3):
            weights["skip.weight"][3 * output + axis, 3 * source + axis] = 1.0
    nothing, ones = np.zeros, np.ones
    scaling = Scaling(nothing((5, 3)), ones((5, 3)), nothing((6, 3)), ones((6, 3)))
    return Model(PROFILE, shape, scaling, weights)
