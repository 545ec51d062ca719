"""How the cost of a method grows with the number of gaps and with the length of a recording."""

from collections.abc import Callable, Sequence
from dataclasses import replace
from importlib.resources import as_file, files
from typing import NamedTuple

import numpy as np

from mocapmend.bench.gaps.trials import timed_fill, warm_up
from mocapmend.bench.grid import Cell, Column, Grid
from mocapmend.files import read_recording
from mocapmend_algorithms import Recording

WALK = "walk_cmu_02_01.c3d"
SECONDS = 60.0
GAP_SECONDS = 0.5
JITTER_MM = 0.3
GAPS = (10, 20, 50, 100)
SOME_GAPS = 50
LENGTHS = (1, 2, 4)

_COLUMNS = (
    Column("method", "method"),
    Column("grows", "what grows"),
    Column("gaps", "gaps"),
    Column("frames", "frames"),
    Column("left_open", "gaps left open"),
    Column("cpu_s", "CPU s", ".3g"),
    Column("times", "times the first", ".2f"),
    Column("to_linear", "to linear growth", ".2f"),
)


class Size(NamedTuple):
    """A recording to be made.

    Attributes
    ----------
    grows : str
        "gaps" or "frames".
    factor : float
        How much larger it is than the first of its series.
    gaps, frames : int
        What it has.
    """

    grows: str
    factor: float
    gaps: int
    frames: int


def sizes(frames: int) -> list[Size]:
    """Return two series: more gaps in as many frames, and as many gaps in more frames."""
    more_gaps = [Size("gaps", gaps / GAPS[0], gaps, frames) for gaps in GAPS]
    more_frames = [Size("frames", length, SOME_GAPS, length * frames) for length in LENGTHS]
    return [*more_gaps, *more_frames]


def scaling(
    walk: Recording, series: Sequence[Size], methods: Sequence[str], say: Callable[[str], None]
) -> Grid:
    """Measure recordings of several sizes, made from a short one.

    Parameters
    ----------
    walk : Recording
        The short one.
    series : sequence of Size
        The first of each kind is what the others of that kind are held against.
    methods : sequence of str
        They take turns at each size.
    say : callable
        Told when a size is done.
    """
    warm_up(methods)
    first: dict[tuple[str, str], float] = {}
    rows: list[dict[str, Cell]] = []
    for size in series:
        recording = with_gaps(tiled(walk, size.frames), size.gaps)
        for method in methods:
            result, seconds = timed_fill(recording.with_points(recording.points), method)
            times = seconds / (first.setdefault((method, size.grows), seconds) or np.nan)
            row: dict[str, Cell] = {
                "method": method,
                "grows": size.grows,
                "gaps": size.gaps,
                "frames": size.frames,
                "left_open": len(result.unfilled),
                "cpu_s": seconds,
                "times": times,
                "to_linear": times / size.factor,
            }
            rows.append(row)
        say(f"{size.gaps} gaps in {size.frames} frames")
    rows.sort(key=lambda row: methods.index(str(row["method"])))
    return Grid("scaling", "Cost", _COLUMNS, rows)


def bundled_walk() -> Recording:
    """Return the bundled walk: 41 markers."""
    with as_file(files("mocapmend_resources") / "samples") as folder:
        return read_recording(folder / WALK).recording


def tiled(walk: Recording, frames: int) -> Recording:
    """Play a recording to and fro, with jitter, so that no two passes are the same."""
    round_trip = np.concatenate((walk.points, walk.points[-2:0:-1]))
    points = round_trip[np.arange(frames) % len(round_trip)]
    jitter = np.random.default_rng(0).normal(0.0, JITTER_MM / walk.mm, points.shape)
    return replace(walk, points=points + jitter)


def with_gaps(recording: Recording, count: int) -> Recording:
    """Punch gaps of half a second, one after the other, into markers that take turns."""
    points = recording.points.copy()
    length = round(GAP_SECONDS * recording.rate)
    markers = np.random.default_rng(1).permutation(recording.markers)
    for k in range(count):
        middle = round((k + 0.5) * recording.frames / count)
        start = max(1, middle - length // 2)
        points[start : start + length, markers[k % len(markers)]] = np.nan
    return recording.with_points(points)
