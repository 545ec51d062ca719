"""Which labels say what a point is, and which are only there because a point needs one."""

import re
from collections.abc import Sequence

MEANINGLESS = re.compile(
    r"""
    \*.*                                             # *0, as Vicon and others write them
    | (?:u|c_|point|marker|unlabell?ed|unnamed|unknown|trajectory|traj|new)[\s_.-]*\d*
    | \d+
    | \s*
    """,
    re.IGNORECASE | re.VERBOSE,
)


def without_subject(label: str) -> str:
    """Return "LASI" of "Matt:LASI"."""
    return label.rpartition(":")[2].strip()


def is_meaningful(label: str) -> bool:
    """Say whether a label names a place on the body: not "", "*12", "U7" or "point 3"."""
    return not MEANINGLESS.fullmatch(without_subject(label))


def points_by_name(labels: Sequence[str]) -> dict[str, list[int]]:
    """Return the points of each label that means something, without the subject."""
    found: dict[str, list[int]] = {}
    for point, label in enumerate(labels):
        if is_meaningful(label):
            found.setdefault(without_subject(label), []).append(point)
    return found


def named_points(labels: Sequence[str]) -> dict[str, int]:
    """Return the points whose labels mean something, and are no other point's as well.

    Parameters
    ----------
    labels : sequence of str
        Of the points of a recording.

    Returns
    -------
    dict of str to int
        Point by label, without the subject.
    """
    named = points_by_name(labels)
    return {name: points[0] for name, points in named.items() if len(points) == 1}
