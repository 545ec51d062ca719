"""The rows of one part of the body, and what its dictionary makes of them (see `part_codes`)."""

from dataclasses import dataclass

import numpy as np

from mocapmend_algorithms.arrays import BoolArray, FloatArray, IntArray, add_ridge
from mocapmend_algorithms.progress import Progress
from mocapmend_algorithms.sparse.body import Body
from mocapmend_algorithms.sparse.bone_codes import Problem, encode_bones
from mocapmend_algorithms.sparse.bone_space import signed_roots, signed_squares
from mocapmend_algorithms.sparse.windows import Span

SPAN = Span.over(6, 0)
PENALTY, BONE_WEIGHT = 1e-4, 0.4
"""lambda1 and lambda2 (W18, section 4.1)."""
COARSE_RIDGE = 1e-3
RECOVERY_STEPS = 200


@dataclass(frozen=True, eq=False)
class PartRows:
    """The rows of one part's triple.

    Attributes
    ----------
    pairs : ndarray of int, shape (pairs, 2)
        Child and parent of each bone of the triple, then the anchors and the root.
    standard : ndarray, shape (pairs,)
        Standard lengths in mm; 0 for anchors, which are no bones.
    own : ndarray of bool, shape (pairs,)
        The bones of the part itself.
    """

    pairs: IntArray
    standard: FloatArray
    own: BoolArray

    @classmethod
    def of(cls, body: Body, at: int, standard: FloatArray) -> "PartRows":
        """Return the rows of a part; `standard` has a length per edge of the tree."""
        edges = body.edges
        triple = np.concatenate([body.parts[other] for other in body.triples[at]])
        inside = np.isin(edges[:, 0], triple)
        root = int(np.flatnonzero(body.parents < 0)[0])
        above = np.setdiff1d(
            edges[np.isin(edges[:, 0], body.parts[at]), 1], [*body.parts[at], root]
        )
        anchors = np.array([(marker, root) for marker in above], dtype=np.int64).reshape(-1, 2)
        own = np.isin(edges[inside, 0], body.parts[at])
        return cls(
            np.concatenate([edges[inside], anchors]),
            np.concatenate([standard[inside], np.zeros(len(anchors))]),
            np.concatenate([own, np.zeros(len(anchors), dtype=np.bool_)]),
        )

    def differences(self, points: FloatArray, places: IntArray) -> FloatArray:
        """Return F1 of windows, shape (frames of a window * pairs * 3, places)."""
        away = points[:, self.pairs[:, 0]] - points[:, self.pairs[:, 1]]
        return away[SPAN.frames(places)].reshape(places.size, -1).T

    def seen(self, seen: BoolArray, places: IntArray) -> BoolArray:
        """Say which pairs of windows are seen, shape (frames of a window * pairs, places)."""
        both = seen[:, self.pairs[:, 0]] & seen[:, self.pairs[:, 1]]
        shown: BoolArray = both[SPAN.frames(places)].reshape(places.size, -1).T
        return shown

    def problem(
        self, away: FloatArray, seen: BoolArray, signs: FloatArray, scale: float, dtype: type
    ) -> Problem:
        """Set the windows' problem up; `signs` are those of F1, scaled rows are F2 / `scale`."""
        bone = np.tile(self.standard > 0, len(SPAN.offsets))
        squares = np.tile(self.standard**2, len(SPAN.offsets)) / scale
        rows = np.repeat(seen, 3, axis=0)
        return Problem(
            np.where(rows, signed_squares(np.where(rows, away, 0.0)) / scale, 0.0).astype(dtype),
            rows,
            (signs * np.repeat(bone, 3)[:, None]).astype(dtype),
            np.broadcast_to(squares[:, None].astype(dtype), seen.shape),
            ~seen & bone[:, None],
            PENALTY,
            BONE_WEIGHT,
        )


@dataclass(frozen=True, eq=False)
class PartDictionary:
    """What one part has learned.

    Attributes
    ----------
    rows : PartRows
        Its rows.
    atoms : ndarray, shape (rows, atoms)
        The dictionary, for scaled rows.
    scale : float
        Mean square of the rows of F2, in mm^2.
    mean : ndarray, shape (rows,)
        Mean of F1 in mm.
    components : ndarray, shape (rows, components)
        Principal components of F1, each as long as its standard deviation.
    """

    rows: PartRows
    atoms: FloatArray
    scale: float
    mean: FloatArray
    components: FloatArray

    def recover(self, away: FloatArray, seen: BoolArray, progress: Progress) -> FloatArray:
        """Recover the rows of windows.

        Parameters
        ----------
        away : ndarray, shape (rows, windows)
            F1, with standard lengths; what is not seen may hold anything.
        seen : ndarray of bool, shape (pairs of all frames, windows)
            What is seen.
        progress : Progress
            Called often.

        Returns
        -------
        ndarray, shape (rows, windows)
            F1; where F2 contradicts the sign that was assumed it is 0.
        """
        rows = np.repeat(seen, 3, axis=0)
        signs = np.sign(np.where(rows, away, self._coarse(away, rows)))
        problem = self.rows.problem(away, seen, signs, self.scale, np.float64)
        start = np.zeros((self.atoms.shape[1], away.shape[1]))
        weights = encode_bones(
            self.atoms, problem, start, iterations=RECOVERY_STEPS, progress=progress
        )
        found = (self.atoms @ weights) * self.scale
        return signed_roots(np.where(signs * found > 0, found, 0.0))

    def _coarse(self, away: FloatArray, rows: BoolArray) -> FloatArray:
        """Complete F1 by principal components, column by column of the same mask."""
        found = np.empty_like(away)
        kinds, which = np.unique(rows, axis=1, return_inverse=True)
        for kind in range(kinds.shape[1]):
            columns, here = which.ravel() == kind, kinds[:, kind]
            basis = self.components[here]
            gram = basis.T @ basis
            add_ridge(gram, COARSE_RIDGE)
            told = basis.T @ (away[np.ix_(here, columns)] - self.mean[here, None])
            found[:, columns] = self.components @ np.linalg.solve(gram, told) + self.mean[:, None]
        return found
