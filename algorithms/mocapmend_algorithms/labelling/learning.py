"""How a model is learned from labelled recordings."""

from collections.abc import Sequence

import numpy as np

from mocapmend_algorithms.arrays import FloatArray, evenly
from mocapmend_algorithms.labelling.around import COMPANIONS, Companions, companions, frames_around
from mocapmend_algorithms.labelling.model import LabelModel
from mocapmend_algorithms.labelling.upright import upright
from mocapmend_algorithms.names import points_by_name
from mocapmend_algorithms.progress import Progress, no_progress, part
from mocapmend_algorithms.recording import Recording
from mocapmend_algorithms.skeleton.distances import CENTRAL, WIDTH_IN_SD, PairDistances
from mocapmend_algorithms.skeleton.segments import find_segments

MOST_FRAMES = 400
"""Looked at of each recording."""
MOST_POSES = 24
LEAST_LABELS = 4
ROUNDS = 3


def learn(
    recordings: Sequence[Recording], segments: Sequence[Sequence[str]], progress: Progress
) -> LabelModel:
    """Learn a model; see `LabelModel.learn`."""
    labels, points = _gathered(recordings)
    progress(0.1)
    known = ~np.isnan(points[:, :, 0])
    if len(labels) < LEAST_LABELS or known.sum(axis=1).max(initial=0) < LEAST_LABELS:
        raise ValueError(
            f"the recordings to learn from show {len(labels)} named markers; at least "
            f"{LEAST_LABELS} are needed that are seen together"
        )
    length, spread = measure(points, part(progress, 0.1, 0.8))
    company = companions(length, spread, COMPANIONS)
    poses = _choose_poses(points)
    shapes, wander = mean_shapes(points, company, poses[0])
    progress(0.9)
    if segments:
        index = {label: k for k, label in enumerate(labels)}
        parts = [tuple(index[name] for name in names if name in index) for names in segments]
    else:
        parts = [each.markers for each in find_segments(PairDistances(length, spread))]
    progress(1.0)
    chosen = tuple(filter(None, parts))
    return LabelModel(labels, length, spread, shapes, wander, poses, chosen)


def _gathered(recordings: Sequence[Recording]) -> tuple[tuple[str, ...], FloatArray]:
    """Return all labels, and the frames of all recordings in the size of the first one."""
    named = [_trajectories(recording) for recording in recordings]
    labels = tuple(dict.fromkeys(label for columns in named for label in columns))
    gathered: list[FloatArray] = []
    for recording, columns in zip(recordings, named, strict=True):
        chosen = evenly(np.arange(recording.frames), MOST_FRAMES)
        full = np.full((len(chosen), len(labels), 3), np.nan)
        for k, label in enumerate(labels):
            if label in columns:
                full[:, k] = columns[label][chosen]
        if gathered:
            full /= _size_beside(full, gathered[0])
        gathered.append(full)
    return labels, np.concatenate(gathered) if gathered else np.empty((0, 0, 3))


def _trajectories(recording: Recording) -> dict[str, FloatArray]:
    """Return the path of each label that means something, shape (frames, 3), in mm and z up.

    Points of the same label that are never seen at once are pieces of one trajectory; of those
    that are, nobody knows which to believe.
    """
    points = upright(recording)
    found = {}
    for label, same in points_by_name(recording.labels).items():
        if recording.present[:, same].sum(axis=1).max(initial=0) <= 1:
            path = np.full((recording.frames, 3), np.nan)
            for point in same:
                seen = recording.present[:, point]
                path[seen] = points[seen, point]
            found[label] = path
    return found


def _size_beside(points: FloatArray, first: FloatArray) -> float:
    """Return how large a body is beside the first one, by the distances that hardly change."""
    own, own_spread = measure(points)
    other, other_spread = measure(first)
    steady = (own_spread < 0.1 * own) & (other_spread < 0.1 * other)
    ratios = own[steady] / other[steady]
    return float(np.median(ratios)) if ratios.size else 1.0


