"""The methods: the single source for menus, forms, the command line and the documentation."""

from collections.abc import Mapping
from dataclasses import dataclass
from typing import Any, Literal, get_args

from mocapmend_algorithms import params
from mocapmend_algorithms.fill import (
    auto,
    bone_dictionary,
    burke_lasenby,
    cyclic,
    interpolate,
    kalman,
    local_frame,
    pca,
    pose_code,
    smbs,
    tsmc,
    woltring,
)
from mocapmend_algorithms.fill.contract import FillFunction

Family = Literal["Automatic", "Interpolation", "Donors", "Low rank", "Sparse", "Kalman"]
FAMILIES: tuple[Family, ...] = get_args(Family)
"""Kinds of methods, in the order of menus; within one they are as in `METHODS`."""


@dataclass(frozen=True)
class Method:
    """A way to fill gaps.

    Attributes
    ----------
    id : str
        Stable: scripts, recipes and provenance name it.
    label : str
        For menus.
    family : str
        One of `FAMILIES`: what menus group it with.
    function : FillFunction
        The fill.
    params : type
        Frozen dataclass of its parameters, with defaults; see `params.option`.
    help : str
        What it does and where it fails, for the user.
    fills_edges : bool
        Whether it fills gaps at the beginning and the end of a recording by its model. Those
        without one may have a parameter `edges`.
    """

    id: str
    label: str
    family: Family
    function: FillFunction
    params: type[Any]
    help: str
    fills_edges: bool = False

    def reaches_edges(self, params: Any) -> bool:
        """Whether gaps at the beginning and the end are filled with these parameters."""
        edges = getattr(params, "edges", None)
        return self.fills_edges if edges is None else edges != "leave"


