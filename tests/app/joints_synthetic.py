"""Skeletons written as BVH and ASF/AMC, and a second implementation of where their joints are."""

from dataclasses import dataclass

import numpy as np
from numpy.typing import NDArray
from scipy.spatial.transform import Rotation

FloatArray = NDArray[np.float64]
AXES = "XYZ"


@dataclass(frozen=True)
class Node:
    """A joint of a BVH file; without channels and with `end` set, an End Site."""

    name: str
    parent: int
    offset: tuple[float, float, float]
    channels: tuple[str, ...] = ()
    end: bool = False


def bvh_text(nodes: list[Node], values: FloatArray, frame_time: str = "0.01") -> str:
    """Write a BVH file, its numbers exact; the nodes are in the order of the file."""

    def block(index: int, depth: int) -> list[str]:
        node, pad = nodes[index], "\t" * depth
        kind = "End Site" if node.end else ("JOINT" if node.parent >= 0 else "ROOT")
        lines = [pad + (kind if node.end else f"{kind} {node.name}"), pad + "{"]
        lines.append(f"{pad}\tOFFSET {' '.join(map(repr, node.offset))}")
        if not node.end:
            lines.append(f"{pad}\tCHANNELS {len(node.channels)} {' '.join(node.channels)}")
        for child, other in enumerate(nodes):
            if other.parent == index:
                lines += block(child, depth + 1)
        return [*lines, pad + "}"]

    lines = ["HIERARCHY"]
    for index, node in enumerate(nodes):
        if node.parent < 0:
            lines += block(index, 0)
    lines += ["MOTION", f"Frames: {len(values)}", f"Frame Time: {frame_time}"]
    lines += [" ".join(map(repr, row)) for row in values.tolist()]
    return "\n".join(lines) + "\n"


def bvh_positions(nodes: list[Node], values: FloatArray) -> FloatArray:
    """Place the joints of a BVH file frame by frame, with rotations of scipy."""
    points = np.empty((len(values), len(nodes), 3))
    for frame, row in enumerate(values.tolist()):
        rest = iter(row)
        turned: list[Rotation] = []
        for index, node in enumerate(nodes):
            offset = list(node.offset)
            order, angles = "", []
            for channel in node.channels:
                if channel.endswith("position"):
                    offset[AXES.index(channel[0])] = next(rest)
                else:
                    order += channel[0]
                    angles.append(next(rest))
            own = Rotation.from_euler(order, angles, degrees=True) if order else Rotation.identity()
            if node.parent < 0:
                points[frame, index] = offset
                turned.append(own)
            else:
                parent = turned[node.parent]
                points[frame, index] = points[frame, node.parent] + parent.apply(offset)
                turned.append(parent * own)
    return points


@dataclass(frozen=True)
class Bone:
    """A bone of an ASF file; parent -1 is the root."""

    name: str
    parent: int
    direction: tuple[float, float, float]
    length: float
    axis: tuple[float, float, float] = (0.0, 0.0, 0.0)
    order: str = "XYZ"
    dof: tuple[str, ...] = ()


def asf_text(bones: list[Bone], root_order: str = "TX TY TZ RX RY RZ", length: str = "0.45") -> str:
    """Write an ASF file."""
    lines = [":version 1.10", ":name test", ":units", f"  length {length}", "  angle deg"]
    lines += [":documentation", "  begin and end of nothing", ":root", f"  order {root_order}"]
    lines += ["  axis XYZ", "  position 0 0 0", "  orientation 0 0 0", ":bonedata"]
    for number, bone in enumerate(bones, 1):
        lines += ["begin", f" id {number}", f" name {bone.name}  # a comment"]
        lines += [f" direction {' '.join(map(repr, bone.direction))}", f" length {bone.length!r}"]
        lines.append(f" axis {' '.join(map(repr, bone.axis))} {bone.order}")
        if bone.dof:
            lines += [f" dof {' '.join(bone.dof)}", " limits (-160.0 20.0)"]
            lines += [" (-inf inf)"] * (len(bone.dof) - 1)
        lines.append("end")
    lines += [":hierarchy", "begin"]
    for index, name in [(-1, "root"), *enumerate(bone.name for bone in bones)]:
        if carried := [bone.name for bone in bones if bone.parent == index]:
            lines.append(f" {name} {' '.join(carried)}")
    return "\n".join([*lines, "end", ""])


def amc_text(bones: list[Bone], root: FloatArray, values: list[FloatArray], first: int = 1) -> str:
    """Write an AMC file; the values of each bone have shape (frames, degrees of freedom)."""
    lines = ["#!OML:ASF C:\\elsewhere\\other.ASF", ":FULLY-SPECIFIED", ":DEGREES"]
    for frame in range(len(root)):
        lines += [str(first + frame), f"root {' '.join(map(repr, root[frame].tolist()))}"]
        # Files list the bones in an order of their own.
        for bone, given in reversed(list(zip(bones, values, strict=True))):
            if bone.dof:
                lines.append(f"{bone.name} {' '.join(map(repr, given[frame].tolist()))}")
    return "\n".join(lines) + "\n"


def fixed(order: str, angles: list[float]) -> Rotation:
    """Return a rotation about fixed axes (lower case in scipy), the first one first."""
    return (
        Rotation.from_euler(order.lower(), angles, degrees=True) if order else Rotation.identity()
    )


def amc_positions(
    bones: list[Bone], root_order: str, root: FloatArray, values: list[FloatArray]
) -> FloatArray:
    """Place root and bone tips frame by frame, with rotations of scipy."""
    points = np.empty((len(root), 1 + len(bones), 3))
    order = root_order.upper().split()
    for frame, row in enumerate(root.tolist()):
        given = dict(zip(order, row, strict=True))
        points[frame, 0] = [given.get("T" + axis, 0.0) for axis in AXES]
        turns = [word for word in order if word[0] == "R"]
        turned = [fixed("".join(word[1] for word in turns), [given[word] for word in turns])]
        for index, bone in enumerate(bones):
            own = fixed(bone.order, list(bone.axis))
            motion = fixed("".join(word[1] for word in bone.dof), values[index][frame].tolist())
            rotation = turned[bone.parent + 1] * own * motion * own.inv()
            tip = rotation.apply(np.multiply(bone.direction, bone.length))
            points[frame, index + 1] = points[frame, bone.parent + 1] + tip
            turned.append(rotation)
    return points
