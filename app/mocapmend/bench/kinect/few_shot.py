"""What a paired calibration recording of a new performer is worth.

Of each movement, the first repetition with a reference is taken: the mean error of each marker, as
seen from the body, is subtracted from all others.
"""

from collections.abc import Sequence

import numpy as np

from mocapmend.refine.measuring import Predict
from mocapmend_algorithms.arrays import FloatArray
from mocapmend_algorithms.refine.measures import Errors, errors_of, pooled
from mocapmend_algorithms.refine.preparing import headings, turned
from mocapmend_algorithms.refine.profile import Profile
from mocapmend_algorithms.refine.train.pairs import Pair


def calibrated(pairs: Sequence[Pair], predict: Predict, profile: Profile) -> tuple[Errors, Errors]:
    """Measure predictions of new performers, with and without their mean error subtracted.

    Returns
    -------
    (Errors, Errors)
        Without and with calibration, both over the pairs that no calibration used.
    """
    plain, better = [], []
    for performer in sorted({pair.performer for pair in pairs}):
        own = [pair for pair in pairs if pair.performer == performer]
        first = {pair.movement: pair for pair in reversed(own)}
        chosen = {id(pair) for pair in first.values()}
        errors = [_seen_from_body(pair, predict(pair.joints), profile) for pair in first.values()]
        offset = np.nanmean(np.concatenate(errors), axis=0)
        for pair in own:
            if id(pair) in chosen:
                continue
            poses = predict(pair.joints)
            plain.append(errors_of(poses, pair.markers, profile))
            angle = headings(pair.joints[None], profile)
            shift = turned(np.broadcast_to(offset, (1, *poses.shape)), angle)[0]
            better.append(errors_of(poses - shift, pair.markers, profile))
    return pooled(plain), pooled(better)


def _seen_from_body(pair: Pair, poses: FloatArray, profile: Profile) -> FloatArray:
    error = (poses - pair.markers)[None]
    seen: FloatArray = turned(error, -headings(pair.joints[None], profile))[0]
    return seen
