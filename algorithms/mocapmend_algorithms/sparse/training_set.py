"""Motion to learn from, of other recordings, and its file.

A training set is what the sparse methods learn from beside the recording itself: complete frames of
several recordings with one set of markers, and dictionaries that were trained on them. Its file is
a NumPy archive (npz) without pickled objects.
"""

import io
import json
from collections.abc import Collection, Mapping, Sequence
from dataclasses import dataclass, field
from pathlib import Path
from typing import Any, get_args

import numpy as np

from mocapmend_algorithms.arrays import FloatArray, IntArray
from mocapmend_algorithms.gaps import runs
from mocapmend_algorithms.names import without_subject
from mocapmend_algorithms.recording import Recording, UpAxis
from mocapmend_algorithms.zip_arrays import ArchiveError, ZipArrays, write_arrays

FORMAT = 1
FREE_BYTES = 32 << 20
"""What a training set may need in single precision however small its file is."""
BELIEVABLE_RATIO = 20
LARGEST_HEAD = 1 << 20
LONGEST_QUOTE = 20
SAME_FRAME = 1e-6
DAMAGED = (
    ArchiveError, OSError, ValueError, KeyError, TypeError, AttributeError, OverflowError,
    RecursionError,
)  # fmt: skip
"""What comes of a file whose content is not what it should be."""


class TrainingSetError(ValueError):
    """A training set cannot be used; the message says why, in words a user understands."""


@dataclass(frozen=True, eq=False)
class TrainingSet:
    """Complete frames of recordings with the same markers.

    Attributes
    ----------
    labels : tuple of str, length markers
        Without the prefix of a subject.
    rate : float
        Frames per second (Hz).
    poses : ndarray, shape (frames, markers, 3)
        Coordinates in mm, finite; the recordings one after the other.
    lengths : tuple of int
        Frames of each recording.
    up : str
        The axis that points up, as "+z".
    about : str
        What it was made from, for people.
    atoms : mapping of str to ndarray, shape (rows, atoms)
        Trained dictionaries by their name.
    settings : mapping
        How the dictionaries were trained.
    """

    labels: tuple[str, ...]
    rate: float
    poses: FloatArray
    lengths: tuple[int, ...]
    up: UpAxis = "+z"
    about: str = ""
    atoms: Mapping[str, FloatArray] = field(default_factory=dict)
    settings: Mapping[str, Any] = field(default_factory=dict)

    def motions(self, up: UpAxis, rate: float | None = None) -> list[FloatArray]:
        """Return the frames of each recording, shape (frames, markers, 3), in mm.

        Parameters
        ----------
        up : str
            The axis that is to point up; where the set has another, all is turned.
        rate : float, optional
            Frames per second (Hz); by default those of the set.
        """
        turned = self.poses @ turn_up(self.up, up).T
        motions = np.split(turned, np.cumsum(self.lengths)[:-1])
        return [_sampled(motion, self.rate, rate or self.rate) for motion in motions]

    def places_of(self, labels: Sequence[str]) -> IntArray:
        """Find the markers of a recording in this set.

        Parameters
        ----------
        labels : sequence of str
            Of the recording; case and subject prefixes do not matter.

        Returns
        -------
        ndarray of int, shape (markers of this set,)
            The recording's marker for each of this set's.

        Raises
        ------
        TrainingSetError
            If the recording lacks some of them, or has one twice.
        """
        bare = [without_subject(label).upper() for label in labels]
        wanted = [label.upper() for label in self.labels]
        lacking = [label for label in self.labels if label.upper() not in bare]
        if lacking:
            some = ", ".join(lacking[:5]) + (" ..." if len(lacking) > 5 else "")
            raise TrainingSetError(
                f"the training set is of other markers: {len(lacking)} of its {len(wanted)} are "
                f"not in this recording ({some})"
            )
        twice = [label for label in self.labels if bare.count(label.upper()) > 1]
        if twice:
            raise TrainingSetError(
                f"the recording has more than one marker {twice[0]}: a training set is for one "
                "subject"
            )
        return np.array([bare.index(label) for label in wanted], dtype=np.int64)


