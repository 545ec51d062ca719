"""Which markers predict which missing ones: the strategies of GF16 (see `pca`).

R1 takes all markers that have a gap anywhere as missing, and those without any predict them. R2
treats each marker with gaps by itself: other markers with gaps help only if they are nearer than
half the mean distance and present throughout the gap.

Deviations: R2's overlap is judged gap by gap and not for all gaps of a marker together, and where
fewer than 3 markers can help by its rule, all that are present throughout the gap do. Where too few
frames are complete, the markers that are missing most are left out (R1 fills them in further
rounds).
"""

from collections.abc import Sequence
from dataclasses import dataclass

import numpy as np

from mocapmend_algorithms.arrays import BoolArray, FloatArray, IntArray
from mocapmend_algorithms.fill.company import mean_distances, seen_together
from mocapmend_algorithms.fill.edges import with_edges
from mocapmend_algorithms.gaps import Gap
from mocapmend_algorithms.recording import Recording

LEAST_HELPERS = 3


@dataclass(frozen=True, eq=False)
class Group:
    """Gaps that one decomposition fills.

    Attributes
    ----------
    helpers, missing : ndarray of int
        Markers that predict and markers to be predicted, ascending.
    distances : ndarray, shape (helpers,)
        From the (nearest) missing marker, in the recording's unit.
    complete : ndarray of int
        Frames that show them all.
    gaps : list of Gap
        Of the missing markers.
    """

    helpers: IntArray
    missing: IntArray
    distances: FloatArray
    complete: IntArray
    gaps: list[Gap]


def r1(recording: Recording, observed: BoolArray, gaps: Sequence[Gap]) -> list[Group]:
    """Let the markers without any gap predict all others (GF16, strategy R1).

    Parameters
    ----------
    recording : Recording
        Not changed.
    observed : ndarray of bool, shape (frames, markers)
        The samples that may be used.
    gaps : sequence of Gap
        The gaps to fill; their markers are seen at least once.

    Returns
    -------
    list of Group
        More than one where some markers are missing much more often than others.
    """
    helpers = np.flatnonzero(observed.all(axis=0))
    rest = np.setdiff1d(np.flatnonzero(observed.any(axis=0)), helpers)
    groups = []
    while gaps and rest.size:
        most_seen = rest[np.argmax(np.count_nonzero(observed[:, rest], axis=0))]
        missing, complete = seen_together(observed, rest, int(most_seen))
        rest = np.setdiff1d(rest, missing)
        away = [mean_distances(recording, observed, marker) for marker in missing.tolist()]
        among = [gap for gap in gaps if gap.marker in missing]
        groups.append(Group(helpers, missing, np.min(away, axis=0)[helpers], complete, among))
    return groups


def r2(
    recording: Recording, observed: BoolArray, gaps: Sequence[Gap], *, near: float
) -> list[Group]:
    """Let the markers that are present in a gap predict its marker (GF16, strategy R2).

    Parameters
    ----------
    recording : Recording
        Not changed.
    observed : ndarray of bool, shape (frames, markers)
        The samples that may be used.
    gaps : sequence of Gap
        The gaps to fill; their markers are seen at least once.
    near : float
        Markers with gaps of their own help if they are nearer than this share of the mean
        distance of all markers.

    Returns
    -------
    list of Group
        One for all gaps of a marker that the same markers help to fill.
    """
    seen, whole = observed.any(axis=0), observed.all(axis=0)
    distances: dict[int, FloatArray] = {}
    groups: dict[tuple[int, bytes], Group] = {}
    for gap in gaps:
        marker = gap.marker
        if marker not in distances:
            distances[marker] = mean_distances(recording, observed, marker)
        away = distances[marker]
        close = away <= near * np.mean(away[seen])
        start, stop = with_edges(observed, gap)
        there: BoolArray = np.asarray(seen & observed[start:stop].all(axis=0))
        helps: BoolArray = np.asarray(there & (whole | close))
        if np.count_nonzero(helps) < LEAST_HELPERS:
            helps = there
        key = marker, helps.tobytes()
        if key not in groups:
            candidates = np.append(np.flatnonzero(helps), marker)
            together, complete = seen_together(observed, candidates, marker)
            helpers = np.setdiff1d(together, [marker])
            groups[key] = Group(helpers, np.array([marker]), away[helpers], complete, [])
        groups[key].gaps.append(gap)
    return list(groups.values())
