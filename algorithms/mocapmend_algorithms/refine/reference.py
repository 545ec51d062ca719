"""A recording of the truth, sampled where it is compared."""

from dataclasses import dataclass

import numpy as np

from mocapmend_algorithms.arrays import BoolArray, FloatArray
from mocapmend_algorithms.recording import Recording
from mocapmend_algorithms.refine.preparing import RATE, RefineError, bridge_gaps, labels_places
from mocapmend_algorithms.refine.profile import Profile, root_track


@dataclass(frozen=True, eq=False)
class Reference:
    """The outputs of a profile as a better system has recorded them.

    Attributes
    ----------
    points : ndarray, shape (frames, outputs, 3)
        In mm, in the recording's own axes; gaps are bridged.
    missing : ndarray of bool, shape (frames, outputs)
        Where.
    rate : float
        Frames per second (Hz).
    root : tuple of int
        Of the outputs.
    """

    points: FloatArray
    missing: BoolArray
    rate: float
    root: tuple[int, ...]

    @classmethod
    def of(cls, recording: Recording, profile: Profile) -> "Reference":
        """Take the outputs out of a recording.

        Raises
        ------
        RefineError
            If some are not among its labels, or it has fewer than two frames.
        """
        places = labels_places(recording.labels, profile.outputs, profile.name)
        if recording.frames < 2:
            raise RefineError("the reference has fewer than two frames")
        points = recording.points[:, places] * recording.mm
        missing = ~recording.present[:, places]
        points[:, missing.sum(axis=0) > recording.frames - 2] = 0.0
        bridge_gaps(points)
        return cls(points, missing, recording.rate, profile.output_root)

    @property
    def seconds(self) -> float:
        """Of the last frame, the first being at 0."""
        return (len(self.points) - 1) / self.rate

    @property
    def frames(self) -> int:
        """Frames at 60 per second that lie within."""
        return int(self.seconds * RATE) + 1

    def at(self, times: FloatArray) -> FloatArray:
        """Sample on natural cubic splines.

        Parameters
        ----------
        times : ndarray, shape (n,)
            Seconds from its first frame; the ends hold beyond.

        Returns
        -------
        ndarray, shape (n, outputs, 3)
            In mm relative to the root; NaN beside samples that are missing, and everywhere in
            frames in which the root is not seen.
        """
        from scipy.interpolate import CubicSpline

        place = np.clip(times * self.rate, 0, len(self.points) - 1)
        spline = CubicSpline(np.arange(len(self.points)), self.points, bc_type="natural")
        sampled: FloatArray = spline(place)
        low, high = np.floor(place).astype(np.int64), np.ceil(place).astype(np.int64)
        sampled[self.missing[low] | self.missing[high]] = np.nan
        relative: FloatArray = sampled - root_track(sampled, self.root)
        return relative