_ALL = (
    Method(
        id="constant",
        label="Constant",
        family="Interpolation",
        function=interpolate.constant,
        params=interpolate.ConstantParams,
        help="Holds the value at one edge of the gap. Right only for a marker that stands still.",
    ),
    Method(
        id="linear",
        label="Linear",
        family="Interpolation",
        function=interpolate.linear,
        params=interpolate.LinearParams,
        help="A straight line between the edges of the gap. It cuts every curve of the motion; "
        "good for a few frames.",
    ),
    Method(
        id="cubic",
        label="Cubic spline",
        family="Interpolation",
        function=interpolate.cubic,
        params=interpolate.CubicParams,
        help="A smooth curve through the samples on both sides. Good below about 0.2 s; above, "
        "it invents motion and may overshoot.",
    ),
    Method(
        id="pchip",
        label="PCHIP",
        family="Interpolation",
        function=interpolate.pchip,
        params=interpolate.PchipParams,
        help="A curve that never overshoots the edges of the gap. Safer than the cubic spline on "
        "jittery samples, less exact on smooth motion.",
    ),
    Method(
        id="woltring",
        label="Woltring, quintic spline",
        family="Interpolation",
        function=woltring.woltring,
        params=woltring.WoltringParams,
        help="A quintic spline that first smooths the samples beside the gap, by as much as "
        "cross-validation says, so that jitter does not swing it. Measured samples stay as they "
        "are. Good below about 0.2 s; above, it invents motion and may overshoot further than "
        "the cubic spline.",
    ),
    Method(
        id="cyclic",
        label="Cyclic",
        family="Interpolation",
        function=cyclic.cyclic,
        params=cyclic.CyclicParams,
        help="For gait, pedalling and other motion in cycles: takes the same phase of the "
        "neighbouring cycles and fits it between the edges of the gap. Good for gaps that span "
        "much of a cycle, poor where speed or direction change, as in a turn.",
    ),
    Method(
        id="rigid",
        label="Rigid body",
        family="Donors",
        function=local_frame.rigid,
        params=local_frame.RigidParams,
        help="Moves the marker with three or more donors that keep their distance to it, such as "
        "those of the same segment. Good while that part of the body is stiff; it cannot follow "
        "skin and joints.",
        fills_edges=True,
    ),
    Method(
        id="pattern",
        label="Pattern",
        family="Donors",
        function=local_frame.pattern,
        params=local_frame.PatternParams,
        help="Moves the marker along with one donor. For lack of better donors: it does not turn "
        "with the body.",
        fills_edges=True,
    ),
    Method(
        id="local-frame",
        label="Local frame regression",
        family="Donors",
        function=local_frame.local_frame,
        params=local_frame.LocalFrameParams,
        help="Learns from this recording how the marker moves beside its donors, in a frame that "
        "moves with four of them. Follows skin and joints as far as the donors show them.",
        fills_edges=True,
    ),
    Method(
        id="pca-r1",
        label="Principal components, all gaps at once",
        family="Low rank",
        function=pca.pca_r1,
        params=pca.PcaR1Params,
        help="Learns from the complete frames how the markers move together and predicts all "
        "markers with gaps at once from those without any (Gløersen and Federolf 2016, R1). For "
        "recordings with few gaps; it learns nothing of postures that no complete frame shows.",
        fills_edges=True,
    ),
    Method(
        id="pca-r2",
        label="Principal components, marker by marker",
        family="Low rank",
        function=pca.pca_r2,
        params=pca.PcaR2Params,
        help="Learns how the markers move together and predicts each marker with gaps from those "
        "that are seen in them, near ones first (Gløersen and Federolf 2016, R2). Good for gaps "
        "up to seconds in repetitive motion; poor where a marker's neighbours are missing too.",
        fills_edges=True,
    ),
    Method(
        id="burke-lasenby",
        label="Low-dimensional Kalman smoother",
        family="Low rank",
        function=burke_lasenby.burke_lasenby,
        params=burke_lasenby.BurkeLasenbyParams,
        help="Learns from the complete frames in which few directions the whole body moves, and "
        "follows the posture there with a Kalman smoother (Burke and Lasenby 2016). Fast; good "
        "for one marker in motion like that of the complete frames, poor where several markers "
        "of a segment are missing.",
        fills_edges=True,
    ),
    Method(
        id="tsmc",
        label="Matrix completion of trajectory segments",
        family="Low rank",
        function=tsmc.tsmc,
        params=tsmc.TsmcParams,
        help="Completes the trajectories around the gap so that they move in as few directions as "
        "possible, near markers counting more (after Tan, Hou and Chau 2013). About as good as the "
        "principal components, and often better where several neighbours are missing too; poor "
        "where the body turns or moves in the gap as it does nowhere around it.",
        fills_edges=True,
    ),
    Method(
        id="pose-code",
        label="Sparse code of poses",
        family="Sparse",
        function=pose_code.pose_code,
        params=pose_code.PoseCodeParams,
        help="Composes each pose from few complete ones, of this recording or of a training set, "
        "that agree with it in the markers that are seen, and takes the missing marker from them. "
        "Good for long gaps where like poses are known; in motion that comes only once, there is "
        "nothing to take from.",
        fills_edges=True,
    ),
    Method(
        id="bone-dictionary",
        label="Sparse code of motion, with bones",
        family="Sparse",
        function=bone_dictionary.bone_dictionary,
        params=bone_dictionary.BoneDictionaryParams,
        help="Composes each stretch of motion from few examples, of this recording or of a "
        "training set, and keeps bone lengths (after Wang, Lu, Han 2018). For several neighbouring "
        "markers or joints that are missing together; poor where no example is like the motion.",
        fills_edges=True,
    ),
    Method(
        id="smbs",
        label="Sparse motion bases",
        family="Sparse",
        function=smbs.smbs,
        params=smbs.SmbsParams,
        help="Composes short windows of motion from few examples, part by part and without bones. "
        "It is what the sparse code with bones is compared to.",
        fills_edges=True,
    ),
    Method(
        id="kalman",
        label="Kalman, constant velocity",
        family="Kalman",
        function=kalman.kalman,
        params=kalman.KalmanParams,
        help="Carries position and velocity into the gap from both sides, relative to the "
        "neighbouring markers that are seen, and says how sure it is. Where none are, it looks at "
        "one marker alone and cannot know what happened inside a gap much longer than 0.2 s.",
    ),
    Method(
        id="auto",
        label="Automatic",
        family="Automatic",
        function=auto.auto,
        params=auto.AutoParams,
        help="Learns from this very recording how the marker moves with all others that are seen "
        "in the gap. Several such fills are tested on hidden stretches like the gap and blended "
        "by how well they did; the expected error and the band come from these tests.",
        fills_edges=True,
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
