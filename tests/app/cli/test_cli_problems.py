"""`mocapmend problems`: bad samples as a table and as JSON."""

from collections.abc import Callable
from pathlib import Path
from typing import Any

import numpy as np
import pytest

from mocapmend.cli import main
from mocapmend.files import read_recording
from mocapmend_algorithms.problems.registry import DETECTORS

Json = Callable[..., tuple[int, Any]]

WALK = "walk_cmu_02_01.c3d"
SPIKE_MM = 90.0


@pytest.fixture
def wrong(tmp_path: Path, samples: Path) -> Path:
    """Write the bundled walk with a spike in one marker, and two others swapped."""
    recording = read_recording(samples / WALK).measured
    points = recording.points.copy()
    points[100:102, 5] += (SPIKE_MM, 0.0, 0.0)
    points[200:230, [7, 9]] = points[200:230, [9, 7]]
    path = tmp_path / "wrong.npz"
    labels = np.array([label.rpartition(":")[2] for label in recording.labels])
    np.savez(path, pos=points, names=labels, fps=recording.rate, units="mm", up="z")
    return path


def test_the_problems_of_a_file_as_json(run_json: Json, wrong: Path) -> None:
    code, found = run_json("problems", wrong)
    assert code == 0
    assert found["kinds"] == list(DETECTORS)
    places = {
        (p["kind"], p["marker_index"], p["first_frame"], p["last_frame"]): p for p in _in(found)
    }
    spike, swap = places["spikes", 5, 101, 102], places["swaps", 7, 201, 230]
    assert spike["deviation_mm"] == pytest.approx(SPIKE_MM, rel=0.05)
    assert spike["harm_mm_frames"] == pytest.approx(2 * spike["deviation_mm"])
    assert (spike["remedy"], spike["other"]) == ("missing", None)
    assert spike["length_ms"] == pytest.approx(2000 / 120)
    assert (swap["remedy"], swap["other_index"]) == ("exchange", 9)
    assert found["bad_samples"] >= 2 + 2 * 30
    harms = [p["harm_mm_frames"] for p in _in(found) if p["harm_mm_frames"] is not None]
    assert harms == sorted(harms, reverse=True)
    assert harms[0] == swap["harm_mm_frames"]


def test_only_some_kinds(run_json: Json, wrong: Path) -> None:
    _, found = run_json("problems", wrong, "--only", "frozen, swaps")
    assert found["kinds"] == ["frozen", "swaps"]
    assert {p["kind"] for p in _in(found)} == {"swaps"}
    assert found["bad_samples"] == 60


def test_the_table_and_its_last_line(wrong: Path, capsys: pytest.CaptureFixture[str]) -> None:
    assert main(["problems", str(wrong), "--only", "swaps"]) == 0
    head, row, last = capsys.readouterr().out.strip().split("\n")
    assert head.split()[:3] == ["Kind", "Marker", "Other"]
    assert row.startswith("swaps ")
    assert " 201-230 " in row
    assert last == f"1 problem, 60 bad samples of {343 * 41}."


@pytest.mark.parametrize("name", ["sprint_basketball.c3d", "gait_plug_in_gait.c3d", WALK])
def test_the_bundled_recordings(run_json: Json, samples: Path, name: str) -> None:
    code, found = run_json("problems", samples / name)
    assert code == 0
    recording = read_recording(samples / name).measured
    first, last = recording.first_frame, recording.first_frame + recording.frames - 1
    for problem in _in(found):
        assert first <= problem["first_frame"] <= problem["last_frame"] <= last
        assert recording.labels[problem["marker_index"]] == problem["marker"]


def test_a_kind_that_does_not_exist(wrong: Path, capsys: pytest.CaptureFixture[str]) -> None:
    with pytest.raises(SystemExit) as stopped:
        main(["problems", str(wrong), "--only", "spooks"])
    assert stopped.value.code == 2
    assert "there is no detector 'spooks'" in capsys.readouterr().err


def test_parameters_of_a_kind(run_json: Json, wrong: Path) -> None:
    options = ("--only", "spikes,frozen", "--param")
    _, found = run_json("problems", wrong, *options, f"spikes.least_mm={SPIKE_MM + 10}")
    assert found["problems"] == []
    assert found["parameters"]["spikes"]["least_mm"] == SPIKE_MM + 10
    assert found["parameters"]["frozen"]["least_frames"] == 2
    _, found = run_json("problems", wrong, *options, f"spikes.least_mm={SPIKE_MM - 10}")
    assert [p["marker_index"] for p in _in(found)] == [5]


@pytest.mark.parametrize(
    ("given", "message"),
    [
        ("least_mm=5", "--param takes KIND.NAME=VALUE, with a kind of spikes, frozen"),
        ("swaps.least_mm=5", "with a kind of spikes, frozen; not 'swaps.least_mm'"),
        ("spikes.size=5", "there is no parameter 'size'; the parameters are: least_mm"),
        ("spikes.least_mm=-5", "least_mm must be at least 0.1 mm, not -5"),
        ("spikes.least_mm", "--param takes NAME=VALUE"),
    ],
)
def test_impossible_parameters(
    wrong: Path, capsys: pytest.CaptureFixture[str], given: str, message: str
) -> None:
    with pytest.raises(SystemExit) as stopped:
        main(["problems", str(wrong), "--only", "spikes,frozen", "--param", given])
    assert stopped.value.code == 2
    assert message in capsys.readouterr().err


def _in(found: dict[str, Any]) -> list[dict[str, Any]]:
    problems: list[dict[str, Any]] = found["problems"]
    return problems
