"""The command line of the benchmark of the window, and its table."""

import argparse
import os
import sys
import tempfile
from collections.abc import Callable, Iterable
from dataclasses import dataclass, replace
from pathlib import Path

import numpy as np

from mocapmend.bench.arguments import add_size
from mocapmend.bench.gui.measure import measure
from mocapmend.bench.gui.rows import held_against, limited
from mocapmend.bench.gui.start import start_rows
from mocapmend.bench.synthetic import write_recording
from mocapmend.bench.table import Row, Table

MARKERS = 100
GAPS = 10_000
SCRUB_TARGET = 60.0
PAUSE_LIMIT_MS = 100.0
PAUSES = {
    "opening": "longest pause: showing a recording that was read",
    "filling": "longest pause: fill all gaps (cubic), scrubbing meanwhile",
    "undoing": "longest pause: undo and redo of all repairs, report following",
    "exporting": "longest pause: export of all repairs, scrubbing meanwhile",
    "reporting": "longest pause: HTML report, scrubbing meanwhile",
    "auto": "longest pause: fill all gaps (auto) of the bundled sprint, scrubbing meanwhile",
}
MEMORY = {
    "looking": "memory: open, 12 plots, scrub, preview, report",
    "edited": "memory: the same, and a repair with its report",
}


@dataclass(frozen=True)
class Trial:
    """What is measured: the file, how often, and the Python that has MNE."""

    path: Path
    runs: int
    mne: str


def add_arguments(parser: argparse.ArgumentParser) -> None:
    """Say what the benchmark takes."""
    add_size(parser)
    parser.add_argument(
        "--only", action="append", choices=PARTS, help="measure this part alone; may be repeated"
    )
    parser.add_argument(
        "--mne-python",
        default=sys.executable,
        metavar="PATH",
        help="a Python that has MNE-Qt-Browser and what mocapmend needs",
    )


def run(arguments: argparse.Namespace) -> Table:
    """Measure 100 markers with 10,000 gaps in a window of 1600 x 950."""
    frames = arguments.frames
    gaps = min(GAPS, frames // 10)
    if sys.platform == "linux" and not (
        os.environ.get("DISPLAY") or os.environ.get("WAYLAND_DISPLAY")
    ):
        os.environ.setdefault("QT_QPA_PLATFORM", "offscreen")
    table = Table("")
    with tempfile.TemporaryDirectory(prefix="mocapmend-bench-") as folder:
        path = Path(folder) / "large.c3d"
        write_recording(path, frames=frames, markers=MARKERS, gaps=gaps)
        trial = Trial(path, arguments.runs, arguments.mne_python)
        for name, rows in PARTS.items():
            if not arguments.only or name in arguments.only:
                _say(name)
                table.rows += rows(trial)
    platform = os.environ.get("QT_QPA_PLATFORM", "the desktop's")
    return Table(
        f"Window, {frames} frames x {MARKERS} markers, {gaps} gaps, on Qt's {platform} platform",
        table.rows,
    )


def _say(text: str) -> None:
    sys.stderr.write(f"bench gui: {text}\n")


def _start(trial: Trial) -> Iterable[Row]:
    return start_rows(trial.runs)


def _plots(trial: Trial) -> Iterable[Row]:
    """Scrub, pan and zoom, in turn with plots of plain pyqtgraph of the same size."""
    ours, plain = [], []
    for _ in range(trial.runs):
        ours.append(measure("plots", trial.path))
        size = (ours[-1]["width"], ours[-1]["height"])
        plain.append(measure("plain", trial.path, *size))
    scrubbed = float(np.median([each["scrub"] for each in ours]))
    yield Row(
        "scrub: 3D + 12 plots + timeline", scrubbed, "steps/s", "60 steps/s",
        scrubbed / SCRUB_TARGET, ">= 1",
    )  # fmt: skip
    yield from held_against(
        "12 linked pyqtgraph plots",
        "steps/s",
        (
            ("12 plots + timeline: pan over 40,000 frames", "pan", ">= 4"),
            ("12 plots + timeline: zoom between 1,000 and 100,000 frames", "zoom", ">= 4"),
        ),
        ours,
        plain,
    )


def _mne(trial: Trial) -> Iterable[Row]:
    """Scroll through 10 s at a time, in turn with MNE-Qt-Browser."""
    ours, theirs = [], []
    for _ in range(trial.runs):
        found = measure("mne", trial.path, python=trial.mne)
        if "missing" in found:
            yield Row("MNE-Qt-Browser", None, "", note=found["missing"])
            return
        theirs.append(found)
        ours.append(measure("scroll", trial.path))
    yield from held_against(
        "MNE-Qt-Browser",
        "steps/s",
        (
            ("12 plots + timeline, 10 s: by a page", "page", ">= 1"),
            ("12 plots + timeline, 10 s: by a quarter page", "quarter", ">= 1"),
        ),
        ours,
        theirs,
    )


def _opening(trial: Trial) -> Iterable[Row]:
    names = ("reading", "sharing", "opening")
    runs = [[measure(name, trial.path) for name in names] for _ in range(trial.runs + 1)]
    # The first round has filled the system's cache of files.
    reading, sharing, ours = zip(*runs[1:], strict=True)
    alone = "reading alone"
    shared = ("the same as the window does it: by threads, into shared memory", "seconds", "")
    opened = ("open to the first paint of the recording", "seconds", "<= 1.5")
    first, *rest = held_against(alone, "s", (shared,), sharing, reading)
    yield replace(first, what=f"{alone}, in a fresh process")
    yield from rest
    yield from list(held_against(alone, "s", (opened,), ours, reading))[1:]


def _pauses(trial: Trial) -> Iterable[Row]:
    found = [measure("pauses", trial.path) for _ in range(trial.runs)]
    return limited(PAUSES, found, "ms", "100 ms", PAUSE_LIMIT_MS, "<= 1")


def _memory(trial: Trial) -> Iterable[Row]:
    found = [measure("memory", trial.path) for _ in range(trial.runs)]
    if "missing" in found[0]:
        return [Row(text, None, "", note=found[0]["missing"]) for text in MEMORY.values()]
    points = found[0]["points"]
    return limited(MEMORY, found, "MB", f"points, {points:.0f} MB", points, "<= 4")


PARTS: dict[str, Callable[[Trial], Iterable[Row]]] = {
    "start": _start,
    "plots": _plots,
    "mne": _mne,
    "opening": _opening,
    "pauses": _pauses,
    "memory": _memory,
}
