"""Which joints go into a refinement network and which markers or joints come out of it."""

from dataclasses import dataclass

import numpy as np

from mocapmend_algorithms.arrays import FloatArray


@dataclass(frozen=True)
class Profile:
    """What a network was made for: one never stands for another.

    Attributes
    ----------
    id : str
        As "kinect22-pig39".
    name : str
        For the user.
    inputs, outputs : tuple of str
        Labels of the joints that go in, and of the markers or joints that come out.
    bones : tuple of (int, int)
        Pairs of outputs whose distance is to stay the same.
    input_root, output_root : tuple of int
        The root is the mean of these: all else is relative to it.
    left, right : tuple of int
        Inputs on either side of the body, in pairs; they tell where it faces.
    matches : tuple of (int, int)
        Inputs and outputs that lie close to each other.

    Raises
    ------
    ValueError
        If it contradicts itself.
    """

    id: str
    name: str
    inputs: tuple[str, ...]
    outputs: tuple[str, ...]
    bones: tuple[tuple[int, int], ...]
    input_root: tuple[int, ...]
    output_root: tuple[int, ...]
    left: tuple[int, ...]
    right: tuple[int, ...]
    matches: tuple[tuple[int, int], ...]

    def __post_init__(self) -> None:
        if not self.id.strip() or not self.inputs or not self.outputs:
            raise ValueError("a profile needs an id, inputs and outputs")
        for labels in (self.inputs, self.outputs):
            if len({label.upper() for label in labels}) != len(labels):
                raise ValueError("a profile has a label twice")
        if len(self.left) != len(self.right) or not self.left:
            raise ValueError("a profile needs as many inputs on the left as on the right")
        near = [one for one, _ in self.matches], [other for _, other in self.matches]
        used_inputs = (*self.input_root, *self.left, *self.right, *near[0])
        used_outputs = (*self.output_root, *near[1], *(end for bone in self.bones for end in bone))
        if not (self.input_root and self.output_root and self.bones and self.matches):
            raise ValueError("a profile needs roots, bones and matches")
        for used, labels in ((used_inputs, self.inputs), (used_outputs, self.outputs)):
            if not all(0 <= index < len(labels) for index in used):
                raise ValueError("a profile uses a joint that it does not have")
        if any(a == b for a, b in self.bones):
            raise ValueError("a profile has a bone from a joint to itself")

    @property
    def bone_ends(self) -> tuple[list[int], list[int]]:
        """The outputs at either end of the bones."""
        return [a for a, _ in self.bones], [b for _, b in self.bones]


def mirrored(labels: tuple[str, ...]) -> tuple[int, ...]:
    """Find the partner of each marker on the other side of the body.

    Left and Right are exchanged wherever they stand, L and R where they begin a label that is in
    capitals, as those of Plug-in Gait are.

    Parameters
    ----------
    labels : tuple of str

    Returns
    -------
    tuple of int
        One per label: itself for those in the middle, -1 for one whose partner is not there.
    """
    places = {label.upper(): index for index, label in enumerate(labels)}
    return tuple(places.get(_other_side(label).upper(), -1) for label in labels)


def _other_side(label: str) -> str:
    for one, other in (("LEFT", "RIGHT"), ("RIGHT", "LEFT")):
        if one in label.upper():
            return label.upper().replace(one, other)
    first = {"L": "R", "R": "L"}.get(label[:1], label[:1]) if label.isupper() else label[:1]
    return first + label[1:]


def root_track(points: FloatArray, root: tuple[int, ...]) -> FloatArray:
    """Return the root of poses, shape (..., 1, 3), from points of shape (..., markers, 3)."""
    track: FloatArray = points[..., list(root), :].mean(axis=-2, keepdims=True)
    return np.asarray(track, dtype=np.float64)