def measure(points: FloatArray, progress: Progress = no_progress) -> tuple[FloatArray, FloatArray]:
    """Measure the distances of all pairs, in all of the frames that are given.

    Parameters
    ----------
    points : ndarray, shape (frames, labels, 3)
        NaN = missing.
    progress : Progress
        Called once per label.

    Returns
    -------
    length, spread : ndarray, shape (labels, labels)
        Median and robust standard deviation; NaN for those never seen together.
    """
    count = points.shape[1]
    length, spread = np.full((2, count, count), np.nan)
    for one in range(count):
        progress(one / count)
        apart = np.linalg.norm(points - points[:, one, None], axis=2)
        apart.sort(axis=0)
        seen = apart.shape[0] - np.isnan(apart).sum(axis=0)
        at = np.clip(np.multiply.outer(CENTRAL, seen - 1).round(), 0, None).astype(np.int64)
        if apart.shape[0]:
            low, middle, high = np.take_along_axis(apart, at, axis=0)
            length[one], spread[one] = middle, (high - low) / WIDTH_IN_SD
    return length, spread


def _choose_poses(points: FloatArray) -> FloatArray:
    """Choose poses that differ most: the fullest frame, then each time the farthest from all.

    Poses are compared by the distances between markers, which no heading changes.
    """
    seen = ~np.isnan(points[:, :, 0])
    enough = np.flatnonzero(seen.sum(axis=1) >= max(LEAST_LABELS, 0.8 * seen.sum(axis=1).max()))
    some = points[evenly(enough, MOST_FRAMES)]
    middle = np.nanmean(some, axis=1, keepdims=True)
    from_middle = np.linalg.norm(some - middle, axis=2)
    heights = some[:, :, 2] - middle[:, :, 2]
    features = np.nan_to_num(np.concatenate([from_middle, heights], axis=1))
    typical = np.median(features, axis=0)
    chosen = [int(np.argmin(np.linalg.norm(features - typical, axis=1)))]
    away = np.linalg.norm(features - features[chosen[0]], axis=1)
    while len(chosen) < min(MOST_POSES, len(some)):
        chosen.append(int(np.argmax(away)))
        away = np.minimum(away, np.linalg.norm(features - features[chosen[-1]], axis=1))
    poses: FloatArray = some[chosen] - middle[chosen]
    return poses


def mean_shapes(
    points: FloatArray, company: Companions, first: FloatArray
) -> tuple[FloatArray, FloatArray]:
    """Average the surroundings of each marker.

    Parameters
    ----------
    points : ndarray, shape (frames, labels, 3)
        NaN = missing.
    company : Companions
        The markers that each one's frame of reference rests on.
    first : ndarray, shape (labels, 3)
        A pose to begin with.

    Returns
    -------
    shapes : ndarray, shape (labels, labels, 3)
        NaN where two are never seen together.
    wander : ndarray, shape (labels,)
        Standard deviation per axis of each marker's own place; NaN where it is not known.
    """
    count = points.shape[1]
    shapes = np.repeat(first[None], count, axis=0)
    wander = np.full(count, np.nan)
    for _ in range(ROUNDS):
        frames = frames_around(points, shapes, company)
        away = points[:, None] - frames.centre[:, :, None]
        local = np.einsum("flji,flmj->flmi", frames.rotation, away) + frames.origin[:, :, None]
        local[~frames.known] = np.nan
        seen = ~np.isnan(local[..., 0])
        number = seen.sum(axis=0)
        mean = np.nan_to_num(local).sum(axis=0) / np.maximum(number, 1)[:, :, None]
        shapes = np.where((number > 0)[:, :, None], mean, np.nan)
        own = np.arange(count)
        away_from_own = np.linalg.norm(local[:, own, own] - shapes[own, own], axis=2)
        for k in range(count):
            known = away_from_own[:, k][~np.isnan(away_from_own[:, k])]
            wander[k] = np.sqrt(np.mean(known**2) / 3.0) if known.size else np.nan
    return shapes, wander
