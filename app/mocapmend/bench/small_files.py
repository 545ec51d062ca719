"""Small files of every format but C3D, to begin from when files are damaged on purpose."""

from collections.abc import Callable
from io import BytesIO

import numpy as np

FRAMES = 24
LABELS = ("LASI", "RASI", "LKNE", "RKNE", "C7")
RATE = 100.0


def _points() -> np.ndarray:
    """Return waves in mm, shape (frames, markers, 3), with a gap."""
    order = np.arange(len(LABELS))
    phase = 0.2 * np.arange(FRAMES)[:, None] + order
    waves = np.stack([400 * np.sin(phase), 30 * np.cos(phase), 900 + 40 * np.sin(2 * phase)], 2)
    waves[8:12, 2] = np.nan
    return waves


def _cells(values: np.ndarray) -> list[str]:
    """Write numbers, missing ones as nothing."""
    return ["" if np.isnan(value) else f"{value:.4f}" for value in values.reshape(-1)]


def _text(separator: str, rows: list[list[str]]) -> bytes:
    return "".join(separator.join(row) + "\r\n" for row in rows).encode()


def _spread(before: list[str], *between: str) -> list[str]:
    """Write each label above three columns."""
    return before + [cell for label in LABELS for cell in (label, *between)]


def trc() -> bytes:
    """Return a TRC file as of Cortex or OpenSim."""
    count = str(len(LABELS))
    keys = ["DataRate", "CameraRate", "NumFrames", "NumMarkers", "Units", "OrigDataRate",
            "OrigDataStartFrame", "OrigNumFrames"]  # fmt: skip
    values = ["100", "100", str(FRAMES), count, "mm", "100", "1", str(FRAMES)]
    axes = [f"{axis}{k}" for k in range(1, len(LABELS) + 1) for axis in "XYZ"]
    rows = [["PathFileType", "4", "(X/Y/Z)", "walk.trc"], keys, values]
    rows += [_spread(["Frame#", "Time"], "", ""), ["", "", *axes], []]
    rows += [[str(k + 1), f"{k / RATE:.3f}", *_cells(row)] for k, row in enumerate(_points())]
    return _text("\t", rows)


def qualisys() -> bytes:
    """Return the 3D data of Qualisys Track Manager."""
    rows = [
        ["NO_OF_FRAMES", str(FRAMES)],
        ["NO_OF_CAMERAS", "8"],
        ["NO_OF_MARKERS", str(len(LABELS))],
        ["FREQUENCY", "100"],
        ["NO_OF_ANALOG", "0"],
        ["ANALOG_FREQUENCY", "0"],
        ["DESCRIPTION", "--"],
        ["TIME_STAMP", "2020-01-01, 12:00:00.000", "1.000"],
        ["DATA_INCLUDED", "3D"],
        ["EVENT", "Foot Strike", "5", "0.04"],
        ["MARKER_NAMES", *LABELS],
    ]
    rows += [_cells(np.nan_to_num(row)) for row in _points()]
    return _text("\t", rows)


