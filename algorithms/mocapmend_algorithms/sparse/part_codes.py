"""W18 as printed, its misprints put right: five parts, signed squares, trained dictionaries.

W18 = Wang, Lu, Han 2018, Computer Systems & Applications 27(5):17-25. Each part of the body has a
dictionary of windows of its triple of parts (`Body.triples`), six frames next to each other. A
window is coded from the rows that are seen and from the squared lengths of the bones that are not;
the part's own rows are read off. The signs that bones need come from a coarse completion: the
principal components of the training windows that fit what is seen best.

Each part's rows are scaled to unit mean square (lambda1 = 1e-4 presumes scaled data), which W18
does not state. Its anchors (joint 14 of the arms) are taken relative to the root.
"""

from collections.abc import Mapping

import numpy as np

from mocapmend_algorithms.arrays import BoolArray, FloatArray, IntArray
from mocapmend_algorithms.progress import Progress, part
from mocapmend_algorithms.sparse.body import Body
from mocapmend_algorithms.sparse.part_rows import SPAN, PartDictionary, PartRows
from mocapmend_algorithms.sparse.rows import Rows


def recover(
    points: FloatArray,
    seen: BoolArray,
    body: Body,
    dictionaries: Mapping[int, PartDictionary],
    progress: Progress,
) -> FloatArray:
    """Fill all that is missing of a motion.

    Parameters
    ----------
    points : ndarray, shape (frames, markers, 3)
        In mm.
    seen : ndarray of bool, shape (frames, markers)
        The samples that may be looked at.
    body : Body
        With the motion's own bone lengths.
    dictionaries : mapping of int to PartDictionary
        Of each part that misses something.
    progress : Progress
        Called often.

    Returns
    -------
    ndarray, shape (frames, markers, 3)
        NaN where a frame lies in no window, or shows no marker.
    """
    edges = body.edges
    found = points[:, edges[:, 0]] - points[:, edges[:, 1]]
    shown = seen[:, edges[:, 0]] & seen[:, edges[:, 1]]
    found[~shown] = np.nan
    for done, (at, dictionary) in enumerate(dictionaries.items()):
        share = part(progress, done / len(dictionaries), (done + 1) / len(dictionaries))
        children = np.isin(edges[:, 0], body.parts[at])
        lacking = np.flatnonzero(~shown[:, children].all(axis=1))
        places = SPAN.inside(0, len(points))
        places = places[np.isin(SPAN.frames(places), lacking).any(axis=1)]
        if not places.size:
            continue
        rows = dictionary.rows
        of = _edge_of(edges, rows.pairs)
        stretch = _stretch(rows, of, body)
        here = rows.seen(seen, places)
        away = rows.differences(np.where(seen[..., None], points, 0.0), places)
        away *= np.tile(np.repeat(stretch, 3), len(SPAN.offsets))[:, None]
        told = dictionary.recover(away, here, share).T
        told = told.reshape(places.size, len(SPAN.offsets), len(rows.pairs), 3)
        mean = SPAN.average(told, places, 0, len(points)) / stretch[:, None]
        for pair in np.flatnonzero(rows.own).tolist():
            edge = int(of[pair])
            found[:, edge] = np.where(shown[:, [edge]], found[:, edge], mean[:, pair])
    progress(1.0)
    return _placed(points, seen, body, found)


def _edge_of(edges: IntArray, pairs: IntArray) -> IntArray:
    """Return the edge of the tree that each pair is; -1 for an anchor."""
    same = (pairs[:, None] == edges[None]).all(axis=2)
    of: IntArray = np.where(same.any(axis=1), same.argmax(axis=1), -1)
    return of


def _stretch(rows: PartRows, of: IntArray, body: Body) -> FloatArray:
    """Return by what pairs of a body become standard; anchors as all bones on their way do."""
    own, bone = body.edge_lengths, of >= 0
    standard = np.zeros_like(own)
    standard[of[bone]] = rows.standard[bone]
    stretch = np.ones(of.size)
    stretch[bone] = rows.standard[bone] / own[of[bone]]
    children = body.edges[:, 0].tolist()
    for pair in np.flatnonzero(~bone).tolist():
        marker, way = int(rows.pairs[pair, 0]), []
        while body.parents[marker] >= 0:
            way.append(children.index(marker))
            marker = int(body.parents[marker])
        stretch[pair] = standard[way].sum() / own[way].sum()
    return stretch


def _placed(points: FloatArray, seen: BoolArray, body: Body, away: FloatArray) -> FloatArray:
    """Put missing markers where the differences lead, from those that are seen."""
    result = np.where(seen[..., None], points, np.nan)
    kinds, which = np.unique(seen, axis=0, return_inverse=True)
    order = {(a, b): at for at, (a, b) in enumerate(body.edges.tolist())}
    for kind, here in enumerate(kinds):
        frames = np.flatnonzero(which.ravel() == kind)
        if here.all() or not here.any():
            continue
        rows = Rows.along_bones(body, np.flatnonzero(here), np.flatnonzero(~here))
        lost = away[frames][:, [order[a, b] for a, b in rows.lost.tolist()]]
        result[np.ix_(frames, rows.targets)] = rows.places(lost, points[frames])
    return result
