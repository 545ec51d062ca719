"""The motions of `bench paper`: which trials teach, which are repaired, and what they lose."""

from collections.abc import Iterator, Mapping, Sequence
from dataclasses import dataclass, replace
from pathlib import Path

import numpy as np

from mocapmend.errors import MocapmendError
from mocapmend.files import read_recording
from mocapmend_algorithms import Gap, Recording
from mocapmend_algorithms.arrays import FloatArray, IntArray
from mocapmend_algorithms.sparse.body import PARTS, Body, find_body
from mocapmend_algorithms.sparse.bone_space import preprocess, restore

FOLDER = "cmu_joints"
SNR_DB = 60.0
LOST_SHARE = 0.4
SEED = 9
MM_PER_CM = 10.0
LEAST_FRAMES = 50
"""Of a recording: windows take up to 41."""


@dataclass(frozen=True)
class MotionSet:
    """Trials of one kind of motion.

    Attributes
    ----------
    trials : tuple of str
        All of them.
    tests : tuple of str
        Those that are repaired; the others teach.
    validation : tuple of str
        Those that settings were chosen on, with the tests left out altogether.
    """

    trials: tuple[str, ...]
    tests: tuple[str, ...]
    validation: tuple[str, ...]


MOTIONS: Mapping[str, MotionSet] = {
    "run": MotionSet(
        tuple(f"09_{n:02}" for n in (2, 3, 4, 5, 6, 8, 9, 10, 11)),
        ("09_05", "09_10"),
        ("09_03", "09_11"),
    ),
    "basketball": MotionSet(
        tuple(f"06_{n:02}" for n in (3, 4, 5, 6, 7, 8, 9, 10, 11, 13, 14, 15)),
        ("06_04", "06_09"),
        ("06_06", "06_15"),
    ),
    "punch": MotionSet(("02_05_first1200",), (), ()),
}
PUNCH_PIECES = ((0, 600), (600, 800), (800, 1000), (1000, 1200))
"""Frames of the one trial at hand: the first piece teaches, the second validates, the rest test."""
REGIONS: Mapping[int, Mapping[str, tuple[str, ...]]] = {
    3: {
        "left arm": ("lradius", "lwrist", "lhumerus"),
        "right arm": ("rradius", "rwrist", "rhumerus"),
        "left leg": ("lfemur", "ltibia", "lfoot"),
        "right leg": ("rfemur", "rtibia", "rfoot"),
    },
    6: {
        "left arm": ("lhumerus", "lradius", "lwrist", "lhand", "lfingers", "lthumb"),
        "right arm": ("rhumerus", "rradius", "rwrist", "rhand", "rfingers", "rthumb"),
        "left leg": ("root", "lhipjoint", "lfemur", "ltibia", "lfoot", "ltoes"),
        "right leg": ("root", "rhipjoint", "rfemur", "rtibia", "rfoot", "rtoes"),
    },
}
"""Points that are missing together: neighbours, as in W18's figure 4, which cannot be read off."""


@dataclass(frozen=True, eq=False)
class Trial:
    """A recording to be repaired and those that teach.

    Attributes
    ----------
    motion, name : str
        What it is.
    truth : Recording
        Complete.
    teachers : tuple of Recording
        Complete trials of the motion.
    """

    motion: str
    name: str
    truth: Recording
    teachers: tuple[Recording, ...]


@dataclass(frozen=True, eq=False)
class Case:
    """A trial that has lost some points.

    Attributes
    ----------
    trial : Trial
        The trial.
    region : str
        Where.
    lost : ndarray of int
        The markers, ascending.
    start, stop : int
        The frames.
    recording : Recording
        What is left, with noise or without.
    body : Body
        Its bones, measured on what is left.
    """

    trial: Trial
    region: str
    lost: IntArray
    start: int
    stop: int
    recording: Recording
    body: Body

    @property
    def gaps(self) -> list[Gap]:
        """The gaps to fill, in the order of the markers."""
        return [Gap(marker, self.start, self.stop) for marker in self.lost.tolist()]


def read_trials(motion: str, folder: Path, test: Path | None, *, validate: bool) -> list[Trial]:
    """Read the trials of a motion.

    Parameters
    ----------
    motion : str
        A key of `MOTIONS`.
    folder : Path
        Of the shared recordings.
    test : Path, optional
        The one recording to be repaired; all others of the motion teach.
    validate : bool
        Whether the validation trials are repaired, and the tests are not looked at.

    Raises
    ------
    MocapmendError
        If a file cannot be read, is not of the 31 joints, or is too short, or if nothing is left
        to learn from.
    """
    if motion == "punch" and test is None:
        return _pieces(folder, validate=validate)
    known = MOTIONS[motion]
    tests = known.validation if validate else known.tests
    aside = {*tests, *(known.tests if validate else ())} if test is None else {test.stem}
    teachers = tuple(read_joints(folder, name) for name in known.trials if name not in aside)
    if not teachers:
        raise MocapmendError(
            f"No other trial of the motion {motion} is there to learn from.",
            str(test),
            "Give a recording that is not among the shared ones.",
        )
    if test is not None:
        return [Trial(motion, test.stem, _joints(test), teachers)]
    return [Trial(motion, name, read_joints(folder, name), teachers) for name in tests]


