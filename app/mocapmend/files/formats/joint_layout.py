"""The joints of files that do not name them: the templates that ship with the program do."""

from dataclasses import dataclass
from functools import cache

from mocapmend_resources import skeletons


@dataclass(frozen=True)
class JointLayout:
    """The joints of files of a kind.

    Attributes
    ----------
    labels : tuple of str
        In the order of the files.
    bones : tuple of (int, int)
        Pairs of parent and joint.
    """

    labels: tuple[str, ...]
    bones: tuple[tuple[int, int], ...]

    @property
    def parents(self) -> dict[int, int]:
        """The parent of each joint that has one."""
        return {joint: parent for parent, joint in self.bones}

    def place(self, label: str) -> int:
        """Return where a joint is among the labels."""
        return self.labels.index(label)


@cache
def joint_layout(name: str) -> JointLayout:
    """Return what a template that ships with the program says, as "kinect_v2_25"."""
    template = skeletons.read(name)
    place = {label: i for i, label in enumerate(template.required)}
    bones = tuple((place[parent], place[joint]) for parent, joint in template.bones)
    return JointLayout(template.required, bones)
