"""W18's preprocessing of joints, step by step, and its exact inverse (its section 1.1).

W18 = Wang, Lu, Han 2018, Computer Systems & Applications 27(5):17-25. Its eq. 1 as printed drops
the place of the parent, which is needed; its eq. 3 keeps world coordinates, whose root is not
sparse: the root's translation stays outside.
"""

from dataclasses import dataclass

import numpy as np

from mocapmend_algorithms.arrays import FloatArray
from mocapmend_algorithms.sparse.body import Body


@dataclass(frozen=True, eq=False)
class Preprocessed:
    """A motion as W18 codes it, and what is needed to undo that.

    Attributes
    ----------
    squares : ndarray, shape (frames, edges, 3)
        F2: per bone of the tree, in the order of `Body.edges`, the signed squares of the
        differences of its ends; their absolute values add up to the standard length squared.
    shifts : ndarray, shape (frames, markers, 3)
        By how much each marker was moved to give all bones the standard lengths.
    roots : ndarray, shape (frames, markers, 3)
        The places of the markers that hang from none; 0 for the others.
    """

    squares: FloatArray
    shifts: FloatArray
    roots: FloatArray


def preprocess(points: FloatArray, body: Body, standard: FloatArray) -> Preprocessed:
    """Give bones standard lengths, take differences, and their signed squares (W18, eqs. 1-5).

    Parameters
    ----------
    points : ndarray, shape (frames, markers, 3)
        Complete for all markers of the tree.
    body : Body
        The tree.
    standard : ndarray, shape (edges,)
        The length that each bone of the tree is to have, above 0.

    Returns
    -------
    Preprocessed
    """
    edges = body.edges
    moved = with_lengths(points, body, standard)
    roots = np.zeros_like(points)
    roots[:, body.parents < 0] = points[:, body.parents < 0]
    away = moved[:, edges[:, 0]] - moved[:, edges[:, 1]]
    return Preprocessed(signed_squares(away), moved - points, roots)


def restore(processed: Preprocessed, body: Body) -> FloatArray:
    """Undo `preprocess` (W18, eq. 7).

    Returns
    -------
    ndarray, shape (frames, markers, 3)
    """
    return chain(signed_roots(processed.squares), processed.roots, body) - processed.shifts


def with_lengths(points: FloatArray, body: Body, lengths: FloatArray) -> FloatArray:
    """Give the bones of a tree other lengths, parents first, and keep their directions (eq. 1).

    Parameters
    ----------
    points : ndarray, shape (frames, markers, 3)
        Places.
    body : Body
        The tree.
    lengths : ndarray, shape (edges,)
        In the order of `Body.edges`.

    Returns
    -------
    ndarray, shape (frames, markers, 3)
        With the markers that hang from none where they were.
    """
    edges = body.edges
    away = points[:, edges[:, 0]] - points[:, edges[:, 1]]
    size = np.linalg.norm(away, axis=2, keepdims=True)
    away = away / np.where(size > 0, size, 1.0) * lengths[:, None]
    return chain(away, points, body)


def chain(away: FloatArray, points: FloatArray, body: Body) -> FloatArray:
    """Put markers where differences along the bones lead, from the roots on.

    Parameters
    ----------
    away : ndarray, shape (frames, edges, 3)
        Child minus parent, in the order of `Body.edges`.
    points : ndarray, shape (frames, markers, 3)
        Where the roots are.
    body : Body
        The tree.

    Returns
    -------
    ndarray, shape (frames, markers, 3)
    """
    edges = body.edges
    result = points.copy()
    for at in np.argsort(body.depths[edges[:, 0]], kind="stable").tolist():
        child, parent = edges[at]
        result[:, child] = result[:, parent] + away[:, at]
    return result


def signed_squares(values: FloatArray) -> FloatArray:
    """Square numbers and keep their signs (W18, eq. 5)."""
    squares: FloatArray = np.sign(values) * values**2
    return squares


def signed_roots(values: FloatArray) -> FloatArray:
    """Undo `signed_squares`."""
    roots: FloatArray = np.sign(values) * np.sqrt(np.abs(values))
    return roots
