"""The skeleton of a BVH file: everything before its word MOTION."""

import re
from collections.abc import Iterator
from dataclasses import replace

import numpy as np

from mocapmend.errors import MocapmendError
from mocapmend.files.formats.kinematics import FARTHEST, MOST_JOINTS, Joint, Turn, Vector
from mocapmend.files.opening import ANOTHER_FILE

TOKEN = re.compile(r"[{}]|[^\s{}]+")
LONGEST_NAME = 200
COUNTS = tuple("0123456")
CHANNELS = {
    f"{letter}{kind}": (axis, kind == "rotation")
    for axis, letter in enumerate("xyz")
    for kind in ("position", "rotation")
}


def read_hierarchy(text: str, where: str) -> tuple[list[Joint], int]:
    """Read the joints and End Sites.

    The braces nest without limit, so that they are followed with a stack, not by recursion.

    Parameters
    ----------
    text : str
        From the word HIERARCHY, which is not looked at, up to the word MOTION.
    where : str
        The file, for messages.

    Returns
    -------
    joints : list of Joint
        In the order of the file. Position channels take the place of the offset along their
        axis, as Blender and MotionBuilder have it; angles are turned in the order of their
        channels.
    channels : int
        Values per frame.

    Raises
    ------
    MocapmendError
        If the text breaks the grammar.
    """
    parser = _Parser(text, where)
    parser.run()
    return parser.joints, parser.channels


class _Parser:
    """A pass over the words of a hierarchy."""

    def __init__(self, text: str, where: str) -> None:
        self.joints: list[Joint] = []
        self.channels = 0
        self._where = where
        self._open: list[int] = []
        self._words: Iterator[str] = (found.group() for found in TOKEN.finditer(text))
        next(self._words, None)

    def run(self) -> None:
        for word in self._words:
            kind = word.upper()
            if kind in ("ROOT", "JOINT", "END"):
                self._begin(kind)
            elif not self._open:
                raise self._error(f"The hierarchy has {_quoted(word)} outside of its joints")
            elif kind == "OFFSET":
                self._offset()
            elif kind == "CHANNELS":
                self._channels()
            elif word == "}":
                self._open.pop()
            else:
                raise self._error(f"The hierarchy has the unknown word {_quoted(word)}")
        if self._open:
            raise self._error(f"The hierarchy ends before joint {self._label} is closed")
        if not self.joints:
            raise self._error("The hierarchy has no joints")

    @property
    def _label(self) -> str:
        return self.joints[self._open[-1]].label

    def _begin(self, kind: str) -> None:
        parent = self._open[-1] if self._open else -1
        words = []
        for word in self._words:
            if word == "{":
                break
            words.append(word)
            if word == "}" or len(words) > LONGEST_NAME:
                raise self._error("The hierarchy lacks an opening brace")
        else:
            raise self._error("The hierarchy ends within the name of a joint")
        name = " ".join(words)
        if kind == "END":
            if parent < 0:
                raise self._error("The hierarchy has an End Site outside of its joints")
            name = f"{self.joints[parent].label} end"
        if len(name) > LONGEST_NAME:
            raise self._error("The hierarchy has a name that is too long")
        if len(self.joints) == MOST_JOINTS:
            raise self._error(f"The hierarchy has more than {MOST_JOINTS} joints")
        self._open.append(len(self.joints))
        label = "".join(letter for letter in name if letter.isprintable())
        self.joints.append(Joint(label=label or f"joint {len(self.joints) + 1}", parent=parent))

    def _offset(self) -> None:
        numbers = [self._number() for _ in range(3)]
        offset: Vector = (numbers[0], numbers[1], numbers[2])
        self._change(offset=offset)

    def _number(self) -> float:
        word = next(self._words, "")
        try:
            number = float(word)
        except ValueError:
            number = np.nan
        if not abs(number) < FARTHEST:
            raise self._error(f"The offset of joint {self._label} is no three numbers")
        return number

    def _channels(self) -> None:
        stated = next(self._words, "")
        if stated not in COUNTS:
            raise self._error(f"Joint {self._label} does not say how many channels it has")
        shifts, turns = [], []
        for _ in range(int(stated)):
            word = next(self._words, "")
            if word.lower() not in CHANNELS:
                raise self._error(f"Joint {self._label} has the unknown channel {_quoted(word)}")
            axis, is_rotation = CHANNELS[word.lower()]
            if is_rotation:
                turns.append(Turn(axis, self.channels))
            else:
                shifts.append((axis, self.channels))
            self.channels += 1
        self._change(shifts=tuple(shifts), turns=tuple(turns))

    def _change(self, **fields: object) -> None:
        index = self._open[-1]
        self.joints[index] = replace(self.joints[index], **fields)  # type: ignore[arg-type]

    def _error(self, what: str) -> MocapmendError:
        return MocapmendError(f"{what}.", self._where, ANOTHER_FILE)


def _quoted(word: str) -> str:
    return repr(word[:40])
