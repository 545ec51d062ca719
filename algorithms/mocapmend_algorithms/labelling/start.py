"""The labels of single frames, from nothing: a model's poses are laid over the points."""

from typing import NamedTuple

import numpy as np

from mocapmend_algorithms.arrays import FloatArray, IntArray
from mocapmend_algorithms.labelling.costs import (
    NOWHERE,
    Expectation,
    Tolerance,
    costs,
    label_places,
)
from mocapmend_algorithms.labelling.model import LabelModel

HEADINGS = 16
ROUNDS = 3
LIKELY = 64
BEST = 6
REFINED = 10
LEAST_POINTS = 4
CERTAIN = 1e3
CLIP_MM = 300.0
LEAST_SIZE = 1e-9
"""Squared, in mm: markers that are all in one place have no size."""
FIRST_TOLERANCE = Tolerance(share=0.08, mm=12.0, loose=1.5)
SIZES = (0.6, 1.7)


class Start(NamedTuple):
    """A labelled frame.

    Attributes
    ----------
    labels : ndarray of int, shape (points,)
        -1 for none.
    cost : float
        Mean over the model's labels; smaller is better.
    scale : float
        Size beside the model's.
    """

    labels: IntArray
    cost: float
    scale: float


def label_frame(model: LabelModel, points: FloatArray, given: IntArray) -> Start | None:
    """Label the points of one frame.

    Each pose of the model is turned to several headings; those that come near are fitted by turns:
    the points nearest to their markers (Hungarian method: Kuhn 1955), and the heading, place and
    size that bring them nearest to these. The best fits are refined by distances.

    Parameters
    ----------
    model : LabelModel
        What to look for.
    points : ndarray, shape (points, 3)
        All seen; in mm, z up.
    given : ndarray of int, shape (points,)
        Labels that are known; -1 for the others.

    Returns
    -------
    Start or None
        The best; None where there are too few points to tell.
    """
    if len(points) < LEAST_POINTS:
        return None
    fits = sorted((_fit(form, points) for form in _likely(model.poses, points)), key=_badness)
    best: Start | None = None
    tried: set[bytes] = set()
    for _, labels, scale in fits:
        if labels.tobytes() not in tried:
            tried.add(labels.tobytes())
            start = _refine(model, points, _with_given(labels, given), given, scale)
            if best is None or start.cost < best.cost:
                best = start
        if len(tried) >= BEST:
            break
    return best


def _badness(fit: tuple[float, IntArray, float]) -> float:
    return fit[0]


def _with_given(labels: IntArray, given: IntArray) -> IntArray:
    """Return labels in which the given ones are where they belong, and nowhere else."""
    free = np.where(np.isin(labels, given[given >= 0]), -1, labels)
    return np.where(given >= 0, given, free)


def _likely(poses: FloatArray, points: FloatArray) -> list[tuple[IntArray, FloatArray]]:
    """Return the poses and headings that come nearest to the points, as labels and places."""
    middle = np.median(points, axis=0)
    reach = np.median(np.linalg.norm(points - middle, axis=1))
    tried = []
    for pose in poses:
        known = np.flatnonzero(~np.isnan(pose[:, 0]))
        form = pose[known] - np.median(pose[known], axis=0)
        form *= reach / max(float(np.median(np.linalg.norm(form, axis=1))), 1e-9)
        for heading in np.arange(HEADINGS) * 2 * np.pi / HEADINGS:
            placed = _turned(form, heading) + middle
            away = np.linalg.norm(placed[:, None] - points, axis=2)
            nearest = np.minimum(away, CLIP_MM).min(axis=1).mean()
            nearest += np.minimum(away, CLIP_MM).min(axis=0).mean()
            tried.append((float(nearest), known, placed))
    tried.sort(key=lambda each: each[0])
    return [(known, placed) for _, known, placed in tried[:LIKELY]]


