"""The detectors: the single source for the command line, the window and the documentation."""

from collections.abc import Iterable
from dataclasses import dataclass
from typing import Any, Literal

from mocapmend_algorithms.problems import spikes, swaps
from mocapmend_algorithms.problems.contract import DetectFunction

Remedy = Literal["missing", "exchange"]


@dataclass(frozen=True)
class Detector:
    """A way to find bad samples.

    Attributes
    ----------
    id : str
        Stable: scripts, recipes and provenance name it.
    label : str
        For menus.
    function : DetectFunction
        The detector.
    params : type
        Frozen dataclass of its parameters, with defaults; see `fill.params.option`.
    help : str
        What it finds and where it fails, for the user.
    remedy : str
        "missing": the samples are set aside and filled; "exchange": they are exchanged with those
        of the marker `other`.
    """

    id: str
    label: str
    function: DetectFunction
    params: type[Any]
    help: str
    remedy: Remedy


_ALL = (
    Detector(
        id="spikes",
        label="Spikes",
        function=spikes.spikes,
        params=spikes.SpikesParams,
        help="Samples that leave the trajectory for one or a few frames and come back. Fast motion "
        "is told apart by the frames on both sides and by the neighbouring markers.",
        remedy="missing",
    ),
    Detector(
        id="swaps",
        label="Swapped labels",
        function=swaps.swaps,
        params=swaps.SwapsParams,
        help="Two markers that carry each other's label for some time, also where a gap or the end "
        "of the recording hides where it begins or ends. Labels that are swapped throughout cannot "
        "be found.",
        remedy="exchange",
    ),
)

DETECTORS: dict[str, Detector] = {detector.id: detector for detector in _ALL}


def detector(detector_id: str) -> Detector:
    """Return a detector by its id.

    Raises
    ------
    KeyError
        If there is none; the message lists the ids.
    """
    if detector_id not in DETECTORS:
        known = ", ".join(DETECTORS)
        raise KeyError(f"there is no detector {detector_id!r}; the detectors are: {known}")
    return DETECTORS[detector_id]


def chosen(ids: Iterable[str] | None) -> list[Detector]:
    """Return the detectors of some ids in the order of the registry; all by default.

    Raises
    ------
    KeyError
        If there is none of an id; the message lists the ids.
    """
    if ids is None:
        return list(DETECTORS.values())
    wanted = {detector(name).id for name in ids}
    return [each for each in DETECTORS.values() if each.id in wanted]
