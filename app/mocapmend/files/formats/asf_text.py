"""The words of an ASF file, sorted by its sections."""

from dataclasses import dataclass, field

from mocapmend.errors import MocapmendError
from mocapmend.files.formats.kinematics import MOST_JOINTS
from mocapmend.files.opening import ANOTHER_FILE

ROOT = "root"
LONGEST_NAME = 200
BLANKS = str.maketrans("(),", "   ")

Fields = dict[str, list[str]]


@dataclass
class Sections:
    """The words of the file.

    Attributes
    ----------
    units, root : dict of str to list of str
        The words after each key.
    bones : dict of str to dict
        The same of each bone, by its name.
    links : list of list of str
        A bone and those that it carries.
    """

    units: Fields = field(default_factory=dict)
    root: Fields = field(default_factory=dict)
    bones: dict[str, Fields] = field(default_factory=dict)
    links: list[list[str]] = field(default_factory=list)


def read_sections(text: str, where: str) -> Sections:
    """Sort the words of an ASF file; a key that comes twice counts once.

    Raises
    ------
    MocapmendError
        If a bone is not closed, has no name or the name of another one.
    """
    found = Sections()
    section = ""
    bone: Fields | None = None
    for line in text.splitlines():
        words = line.partition("#")[0].translate(BLANKS).split()
        if not words:
            continue
        key = words[0].lower()
        if key.startswith(":"):
            section = key
        elif section == ":units":
            found.units[key] = words[1:]
        elif section == ":root":
            found.root[key] = words[1:]
        elif section == ":hierarchy" and key not in ("begin", "end"):
            found.links.append(words)
        elif section == ":bonedata" and key == "begin":
            bone = {}
        elif section == ":bonedata" and key == "end":
            _add_bone(found.bones, bone, where)
            bone = None
        elif section == ":bonedata" and bone is not None:
            bone.setdefault(key, words[1:])
    if bone is not None:
        raise MocapmendError("The skeleton file ends within a bone.", where, ANOTHER_FILE)
    return found


def _add_bone(bones: dict[str, Fields], bone: Fields | None, where: str) -> None:
    name = "".join(filter(str.isprintable, " ".join((bone or {}).get("name", ()))))[:LONGEST_NAME]
    if not bone or not name:
        raise MocapmendError("The skeleton has a bone without a name.", where, ANOTHER_FILE)
    if name in bones or name == ROOT:
        raise MocapmendError(f"The skeleton has two bones {name}.", where, ANOTHER_FILE)
    if len(bones) == MOST_JOINTS:
        raise MocapmendError(
            f"The skeleton has more than {MOST_JOINTS} bones.", where, ANOTHER_FILE
        )
    bones[name] = bone
