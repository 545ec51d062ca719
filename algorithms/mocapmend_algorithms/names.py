"""Which labels say what a point is, and which are only there because a point needs one.

There are two answers. A recording is known: a label like "3" may well be its laboratory's own name
of a marker, and nothing but what programs write of themselves counts as no label. Another one is to
be labelled by it: what would not be found in any other recording teaches nothing.
"""

import re
from collections.abc import Sequence

UNLABELLED = re.compile(
    r"(\*.*|\s*|(unlabell?ed|unidentified|uname|u_|new)[\W_]*\d*)", re.IGNORECASE
)
"""As Vicon, Qualisys, OptiTrack and Motion Analysis name points that nobody has named."""
MEANINGLESS = re.compile(
    r"""
    \*.*                                             # *0, as Vicon and others write them
    | (?:u|c_|point|marker|unlabell?ed|unnamed|unknown|trajectory|traj|new)[\s_.-]*\d*
    | \d+
    | \s*
    """,
    re.IGNORECASE | re.VERBOSE,
)


def is_unlabelled(label: str) -> bool:
    """Whether a label is what a program calls a point that nobody has named."""
    return UNLABELLED.fullmatch(label.rpartition(":")[2]) is not None


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