def motive() -> bytes:
    """Return a CSV file of OptiTrack Motive."""
    head = ["Format Version", "1.23", "Take Name", "walk", "Export Frame Rate", "100.000000",
            "Total Exported Frames", str(FRAMES), "Length Units", "Millimeters",
            "Coordinate Space", "Global"]  # fmt: skip
    columns = range(3 * len(LABELS))
    rows = [head, []]
    rows.append(["", "Type", *("Marker" for _ in columns)])
    rows.append(["", "Name", *(LABELS[k // 3] for k in columns)])
    rows.append(["", "ID", *(f'"{k // 3:032X}"' for k in columns)])
    rows.append(["", "", *("Position" for _ in columns)])
    rows.append(["Frame", "Time (Seconds)", *("XYZ"[k % 3] for k in columns)])
    rows += [[str(k), f"{k / RATE:.6f}", *_cells(row)] for k, row in enumerate(_points())]
    return _text(",", rows)


def nexus() -> bytes:
    """Return a text file of Vicon Nexus."""
    rows = [["Trajectories"], ["100"], _spread(["", ""], "", "")]
    rows.append(["Frame", "Sub Frame", *(["X", "Y", "Z"] * len(LABELS))])
    rows.append(["", "", *["mm"] * (3 * len(LABELS))])
    rows += [[str(k + 1), "0", *_cells(row)] for k, row in enumerate(_points())]
    return _text(",", rows)


def wide() -> bytes:
    """Return a CSV file with a column for each coordinate."""
    rows = [["frame", "time", *(f"{label}_{axis}" for label in LABELS for axis in "xyz")]]
    rows += [[str(k), f"{k / RATE:.3f}", *_cells(row)] for k, row in enumerate(_points())]
    return _text(",", rows)


def long() -> bytes:
    """Return a CSV file with a line for each sample."""
    rows = [["frame", "time", "marker", "x", "y", "z"]]
    for k, row in enumerate(_points()):
        rows += [
            [str(k), f"{k / RATE:.3f}", label, *_cells(value)]
            for label, value in zip(LABELS, row, strict=True)
        ]
    return _text(",", rows)


def bvh() -> bytes:
    """Return a BVH file with three joints."""
    head = """HIERARCHY
ROOT Hips
{
  OFFSET 0.0 0.0 0.0
  CHANNELS 6 Xposition Yposition Zposition Zrotation Xrotation Yrotation
  JOINT Chest
  {
    OFFSET 0.0 20.5 0.0
    CHANNELS 3 Zrotation Xrotation Yrotation
    End Site
    {
      OFFSET 0.0 18.25 1.5
    }
  }
  JOINT LeftUpLeg
  {
    OFFSET 9.1 -1.5 0.0
    CHANNELS 3 Zrotation Xrotation Yrotation
    End Site
    {
      OFFSET 0.0 -40.0 0.0
    }
  }
}
MOTION
"""
    frames = np.round(20 * np.sin(0.3 * np.arange(FRAMES)[:, None] + np.arange(12)), 4)
    lines = [" ".join(map(str, row)) for row in frames.tolist()]
    return (head + f"Frames: {FRAMES}\nFrame Time: 0.01\n" + "\n".join(lines) + "\n").encode()


def asf() -> bytes:
    """Return an Acclaim skeleton of two bones."""
    bones = "".join(
        f"  begin\n    id {k}\n    name {name}\n    direction {direction}\n    length {length}\n"
        f"    axis 0 0 {20 * k} XYZ\n    dof rx ry rz\n    limits (-160.0 20.0)\n"
        "           (-70.0 70.0)\n           (-60.0 70.0)\n  end\n"
        for k, name, direction, length in (
            (1, "lfemur", "0.34 -0.94 0", 7.4),
            (2, "ltibia", "0.34 -0.94 0", 7.5),
        )
    )
    return (
        "# skeleton\n:version 1.10\n:name walk\n:units\n  mass 1.0\n  length 0.45\n  angle deg\n"
        ":documentation\n  none\n:root\n  order TX TY TZ RX RY RZ\n  axis XYZ\n"
        "  position 0 0 0\n  orientation 0 0 0\n:bonedata\n" + bones + ":hierarchy\n  begin\n"
        "    root lfemur\n    lfemur ltibia\n  end\n"
    ).encode()


def amc() -> bytes:
    """Return a motion of that skeleton."""
    angles = np.round(20 * np.sin(0.3 * np.arange(FRAMES)[:, None] + np.arange(12)), 4).tolist()
    lines = ["#!OML:ASF walk.asf", ":FULLY-SPECIFIED", ":DEGREES"]
    for k, row in enumerate(angles, 1):
        parts = (("root", row[:6]), ("lfemur", row[6:9]), ("ltibia", row[9:]))
        lines += [str(k), *(f"{name} " + " ".join(map(str, part)) for name, part in parts)]
    return ("\n".join(lines) + "\n").encode()


def npz() -> bytes:
    """Return a numpy archive of joints."""
    file = BytesIO()
    np.savez(
        file,
        pos=np.nan_to_num(_points()).astype(np.float32),
        fps=np.float64(RATE),
        names=np.array(LABELS),
        parents=np.array([-1, 0, 1, 2, 3]),
    )
    return file.getvalue()


SMALL_FILES: tuple[tuple[str, str, Callable[[], bytes]], ...] = (
    ("TRC", ".trc", trc),
    ("TSV of Qualisys", ".tsv", qualisys),
    ("CSV of Motive", ".csv", motive),
    ("CSV of Nexus", ".csv", nexus),
    ("CSV, a column per coordinate", ".csv", wide),
    ("CSV, a line per sample", ".csv", long),
    ("BVH", ".bvh", bvh),
    ("ASF", ".asf", asf),
    ("AMC", ".amc", amc),
    ("NPZ", ".npz", npz),
)
"""Kind, suffix, and what makes the file."""

BESIDE: dict[str, tuple[tuple[str, Callable[[], bytes]], ...]] = {".amc": ((".asf", asf),)}
"""By suffix: files without which one of that suffix cannot be read."""