def _pieces(folder: Path, *, validate: bool) -> list[Trial]:
    (name,) = MOTIONS["punch"].trials
    whole = read_joints(folder, name)
    parts = [whole.with_points(whole.points[a:b].copy()) for a, b in PUNCH_PIECES]
    chosen = [1] if validate else [2, 3]
    return [
        Trial(
            "punch",
            f"02_05 frames {PUNCH_PIECES[at][0] + 1}-{PUNCH_PIECES[at][1]}",
            parts[at],
            (parts[0],),
        )
        for at in chosen
    ]


def read_joints(folder: Path, name: str) -> Recording:
    """Read a trial of the shared recordings by its name; see `read_trials`."""
    return _joints(folder / FOLDER / f"{name}.npz")


def _joints(path: Path) -> Recording:
    """Read a recording of the 31 joints in centimetres, in the order of W18's parts."""
    recording = read_recording(path).recording
    names = [label.rpartition(":")[2].strip().lower() for label in recording.labels]
    wanted = [name for part in PARTS for name in part]
    if any(names.count(name) != 1 for name in wanted) or not recording.present.all():
        raise MocapmendError(
            "This is not a complete recording of the 31 joints of the CMU skeleton.",
            str(path),
            "Give one of those that the folder cmu_joints has.",
        )
    if recording.frames < LEAST_FRAMES:
        raise MocapmendError(
            f"This recording is too short: it has {recording.frames} frames.",
            str(path),
            f"Give one of at least {LEAST_FRAMES} frames.",
        )
    points = recording.points[:, [names.index(name) for name in wanted]] * recording.mm / MM_PER_CM
    return replace(recording, points=points, labels=tuple(wanted), unit="cm")


def cases(trial: Trial, points: int, share: float, *, noise: bool) -> Iterator[Case]:
    """Lose points of a trial in one run of frames in its middle, region by region."""
    truth = trial.truth
    body = find_body(truth, truth.present)
    noisy = with_noise(truth.points, body) if noise else truth.points
    length = round(share * truth.frames)
    start = (truth.frames - length) // 2
    for region, names in REGIONS[points].items():
        lost = np.sort([truth.labels.index(name) for name in names])
        left = noisy.copy()
        left[start : start + length, lost] = np.nan
        recording = truth.with_points(left)
        yield Case(
            trial,
            region,
            lost,
            start,
            start + length,
            recording,
            find_body(recording, recording.present),
        )


def with_noise(points: FloatArray, body: Body) -> FloatArray:
    """Add noise of 60 dB to the signed squares of the bones' differences, and go back once.

    W18 adds it to the preprocessed data; so that every method gets the same, it is taken back to
    coordinates here. A component near zero moves by the root of its noise: half a centimetre in
    the mean.
    """
    processed = preprocess(points * MM_PER_CM, body, body.edge_lengths)
    squares = processed.squares
    noise = np.random.default_rng(SEED).normal(size=squares.shape)
    size = np.sqrt(np.mean(squares**2) / np.mean(noise**2)) * 10 ** (-SNR_DB / 20)
    return restore(replace(processed, squares=squares + size * noise), body) / MM_PER_CM


def rmse(case: Case, found: FloatArray) -> float:
    """Return the 3-D error over the lost points in cm; NaN where one is not found."""
    truth = case.trial.truth.points[case.start : case.stop][:, case.lost]
    return float(np.sqrt(np.mean(np.sum((found - truth) ** 2, axis=2))))


def bone_rmse(case: Case, found: FloatArray, *, everywhere: bool = False) -> float:
    """Return the error of bone lengths in cm, in the frames of the gap.

    Parameters
    ----------
    case : Case
        The case.
    found : ndarray, shape (frames of the gap, lost, 3)
        What a method says.
    everywhere : bool
        Over all bones, as W18's n_L; otherwise over those that touch a lost point.

    Returns
    -------
    float
        Against the lengths of the truth. W18's eq. 34 takes squared lengths for lengths.
    """
    edges = case.body.edges
    if not everywhere:
        edges = edges[np.isin(edges, case.lost).any(axis=1)]
    points = case.recording.points[case.start : case.stop].copy()
    points[:, case.lost] = found
    truth = case.trial.truth.points
    wanted = np.median(_lengths(truth, edges), axis=0)
    return float(np.sqrt(np.mean((_lengths(points, edges) - wanted) ** 2)))


def _lengths(points: FloatArray, edges: IntArray) -> FloatArray:
    lengths: FloatArray = np.linalg.norm(points[:, edges[:, 0]] - points[:, edges[:, 1]], axis=2)
    return lengths


def spectrum(points: FloatArray, body: Body, most: int) -> tuple[Sequence[float], Sequence[float]]:
    """Return the first normalised singular values of coordinates X and of F2 (W18, figure 3)."""
    squares = preprocess(points * MM_PER_CM, body, body.edge_lengths).squares
    both = []
    for rows in (points, squares):
        values = np.linalg.svd(rows.reshape(len(rows), -1), compute_uv=False)
        both.append((values / values.sum())[:most].tolist())
    return both[0], both[1]
