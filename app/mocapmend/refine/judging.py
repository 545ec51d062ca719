"""How far a refined recording is from a reference, as figures that a report and a window show."""

from dataclasses import dataclass

import numpy as np

from mocapmend.refine.profiles import profiles
from mocapmend_algorithms import Recording
from mocapmend_algorithms.refine.comparing import Comparison, compare
from mocapmend_algorithms.refine.measures import Errors
from mocapmend_algorithms.refine.preparing import (
    RATE,
    UP,
    RefineError,
    at_rate,
    bridge_gaps,
    labels_places,
)
from mocapmend_algorithms.refine.profile import Profile, root_track
from mocapmend_algorithms.sparse.training_set import turn_up


@dataclass(frozen=True)
class Judged:
    """Figures of a comparison with a reference.

    Attributes
    ----------
    reference : str
        Name of its file.
    lag : float
        Seconds by which the reference had to be shifted.
    refined, truth : Errors
        Lp, Lb and Ls of the outcome, and of the reference itself.
    rms : tuple of (str, float)
        Root mean square distance of each marker in mm, NaN where the reference has none.
    """

    reference: str
    lag: float
    refined: Errors
    truth: Errors
    rms: tuple[tuple[str, float], ...]

    @classmethod
    def of(cls, found: Comparison, profile: Profile, reference: str) -> "Judged":
        """Take the figures out of a comparison."""
        rms = tuple(zip(profile.outputs, found.rms.tolist(), strict=True))
        return cls(reference, found.alignment.seconds, found.errors, found.truth, rms)


def judge(refined: Recording, reference: Recording, profile_id: str, name: str) -> Judged | None:
    """Hold a refined recording against one that has all its markers.

    Parameters
    ----------
    refined : Recording
        As a network has made it; sampled at 60 frames per second here, relative to its own root.
    reference : Recording
        Of the same movement.
    profile_id : str
        Of the network.
    name : str
        Of the reference's file.

    Returns
    -------
    Judged or None
        None where the profile is not known, markers are not in both, or too little is common.
    """
    profile = profiles().get(profile_id)
    if profile is None:
        return None
    try:
        return Judged.of(compare(_poses(refined, profile), reference, profile), profile, name)
    except RefineError:
        return None


def _poses(recording: Recording, profile: Profile) -> np.ndarray:
    """Return the outputs of a profile as networks make them."""
    places = labels_places(recording.labels, profile.outputs, profile.name)
    points = recording.points[:, places] * recording.mm @ turn_up(recording.up, UP).T
    if len(points) < 2 or (np.count_nonzero(~np.isnan(points[..., 0]), axis=0) < 2).any():
        raise RefineError("the recording has fewer than two frames")
    bridge_gaps(points)
    poses = at_rate(points, recording.rate, RATE)
    return np.asarray(poses - root_track(poses, profile.output_root))
