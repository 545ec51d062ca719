"""`bench poses`: its cases, its sweeps and what it prints."""

import json
from pathlib import Path

import numpy as np
import pytest

from mocapmend.bench import main, pose_cases, poses
from mocapmend.bench.pose_cases import COMPLEX, REPETITIVE, Subject, bundled, lose, of_folder
from mocapmend.bench.poses import OTHERS, OWN, PCA, PRINTED, SPLINE, TITLES
from mocapmend.errors import MocapmendError
from mocapmend_algorithms import Recording


def walker(frames: int = 150, markers: int = 9, phase: float = 0.0) -> Recording:
    """Return a body that walks and swings."""
    rng = np.random.default_rng(0)
    shape, swing = rng.normal(0, 400, (markers, 3)), rng.normal(0, 80, (2, markers, 3))
    time = np.arange(frames)[:, None, None] / 20 + phase
    points = shape + swing[0] * np.sin(time) + swing[1] * np.cos(2 * time)
    points[:, :, 0] += 10.0 * np.arange(frames)[:, None]
    return Recording(points, tuple(f"M{marker}" for marker in range(markers)), 120.0)


@pytest.fixture
def few(monkeypatch: pytest.MonkeyPatch) -> None:
    """Sweep little."""
    sweeps = (
        ("poses", "Poses in the dictionary", (20, 40)),
        ("seconds", "Length of the gap (s)", (0.1, 5.0)),
        ("markers", "Missing markers", (1, 20)),
    )
    monkeypatch.setattr(poses, "SWEEPS", sweeps)


@pytest.fixture
def folder(tmp_path: Path, monkeypatch: pytest.MonkeyPatch) -> Path:
    """Return a folder with a repetitive recording, another trial of it and a complex one."""
    trials = (
        pose_cases.Trial("walk", REPETITIVE, "cmu_joints/a.npz", ("b", "absent")),
        pose_cases.Trial("dance", COMPLEX, "cmu_markers/c.npz"),
        pose_cases.Trial("absent", COMPLEX, "cmu_markers/absent.npz"),
    )
    monkeypatch.setattr(pose_cases, "TRIALS", trials)
    for number, name in enumerate(("cmu_joints/a", "cmu_joints/b", "cmu_markers/c")):
        path = tmp_path / f"{name}.npz"
        path.parent.mkdir(exist_ok=True)
        recording = walker(phase=number / 3)
        np.savez(path, pos=recording.points, fps=120.0, names=recording.labels, units="mm", up="z")
    return tmp_path


def test_markers_are_lost_together_by_lot_and_nothing_else() -> None:
    subject = Subject("walk", REPETITIVE, walker())
    first, again, other = (lose(subject, 0.25, 3, number, 2) for number in (0, 0, 1))
    assert first is not None
    assert again is not None
    assert other is not None
    assert first.gaps == again.gaps != other.gaps
    assert {gap.length for gap in first.gaps} == {30}
    assert len({(gap.start, gap.stop) for gap in first.gaps}) == 1
    assert 0 < first.gaps[0].start < other.gaps[0].start
    assert other.gaps[0].stop < 150
    missing = np.isnan(first.recording.points)
    assert missing.sum() == 3 * 30 * 3
    np.testing.assert_array_equal(first.recording.points[~missing], subject.truth.points[~missing])


@pytest.mark.parametrize(("seconds", "markers"), [(0.7, 3), (0.1, 5)])
def test_what_would_leave_too_little_is_no_case(seconds: float, markers: int) -> None:
    assert lose(Subject("walk", REPETITIVE, walker()), seconds, markers, 0, 1) is None


def test_the_bundled_walk_is_complete() -> None:
    (subject,) = bundled()
    assert subject.kind == REPETITIVE
    assert subject.truth.present.all()
    assert not subject.others


def test_a_folder_gives_what_it_has(folder: Path, tmp_path: Path) -> None:
    walk, dance = of_folder(folder)
    assert (walk.motion, walk.kind, len(walk.others)) == ("walk", REPETITIVE, 1)
    assert (dance.motion, dance.kind, len(dance.others)) == ("dance", COMPLEX, 0)
    np.testing.assert_array_equal(walk.truth.points, walker().points)
    with pytest.raises(MocapmendError, match="None of the recordings"):
        of_folder(tmp_path / "nowhere")


@pytest.mark.usefixtures("few")
def test_the_tables_of_a_folder(capsys: pytest.CaptureFixture[str], folder: Path) -> None:
    assert main(["poses", "--data", str(folder), "--runs", "1", "--json"]) == 0
    document = json.loads(capsys.readouterr().out)
    sizes = document["poses"]
    assert [(row["kind"], row["value"]) for row in sizes] == [
        (kind, value) for kind in (REPETITIVE, COMPLEX) for value in (20, 40)
    ]
    # Five seconds are longer than half a recording, and of nine markers four may be missing.
    assert [row["value"] for row in document["seconds"]] == [0.1, 0.1]
    assert [row["value"] for row in document["markers"]] == [1, 1]
    for row in sizes:
        assert row["count"] == 1
        assert 0 < row[OWN] < 0.3 * row[SPLINE]
        assert row[PCA] > 0
        assert row[PRINTED] > 0
        assert (row[OTHERS] is None) == (row["kind"] == COMPLEX)
    assert {row["method"] for row in document["motions"] if row["motion"] == "walk"} == {
        TITLES[method] for method in (OWN, OTHERS, PCA, SPLINE)
    }
    assert all(0 <= row["inside"] <= 100 for row in document["motions"])
    assert len(document["cases"]) == 2 * 4


@pytest.mark.usefixtures("few")
def test_the_bundled_walk_says_what_is_missing(capsys: pytest.CaptureFixture[str]) -> None:
    assert main(["poses", "--runs", "1"]) == 0
    printed = capsys.readouterr().out
    assert "complex motion and other trials need the recordings that --data names" in printed
    assert "| repetitive | 20 | 1 |" in printed
    assert "| complex |" not in printed


@pytest.mark.usefixtures("few")
def test_two_runs_give_the_same_errors(capsys: pytest.CaptureFixture[str], folder: Path) -> None:
    documents = []
    for _ in range(2):
        assert main(["poses", "--data", str(folder), "--runs", "1", "--json"]) == 0
        documents.append(json.loads(capsys.readouterr().out))
    assert documents[0]["cases"] == documents[1]["cases"]
