"""AMC (Acclaim, as in CMU's database): the angles of the bones of an ASF skeleton."""

from array import array
from dataclasses import dataclass
from pathlib import Path

import numpy as np
from numpy.typing import NDArray

from mocapmend.errors import MocapmendError
from mocapmend.files.formats.asf import Skeleton, read_asf
from mocapmend.files.formats.assumed import CM_PER_INCH, RATE, body_unit
from mocapmend.files.formats.joint_files import about_samples, lines_of, read_bytes
from mocapmend.files.formats.kinematics import bones_of, check_size, positions
from mocapmend.files.opening import ANOTHER_FILE, Stamp, cannot_read, too_large
from mocapmend.files.source import Source
from mocapmend_algorithms.recording import Recording

MOST_WORDS = 9
"""On a line: the name of a bone, and fewer values."""
MOST_DIGITS = 9


def read_amc(path: Path) -> Source:
    """Read an AMC motion with the ASF skeleton beside it, or an ASF skeleton in its rest pose.

    The markers are the root and the tip of each bone, y up. The skeleton is the file of the same
    name, or of the name up to an underscore ("35.asf" for "35_01.amc"), or the only one in the
    folder. What the motion says of its place is not followed.

    Raises
    ------
    MocapmendError
        If they cannot be read; nothing else.
    """
    path = Path(path)
    try:
        raw, stamp = read_bytes(path)
        if path.suffix.lower() == ".asf":
            return _rest(path, raw, stamp)
        return _motion(path, raw, stamp)
    except MemoryError:
        raise too_large(str(path)) from None


def _rest(path: Path, raw: bytes, stamp: Stamp) -> Source:
    skeleton = read_asf(raw, str(path))
    only = (
        "A skeleton file holds no motion; the rest pose is shown as one frame. Open the .amc file "
        "to see a motion."
    )
    warnings = [*skeleton.warnings, only]
    return _source(path, stamp, skeleton, np.zeros((1, skeleton.channels)), 1, warnings)


def _motion(path: Path, raw: bytes, stamp: Stamp) -> Source:
    beside, how = _skeleton_of(path)
    skeleton = read_asf(read_bytes(beside)[0], str(beside))
    frames = _Frames(skeleton, str(path))
    frames.read(raw)
    warnings = [*how, *skeleton.warnings, *frames.warnings]
    return _source(path, stamp, skeleton, frames.values, frames.first, warnings)


def _source(
    path: Path,
    stamp: Stamp,
    skeleton: Skeleton,
    values: NDArray[np.float64],
    first_frame: int,
    warnings: list[str],
) -> Source:
    """Place the joints; the values, of shape (frames, channels), are changed."""
    joints = skeleton.joints
    check_size(len(values), len(joints), stamp.size, str(path))
    for channel, start in skeleton.start.items():
        values[:, channel] += start
    points = positions(joints, values)
    labels = tuple(joint.label for joint in joints)
    about_samples(points, labels, warnings)
    warnings.append(
        f"The file states no rate and no axis that points up; {RATE:g} Hz and +y, as in CMU's "
        "recordings, are assumed."
    )
    if skeleton.length == 1:
        unit, factor = body_unit(points, joints, warnings)
    else:
        unit, factor = "cm", CM_PER_INCH / skeleton.length
        warnings.append(
            f"One length unit of the skeleton is taken for 1/{skeleton.length:g} inch, as in CMU's "
            "recordings, and lengths are converted to cm."
        )
    points *= factor
    return Source(
        path=path,
        kind="ASF/AMC",
        recording=Recording(points, labels, RATE, unit=unit, up="+y", first_frame=first_frame),
        bones=bones_of(joints),
        warnings=tuple(warnings),
        stamp=stamp,
    )


def _skeleton_of(path: Path) -> tuple[Path, list[str]]:
    """Find the ASF file beside a motion; the second value says how where that is not plain."""
    try:
        found = sorted(item for item in path.parent.iterdir() if item.suffix.lower() == ".asf")
    except OSError as error:
        raise cannot_read(str(path.parent), error) from error
    stem = path.stem.lower()
    for name in (stem, stem.rpartition("_")[0], stem.partition("_")[0]):
        for item in found:
            if item.stem.lower() == name:
                return item, []
    if len(found) == 1:
        return found[0], [f"The skeleton is {found[0].name}, the only one in the folder."]
    raise MocapmendError(
        "The skeleton (.asf) that this motion belongs to is not beside it.",
        str(path),
        "Put it into the same folder, under the name of the motion or of its subject.",
    )