def gather(
    recordings: Sequence[Recording],
    about: str = "",
    rate: float | None = None,
    markers: Collection[str] = (),
) -> TrainingSet:
    """Make a training set from recordings.

    Parameters
    ----------
    recordings : sequence of Recording
        With the same markers, in any order and unit. Only frames that show all markers are taken.
        Those in which another axis points up than in the first are turned.
    about : str
        What they are, for people.
    rate : float, optional
        Frames per second (Hz) of the set; by default that of the recordings, which must be the
        same then. Recordings of another rate are sampled anew on cubic splines; where theirs is a
        multiple of it, that takes every so many frames as they are.
    markers : collection of str
        Labels of those to take, without the prefix of a subject; by default all but fragments of
        trajectories, which are named *... .

    Returns
    -------
    TrainingSet
        Those of the markers that all recordings have, in the order of the first.

    Raises
    ------
    TrainingSetError
        If there is no recording, no common marker, no complete frame, if a recording lacks one of
        the given markers, or if rates differ and none is given.
    """
    if not recordings:
        raise TrainingSetError("there is no recording to learn from")
    first = recordings[0]
    common_rate = first.rate if rate is None else rate
    names = [[without_subject(label) for label in recording.labels] for recording in recordings]
    common = [name for name in names[0] if all(own.count(name) == 1 for own in names)]
    lacking = sorted(set(markers).difference(common))
    if lacking:
        raise TrainingSetError(f"not every recording has one marker {lacking[0]!r}")
    common = [name for name in common if name in markers or not (markers or name[:1] == "*")]
    if not common:
        raise TrainingSetError("the recordings have no marker in common")
    poses: list[FloatArray] = []
    for recording, own in zip(recordings, names, strict=True):
        if rate is None and recording.rate != first.rate:
            raise TrainingSetError(
                f"the recordings have different frame rates: {first.rate:g} and "
                f"{recording.rate:g} Hz"
            )
        points = recording.points[:, [own.index(name) for name in common]] * recording.mm
        if recording.up != first.up:
            points = points @ turn_up(recording.up, first.up).T
        seen = np.asarray(~np.isnan(points).any(axis=(1, 2)))
        poses += [_sampled(points[a:b], recording.rate, common_rate) for a, b in runs(seen)]
    if not poses:
        raise TrainingSetError("no frame of the recordings shows all their common markers")
    return TrainingSet(
        tuple(common),
        common_rate,
        np.concatenate(poses),
        tuple(len(part) for part in poses),
        first.up,
        about,
    )


@np.errstate(over="ignore")
def encode_training_set(training: TrainingSet) -> bytes:
    """Return the file of a training set; coordinates and weights have single precision there.

    The same training set gives the same bytes.
    """
    head = {
        "format": FORMAT,
        "labels": list(training.labels),
        "rate": training.rate,
        "lengths": list(training.lengths),
        "up": training.up,
        "about": training.about,
        "settings": dict(training.settings),
    }
    arrays = {"head": np.array(json.dumps(head)), "poses": training.poses.astype(np.float32)}
    arrays |= {f"atoms {name}": atoms.astype(np.float32) for name, atoms in training.atoms.items()}
    stream = io.BytesIO()
    write_arrays(stream, arrays, compress=True)
    return stream.getvalue()


def write_training_set(training: TrainingSet, path: Path) -> None:
    """Write a training set; see `encode_training_set`.

    Raises
    ------
    OSError
        If it cannot be written.
    """
    path.write_bytes(encode_training_set(training))


