"""ASF (Acclaim): the skeleton that AMC motions belong to."""

from collections.abc import Mapping, Sequence
from dataclasses import dataclass

from mocapmend.errors import MocapmendError
from mocapmend.files.formats.asf_text import ROOT, Fields, Sections, read_sections
from mocapmend.files.formats.joint_files import LONGEST_SKELETON, text_of
from mocapmend.files.formats.kinematics import FARTHEST, Joint, Turn
from mocapmend.files.opening import ANOTHER_FILE

AXES = {"x": 0, "y": 1, "z": 2}
ROTATIONS = {"rx": 0, "ry": 1, "rz": 2}
TRANSLATIONS = {"tx": 0, "ty": 1, "tz": 2}
FREEDOMS = {*ROTATIONS, *TRANSLATIONS, "l"}
ROOT_ORDER = ("tx", "ty", "tz", "rx", "ry", "rz")
LENGTH_UNITS = 1e-3, 1e3
DEGREES_PER_RADIAN = 57.29577951308232


@dataclass(frozen=True)
class Skeleton:
    """What an ASF file says.

    Attributes
    ----------
    joints : tuple of Joint
        The root and the tip of each bone, each after its parent. Their turns expect degrees.
    columns : mapping of str to tuple of int
        The columns of the motion that each bone of the AMC file fills, in the order of its values.
    channels : int
        Number of columns of the motion.
    angles : tuple of int
        The columns that hold angles.
    start : mapping of int to float
        What the root's position adds to columns of the motion.
    length : float
        The file's length unit; 1 where it states none that can be.
    radians : bool
        Whether its angles are radians.
    warnings : tuple of str
        What was odd.
    """

    joints: tuple[Joint, ...]
    columns: Mapping[str, tuple[int, ...]]
    channels: int
    angles: tuple[int, ...]
    start: Mapping[int, float]
    length: float
    radians: bool
    warnings: tuple[str, ...]


def read_asf(raw: bytes, where: str) -> Skeleton:
    """Read the skeleton of an ASF file.

    A bone turns by C M C^-1: C is its axis, M its angles in the file, both about fixed axes in
    the order in which they are written. Its tip lies at its parent's tip plus its own direction
    times its length, carried by all turns from the root to itself. The root turns in the same way,
    its orientation being C.

    Parameters
    ----------
    raw : bytes
        The file.
    where : str
        Its name, for messages.

    Raises
    ------
    MocapmendError
        If it is no skeleton or breaks the grammar.
    """
    if len(raw) > LONGEST_SKELETON:
        raise MocapmendError("The skeleton file is too long.", where, ANOTHER_FILE)
    text = text_of(raw)
    if ":bonedata" not in text.lower():
        raise MocapmendError("This is no ASF skeleton.", where, ANOTHER_FILE)
    return _Builder(read_sections(text, where), where).skeleton()


