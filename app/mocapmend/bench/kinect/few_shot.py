"""What paired calibration recordings of a new performer are worth."""

from collections.abc import Sequence
from dataclasses import dataclass

from mocapmend.refine.measuring import Predict
from mocapmend_algorithms.arrays import FloatArray
from mocapmend_algorithms.refine.calibrating import corrected, mean_error
from mocapmend_algorithms.refine.measures import Errors, errors_of, pooled
from mocapmend_algorithms.refine.profile import Profile
from mocapmend_algorithms.refine.train.pairs import Pair


@dataclass(frozen=True)
class Worth:
    """Errors over the pairs that no calibration used, mm^2.

    Attributes
    ----------
    way : str
        What was calibrated.
    before : Errors
        Without calibration.
    one, each : Errors
        With one repetition of one movement, and with one of each movement.
    """

    way: str
    before: Errors
    one: Errors
    each: Errors


def calibrated(way: str, pairs: Sequence[Pair], predict: Predict, profile: Profile) -> Worth:
    """Measure predictions of new performers with and without calibration."""
    found: dict[str, list[Errors]] = {"before": [], "one": [], "each": []}
    for performer in sorted({pair.performer for pair in pairs}):
        own = [pair for pair in pairs if pair.performer == performer]
        poses = [predict(pair.joints) for pair in own]
        movements = [pair.movement for pair in own]
        first = [movements.index(movement) for movement in dict.fromkeys(movements)]
        offsets = {"one": _error(own, poses, first[:1], profile)}
        offsets["each"] = _error(own, poses, first, profile)
        for at in set(range(len(own))).difference(first):
            pair = own[at]
            found["before"].append(errors_of(poses[at], pair.markers, profile))
            for name, offset in offsets.items():
                better = corrected(pair.joints, poses[at], offset, profile)
                found[name].append(errors_of(better, pair.markers, profile))
    return Worth(way, **{name: pooled(errors) for name, errors in found.items()})


def _error(
    own: list[Pair], poses: list[FloatArray], chosen: list[int], profile: Profile
) -> FloatArray:
    return mean_error(
        [own[at].joints for at in chosen],
        [poses[at] for at in chosen],
        [own[at].markers for at in chosen],
        profile,
    )
