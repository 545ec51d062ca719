"""What of a pose is known and what is to be found, as differences along bones (W18, eqs. 3-7).

W18 describes a pose by the differences of neighbouring joints. Where a joint is missing, all
differences to it are; what is left of the others says nothing of where the markers beyond it are.
So the known rows are *bridged* here: each marker that is seen is taken relative to the nearest one
that is seen on the way to the root. That is W18's F1 where none is missing between them.

SMBS takes all markers relative to the root instead.
"""

from dataclasses import dataclass

import numpy as np

from mocapmend_algorithms.arrays import FloatArray, IntArray
from mocapmend_algorithms.sparse.body import Body


@dataclass(frozen=True, eq=False)
class Rows:
    """The pairs of markers whose differences are known, and those to be found.

    Attributes
    ----------
    helpers, targets : ndarray of int
        Markers that are seen, and those to be found.
    known : ndarray of int, shape (known, 2)
        Pairs (marker, the one that it is taken relative to), both helpers.
    lost : ndarray of int, shape (lost, 2)
        Pairs of which one at least is a target.
    """

    helpers: IntArray
    targets: IntArray
    known: IntArray
    lost: IntArray

    @classmethod
    def along_bones(cls, body: Body, helpers: IntArray, targets: IntArray) -> "Rows":
        """Join helpers along bones, also across markers that are missing, and targets to them.

        Parameters
        ----------
        body : Body
            The tree.
        helpers, targets : ndarray of int
            Markers that are seen, at least one, and those to be found.
        """
        both = {*helpers.tolist(), *targets.tolist()}
        seen = set(helpers.tolist())
        known = _joined(body.parents, helpers, seen)
        pairs = _joined(body.parents, np.array(sorted(both)), both, join_roots=False)
        lost = [(a, b) for a, b in pairs if a not in seen or b not in seen]
        lost += [(marker, int(helpers[0])) for marker in _adrift(lost, targets, seen)]
        return cls(helpers, targets, _pairs(known), _pairs(lost))

    @classmethod
    def around_root(cls, body: Body, helpers: IntArray, targets: IntArray) -> "Rows":
        """Take all markers relative to the root, or the helper that is nearest to it."""
        depth = body.depths
        centre = int(helpers[np.argmin(depth[helpers])])
        known = [(marker, centre) for marker in helpers.tolist() if marker != centre]
        lost = [(marker, centre) for marker in targets.tolist()]
        return cls(helpers, targets, _pairs(known), _pairs(lost))

    def places(self, lost: FloatArray, points: FloatArray) -> FloatArray:
        """Put the targets where the found differences to the helpers are met best.

        Parameters
        ----------
        lost : ndarray, shape (frames, lost, 3)
            The differences.
        points : ndarray, shape (frames, markers, 3)
            Where the helpers are; the targets are not looked at.

        Returns
        -------
        ndarray, shape (frames, targets, 3)
            Least squares where a target hangs between several helpers.
        """
        signs = self.signs
        known = np.array(lost)
        for sign, side in ((1.0, 0), (-1.0, 1)):
            there = np.isin(self.lost[:, side], self.helpers)
            known[:, there] -= sign * points[:, self.lost[there, side]]
        places: FloatArray = np.linalg.pinv(signs) @ known
        return places

    @property
    def signs(self) -> FloatArray:
        """How the targets enter the lost differences: 1, -1 or 0, shape (lost, targets)."""
        ends = self.lost[:, :, None] == self.targets
        signs: FloatArray = ends[:, 0].astype(np.float64) - ends[:, 1]
        return signs


def differences(points: FloatArray, pairs: IntArray) -> FloatArray:
    """Take differences of markers.

    Parameters
    ----------
    points : ndarray, shape (..., markers, 3)
        Places.
    pairs : ndarray of int, shape (pairs, 2)
        Of markers.

    Returns
    -------
    ndarray, shape (..., pairs, 3)
    """
    away: FloatArray = points[..., pairs[:, 0], :] - points[..., pairs[:, 1], :]
    return away


def _joined(
    parents: IntArray, markers: IntArray, among: set[int], *, join_roots: bool = True
) -> list[tuple[int, int]]:
    """Take each marker relative to its nearest ancestor among some; those without, to the first."""
    pairs, roots = [], []
    for marker in markers.tolist():
        above = int(parents[marker])
        while above >= 0 and above not in among:
            above = int(parents[above])
        if above >= 0:
            pairs.append((marker, above))
        else:
            roots.append(marker)
    return pairs + [(root, roots[0]) for root in roots[1:] if join_roots]


def _adrift(lost: list[tuple[int, int]], targets: IntArray, seen: set[int]) -> list[int]:
    """Return one target of each group that no difference joins to a helper."""
    adrift, left = [], set(targets.tolist())
    while left:
        first = min(left)
        group, todo = {first}, [first]
        while todo:
            marker = todo.pop()
            beside = {a + b - marker for a, b in lost if marker in (a, b)}
            todo += sorted(beside - group - seen)
            group |= beside
        if not group & seen:
            adrift.append(first)
        left -= group
    return adrift


def _pairs(pairs: list[tuple[int, int]]) -> IntArray:
    return np.array(pairs, dtype=np.int64).reshape(-1, 2)
