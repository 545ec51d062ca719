"""Scrubbing and start-up of the window, on whatever platform Qt finds."""

import argparse
import os
import subprocess
import sys
import tempfile
import time
from collections.abc import Callable
from pathlib import Path

import numpy as np
import pyqtgraph
from PySide6.QtCore import QSettings
from PySide6.QtWidgets import QApplication

from mocapmend import engine
from mocapmend.bench.arguments import add_size
from mocapmend.bench.synthetic import write_recording
from mocapmend.bench.table import Row, Table
from mocapmend.errors import MocapmendError
from mocapmend.settings import Settings
from mocapmend.views.application import make_application
from mocapmend.views.main_window import MainWindow
from mocapmend_algorithms import no_progress

MARKERS = 100
GAPS = 10_000
STEPS = 200
TARGET = 60.0
PLOTS = 12
PATIENCE_S = 10.0


def add_arguments(parser: argparse.ArgumentParser) -> None:
    """Say what the benchmark takes."""
    add_size(parser)


def run(arguments: argparse.Namespace) -> Table:
    """Measure 100 markers with 10,000 gaps in a window of 1600 x 950."""
    frames, runs = arguments.frames, arguments.runs
    if sys.platform == "linux" and not (
        os.environ.get("DISPLAY") or os.environ.get("WAYLAND_DISPLAY")
    ):
        os.environ.setdefault("QT_QPA_PLATFORM", "offscreen")
    app_start, bare_start = _start_times(runs)
    scrub_rows = _scrub_rows(frames, runs)
    platform = QApplication.platformName()
    title = f"Window, {frames} frames x {MARKERS} markers, {GAPS} gaps, on Qt's {platform} platform"
    table = Table(title)
    ratio = float(np.median(np.array(app_start) / np.array(bare_start)))
    table.rows += [
        Row("bare PySide6 + pyqtgraph window, start to first paint",
            float(np.median(bare_start)), "s"),
        Row("mocapmend, start to first paint", float(np.median(app_start)), "s",
            "bare window", ratio, "<= 1.6"),
        *scrub_rows,
    ]  # fmt: skip
    return table


def _start_times(runs: int) -> tuple[list[float], list[float]]:
    """Start our window and a bare one in turn, after a round that is not counted."""
    times: dict[str, list[float]] = {"program": [], "bare": []}
    for counted in range(-1, runs):
        for which, seconds in times.items():
            command = [sys.executable, "-m", "mocapmend.bench.first_paint", which]
            started = time.time()
            done = subprocess.run(command, check=True, capture_output=True, text=True)  # noqa: S603
            if counted >= 0:
                seconds.append(float(done.stdout) - started)
    return times["program"], times["bare"]


def _scrub_rows(frames: int, runs: int) -> list[Row]:
    existing = QApplication.instance()
    app = existing if isinstance(existing, QApplication) else make_application()
    with tempfile.TemporaryDirectory(prefix="mocapmend-bench-") as folder:
        path = Path(folder) / "large.c3d"
        write_recording(path, frames=frames, markers=MARKERS, gaps=GAPS)
        return [*_program(app, path, runs), *_plain_plots(app, path, runs)]


def _program(app: QApplication, path: Path, runs: int) -> list[Row]:
    """Scrub our window: 3D view, 12 plots and timeline follow every step."""
    settings = QSettings(str(path.with_suffix(".ini")), QSettings.Format.IniFormat)
    window = MainWindow(Settings(settings))
    window.resize(1600, 950)
    window.show()
    source, skeleton = engine.load(path, no_progress)
    window.show_source(source, skeleton)
    workspace = window.workspace
    assert workspace is not None
    workspace.trajectories.set_separate(on=True)
    workspace.view.select((3, 30, 60, 90))
    # The panes get their sizes in the first steps of the event loop.
    limit = time.perf_counter() + PATIENCE_S
    while len(workspace.trajectories.lanes()) < PLOTS:
        app.processEvents()
        if time.perf_counter() > limit:
            window.close()
            raise MocapmendError(
                "The screen is too small for 12 plots.",
                "bench gui",
                "Use QT_QPA_PLATFORM=offscreen.",
            )
    rng = np.random.default_rng(0)
    places = rng.integers(0, source.recording.frames, STEPS).tolist()

    def scrub(frame: int) -> None:
        workspace.view.set_frame(frame)

    def zoom(step: int) -> None:
        centre = places[step % STEPS]
        workspace.view.set_visible(centre - 20_000, centre + 20_000)

    rate = _steps_per_second(app, runs, scrub, places)
    moves = _steps_per_second(app, runs, zoom, list(range(40)))
    rows = [
        Row(
            "scrub: 3D + 12 plots + timeline", rate, "steps/s", "60 steps/s", rate / TARGET, ">= 1"
        ),
        Row("pan over 40,000 frames: 12 plots + timeline", moves, "steps/s"),
    ]
    window.close()
    return rows


def _plain_plots(app: QApplication, path: Path, runs: int) -> list[Row]:
    """Scrub 12 linked pyqtgraph plots of the same data, set up as its manual advises."""
    points = engine.load(path, no_progress)[0].recording.points
    widget = pyqtgraph.GraphicsLayoutWidget()
    widget.resize(800, 800)
    lines, first = [], None
    for row, (marker, axis) in enumerate((m, a) for m in (3, 30, 60, 90) for a in range(3)):
        plot = widget.addPlot(row=row, col=0)
        plot.setDownsampling(auto=True, mode="peak")
        plot.setClipToView(True)
        plot.enableAutoRange(x=False, y=True)
        plot.plot(points[:, marker, axis], connect="finite")
        line = pyqtgraph.InfiniteLine(angle=90)
        plot.addItem(line, ignoreBounds=True)
        lines.append(line)
        first = first or plot
        plot.setXLink(first)
    assert first is not None
    first.setXRange(0, len(points))
    widget.show()
    app.processEvents()
    places = np.random.default_rng(0).integers(0, len(points), 40).tolist()

    def scrub(frame: int) -> None:
        for line in lines:
            line.setValue(frame)

    def pan(frame: int) -> None:
        first.setXRange(frame - 20_000, frame + 20_000, padding=0)

    scrubbed = _steps_per_second(app, runs, scrub, places)
    panned = _steps_per_second(app, runs, pan, places)
    widget.close()
    return [
        Row("12 linked pyqtgraph plots alone: scrub", scrubbed, "steps/s"),
        Row("12 linked pyqtgraph plots alone: pan over 40,000 frames", panned, "steps/s"),
    ]


def _steps_per_second(
    app: QApplication, runs: int, step: Callable[[int], None], values: list[int]
) -> float:
    """Return the median rate at which steps are made and painted."""
    rates = []
    for _ in range(runs):
        start = time.perf_counter()
        for value in values:
            step(value)
            app.processEvents()
        rates.append(len(values) / (time.perf_counter() - start))
    return float(np.median(rates))
