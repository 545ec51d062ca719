"""What is lost, told from what is known by sparse codes over examples.

In W18, and in the patent X13 before it, the code of the known rows over the atoms' known rows,
times the atoms' lost rows, is the answer. Measured on real motion (`bench paper`) that is worse
than a ridge regression: all known rows weigh alike, also those that say nothing of the lost ones,
and the penalty pulls the answer to the mean. Two changes mend it, and are the default here:

- the known rows are joined by what a ridge regression makes of them, so that examples are alike
  where they are alike in what matters;
- the lost rows of the atoms are those that reconstruct further examples best from their codes
  (least squares; W18's eq. 15 given the codes), and not the atoms' own.
"""

from dataclasses import dataclass

import numpy as np

from mocapmend_algorithms.arrays import FloatArray, IntArray, add_ridge, evenly
from mocapmend_algorithms.progress import Progress
from mocapmend_algorithms.sparse.newton import Coder

RIDGE = 1e-2
REFIT = 1e-2
"""Weights of the two regressions, relative to the mean of what they are added to."""
TOLERANCE = 1e-2


@dataclass(frozen=True)
class CodeSettings:
    """How examples are coded.

    Attributes
    ----------
    atoms : int
        Most examples that are atoms.
    examples : int
        Most further examples, by which the lost rows are fitted; 0 keeps the atoms' own.
    penalty : float
        Of the codes; atoms have unit length and rows a mean square sum of 1.
    guided : bool
        Whether the known rows are joined by a regression's prediction.
    """

    atoms: int = 300
    examples: int = 600
    penalty: float = 0.1
    guided: bool = True


class CodeModel:
    """Predicts lost rows from known rows.

    Parameters
    ----------
    known : ndarray, shape (examples, known rows)
        Examples.
    lost : ndarray, shape (examples, lost rows)
        The same examples.
    settings : CodeSettings
        How.
    progress : Progress
        Called often.

    Attributes
    ----------
    left_over : ndarray, shape (further examples, lost rows)
        What is missed of the examples by which the lost rows were fitted.
    """

    def __init__(
        self, known: FloatArray, lost: FloatArray, settings: CodeSettings, progress: Progress
    ) -> None:
        self._settings = settings
        atoms, others = _deal(len(known), settings)
        used = np.union1d(atoms, others)
        self._features = _Features(known[used], lost[used], guided=settings.guided)
        self._mean = lost[used].mean(axis=0)
        coordinates = self._features(known[atoms])
        size = np.sqrt(np.einsum("er,er->e", coordinates, coordinates))
        size[size == 0] = 1.0
        self._coder = Coder.of((coordinates / size[:, None]).T)
        self._lost = ((lost[atoms] - self._mean) / size[:, None]).T
        self.left_over = np.zeros((0, lost.shape[1]))
        if others.size:
            codes = self._encode(known[others], progress)
            wanted = (lost[others] - self._mean).T
            gram = codes @ codes.T
            add_ridge(gram, REFIT)
            missed = (wanted - self._lost @ codes) @ codes.T
            self._lost = self._lost + np.linalg.solve(gram, missed.T).T
            self.left_over = (wanted - self._lost @ codes).T

    def __call__(self, known: FloatArray, progress: Progress) -> FloatArray:
        """Predict the lost rows, shape (columns, lost rows)."""
        codes = self._encode(known, progress)
        lost: FloatArray = (self._lost @ codes).T + self._mean
        return lost

    def _encode(self, known: FloatArray, progress: Progress) -> FloatArray:
        targets = np.ascontiguousarray(self._features(known).T)
        return self._coder.encode(
            targets, self._settings.penalty, tolerance=TOLERANCE, progress=progress
        ).weights


class _Features:
    """Known rows, centred and scaled, and what a regression makes of them."""

    def __init__(self, known: FloatArray, lost: FloatArray, *, guided: bool) -> None:
        self._mean = known.mean(axis=0)
        centred = known - self._mean
        self._scale = _scale(centred)
        self._map = np.zeros((known.shape[1], 0))
        if guided:
            gram = centred.T @ centred
            add_ridge(gram, RIDGE)
            weights = np.linalg.solve(gram, centred.T @ (lost - lost.mean(axis=0)))
            self._map = weights * _scale(centred @ weights) / np.sqrt(2)
            self._scale /= np.sqrt(2)

    def __call__(self, known: FloatArray) -> FloatArray:
        centred = known - self._mean
        return np.concatenate([centred * self._scale, centred @ self._map], axis=1)


def _scale(rows: FloatArray) -> float:
    """Return by what rows are multiplied to have a mean square sum of 1."""
    size = float(np.sqrt(np.mean(np.einsum("er,er->e", rows, rows))))
    return 1.0 / size if size > 0 else 1.0


def _deal(count: int, settings: CodeSettings) -> tuple[IntArray, IntArray]:
    """Choose the examples that are atoms, and those by which the lost rows are fitted."""
    everyone = np.arange(count)
    if not settings.examples:
        return evenly(everyone, settings.atoms), everyone[:0]
    return evenly(everyone[::2], settings.atoms), evenly(everyone[1::2], settings.examples)