def read_training_set(path: Path) -> TrainingSet:
    """Read a training set.

    Nothing is allocated that the size of the file does not justify.

    Raises
    ------
    TrainingSetError
        If there is no such file, or it is not a training set.
    """
    try:
        # Opening a pipe or a device could wait for ever.
        if path.exists() and not path.is_file():
            raise TrainingSetError("this is not a file")
        with path.open("rb", buffering=0) as stream:
            return _read(ZipArrays(stream), path.stat().st_size)
    except FileNotFoundError:
        raise TrainingSetError("there is no such training set") from None
    except PermissionError:
        raise TrainingSetError("this training set may not be read") from None
    except TrainingSetError:
        raise
    except DAMAGED as error:
        raise TrainingSetError(
            "this is not a training set of mocapmend, or it is damaged"
        ) from error


def _read(arrays: ZipArrays, size: int) -> TrainingSet:
    if arrays.bytes > max(FREE_BYTES, BELIEVABLE_RATIO * size):
        raise TrainingSetError("the training set would grow beyond what is believable")
    raw = arrays.read("head")
    if raw.nbytes > LARGEST_HEAD:
        raise TrainingSetError("the head of the training set is too long")
    head = json.loads(str(raw))
    training = TrainingSet(
        tuple(map(str, head["labels"])),
        float(head["rate"]),
        _numbers(arrays, "poses"),
        tuple(map(int, head["lengths"])),
        head["up"],
        str(head["about"]),
        {
            name.removeprefix("atoms "): _numbers(arrays, name)
            for name in arrays.names
            if name.startswith("atoms ")
        },
        dict(head["settings"]),
    )
    _check(training, head["format"])
    return training


def _numbers(arrays: ZipArrays, name: str) -> FloatArray:
    array = arrays.read(name)
    if array.dtype != np.float32:
        raise TrainingSetError(f"the training set has {array.dtype} in “{name}”, not float32")
    return np.asarray(array, dtype=np.float64)


def _check(training: TrainingSet, version: object) -> None:
    if version != FORMAT:
        raise TrainingSetError(f"the training set has format {_quote(version)}, not {FORMAT}")
    if training.up not in get_args(UpAxis):
        raise TrainingSetError(f"the training set says that {_quote(training.up)} points up")
    shape = (sum(training.lengths), len(training.labels), 3)
    if training.poses.shape != shape or min(training.lengths, default=0) < 1:
        raise TrainingSetError("the training set contradicts itself: its frames are not as listed")
    arrays = [training.poses, *training.atoms.values()]
    if any(atoms.ndim != 2 for atoms in training.atoms.values()):
        raise TrainingSetError("the training set has a dictionary that is no table")
    if not all(np.isfinite(a).all() for a in arrays) or not 0 < training.rate < np.inf:
        raise TrainingSetError("the training set has values that are no numbers")


def _quote(value: object) -> str:
    return str(value)[:LONGEST_QUOTE]


def _sampled(points: FloatArray, own: float, wanted: float) -> FloatArray:
    """Sample complete frames, shape (frames, markers, 3), at another rate (Hz)."""
    if own == wanted or len(points) < 2:
        return points
    from scipy.interpolate import CubicSpline

    seconds = np.arange(len(points)) / own
    count = int(seconds[-1] * wanted + SAME_FRAME) + 1
    spline = CubicSpline(seconds, points, axis=0)
    sampled: FloatArray = spline(np.minimum(np.arange(count) / wanted, seconds[-1]))
    return sampled


def up_vector(up: UpAxis) -> FloatArray:
    """Return the unit vector that points up, shape (3,)."""
    vector = np.zeros(3)
    vector["xyz".index(up[1])] = 1.0 if up[0] == "+" else -1.0
    return vector


def turn_up(start: UpAxis, stop: UpAxis) -> FloatArray:
    """Return the smallest rotation that turns one upward axis into another."""
    a, b = up_vector(start), up_vector(stop)
    cosine = float(a @ b)
    if cosine < 0:
        aside = np.roll(np.abs(a), 1)
        return 2 * np.outer(aside, aside) - np.eye(3)
    cross = np.cross(a, b)
    x, y, z = cross
    skew = np.array([[0, -z, y], [z, 0, -x], [-y, x, 0]])
    rotation: FloatArray = np.eye(3) + skew + skew @ skew / (1 + cosine)
    return rotation
