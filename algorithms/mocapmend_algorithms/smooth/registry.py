"""The smoothing methods: the single source for menus, forms, the command line and the records."""

from collections.abc import Mapping
from dataclasses import dataclass
from typing import Any

from mocapmend_algorithms import params
from mocapmend_algorithms.smooth import butterworth, gcv, kalman_smoother, savgol
from mocapmend_algorithms.smooth.contract import SmoothFunction


@dataclass(frozen=True)
class Smoother:
    """A way to smooth.

    Attributes
    ----------
    id : str
        Stable: scripts, recipes and provenance name it.
    label : str
        For menus.
    function : SmoothFunction
        The smoothing.
    params : type
        Frozen dataclass of its parameters, with defaults; see `params.option`.
    help : str
        What it does and where it fails, for the user.
    """

    id: str
    label: str
    function: SmoothFunction
    params: type[Any]
    help: str


_ALL = (
    Smoother(
        id="butterworth",
        label="Butterworth, zero lag",
        function=butterworth.butterworth,
        params=butterworth.ButterworthParams,
        help="Takes away what is faster than a cut-off frequency, forwards and backwards so that "
        "nothing is delayed. The common choice of biomechanics; it rounds off impacts.",
    ),
    Smoother(
        id="savgol",
        label="Savitzky-Golay",
        function=savgol.savgol,
        params=savgol.SavgolParams,
        help="Fits a polynomial to a short stretch around each sample. Keeps the height of peaks "
        "better than most; what is faster than its window is not taken away completely.",
    ),
    Smoother(
        id="gcv",
        label="Woltring, quintic spline",
        function=gcv.gcv,
        params=gcv.GcvParams,
        help="A quintic spline that smooths by as much as generalised cross-validation says, and "
        "less at impacts. Good where speeds and accelerations are wanted; jitter that lasts for "
        "several frames is taken for motion.",
    ),
    Smoother(
        id="kalman-smoother",
        label="Kalman smoother",
        function=kalman_smoother.kalman_smoother,
        params=kalman_smoother.KalmanSmootherParams,
        help="Weighs each sample against what the motion around it lets expect. How fast the "
        "motion changes and how noisy the samples are is estimated from the samples.",
    ),
)

SMOOTHERS: dict[str, Smoother] = {smoother.id: smoother for smoother in _ALL}
AMOUNTS = ("cutoff_hz", "window_ms", "noise_mm")
"""Parameters that say how much is smoothed; a method chooses it where all it has are None."""
SUGGESTED = "gcv"
"""Where the user has named none."""


def smoother(smoother_id: str) -> Smoother:
    """Return a smoothing method by its id.

    Raises
    ------
    KeyError
        If there is none; the message lists the ids.
    """
    if smoother_id not in SMOOTHERS:
        known = ", ".join(SMOOTHERS)
        raise KeyError(f"there is no smoothing method {smoother_id!r}; there are: {known}")
    return SMOOTHERS[smoother_id]


def smoother_label(smoother_id: str) -> str:
    """Return a method's label; the id of one that this version does not know."""
    return SMOOTHERS[smoother_id].label if smoother_id in SMOOTHERS else smoother_id


def parse_params(smoother: Smoother, pairs: Mapping[str, str]) -> Any:
    """Make a method's parameters from text, as `name=value`; see `params.parse`."""
    return params.parse(smoother.params, pairs)


def restore_params(smoother: Smoother, values: Mapping[str, Any]) -> Any:
    """Make a method's parameters from what a JSON file has of them; see `params.restore`."""
    return params.restore(smoother.params, values)
