"""The detectors: the single source for the command line, the window and the documentation."""

from collections.abc import Iterable
from dataclasses import dataclass
from typing import Any, Literal

from mocapmend_algorithms.problems import (
    bone_breaks,
    far,
    fragments,
    frozen,
    reflections,
    spikes,
    swaps,
    tails,
)
from mocapmend_algorithms.problems.bad_run import BadRun
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
        Frozen dataclass of its parameters, with defaults; see `params.option`.
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
    Detector(
        id="fragments",
        label="Fragments and ghosts",
        function=fragments.fragments,
        params=fragments.FragmentsParams,
        help="Points without a label, and labels that come twice, that are pieces of a marker's "
        "trajectory. Those that fit no marker are listed as ghosts.",
        remedy="exchange",
    ),
    Detector(
        id="tails",
        label="Ragged ends",
        function=tails.tails,
        params=tails.TailsParams,
        help="Samples just before or after a gap that bend away from the trajectory, as those of a "
        "marker that is half hidden.",
        remedy="missing",
    ),
    Detector(
        id="frozen",
        label="Frozen samples",
        function=frozen.frozen,
        params=frozen.FrozenParams,
        help="Samples that repeat the one before exactly while the marker goes on moving. Files in "
        "which repeats are usual, as up-sampled ones, are left alone.",
        remedy="missing",
    ),
    Detector(
        id="bone-breaks",
        label="Broken bones",
        function=bone_breaks.bone_breaks,
        params=bone_breaks.BoneBreaksParams,
        help="Markers that for some frames are at another distance from their neighbours than "
        "otherwise, and go there or come back in a jump.",
        remedy="missing",
    ),
    Detector(
        id="far",
        label="Far from the body",
        function=far.far,
        params=far.FarParams,
        help="Points much further from the body than its markers are, and than they usually are.",
        remedy="missing",
    ),
    Detector(
        id="reflections",
        label="Coinciding points",
        function=reflections.reflections,
        params=reflections.ReflectionsParams,
        help="Two points in the same place that are apart otherwise: one is a reflection, or was "
        "labelled twice.",
        remedy="missing",
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


def remedy(run: BadRun) -> Remedy:
    """Return what a bad run calls for; samples that belong to no other marker are set aside."""
    return "missing" if run.other is None else detector(run.kind).remedy


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
