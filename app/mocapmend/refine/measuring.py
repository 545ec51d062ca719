"""How good a network is on pairs that it has not seen, beside a regression of the same pairs."""

from collections.abc import Callable, Sequence
from dataclasses import replace

from mocapmend_algorithms.arrays import FloatArray
from mocapmend_algorithms.progress import Progress
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


def measure(
    model: Model, learnt: Sequence[Pair], rest: Sequence[Pair], progress: Progress
) -> Model:
    """Return the model with a card that says how good it is on pairs it has not seen."""
    ridge = ridge_on_butterworth(learnt, model.profile)

    def network(joints: FloatArray) -> FloatArray:
        return refined_poses(joints, model, STRIDE, lambda _: None)

    kinds: dict[str, Predict] = {
        NETWORK: network,
        FILTERED: lambda joints: filtered(network(joints), OUTPUT_FILTER_HZ),
        RIDGE: ridge,
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


def ridge_on_butterworth(pairs: Sequence[Pair], profile: Profile) -> Predict:
    """Fit a ridge regression on joints smoothed at 5 Hz."""
    smooth = [filtered(pair.joints, INPUT_FILTER_HZ) for pair in pairs]
    ridge = Ridge(smooth, [pair.markers for pair in pairs], profile)
    return lambda joints: ridge(filtered(joints, INPUT_FILTER_HZ))


def errors_over(pairs: Sequence[Pair], predict: Predict, profile: Profile) -> Errors:
    """Measure predictions on pairs, each frame counting the same."""
    return pooled([errors_of(predict(pair.joints), pair.markers, profile) for pair in pairs])
