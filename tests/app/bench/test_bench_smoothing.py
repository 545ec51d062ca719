"""`bench smoothing`: its recordings, errors and tables."""

import json
import shutil
from pathlib import Path

import numpy as np
import pytest

from mocapmend.bench import main
from mocapmend.bench.smoothing import command
from mocapmend.bench.smoothing.cases import HALVES, Case, read_cases, subject
from mocapmend.bench.smoothing.trials import WAYS, errors, smooth_all, trials
from mocapmend.errors import MocapmendError
from mocapmend_algorithms import Recording
from mocapmend_algorithms.arrays import FloatArray


def recording(points: FloatArray) -> Recording:
    """Return two markers at 100 Hz in metres."""
    return Recording(np.array(points), ("A", "B"), 100.0, "m")


def swing(frames: int = 300) -> FloatArray:
    """Return slow waves, and one sudden stop of the second marker at frame 200."""
    time = np.arange(frames)[:, None, None] / 100
    points = 0.3 * np.sin(2 * np.pi * time + np.arange(2)[:, None] + np.arange(3))
    points[:, 1, 2] = 2 * np.minimum(time[:, 0, 0], 2.0)
    return points


def test_subjects_stay_together(samples: Path, tmp_path: Path) -> None:
    walk = samples / "walk_cmu_02_01.c3d"
    names = ["01_02", "01_01", "02_07", "mr_85_02", "05_06"]
    for folder in ("cmu_joints", "cmu_markers"):
        (tmp_path / folder).mkdir()
        for name in names:
            shutil.copy(walk, tmp_path / folder / f"{name}.c3d")
    cases = read_cases(tmp_path, None, 100)
    found = {(case.folder, case.name): case.half for case in cases}
    joints = ["train", "train", "validation", "train"]
    for folder, halves in (("cmu_joints", joints), ("cmu_markers", None)):
        kept = ["01_01", "01_02", "02_07", "mr_85_02"]
        turned = [HALVES[1 - HALVES.index(half)] for half in joints]
        assert [found[folder, name] for name in kept] == (halves or turned)
    assert len(found) == 8, "a leg flips in 05_06"
    assert {case.truth.frames for case in cases} == {100}
    train = read_cases(tmp_path, "train", 100)
    assert {(case.folder, case.name) for case in train} == {
        key for key, half in found.items() if half == "train"
    }
    assert [subject(name) for name in (*names, "walk")] == [1, 1, 2, 85, 5, 0]


def test_folders_without_recordings_are_refused(tmp_path: Path) -> None:
    with pytest.raises(MocapmendError, match="There is no such folder"):
        read_cases(tmp_path / "nowhere", None, 100)
    with pytest.raises(MocapmendError, match="no recording of 64 or more frames"):
        read_cases(tmp_path, None, 100)


def test_noise_is_the_same_every_time_and_as_large_as_it_says() -> None:
    case = Case("a", "here", "train", recording(swing()))
    noise = (case.noisy(2.0).points - case.truth.points) * 1000
    assert np.std(noise) == pytest.approx(2.0, rel=0.1)
    np.testing.assert_array_equal(case.noisy(2.0).points, case.noisy(2.0).points)
    other = Case("b", "here", "train", case.truth)
    assert not np.array_equal(case.noisy(2.0).points, other.noisy(2.0).points)
    np.testing.assert_array_equal(case.noisy(0.0).points, case.truth.points)


def test_a_sudden_stop_is_an_impact() -> None:
    found = Case("a", "here", "train", recording(swing())).impacts()
    assert found[199:202, 1].all()
    assert 6 <= found.sum() <= 7


def test_errors_against_closed_forms() -> None:
    truth = recording(swing())
    impacts = np.zeros((300, 2), dtype=np.bool_)
    impacts[50, 0] = True
    still = errors(truth.with_points(truth.points + np.array([0.003, 0.0, 0.004])), truth, impacts)
    assert still.position == pytest.approx(5.0)
    assert still.speed == pytest.approx(0.0, abs=1e-6)
    assert still.at_impacts == still.largest_at_impacts == pytest.approx(5.0)
    time = np.arange(300)[:, None, None] / 100
    drift = errors(truth.with_points(truth.points + 0.002 * time * [0, 0, 1]), truth, impacts)
    assert drift.speed == pytest.approx(2.0)
    assert drift.acceleration == pytest.approx(0.0, abs=1e-6)
    assert drift.at_impacts == pytest.approx(1.0)
    curve = errors(truth.with_points(truth.points + 0.5 * time**2 * [0, 3, 0]), truth, impacts)
    assert curve.acceleration == pytest.approx(3.0)


def test_missing_samples_count_nowhere() -> None:
    points = swing()
    points[100:120, 0] = np.nan
    case = Case("a", "here", "train", recording(points))
    for trial in trials(case, 2.0, {"gcv": WAYS["gcv"]}):
        assert np.isfinite([trial.before.position, trial.after.position]).all()
        assert trial.after.position < trial.before.position
    smoothed = smooth_all(case.noisy(2.0), "gcv", {})
    assert np.isnan(smoothed.points[100:120, 0]).all()


def test_the_tables(
    samples: Path,
    tmp_path: Path,
    capsys: pytest.CaptureFixture[str],
    monkeypatch: pytest.MonkeyPatch,
) -> None:
    monkeypatch.setattr(command, "NOISES_MM", (0.0, 5.0))
    shutil.copy(samples / "walk_cmu_02_01.c3d", tmp_path / "walk_01.c3d")
    arguments = ["smoothing", "--data", str(tmp_path), "--frames", "100"]
    assert main([*arguments, "--json"]) == 0
    document = json.loads(capsys.readouterr().out)
    rows = {row["way"]: row for row in document["position"]}
    assert set(rows) == set(WAYS)
    for row in rows.values():
        assert (row["half"], row["folder"]) == ("train", tmp_path.name)
        assert 0 < row["noise_5"] < 1
    assert {row["noise_mm"] for row in document["trials"]} == {0, 5}
    assert all(row["noise_0"] > 0 for row in document["impacts"])
    assert main(arguments) == 0
    assert "| gcv |" in capsys.readouterr().out
