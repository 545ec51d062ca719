"""Whether a recording has what a network takes, said before anything is computed."""

from dataclasses import dataclass

import numpy as np

from mocapmend.refine.profiles import profiles
from mocapmend_algorithms import Recording
from mocapmend_algorithms.names import without_subject
from mocapmend_algorithms.refine.profile import Profile

LEAST_SAMPLES = 2


@dataclass(frozen=True)
class Misfit:
    """Why a recording cannot be refined by networks of a profile.

    Attributes
    ----------
    lacking, twice, unseen : tuple of str
        Joints of the profile that the recording has no label for, more than one, and one without
        samples.
    own : str
        What the recording does fit: the name of another profile, "" if of none.
    """

    lacking: tuple[str, ...] = ()
    twice: tuple[str, ...] = ()
    unseen: tuple[str, ...] = ()
    own: str = ""

    def __bool__(self) -> bool:
        return bool(self.lacking or self.twice or self.unseen)


def misfit(recording: Recording, profile: Profile) -> Misfit:
    """Say which joints are in the way, if some are; case and subjects of labels do not matter."""
    labels = [without_subject(label).upper() for label in recording.labels]
    lacking = tuple(name for name in profile.inputs if name.upper() not in labels)
    twice = tuple(name for name in profile.inputs if labels.count(name.upper()) > 1)
    counts = np.count_nonzero(recording.present, axis=0)
    unseen = tuple(
        name
        for name in profile.inputs
        if labels.count(name.upper()) == 1 and counts[labels.index(name.upper())] < LEAST_SAMPLES
    )
    others = (each for each in profiles().values() if each.id != profile.id)
    fitting = (each.name for each in others if {n.upper() for n in each.inputs} <= set(labels))
    return Misfit(lacking, twice, unseen, next(fitting, "") if lacking else "")
