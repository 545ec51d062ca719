"""One small recording in every format that is read, each with two gaps, and its repair."""

import hashlib
from pathlib import Path

import numpy as np
from c3d_synthetic import Synthetic, encode, walk
from joints_synthetic import Bone, Node, amc_text, asf_text, bvh_text
from kinect_samples import person, rows, with_states

from mocapmend import engine
from mocapmend.files import Source, read_recording
from mocapmend_algorithms import find_gaps, no_progress
from mocapmend_algorithms.fill.limits import Limits
from mocapmend_algorithms.fill.registry import METHODS

FRAMES = 40
LABELS = ["A", "B", "C", "D"]
SOURCES = ("c3d", "trc", "csv", "tsv", "txt", "npz", "bvh", "amc")
TARGETS = ("c3d", "trc", "csv", "long.csv", "npz")
NO_LIMITS = Limits(max_error_mm=float("inf"))


def digest(path: Path) -> str:
    """Return what tells whether two files are the same."""
    return hashlib.sha256(path.read_bytes()).hexdigest()


def trajectories() -> np.ndarray:
    """Return four markers with gaps at frames 10-14 of B and 20-29 of D."""
    points = walk(FRAMES, 4)
    points[10:15, 1] = np.nan
    points[20:30, 3] = np.nan
    return points


def write_sample(folder: Path, kind: str) -> Path:
    """Write the recording; the programs' own writers are not used."""
    path = folder / f"walk.{kind}"
    write = {"c3d": _c3d, "npz": _npz, "bvh": _bvh, "amc": _amc}.get(kind)
    if write is not None:
        write(path)
    else:
        path.write_text({"trc": _trc, "csv": _csv, "tsv": _qualisys, "txt": _kinect}[kind]())
    return path


def repair(path: Path, out: Path, method: str = "linear", gaps: slice = slice(None)) -> Source:
    """Fill gaps of a file in a new one, and return the file as it was read."""
    source = read_recording(path)
    changes = changes_in(source, method, gaps)
    engine.export(source, changes, out, False, False, no_progress)
    return source


def changes_in(source: Source, method: str = "linear", gaps: slice = slice(None)) -> engine.Changes:
    """Fill gaps of a recording, all by default."""
    found = [gap for gap in find_gaps(source.measured.present) if gap not in source.repaired]
    params = METHODS[method].params()
    result = engine.fill(source.measured, found[gaps], method, params, NO_LIMITS, no_progress)
    assert not result.unfilled
    return engine.changes_of(source, result, method, params)


def _c3d(path: Path) -> None:
    points = np.insert(trajectories(), 1, 7.0, axis=1)
    missing = np.isnan(points[..., 0])
    spec = Synthetic(
        np.where(missing[..., None], 0.0, points),
        fourth=np.where(missing, -1.0, 0.0),
        analog=np.arange(FRAMES * 2 * 3.0).reshape(FRAMES, 2, 3),
        first_frame=101,
        labels=["A", "Angle", "B", "C", "D"],
        parameters={"POINT:ANGLES": ["Angle"]},
        events=[("RHS", 1.25)],
    )
    path.write_bytes(encode(spec))


def _rows(separator: str, numbered: bool = True) -> list[str]:
    rows = []
    for i, frame in enumerate(trajectories().reshape(FRAMES, -1).tolist()):
        cells = [str(51 + i), f"{i / 50:.2f}"] if numbered else []
        cells += ["" if np.isnan(value) else repr(value) for value in frame]
        rows.append(separator.join(cells))
    return rows


def _trc() -> str:
    names = "\t".join(f"{label}\t\t" for label in LABELS)
    axes = "\t".join(f"X{i}\tY{i}\tZ{i}" for i in range(1, 5))
    return "\n".join([
        "PathFileType\t4\t(X/Y/Z)\twalk.trc",
        "DataRate\tCameraRate\tNumFrames\tNumMarkers\tUnits",
        f"50\t50\t{FRAMES}\t4\tcm",
        f"Frame#\tTime\t{names}",
        f"\t\t{axes}",
        *_rows("\t"),
        "",
    ])  # fmt: skip


def _csv() -> str:
    names = ",".join(f"{label}_{axis}" for label in LABELS for axis in "xyz")
    return "\n".join(
        ["# unit=in", "# up=-y", "# rate_hz=50", f"frame,time,{names}", *_rows(","), ""]
    )


def _qualisys() -> str:
    return "\n".join([
        f"NO_OF_FRAMES\t{FRAMES}",
        "NO_OF_MARKERS\t4",
        "FREQUENCY\t50",
        "DATA_INCLUDED\t3D",
        "EVENT\tToe off\t3\t0.04",
        "EVENT\tHeel strike\t17\t0.32",
        "MARKER_NAMES\t" + "\t".join(LABELS),
        *_rows("\t", numbered=False),
        "",
    ])  # fmt: skip


def _kinect() -> str:
    states = np.full((FRAMES, 25), 2.0)
    states[10:15, 6] = 0
    states[20:30, 14] = 0
    return rows(with_states(person(FRAMES), states))


def _npz(path: Path) -> None:
    arrays = {"fps": 59.94, "names": LABELS, "units": "m", "up": "y", "bones": [[0, 1], [1, 3]]}
    np.savez(path, pos=trajectories() / 1000, **arrays)


def _bvh(path: Path) -> None:
    turns = ("Zrotation", "Xrotation", "Yrotation")
    arm = [
        Node("Hips", -1, (0.0, 95.0, 0.0), ("Xposition", "Yposition", "Zposition", *turns)),
        Node("Arm", 0, (0.0, 50.0, 0.0), turns),
        Node("", 1, (60.0, 0.0, 0.0), end=True),
    ]
    values = np.random.default_rng(1).normal(0, 2, (FRAMES, 9)).cumsum(axis=0) + 80
    values[10:15, 6] = np.nan
    values[20:30, 7] = np.nan
    path.write_text(bvh_text(arm, values))


def _amc(path: Path) -> None:
    leg = [
        Bone("femur", -1, (0.0, -1.0, 0.0), 7.0, dof=("rx", "ry", "rz")),
        Bone("back", -1, (0.0, 1.0, 0.0), 5.0, dof=("rz", "rx")),
    ]
    rng = np.random.default_rng(2)
    root, femur, back = (rng.normal(0, 2, (FRAMES, n)).cumsum(axis=0) for n in (6, 3, 2))
    femur[10:15, 0] = np.nan
    back[20:30, 1] = np.nan
    path.with_suffix(".asf").write_text(asf_text(leg))
    path.write_text(amc_text(leg, root, [femur, back], first=7))
