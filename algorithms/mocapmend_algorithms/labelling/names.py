"""Which labels say what a point is, and which are only there because a point needs one."""

import re
from collections import Counter
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


def named_points(labels: Sequence[str]) -> dict[str, int]:
    """Return the points whose labels mean something, and are no other point's as well.

    Parameters
    ----------
    labels : sequence of str
        Of the points of a recording.

    Returns
    -------
    dict of str to int
        Point by label; without the subject, unless several subjects have the same.
    """
    short = [without_subject(label) for label in labels]
    count = Counter(short)
    return {
        short[point]: point
        for point, label in enumerate(labels)
        if is_meaningful(label) and count[short[point]] == 1
    }
