"""The methods: the single source for menus, forms, the command line and the documentation."""

from collections.abc import Mapping
from dataclasses import dataclass
from typing import Any

from mocapmend_algorithms.fill import interpolate, kalman, params
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
        id="kalman",
        label="Kalman, constant velocity",
        function=kalman.kalman,
        params=kalman.KalmanParams,
        help="Carries position and velocity into the gap from both sides, relative to the "
        "neighbouring markers that are seen, and says how sure it is. Where none are, it looks at "
        "one marker alone and cannot know what happened inside a gap much longer than 0.2 s.",
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
