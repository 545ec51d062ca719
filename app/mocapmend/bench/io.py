"""Reading and saving a large C3D file, against numpy, a file copy, c3d and ezc3d.

Each figure is of a fresh process, without its imports. The runs take turns, and a ratio is the
median of the ratios run by run: what drifts hits all alike.
"""

import argparse
import json
import subprocess
import sys
import tempfile
from collections.abc import Iterator
from dataclasses import asdict
from importlib.util import find_spec
from pathlib import Path
from typing import NamedTuple

import numpy as np
from numpy.typing import NDArray

from mocapmend.bench.arguments import add_size
from mocapmend.bench.io_jobs import JOBS, RECORDING, Step, Work
from mocapmend.bench.synthetic import write_recording
from mocapmend.bench.table import Row, Table
from mocapmend.errors import MocapmendError
from mocapmend.files import read_c3d
from mocapmend_algorithms import find_gaps

MARKERS = 60
ANALOG = 16
PEERS = ("c3d", "ezc3d")
PATIENCE_S = 300.0
MOST_MB = 500.0


class Part(NamedTuple):
    """Steps of a job; all of them by default."""

    job: str
    steps: tuple[int, ...] = ()


class Line(NamedTuple):
    """A row of times: what, which steps, and what they are held against."""

    what: str
    part: Part
    against: str = ""
    to: Part | None = None
    target: str = ""


PLAIN, COPY = Part("numpy"), Part("copy")
POINTS, EVERYTHING, REPAIR = Part("own read", (0,)), Part("own read"), Part("own save")
C3D, EZC3D = Part("c3d read"), Part("ezc3d", (0,))
TIMES = (
    Line("plain read (np.fromfile)", PLAIN),
    Line("read, points", POINTS, "plain read", PLAIN, "<= 3"),
    Line("c3d: read, points (it always reads everything)", C3D, "mocapmend", POINTS, ">= 10"),
    Line("ezc3d: read, points (it always reads everything)", EZC3D, "mocapmend", POINTS, ">= 10"),
    Line("read, points, residuals and analog", EVERYTHING, "plain read", PLAIN),
    Line("c3d: read, points, residuals and analog", C3D, "mocapmend", EVERYTHING, ">= 5"),
    Line("ezc3d: read, points, residuals and analog", EZC3D, "mocapmend", EVERYTHING, ">= 5"),
    Line("copy, fsync, read back", COPY),
    Line("save a repair, verified", Part("own save", (1,)), "copy", COPY, "<= 3"),
    Line("read, repair, save, verified", REPAIR, "copy", COPY),
    Line("c3d: read, repair, write, not verified", Part("c3d save"), "mocapmend", REPAIR),
    Line("ezc3d: read, repair, write, not verified", Part("ezc3d"), "mocapmend", REPAIR),
    Line(
        "export with all proofs, the c3d library's reading among them",
        Part("own export"), "copy", COPY,
    ),
)  # fmt: skip
MEMORY = (
    ("read points", "own read", 0),
    ("read points, residuals and analog", "own read", 1),
    ("read, repair, save", "own save", 1),
    ("export with all proofs, of a recording that was read", "own export", 0),
    ("c3d: read points, residuals and analog", "c3d read", 0),
    ("ezc3d: read points, residuals and analog", "ezc3d", 0),
    ("c3d: read, repair, write", "c3d save", 0),
    ("ezc3d: read, repair, write", "ezc3d", 1),
)
"""What, a job, and up to which of its steps."""


def add_arguments(parser: argparse.ArgumentParser) -> None:
    """Say what the benchmark takes."""
    add_size(parser)


def run(arguments: argparse.Namespace) -> Table:
    """Measure on a synthetic recording: 60 markers, 16 analog channels at ten times the rate."""
    with tempfile.TemporaryDirectory(prefix="mocapmend-bench-") as folder:
        path = Path(folder) / RECORDING
        write_recording(path, frames=arguments.frames, markers=MARKERS, analog=ANALOG, gaps=200)
        size = path.stat().st_size
        gap = find_gaps(read_c3d(path).recording.present)[0]
        results = measure_all(Work(folder, gap.marker, gap.start, gap.stop), arguments.runs)
    title = f"Input and output, a C3D file of {size / 1e6:.0f} MB ({arguments.frames} frames)"
    return Table(title, rows(results))


class Results:
    """What the jobs took.

    Attributes
    ----------
    steps : dict of str to list of list of Step
        By job, for each run.
    failures : dict of str to str
        Why a job has no figures.
    """

    def __init__(self) -> None:
        self.steps: dict[str, list[list[Step]]] = {name: [] for name in JOBS}
        self.failures: dict[str, str] = {}

    def seconds(self, part: Part) -> NDArray[np.float64]:
        """Return how long a part took, one number per run."""
        runs = self.steps[part.job]
        return np.array(
            [sum(run[i].seconds for i in part.steps or range(len(run))) for run in runs]
        )

    def extra_mb(self, job: str, step: int) -> float | None:
        """Return the extra memory up to a step of a job, median of the runs."""
        told = [run[step].extra_mb for run in self.steps[job]]
        values = [value for value in told if value is not None]
        return float(np.median(values)) if values else None


def measure_all(work: Work, runs: int) -> Results:
    """Run all jobs in turn; a peer that is not there or fails is left out."""
    results = Results()
    for _ in range(runs):
        for name in JOBS:
            if name in results.failures:
                continue
            outcome = _run(name, work)
            if isinstance(outcome, str):
                results.failures[name] = outcome
            else:
                results.steps[name].append(outcome)
    return results


def _run(name: str, work: Work) -> list[Step] | str:
    """Run a job in a process of its own; return its steps, or why a peer has none."""
    peer = name.split()[0] in PEERS
    if peer and find_spec(name.split()[0]) is None:
        return "not installed"
    command = [sys.executable, "-m", "mocapmend.bench.io_jobs", name, json.dumps(asdict(work))]
    try:
        done = subprocess.run(  # noqa: S603
            command, check=False, capture_output=True, text=True, timeout=PATIENCE_S
        )
    except subprocess.TimeoutExpired:
        failure = f"not done after {PATIENCE_S:g} s"
    else:
        if done.returncode == 0:
            return [Step(**step) for step in json.loads(done.stdout)]
        failure = f"failed with exit code {done.returncode}"
    if not peer:
        raise MocapmendError(f"The measurement ended early: {failure}.", f"bench io, {name}")
    return failure


def rows(results: Results) -> list[Row]:
    """Make the table."""
    return [*(_time(line, results) for line in TIMES), *_memory(results)]


def _time(line: Line, results: Results) -> Row:
    note = results.failures.get(line.part.job, "")
    if note:
        return Row(line.what, None, "s", line.against, None, line.target, note)
    seconds = results.seconds(line.part)
    ratio = line.to and float(np.median(seconds / results.seconds(line.to)))
    return Row(line.what, float(np.median(seconds)), "s", line.against, ratio, line.target)


def _memory(results: Results) -> Iterator[Row]:
    for what, job, step in MEMORY:
        name = f"extra memory, {what}"
        note = results.failures.get(job, "")
        megabytes = None if note else results.extra_mb(job, step)
        if megabytes is None:
            yield Row(name, None, "MB", note=note or "not told by this system")
        elif job.startswith("own"):
            yield Row(name, megabytes, "MB", f"limit {MOST_MB:g} MB", megabytes / MOST_MB, "<= 1")
        else:
            yield Row(name, megabytes, "MB")
