"""Paired recordings of UI-PRMD, packed in one NumPy archive.

Vakanski et al., "A Data Set of Human Body Movements for Physical Rehabilitation Exercises", Data
3(1), 2018. The archive holds, for each repetition, the Kinect's 22 joints at 30 Hz and Plug-in
Gait's 39 markers at 100 Hz as second differences in 0.1 mm, and how the two were synchronised.
"""

from pathlib import Path
from typing import Any

import numpy as np
from numpy.typing import NDArray

from mocapmend.errors import MocapmendError
from mocapmend.files.opening import open_file
from mocapmend_algorithms.arrays import FloatArray
from mocapmend_algorithms.recording import Recording, UpAxis
from mocapmend_algorithms.refine.preparing import RefineError
from mocapmend_algorithms.refine.profile import Profile
from mocapmend_algorithms.refine.train.pairs import Pair, make_pair
from mocapmend_algorithms.zip_arrays import ArchiveError, ZipArrays

PROFILE = "kinect22-pig39"
KINECT_RATE, VICON_RATE = 30.0, 100.0
KINECT_UP: UpAxis = "+y"
VICON_UP: UpAxis = "+z"
PER_MM = 10.0
ARRAYS = ("keys", "nk", "nv", "K0", "V0", "Kb0", "Kb1", "Vb0", "Vb1", "lag_s", "R", "use")


def is_packed(path: Path) -> bool:
    """Say whether a file is such an archive."""
    try:
        with open_file(path) as (stream, _):
            arrays = ZipArrays(stream)
            return all(name in arrays for name in ARRAYS)
    except (ArchiveError, OSError, MocapmendError):
        return False


def read_packed(path: Path, profile: Profile) -> list[Pair]:
    """Read the repetitions that are marked as usable, in the order of the file.

    Vicon's axes are those of the Kinect after the mean rotation of each performer's repetitions.

    Raises
    ------
    MocapmendError
        If the file is damaged, or the profile is for other joints.
    """
    if profile.id != PROFILE:
        raise MocapmendError(
            f"These pairs are for the profile {PROFILE}.", str(path), "Choose that one."
        )
    try:
        with open_file(path) as (stream, _):
            arrays = ZipArrays(stream)
            packed = {name: arrays.read(name) for name in ARRAYS}
        return _pairs(packed, profile)
    except (ArchiveError, OSError, ValueError, IndexError, RefineError) as error:
        raise MocapmendError(
            f"The pairs cannot be read: {error}", str(path), "Choose another file."
        ) from error


def _pairs(packed: dict[str, NDArray[Any]], profile: Profile) -> list[Pair]:
    use = packed["use"].astype(bool)
    kinect = _decoded(packed["Kb0"], packed["Kb1"], packed["K0"], packed["nk"])
    vicon = _decoded(packed["Vb0"], packed["Vb1"], packed["V0"], packed["nv"])
    performers = packed["keys"][:, 2]
    rotations = {who: _mean(packed["R"][use & (performers == who)]) for who in set(performers[use])}
    pairs = []
    for index in np.flatnonzero(use):
        _, movement, performer, repetition = (int(number) for number in packed["keys"][index])
        markers = vicon[index]
        markers[~markers.any(axis=2)] = np.nan
        pairs.append(
            make_pair(
                Recording(kinect[index], profile.inputs, KINECT_RATE, up=KINECT_UP),
                Recording(markers, profile.outputs, VICON_RATE, up=VICON_UP),
                profile,
                (float(packed["lag_s"][index]), rotations[performer]),
                performer=performer,
                movement=movement,
                repetition=repetition,
            )
        )
    return pairs


def _decoded(
    low: NDArray[Any], high: NDArray[Any], first: NDArray[Any], counts: NDArray[Any]
) -> list[FloatArray]:
    """Undo the zig-zag coding of second differences; one array of (frames, points, 3) each, mm."""
    coded = low.astype(np.int64) + 256 * high.astype(np.int64)
    differences = ((coded >> 1) ^ -(coded & 1)).T
    taken = np.maximum(counts.astype(np.int64) - 1, 0)
    if taken.sum() != len(differences):
        raise ValueError("its arrays do not belong together")
    decoded = []
    for start, part in zip(first, np.split(differences, np.cumsum(taken)[:-1]), strict=True):
        steps = np.vstack([start, np.cumsum(part, axis=0)])
        decoded.append(np.cumsum(steps, axis=0).reshape(len(steps), -1, 3) / PER_MM)
    return decoded


def _mean(rotations: NDArray[Any]) -> FloatArray:
    from scipy.spatial.transform import Rotation

    mean: FloatArray = Rotation.from_matrix(rotations).mean().as_matrix()
    return mean
