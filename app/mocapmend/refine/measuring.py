"""How good a network is on pairs that it has not seen, beside a regression of the same pairs."""

from collections.abc import Callable, Sequence
from dataclasses import replace

from mocapmend_algorithms.arrays import FloatArray
from mocapmend_algorithms.progress import Progress, no_progress
from mocapmend_algorithms.refine.measures import Errors, errors_of, pooled
from mocapmend_algorithms.refine.model import Model
from mocapmend_algorithms.refine.profile import Profile
from mocapmend_algorithms.refine.refining import filtered, refined_poses
from mocapmend_algorithms.refine.ridge import Ridge
from mocapmend_algorithms.refine.train.pairs import Pair

STRIDE = 60
OUTPUT_FILTER_HZ = 6.0
INPUT_FILTER_HZ = 4.0
"""Both ways together: what a filter of second order and 5 Hz does, forwards and backwards."""
NETWORK, FILTERED, RIDGE = "network", "network, 6 Hz", "ridge on 5 Hz Butterworth"

Predict = Callable[[FloatArray], FloatArray]
"""From joints, shape (frames, inputs, 3), to markers, shape (frames, outputs, 3)."""
Smooth = Callable[[FloatArray], FloatArray]
"""From joints, shape (frames, inputs, 3), to smoother ones."""


def measure(
    model: Model, learnt: Sequence[Pair], rest: Sequence[Pair], progress: Progress
) -> Model:
    """Return the model with a card that says how good it is on pairs it has not seen."""
    network = remembering(refining(model))
    kinds: dict[str, Predict] = {
        NETWORK: network,
        FILTERED: smoothing(network),
        RIDGE: ridge_on(butterworth, learnt, model.profile),
    }
    figures = {}
    for done, (name, predict) in enumerate(kinds.items()):
        errors = errors_over(rest, predict, model.profile)
        figures[name] = {
            "position_mm2": errors.position,
            "bones_mm2": errors.bones,
            "smoothness_mm2": errors.smoothness,
        }
        progress((done + 1) / len(kinds))
    return replace(model, card={**model.card, "figures": figures, "measured_on": len(rest)})


def refining(model: Model) -> Predict:
    """Return what a network predicts, as it does by default."""
    return lambda joints: refined_poses(joints, model, STRIDE, no_progress)


def remembering(predict: Predict) -> Predict:
    """Return the same predictions, each made once.

    For arrays that live as long as it does: they are told apart by their identity.
    """
    made: dict[int, FloatArray] = {}

    def remembered(joints: FloatArray) -> FloatArray:
        if id(joints) not in made:
            made[id(joints)] = predict(joints)
        return made[id(joints)]

    return remembered


def smoothing(predict: Predict) -> Predict:
    """Return predictions with the output filter."""
    return lambda joints: filtered(predict(joints), OUTPUT_FILTER_HZ)


def butterworth(joints: FloatArray) -> FloatArray:
    """Smooth joints with the usual filter of 5 Hz, forwards and backwards."""
    return filtered(joints, INPUT_FILTER_HZ)


def ridge_on(smooth: Smooth, pairs: Sequence[Pair], profile: Profile) -> Predict:
    """Fit a ridge regression on smoothed joints."""
    smoothed = [smooth(pair.joints) for pair in pairs]
    ridge = Ridge(smoothed, [pair.markers for pair in pairs], profile)
    return lambda joints: ridge(smooth(joints))


def errors_over(pairs: Sequence[Pair], predict: Predict, profile: Profile) -> Errors:
    """Measure predictions on pairs, each frame counting the same."""
    return pooled([errors_of(predict(pair.joints), pair.markers, profile) for pair in pairs])
