"""How many frames per second the constant-velocity filter makes, beside filterpy's.

filterpy's filter is the same model with the same two noises: six states per marker, a step for
each frame, and its Rauch-Tung-Striebel smoother.
"""

import time
from collections.abc import Callable
from dataclasses import dataclass, field
from importlib.util import find_spec
from typing import Any

import numpy as np

from mocapmend.bench.kalman_cases import Case
from mocapmend.bench.table import Row
from mocapmend_algorithms import Gap, Recording, no_progress
from mocapmend_algorithms.arrays import FloatArray, IntArray
from mocapmend_algorithms.fill.constant_velocity import bridge
from mocapmend_algorithms.fill.kalman import REACH, KalmanParams, kalman
from mocapmend_algorithms.fill.kalman_settings import process_noise

NOISE_MM = 1.0
PAPER = 30.5
TARGET = ">= 200"
START_SPREAD = 1e4
LEAST_SECONDS = 0.2
PEER = "filterpy: filter and smooth all markers"
PEER_LIVE = "filterpy: filter all markers, as a live system must"
PEER_LOST = "filterpy: filter and smooth the lost markers alone"
ALONE = "mocapmend: smooth across the gaps alone, band not measured"
PRINTED = "mocapmend: repair in the world frame with given noise, band measured"
DEFAULT = "mocapmend: repair with the default settings, noise chosen, band measured"


@dataclass(frozen=True)
class Line:
    """A row: a job, and the ones that it is held against."""

    what: str
    against: str = ""
    target: str = ""


LINES = (
    Line(PEER),
    Line(PEER_LIVE),
    Line(PEER_LOST),
    Line(ALONE, PEER, TARGET),
    Line(ALONE, PEER_LOST),
    Line(PRINTED, PEER, TARGET),
    Line(PRINTED, PEER_LOST),
    Line(DEFAULT, PEER, TARGET),
    Line(DEFAULT, PEER_LOST),
    Line(DEFAULT, "the paper's 30.5 frames/s"),
)


@dataclass
class Rates:
    """Frames per second of each job, one number per run."""

    of: dict[str, list[float]] = field(default_factory=dict)

    def row(self, line: Line) -> Row:
        """Make a row; a peer that is not there has none."""
        if line.what not in self.of:
            return Row(line.what, None, "frames/s", note="not installed")
        rates = np.array(self.of[line.what])
        figure = float(np.median(rates))
        if not line.against:
            return Row(line.what, figure, "frames/s")
        if line.against in (PEER, PEER_LIVE, PEER_LOST):
            peer = np.array(self.of.get(line.against, []))
            if not peer.size:
                return Row(line.what, figure, "frames/s", line.against, None, line.target)
        else:
            peer = np.array([PAPER])
        ratio = float(np.median(rates / peer))
        return Row(line.what, figure, "frames/s", line.against, ratio, line.target)


def rows(case: Case, runs: int) -> list[Row]:
    """Measure all jobs in turn; each is done as often as fits into a fifth of a second."""
    rates = Rates()
    for _ in range(runs):
        for name, job in _jobs(case).items():
            rate = case.reference.frames / _seconds(job)
            rates.of.setdefault(name, []).append(rate)
    return [rates.row(line) for line in LINES]


def _seconds(job: Callable[[], Any]) -> float:
    """Return how long a job takes when all is imported, but no gap's weights are kept."""
    job()
    started, count = time.perf_counter(), 0
    while True:
        bridge.cache_clear()
        job()
        count += 1
        passed = time.perf_counter() - started
        if passed > LEAST_SECONDS:
            return passed / count


def _jobs(case: Case) -> dict[str, Callable[[], Any]]:
    raw = case.raw
    lost = sorted({gap.marker for gap in case.gaps})
    jobs: dict[str, Callable[[], Any]] = {}
    if find_spec("filterpy") is not None:
        jobs |= {
            PEER: lambda: [filterpy_smooth(raw, marker) for marker in range(raw.markers)],
            PEER_LIVE: lambda: [filterpy_filter(raw, marker) for marker in range(raw.markers)],
            PEER_LOST: lambda: [filterpy_smooth(raw, marker) for marker in lost],
        }
    printed = KalmanParams(frame="world", noise_mm=NOISE_MM)
    return jobs | {
        ALONE: lambda: [smooth_alone(raw, gap) for gap in case.gaps],
        PRINTED: lambda: kalman(raw, case.gaps, printed, no_progress),
        DEFAULT: lambda: kalman(raw, case.gaps, KalmanParams(), no_progress),
    }


def smooth_alone(recording: Recording, gap: Gap) -> FloatArray:
    """Fill a gap with the smoother and nothing else; shape (length, 3)."""
    seen = np.flatnonzero(recording.present[:, gap.marker])
    middle = int(np.searchsorted(seen, gap.start))
    knots: IntArray = seen[max(middle - REACH, 0) : middle + REACH]
    points = recording.points[:, gap.marker]
    ratio = noise_ratio(recording, gap.marker)
    weights, _ = bridge(tuple((knots - gap.start).tolist()), gap.length, ratio)
    return weights @ points[knots]


def noise_ratio(recording: Recording, marker: int) -> float:
    """Return measurement variance over process noise in frames, as `bridge` takes it."""
    rate = recording.rate
    density = process_noise(recording.points[:, marker], rate)
    return float((NOISE_MM / recording.mm) ** 2 / (density / rate**3)) if density else 1.0


def filterpy_filter(recording: Recording, marker: int) -> tuple[Any, FloatArray, FloatArray]:
    """Filter a marker frame by frame; return the filter, states and covariances."""
    from filterpy.common import Q_continuous_white_noise
    from filterpy.kalman import KalmanFilter

    points = recording.points[:, marker]
    seen = recording.present[:, marker]
    # Time in frames and unit process noise: the numbers stay within a few powers of ten.
    model = KalmanFilter(dim_x=6, dim_z=3)
    model.F = np.eye(6) + np.eye(6, k=3)
    model.H = np.eye(3, 6)
    model.Q = Q_continuous_white_noise(2, dt=1.0, block_size=3, order_by_dim=False)
    ratio = noise_ratio(recording, marker)
    model.R = np.eye(3) * ratio
    model.P = np.eye(6) * START_SPREAD * max(1.0, ratio)
    model.x[:3, 0] = points[np.argmax(seen)]
    states, covariances = [], []
    for point, known in zip(points, seen, strict=True):
        model.predict()
        model.update(point if known else None)
        states.append(model.x.copy())
        covariances.append(model.P.copy())
    return model, np.array(states), np.array(covariances)


def filterpy_smooth(recording: Recording, marker: int) -> FloatArray:
    """Filter and smooth a marker; shape (frames, 3)."""
    model, states, covariances = filterpy_filter(recording, marker)
    smooth: FloatArray = model.rts_smoother(states, covariances)[0][:, :3, 0]
    return smooth
