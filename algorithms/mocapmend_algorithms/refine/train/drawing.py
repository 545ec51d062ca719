"""Drawing windows to learn from, each a little different every time."""

from collections.abc import Sequence
from dataclasses import dataclass

import numpy as np

from mocapmend_algorithms.arrays import BoolArray, FloatArray
from mocapmend_algorithms.refine.mirroring import Mirror
from mocapmend_algorithms.refine.preparing import bridge_gaps, headings, turned
from mocapmend_algorithms.refine.profile import Profile
from mocapmend_algorithms.refine.train.pairs import Pair
from mocapmend_algorithms.refine.windows import LENGTH


@dataclass(frozen=True)
class Changes:
    """How windows are changed at random, so that a network does not learn ten people by heart.

    Attributes
    ----------
    share : float
        Of the windows that are changed; the others are as they were recorded.
    scale : float
        Bodies are made larger or smaller by up to this share.
    turn : float
        Largest turn about the vertical in radians, beside the heading.
    offset : float
        Standard deviation in mm of an error that an input joint keeps through a window: sensors
        place the joints of each person differently.
    mirror : bool
        Whether half of the changed windows are seen in a mirror.
    hidden : float
        Probability that an input joint is missing for a while, and bridged.
    longest_hidden : int
        Frames that it is missing at most.
    """

    share: float = 0.5
    scale: float = 0.1
    turn: float = 0.1
    offset: float = 20.0
    mirror: bool = True
    hidden: float = 0.02
    longest_hidden: int = 30

    @property
    def mirrors(self) -> bool:
        """Whether any window is seen in a mirror."""
        return self.mirror and self.share > 0


NO_CHANGES = Changes(share=0.0)


@dataclass(frozen=True, eq=False)
class Drawn:
    """Windows of pairs.

    Attributes
    ----------
    joints : ndarray, shape (windows, LENGTH, inputs, 3)
        In mm, facing the same way.
    markers : ndarray, shape (windows, LENGTH, outputs, 3)
        NaN where missing, and behind the end of a pair that is shorter than a window.
    """

    joints: FloatArray
    markers: FloatArray


class Drawer:
    """Draws windows from pairs.

    Parameters
    ----------
    pairs : sequence of Pair
        At least one.
    profile : Profile
        What is learnt.
    changes : Changes
        How windows are changed.
    """

    def __init__(self, pairs: Sequence[Pair], profile: Profile, changes: Changes) -> None:
        self._pairs = pairs
        self._profile = profile
        self._changes = changes
        self._mirror = Mirror(profile)

    def round(self, rng: np.random.Generator) -> Drawn:
        """Draw as many windows as cover the pairs once, in random order, changed at random."""
        joints, markers = [], []
        for pair in self._pairs:
            spare = max(len(pair.joints) - LENGTH, 0)
            for _ in range(max(1, round(len(pair.joints) / LENGTH))):
                at = int(rng.integers(spare + 1)) + np.arange(LENGTH)
                inside = np.minimum(at, len(pair.joints) - 1)
                joints.append(pair.joints[inside])
                seen = pair.markers[inside].copy()
                seen[at >= len(pair.joints)] = np.nan
                markers.append(seen)
        order = rng.permutation(len(joints))
        drawn = Drawn(np.stack(joints)[order], np.stack(markers)[order])
        return self._changed(drawn, rng)

    def _changed(self, drawn: Drawn, rng: np.random.Generator) -> Drawn:
        changes, joints, markers = self._changes, drawn.joints, drawn.markers
        count = len(joints)
        changed = rng.random(count) < changes.share
        flip = changed & (rng.random(count) < 0.5)
        if changes.mirror and self._mirror.possible:
            joints[flip] = self._mirror.joints(joints[flip])
            markers[flip] = self._mirror.markers(markers[flip])
        alike = (changed * rng.uniform(-changes.scale, changes.scale, count))[:, None, None, None]
        joints, markers = joints * (1 + alike), markers * (1 + alike)
        offsets = rng.normal(0, changes.offset, (count, 1, *joints.shape[2:]))
        offsets[~changed] = 0.0
        offsets[:, :, list(self._profile.input_root)] = 0.0
        joints = joints + offsets
        hidden = changed[:, None] & (rng.random(joints.shape[::2]) < changes.hidden)
        hidden[:, list(self._profile.input_root)] = False
        self._hide(joints, hidden, rng)
        angles = headings(joints, self._profile)
        angles += changed * rng.uniform(-changes.turn, changes.turn, count)
        return Drawn(turned(joints, -angles), turned(markers, -angles))

    def _hide(self, joints: FloatArray, hidden: BoolArray, rng: np.random.Generator) -> None:
        for window, joint in zip(*np.nonzero(hidden), strict=True):
            length = int(rng.integers(1, self._changes.longest_hidden + 1))
            start = int(rng.integers(LENGTH - length + 1))
            track = joints[window][:, [joint]]
            track[start : start + length] = np.nan
            bridge_gaps(track)
            joints[window, :, joint] = track[:, 0]
