"""The benchmark of the window: its rows and its children, with few frames and without MNE."""

import subprocess
import sys
from pathlib import Path
from typing import Any

import numpy as np
import pytest

from mocapmend.bench.gui import command, mne_browser
from mocapmend.bench.gui.measure import measure
from mocapmend.bench.gui.rows import held_against, limited
from mocapmend.bench.gui.steps import PAGE_S, page_starts, pan_ranges, zoom_ranges
from mocapmend.bench.synthetic import write_recording
from mocapmend.errors import MocapmendError
from mocapmend.files import read_recording


@pytest.fixture
def recording(tmp_path: Path) -> Path:
    path = tmp_path / "small.c3d"
    write_recording(path, frames=4000, markers=100, gaps=100)
    return path


def test_a_ratio_is_the_median_of_the_ratios_of_the_runs() -> None:
    ours = [{"pan": 10.0}, {"pan": 40.0}, {"pan": 90.0}]
    theirs = [{"pan": 10.0}, {"pan": 10.0}, {"pan": 30.0}]
    rival, row = held_against("rival", "steps/s", [("pan", "pan", ">= 1")], ours, theirs)
    assert (rival.figure, row.figure, row.ratio) == (10.0, 40.0, 3.0)


def test_a_limit_is_held_against_the_median() -> None:
    runs = [{"pause": 50.0}, {"pause": 80.0}, {"pause": 500.0}]
    (row,) = limited({"pause": "longest pause"}, runs, "ms", "100 ms", 100.0, "<= 1")
    assert (row.what, row.figure, row.ratio) == ("longest pause", 80.0, 0.8)


@pytest.mark.parametrize("frames", [4000, 100_000])
def test_all_ranges_lie_in_the_recording(frames: int) -> None:
    for start, stop in (*pan_ranges(frames), *zoom_ranges(frames)):
        assert 0 <= start < stop <= frames
    page = 200 * PAGE_S
    assert max(page_starts(frames, page, 1.0, 1000)) + page <= frames


def test_signals_for_mne_have_no_gaps_and_the_measured_samples(recording: Path) -> None:
    read = read_recording(recording).recording
    channels = mne_browser.signals(read)
    assert channels.shape == (300, 4000)
    assert np.isfinite(channels).all()
    known = read.present[:, 7]
    assert (channels[22, known] == read.points[known, 7, 1]).all()


def test_the_plots_are_measured_in_a_process(recording: Path) -> None:
    ours = measure("plots", recording)
    assert min(ours["scrub"], ours["pan"], ours["zoom"]) > 0
    plain = measure("plain", recording, ours["width"], ours["height"])
    assert min(plain["pan"], plain["zoom"]) > 0


def test_opening_is_measured_beside_reading(recording: Path) -> None:
    assert measure("opening", recording)["seconds"] > 0
    assert measure("reading", recording)["seconds"] > 0


def test_a_measurement_that_fails_says_why(tmp_path: Path) -> None:
    with pytest.raises(MocapmendError, match=r"reading failed: .*no such file"):
        measure("reading", tmp_path / "nothing.c3d")


def test_without_mne_the_row_says_how_to_install_it(
    recording: Path, monkeypatch: pytest.MonkeyPatch
) -> None:
    def without(name: str, path: Path, *sizes: float, python: str = "") -> dict[str, Any]:
        return {"missing": mne_browser.HOW_TO_INSTALL}

    monkeypatch.setattr(command, "measure", without)
    trial = command.Trial(recording, 1, sys.executable)
    (row,) = command.PARTS["mne"](trial)
    assert row.figure is None
    assert "pip install" in row.note


@pytest.mark.timeout(600)
def test_the_command_measures_one_part_alone() -> None:
    arguments = ["bench", "gui", "--runs", "1", "--frames", "2000", "--only", "memory"]
    done = subprocess.run(
        [sys.executable, "-m", "mocapmend", *arguments], check=True, capture_output=True, text=True
    )
    assert "2000 frames x 100 markers, 200 gaps" in done.stdout
    assert "memory" in done.stdout
    assert "scrub:" not in done.stdout