@dataclass
class _Frame:
    """The frame that is being read."""

    number: int
    bones: dict[str, list[float]]


class _Frames:
    """Reads the frames of a motion, which all hold the same bones."""

    def __init__(self, skeleton: Skeleton, where: str) -> None:
        self.first = 1
        self.warnings: list[str] = []
        self.values = np.empty((0, skeleton.channels))
        self._skeleton = skeleton
        self._where = where
        self._radians = skeleton.radians
        self._numbers = array("d")
        self._names: list[str] = []
        self._count = 0
        self._next = 0

    def read(self, raw: bytes) -> None:
        """Read all frames; an incomplete last one is left out."""
        frame: _Frame | None = None
        fault: MocapmendError | None = None
        for line in lines_of(raw):
            if fault:
                raise fault
            words = line.split(None, MOST_WORDS)
            if words[0].startswith((b"#", b":")):
                self._option(words[0])
            elif len(words) == 1 and words[0].isdigit():
                if frame:
                    self._close(frame)
                frame = _Frame(int(words[0][:MOST_DIGITS]), {})
            elif frame is None:
                raise self._error("This is no AMC motion")
            else:
                # Files are cut anywhere: a fault in the last line is none.
                fault = self._add(frame, words)
        if frame and not fault and self._whole(frame):
            self._close(frame)
        elif self._count:
            self.warnings.append("The last frame is incomplete and is left out.")
        if not self._count:
            raise self._error("The file ends before its first frame")
        self._arrange(len(raw))

    def _option(self, word: bytes) -> None:
        if word.upper() in (b":DEGREES", b":RADIANS"):
            self._radians = word.upper() == b":RADIANS"

    def _add(self, frame: _Frame, words: list[bytes]) -> MocapmendError | None:
        """Add the values of a bone; return what is wrong with them."""
        name = words[0].decode("utf-8", errors="replace")
        columns = self._skeleton.columns.get(name)
        if columns is None:
            return self._error(
                f"Frame {frame.number} has the bone {name[:40]!r}, which the skeleton lacks"
            )
        try:
            values = list(map(float, words[1:]))
        except ValueError:
            values = []
        if len(values) != len(columns):
            return self._error(
                f"Frame {frame.number} has no {len(columns)} values of the bone {name}, as the "
                "skeleton wants"
            )
        if name in frame.bones:
            return self._error(f"Frame {frame.number} has two bones {name}")
        frame.bones[name] = values
        return None

    def _whole(self, frame: _Frame) -> bool:
        return bool(frame.bones) and (not self._names or frame.bones.keys() == set(self._names))

    def _close(self, frame: _Frame) -> None:
        if not self._whole(frame):
            raise self._error(f"Frame {frame.number} does not have the bones of the first frame")
        if not self._count:
            self._names = list(frame.bones)
            self.first = frame.number
        elif frame.number != self._next and not self.warnings:
            self.warnings.append(
                f"Frame {frame.number} does not follow the frame before it; frames are read as if "
                "none were left out."
            )
        for name in self._names:
            self._numbers.extend(frame.bones[name])
        self._count += 1
        self._next = frame.number + 1

    def _arrange(self, file_bytes: int) -> None:
        """Put the values of the bones where the skeleton expects them."""
        columns = [column for name in self._names for column in self._skeleton.columns[name]]
        check_size(self._count, self._skeleton.channels, file_bytes, self._where)
        still = sum(map(bool, self._skeleton.columns.values())) - len(self._names)
        if still:
            self.warnings.append(f"{still} bones have no values in the motion and do not turn.")
        self.values = np.zeros((self._count, self._skeleton.channels))
        self.values[:, columns] = np.asarray(self._numbers).reshape(self._count, -1)
        if self._radians:
            angles = list(self._skeleton.angles)
            self.values[:, angles] = np.rad2deg(self.values[:, angles])

    def _error(self, what: str) -> MocapmendError:
        return MocapmendError(f"{what}.", self._where, ANOTHER_FILE)
