"""The benchmark of the window: its rows and its children, with few frames and without MNE."""

import json
import sys
from pathlib import Path
from typing import Any

import numpy as np
import pytest

from mocapmend.bench import main
from mocapmend.bench.gui import command, mne_browser
from mocapmend.bench.gui.measure import measure
from mocapmend.bench.gui.rows import held_against, limited
from mocapmend.bench.gui.steps import PAGE_S, page_starts, pan_ranges, zoom_ranges
from mocapmend.bench.synthetic import write_recording
from mocapmend.bench.table import Row
from mocapmend.errors import MocapmendError
from mocapmend.files import read_recording

QUICK = ["--runs", "1", "--frames", "2000"]


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


# Each figure is measured in a process of its own.
@pytest.mark.parametrize("part", list(command.PARTS))
def test_every_part_measures_its_rows(part: str, capsys: pytest.CaptureFixture[str]) -> None:
    assert main(["gui", *QUICK, "--only", part, "--json"]) == 0
    document = json.loads(capsys.readouterr().out)
    assert (document["schema"], document["command"]) == (1, "bench gui")
    assert document["rows"]
    noted = [row for row in document["rows"] if row["note"]]
    assert all(row["figure"] > 0 for row in document["rows"] if row not in noted)
    if not noted:
        assert any(row["ratio"] is not None and row["target"] for row in document["rows"])
    assert not noted or part in ("mne", "memory"), "the others need nothing that may be missing"


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


@pytest.mark.parametrize(
    ("options", "measured"), [([], ["plots", "memory"]), (["--only", "memory"], ["memory"])]
)
def test_the_command_measures_all_parts_or_those_that_are_named(
    options: list[str],
    measured: list[str],
    monkeypatch: pytest.MonkeyPatch,
    capsys: pytest.CaptureFixture[str],
) -> None:
    for name in list(command.PARTS):
        monkeypatch.delitem(command.PARTS, name)
    for name in ("plots", "memory"):
        rows = [Row(f"the {name}", 1.0, "ms")]
        monkeypatch.setitem(command.PARTS, name, lambda trial, rows=rows: rows)
    assert main(["gui", *QUICK, *options]) == 0
    text = capsys.readouterr().out
    assert "2000 frames x 100 markers, 200 gaps" in text
    assert [name for name in ("plots", "memory") if f"the {name}" in text] == measured
