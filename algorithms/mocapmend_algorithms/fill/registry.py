"""The methods: the single source for menus, forms, the command line and the documentation."""

from collections.abc import Mapping
from dataclasses import dataclass
from typing import Any

from mocapmend_algorithms.fill import burke_lasenby, interpolate, kalman, low_rank, params
from mocapmend_algorithms.fill.contract import FillFunction


@dataclass(frozen=True)
class Method:
    """A way to fill gaps.

    Attributes
    ----------
    id : str
        Stable: scripts, recipes and provenance name it.
    label : str
        For menus.
    function : FillFunction
        The fill.
    params : type
        Frozen dataclass of its parameters, with defaults; see `params.option`.
    help : str
        What it does and where it fails, for the user.
    fills_edges : bool
        Whether it fills gaps at the beginning and the end of a recording.
    """

    id: str
    label: str
    function: FillFunction
    params: type[Any]
    help: str
    fills_edges: bool = False


_ALL = (
    Method(
        id="constant",
        label="Constant",
        function=interpolate.constant,
        params=interpolate.ConstantParams,
        help="Holds the value at one edge of the gap. Right only for a marker that stands still.",
    ),
    Method(
        id="linear",
        label="Linear",
        function=interpolate.linear,
        params=interpolate.LinearParams,
        help="A straight line between the edges of the gap. It cuts every curve of the motion; "
        "good for a few frames.",
    ),
    Method(
        id="cubic",
        label="Cubic spline",
        function=interpolate.cubic,
        params=interpolate.CubicParams,
        help="A smooth curve through the samples on both sides. Good below about 0.2 s; above, "
        "it invents motion and may overshoot.",
    ),
    Method(
        id="pchip",
        label="PCHIP",
        function=interpolate.pchip,
        params=interpolate.PchipParams,
        help="A curve that never overshoots the edges of the gap. Safer than the cubic spline on "
        "jittery samples, less exact on smooth motion.",
    ),
    Method(
        id="pca-r1",
        label="Principal components, all gaps at once",
        function=low_rank.pca_r1,
        params=low_rank.PcaR1Params,
        help="Learns from the complete frames how the markers move together and predicts all "
        "markers with gaps at once from those without any (Gløersen and Federolf 2016, R1). For "
        "recordings with few gaps; it learns nothing of postures that no complete frame shows.",
        fills_edges=True,
    ),
    Method(
        id="pca-r2",
        label="Principal components, marker by marker",
        function=low_rank.pca_r2,
        params=low_rank.PcaR2Params,
        help="Learns how the markers move together and predicts each marker with gaps from those "
        "that are seen in them, near ones first (Gløersen and Federolf 2016, R2). Good for gaps "
        "up to seconds in repetitive motion; poor where a marker's neighbours are missing too.",
        fills_edges=True,
    ),
    Method(
        id="burke-lasenby",
        label="Low-dimensional Kalman smoother",
        function=burke_lasenby.burke_lasenby,
        params=burke_lasenby.BurkeLasenbyParams,
        help="Learns from the complete frames in which few directions the whole body moves, and "
        "follows the posture there with a Kalman smoother (Burke and Lasenby 2016). Fast; good "
        "for one marker in motion like that of the complete frames, poor where several markers "
        "of a segment are missing.",
        fills_edges=True,
    ),
    Method(
        id="kalman",
        label="Kalman, constant velocity",
        function=kalman.kalman,
        params=kalman.KalmanParams,
        help="Carries position and velocity into the gap from both sides, with a band that says "
        "how sure it is. It looks at one marker alone and cannot know what happened inside a "
        "gap much longer than 0.2 s.",
    ),
)

METHODS: dict[str, Method] = {method.id: method for method in _ALL}


def method(method_id: str) -> Method:
    """Return a method by its id.

    Raises
    ------
    KeyError
        If there is none; the message lists the ids.
    """
    if method_id not in METHODS:
        raise KeyError(f"there is no method {method_id!r}; the methods are: {', '.join(METHODS)}")
    return METHODS[method_id]


def method_label(method_id: str) -> str:
    """Return a method's label; the id of one that this version does not know."""
    return METHODS[method_id].label if method_id in METHODS else method_id


def parse_params(method: Method, pairs: Mapping[str, str]) -> Any:
    """Make a method's parameters from text, as `name=value` on the command line.

    Parameters
    ----------
    method : Method
        Whose parameters.
    pairs : mapping of str to str
        Name and value of those that differ from their defaults.

    Returns
    -------
    object
        An instance of `method.params`.

    Raises
    ------
    ValueError
        With one sentence that says which parameter is wrong and what it may be.
    """
    return params.parse(method.params, pairs)


def restore_params(method: Method, values: Mapping[str, Any]) -> Any:
    """Make a method's parameters from what a JSON file has of them; see `params.restore`."""
    return params.restore(method.params, values)
