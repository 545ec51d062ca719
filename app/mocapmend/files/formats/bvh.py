"""BVH (Biovision): a skeleton and the angles of its joints."""

import re
from array import array
from collections.abc import Iterator
from dataclasses import dataclass
from itertools import chain
from pathlib import Path

import numpy as np
from numpy.typing import NDArray

from mocapmend.errors import MocapmendError
from mocapmend.files.formats.assumed import body_unit, rate_of, up_axis
from mocapmend.files.formats.bvh_hierarchy import read_hierarchy
from mocapmend.files.formats.joint_files import (
    LONGEST_SKELETON,
    about_samples,
    lines_of,
    read_bytes,
    text_of,
)
from mocapmend.files.formats.kinematics import bones_of, check_size, positions, rest_values
from mocapmend.files.opening import ANOTHER_FILE, Stamp, too_large
from mocapmend.files.source import Source, truncation
from mocapmend_algorithms.recording import Recording

START = re.compile(rb"(?:\xef\xbb\xbf)?\s*HIERARCHY\b", re.IGNORECASE)
MOTION = re.compile(rb"[\r\n][ \t]*MOTION[ \t]*(?=[\r\n]|\Z)", re.IGNORECASE)
FRAMES = re.compile(rb"\s*Frames\s*:?\s*(\S*)\s*", re.IGNORECASE)
MOST_DIGITS = 18
FRAME_TIME = re.compile(rb"\s*Frame\s*Time\s*:?\s*(\S{1,40})\s*", re.IGNORECASE)


def read_bvh(path: Path) -> Source:
    """Read a BVH file: its joints and End Sites ("Head end") as markers, joined by its bones.

    Length unit and axis that points up are guessed, for the format does not state them.

    Raises
    ------
    MocapmendError
        If it cannot be read; nothing else.
    """
    path = Path(path)
    try:
        return _read(path, *read_bytes(path))
    except MemoryError:
        raise too_large(str(path)) from None


def _read(path: Path, raw: bytes, stamp: Stamp) -> Source:
    where = str(path)
    if not START.match(raw):
        raise MocapmendError("This is not a BVH file.", where, ANOTHER_FILE)
    found = MOTION.search(raw)
    if not found:
        raise MocapmendError("The file ends before its motion.", where, ANOTHER_FILE)
    if found.start() > LONGEST_SKELETON:
        raise MocapmendError("The hierarchy is too long.", where, ANOTHER_FILE)
    joints, channels = read_hierarchy(text_of(raw[: found.start()]), where)

    motion = _read_motion(raw, found.end(), channels, where)
    warnings = list(motion.warnings)
    rate = rate_of(motion.frame_time, warnings)
    rest = rest_values(joints, channels)
    values = motion.values
    if not len(values) and motion.promised == 0:
        warnings.append("The file holds no motion; the rest pose is shown as one frame.")
        values = rest
    elif not len(values):
        raise MocapmendError("The file ends before its first frame.", where, ANOTHER_FILE)
    check_size(len(values), len(joints), stamp.size, where)
    points = positions(joints, values)
    labels = tuple(joint.label for joint in joints)
    about_samples(points, labels, warnings)
    unit, factor = body_unit(points, joints, warnings)
    if factor != 1:
        points *= factor
    up = up_axis(points, positions(joints, rest), warnings)
    return Source(
        path=path,
        kind="BVH",
        recording=Recording(points, labels, rate, unit=unit, up=up),
        bones=bones_of(joints),
        warnings=tuple(warnings),
        frames_promised=motion.promised or 0,
        stamp=stamp,
    )


@dataclass(frozen=True)
class _Motion:
    values: NDArray[np.float64]
    promised: int | None
    frame_time: str
    warnings: tuple[str, ...]


def _read_motion(raw: bytes, start: int, channels: int, where: str) -> _Motion:
    """Read what follows the word MOTION; the values have shape (frames, channels)."""
    promised = None
    frame_time = ""
    lines = lines_of(raw, start)
    for line in lines:
        if found := FRAMES.fullmatch(line):
            promised = int(found[1][:MOST_DIGITS]) if found[1].isdigit() else None
        elif found := FRAME_TIME.fullmatch(line):
            frame_time = found[1].decode("latin-1")
        else:
            lines = chain([line], lines)
            break
    values, warnings = _read_rows(lines, channels, where) if channels else (np.empty((0, 0)), [])
    if promised is None:
        warnings.append("The file does not say how many frames it holds.")
    elif channels:
        if len(values) < promised and not warnings and not raw.endswith((b"\n", b"\r")):
            # The file was cut: of its last number, only the first digits may be left.
            values = values[:-1]
        warnings += _about_frames(len(values), promised)
    return _Motion(values, promised if channels else 0, frame_time, tuple(warnings))


def _about_frames(frames: int, promised: int) -> Iterator[str]:
    if frames < promised:
        yield truncation(promised, frames)
    elif frames > promised:
        yield (
            f"The file says that it holds {promised} frames, but {frames} are there; all are read."
        )


def _read_rows(
    lines: Iterator[bytes], channels: int, where: str
) -> tuple[NDArray[np.float64], list[str]]:
    """Read one frame per line; a bad last line is left out, for files are cut anywhere."""
    numbers = array("d")
    for line in lines:
        # Not more words than needed: a line may be as long as the file.
        words = line.split(None, channels)
        try:
            row = array("d", map(float, words))
        except ValueError:
            row = array("d")
        if len(row) == channels:
            numbers.extend(row)
        elif next(lines, None) is None:
            warnings = ["The last line is no complete frame and is left out."]
            break
        else:
            raise MocapmendError(
                f"Frame {len(numbers) // channels + 1} does not consist of {channels} numbers.",
                where,
                ANOTHER_FILE,
            )
    else:
        warnings = []
    return np.asarray(numbers).reshape(-1, channels), warnings