def _fit(start: tuple[IntArray, FloatArray], points: FloatArray) -> tuple[float, IntArray, float]:
    """Fit labels that are placed near points, by turns; return the cost and the points' labels."""
    from scipy.optimize import linear_sum_assignment

    known, form = start
    placed, scale = form, 1.0
    for _ in range(ROUNDS):
        away = np.linalg.norm(placed[:, None] - points, axis=2)
        square = np.minimum(away, CLIP_MM) ** 2
        rows, columns = linear_sum_assignment(square)
        near = away[rows, columns] < CLIP_MM
        if near.sum() < 4:
            break
        placed, scale = _laid(form, rows[near], points[columns[near]])
    away = np.linalg.norm(placed[:, None] - points, axis=2)
    square = np.minimum(away, CLIP_MM) ** 2
    rows, columns = linear_sum_assignment(square)
    labels = np.full(len(points), -1, np.int64)
    near = away[rows, columns] < CLIP_MM
    labels[columns[near]] = known[rows[near]]
    return float(square[rows, columns].mean()), labels, scale


def _laid(form: FloatArray, rows: IntArray, goal: FloatArray) -> tuple[FloatArray, float]:
    """Turn, shift and scale a form so that some of its markers come near to their goals."""
    own, other = form[rows].mean(axis=0), goal.mean(axis=0)
    a, b = form[rows] - own, goal - other
    heading = np.arctan2((a[:, 0] * b[:, 1] - a[:, 1] * b[:, 0]).sum(), (a[:, :2] * b[:, :2]).sum())
    turned = _turned(a, heading)
    scale = float(np.clip((turned * b).sum() / max((a**2).sum(), LEAST_SIZE), *SIZES))
    return scale * _turned(form - own, heading) + other, scale


def _turned(form: FloatArray, heading: float) -> FloatArray:
    cosine, sine = np.cos(heading), np.sin(heading)
    turn = np.array([[cosine, -sine, 0.0], [sine, cosine, 0.0], [0.0, 0.0, 1.0]])
    turned: FloatArray = form @ turn.T
    return turned


def _refine(
    model: LabelModel, points: FloatArray, labels: IntArray, given: IntArray, scale: float
) -> Start:
    cost = np.inf
    for _ in range(REFINED):
        scale = size_of(model, points[None], labels[None], scale)
        expected = Expectation.of(model, scale, FIRST_TOLERANCE)
        table = costs(expected, points[None], labels[None])[0]
        new, cost = assign(table, given)
        if np.array_equal(new, labels):
            break
        labels = new
    return Start(labels, cost, scale)


def assign(table: FloatArray, given: IntArray) -> tuple[IntArray, float]:
    """Give points labels so that the sum of the costs is least.

    Parameters
    ----------
    table : ndarray, shape (points, labels)
        A label costs `NOWHERE` where no point gets it.
    given : ndarray of int, shape (points,)
        Labels that are known; -1 for the others.

    Returns
    -------
    labels : ndarray of int, shape (points,)
        -1 for none.
    cost : float
        Mean over the labels.
    """
    from scipy.optimize import linear_sum_assignment

    bounded = np.minimum(table, NOWHERE)
    known = np.flatnonzero(given >= 0)
    bounded[known] = NOWHERE
    bounded[known, given[known]] = -CERTAIN
    rows, columns = linear_sum_assignment(bounded)
    good = bounded[rows, columns] < NOWHERE
    chosen = np.minimum(table, NOWHERE)[rows, columns]
    labels = np.full(len(table), -1, np.int64)
    labels[rows[good]] = columns[good]
    total = chosen[good].sum() + NOWHERE * (table.shape[1] - good.sum())
    return labels, float(total / table.shape[1])


def size_of(model: LabelModel, points: FloatArray, labels: IntArray, otherwise: float) -> float:
    """Return the size beside the model's, by the distances that hardly change in it."""
    places = label_places(points, labels, len(model.labels))
    steady = np.argwhere(np.triu(model.spread < 0.06 * model.length, 1))
    apart = np.linalg.norm(places[:, steady[:, 0]] - places[:, steady[:, 1]], axis=2)
    ratios = apart / model.length[steady[:, 0], steady[:, 1]]
    ratios = ratios[~np.isnan(ratios)]
    return float(np.clip(np.median(ratios), *SIZES)) if ratios.size >= 3 else otherwise
