"""Which columns of a table hold the coordinates of which marker."""

import re
from collections.abc import Sequence
from dataclasses import dataclass

from mocapmend.files.formats.text import Lines

MOST_MARKERS = 20_000
LONGEST_LABEL = 500

FRAME_NAMES = frozenset({"frame", "frame#", "#frame", "frames", "framenumber", "field", "index"})
TIME_NAMES = re.compile(r"(time|t|seconds|timestamp)[^a-z]*(s|sec|seconds|ms)?\W*", re.ASCII)
UNIT_AT_END = re.compile(r"\s*[(\[](mm|cm|dm|m|in|ft)[)\]]$")
AXIS_AT_END = re.compile(r"(.*?)[ _.:\-]?([xyz])", re.IGNORECASE | re.DOTALL | re.ASCII)
UNSHOWN = re.compile("[\x00-\x1f\x7f-\x9f\u2028\u2029\ud800-\udfff]")
NUMBERED_AXIS = re.compile(r"([xyz])[ _]?\d+", re.IGNORECASE | re.ASCII)


@dataclass(frozen=True)
class Columns:
    """Where a table of one line per frame holds what.

    Attributes
    ----------
    labels : tuple of str
        One per marker, possibly empty.
    first : tuple of int
        The column of each marker's x; y and z follow.
    frame, time : int or None
        Columns of the frame's number and time.
    time_scale : float
        Seconds per unit of the time.
    unit : str
        Length unit that the names of the columns state, or empty.
    """

    labels: tuple[str, ...]
    first: tuple[int, ...]
    frame: int | None = None
    time: int | None = None
    time_scale: float = 1.0
    unit: str = ""


def clean_label(text: str) -> str:
    """Return a label without what cannot be shown or written: control and broken characters."""
    return UNSHOWN.sub(" ", text).strip()[:LONGEST_LABEL].rstrip()


def check_count(lines: Lines, markers: int) -> None:
    """Refuse more markers than any recording has.

    Raises
    ------
    MocapmendError
        If there are more than `MOST_MARKERS`.
    """
    if markers > MOST_MARKERS:
        raise lines.error(f"The file names {markers} markers; at most {MOST_MARKERS} can be read.")


def named_columns(names: Sequence[str]) -> Columns | None:
    """Find the markers in a header as "frame, time, LASI_x, LASI_y, LASI_z"; None without any."""
    labels, first, unit = [], [], ""
    at = 0
    while at + 2 < len(names):
        stems = [_stem(name, axis) for name, axis in zip(names[at : at + 3], "xyz", strict=True)]
        if stems[0] is None or stems[0] != stems[1] or stems[1] != stems[2]:
            at += 1
            continue
        labels.append(clean_label(stems[0]))
        first.append(at)
        found = UNIT_AT_END.search(names[at])
        unit = found[1] if found else unit
        at += 3
    return _with_frame_and_time(names, labels, first, unit) if first else None


def axis_columns(axes: Sequence[str], labels: Sequence[str]) -> Columns | None:
    """Find the markers under a row of labels: a row of X, Y, Z; None without any.

    Parameters
    ----------
    axes : sequence of str
        Cells of the row of axes, which names frame and time too.
    labels : sequence of str
        Cells of the row above, the label above X, or to the left of it.
    """
    lower = [axis.lower() for axis in axes]
    first = [i for i in range(len(axes) - 2) if lower[i : i + 3] == ["x", "y", "z"]]
    if not first:
        return None
    names = [clean_label(labels[i]) if i < len(labels) else "" for i in first]
    return _with_frame_and_time(axes, names, first, "")


def time_scale(name: str) -> float:
    """Return the seconds per unit of a column of times by its name, as "time (ms)"."""
    return 1e-3 if name.rstrip(" )]").endswith("ms") else 1.0


def _with_frame_and_time(
    names: Sequence[str], labels: list[str], first: list[int], unit: str
) -> Columns:
    taken = {i + axis for i in first for axis in range(3)}
    free = [(i, name.lower().strip()) for i, name in enumerate(names) if i not in taken]
    frame = next((i for i, name in free if name.replace(" ", "") in FRAME_NAMES), None)
    times = [(i, name) for i, name in free if TIME_NAMES.fullmatch(name)]
    return Columns(
        labels=tuple(labels),
        first=tuple(first),
        frame=frame,
        time=times[0][0] if times else None,
        time_scale=time_scale(times[0][1]) if times else 1.0,
        unit=unit,
    )


def _stem(name: str, axis: str) -> str | None:
    """Return a column's name without its axis at the end, None if it is not that axis."""
    name = UNIT_AT_END.sub("", name)
    if NUMBERED_AXIS.fullmatch(name):
        return "" if name[0].lower() == axis else None
    found = AXIS_AT_END.fullmatch(name)
    return found[1] if found and found[2].lower() == axis else None