class _Builder:
    """Makes the joints, and numbers the columns of the motion as it meets them."""

    def __init__(self, sections: Sections, where: str) -> None:
        self._sections = sections
        self._where = where
        self._columns: dict[str, tuple[int, ...]] = {}
        self._channels = 0
        self._angles: list[int] = []
        self._warnings: dict[str, None] = {}
        self._radians = [word.lower()[:3] for word in sections.units.get("angle", ())] == ["rad"]

    def skeleton(self) -> Skeleton:
        joints = [self._root()]
        for name, parent in self._parents():
            joints.append(self._bone(name, parent))
        (length,) = self._numbers(self._sections.units, "length", 1, "The skeleton", (1.0,))
        position = self._numbers(self._sections.root, "position", 3, "The root", (0.0,) * 3)
        return Skeleton(
            joints=tuple(joints),
            columns=self._columns,
            channels=self._channels,
            angles=tuple(self._angles),
            start={channel: position[axis] for axis, channel in joints[0].shifts},
            length=length if LENGTH_UNITS[0] <= length <= LENGTH_UNITS[1] else 1.0,
            radians=self._radians,
            warnings=tuple(self._warnings),
        )

    def _parents(self) -> list[tuple[str, int]]:
        """List the bones that the root carries, with the indices of their parents."""
        children: dict[str, list[str]] = {}
        placed = {ROOT}
        for parent, *carried in self._sections.links:
            for name in (parent, *carried):
                if name != ROOT and name not in self._sections.bones:
                    raise self._error(f"The hierarchy has the unknown bone {name[:40]!r}")
            for name in carried:
                if name in placed:
                    raise self._error(f"The hierarchy has two parents of {name}")
                placed.add(name)
            children.setdefault(parent, []).extend(carried)
        order: list[tuple[str, int]] = []
        waiting = [(name, 0) for name in reversed(children.get(ROOT, []))]
        while waiting:
            name, parent_index = waiting.pop()
            order.append((name, parent_index))
            waiting += [(child, len(order)) for child in reversed(children.get(name, []))]
        # One parent each, so that what the root does not reach hangs in the air or in a ring.
        if lost := set(self._sections.bones) - {name for name, _ in order}:
            raise self._error(f"The hierarchy does not join {min(lost)} to the root")
        return order

    def _root(self) -> Joint:
        fields = self._sections.root
        order = tuple(word.lower() for word in fields.get("order", ROOT_ORDER))
        columns = self._number_columns(ROOT, order)
        axis = fields.get("axis", ["XYZ"])[-1:]
        angles = self._numbers(fields, "orientation", 3, "The root", (0.0,) * 3)
        return Joint(
            label=ROOT,
            parent=-1,
            shifts=tuple(
                (TRANSLATIONS[freedom], column)
                for freedom, column in zip(order, columns, strict=True)
                if freedom in TRANSLATIONS
            ),
            turns=self._turns(angles, "".join(axis), order, columns, "The root"),
        )

    def _bone(self, name: str, parent: int) -> Joint:
        fields = self._sections.bones[name]
        owner = f"Bone {name}"
        x, y, z = self._numbers(fields, "direction", 3, owner)
        (length,) = self._numbers(fields, "length", 1, owner)
        axis = fields.get("axis", [])
        angles = self._numbers({"axis": axis[:3]}, "axis", 3, owner) if axis else (0.0,) * 3
        order = tuple(word.lower() for word in fields.get("dof", ()))
        columns = self._number_columns(name, order)
        if not set(order) <= set(ROTATIONS):
            self._warnings["Bones that shift or stretch are drawn with a fixed length."] = None
        return Joint(
            label=name,
            parent=parent,
            offset=(x * length, y * length, z * length),
            turns=self._turns(angles, axis[3] if len(axis) > 3 else "XYZ", order, columns, owner),
            moves_itself=True,
        )

    def _number_columns(self, name: str, order: Sequence[str]) -> tuple[int, ...]:
        if not set(order) <= FREEDOMS or len(order) > len(FREEDOMS):
            raise self._error(f"The skeleton has unknown degrees of freedom of {name}")
        columns = tuple(range(self._channels, self._channels + len(order)))
        self._channels += len(order)
        self._columns[name] = columns
        self._angles += [
            column for freedom, column in zip(order, columns, strict=True) if freedom in ROTATIONS
        ]
        return columns

    def _turns(
        self,
        angles: Sequence[float],
        letters: str,
        order: Sequence[str],
        columns: Sequence[int],
        owner: str,
    ) -> tuple[Turn, ...]:
        """Return C M C^-1; about fixed axes, what is written first is applied first."""
        axes = [AXES.get(letter) for letter in letters.lower()]
        if len(axes) != 3 or None in axes:
            raise self._error(f"{owner} has the unknown order of axes {letters[:40]!r}")
        factor = DEGREES_PER_RADIAN if self._radians else 1.0
        inverse = [
            Turn(axis, degrees=-angle * factor)
            for axis, angle in zip(axes, angles, strict=True)
            if axis is not None and angle
        ]
        motion = [
            Turn(ROTATIONS[freedom], column)
            for freedom, column in zip(order, columns, strict=True)
            if freedom in ROTATIONS
        ]
        if not motion:
            return ()
        own = [Turn(turn.axis, degrees=-turn.degrees) for turn in reversed(inverse)]
        return (*own, *reversed(motion), *inverse)

    def _numbers(
        self,
        fields: Fields,
        key: str,
        count: int,
        owner: str,
        otherwise: tuple[float, ...] = (),
    ) -> tuple[float, ...]:
        if key not in fields and otherwise:
            return otherwise
        try:
            numbers = tuple(float(word) for word in fields.get(key, ()))
        except ValueError:
            numbers = ()
        if len(numbers) != count or not all(abs(number) < FARTHEST for number in numbers):
            raise self._error(f"{owner} has no usable {key}")
        return numbers

    def _error(self, what: str) -> MocapmendError:
        return MocapmendError(f"{what}.", self._where, ANOTHER_FILE)
