"""`mocapmend train sparse --atoms`: dictionaries of a skeleton's parts, and what uses them."""

from collections.abc import Callable
from importlib.resources import files
from pathlib import Path
from typing import Any

import numpy as np
import pytest

from mocapmend.cli import main
from mocapmend.errors import MocapmendError
from mocapmend.files import read_recording
from mocapmend_algorithms import find_gaps
from mocapmend_algorithms.sparse import part_sets
from mocapmend_algorithms.sparse.training_set import read_training_set
from mocapmend_resources import training as shipped

Json = Callable[..., tuple[int, Any]]
LOST = ("lhumerus", "lradius", "lwrist")


def skeleton(path: Path, frames: slice = slice(0, 80), lost: slice = slice(0, 0)) -> Path:
    """Write some of the shipped run as a recording of its own."""
    training = read_training_set(shipped.path_of("cmu-31-joints"))
    points = training.motions("+y")[0][frames].copy()
    for label in LOST:
        points[lost, training.labels.index(label)] = np.nan
    names = np.array(training.labels)
    np.savez(path, pos=points, fps=training.rate, names=names, units="mm", up="y")
    return path


def train(*arguments: object) -> int:
    return main(["train", "sparse", *map(str, arguments), "--atoms", "10", "--rounds", "2"])


def test_dictionaries_are_trained_and_told_of(run_json: Json, tmp_path: Path) -> None:
    out = tmp_path / "set.npz"
    path = skeleton(tmp_path / "run.npz")
    options = ("--motion", path, "-o", out, "--atoms", "10", "--rounds", "2")
    code, made = run_json("train", "sparse", *options)
    assert code == 0
    assert made["atoms"] == 10
    training = read_training_set(out)
    assert sorted(training.atoms) == [f"part {at}" for at in range(5)]
    for objectives in training.settings["objectives"].values():
        assert len(objectives) == 3
        assert objectives == sorted(objectives, reverse=True)


def test_a_training_that_was_broken_off_goes_on(
    tmp_path: Path, monkeypatch: pytest.MonkeyPatch
) -> None:
    path, whole, broken = skeleton(tmp_path / "run.npz"), tmp_path / "a.npz", tmp_path / "b.npz"
    assert train("--motion", path, "-o", whole) == 0
    real, parts = part_sets.train_part, []

    def breaking(motions: Any, body: Any, at: int, *rest: Any) -> Any:
        parts.append(at)
        if len(parts) == 3:
            raise MocapmendError("Broken off.", "", "")
        return real(motions, body, at, *rest)

    monkeypatch.setattr(part_sets, "train_part", breaking)
    assert train("--motion", path, "-o", broken) == 1
    assert sorted(read_training_set(broken).atoms) == ["part 0", "part 1"]
    assert train("--motion", path, "-o", broken, "--resume") == 0
    assert parts == [0, 1, 2, 2, 3, 4]
    assert broken.read_bytes() == whole.read_bytes()


def test_another_motion_is_trained_anew(tmp_path: Path) -> None:
    out, other = tmp_path / "set.npz", tmp_path / "other.npz"
    assert train("--motion", skeleton(tmp_path / "run.npz"), "-o", out) == 0
    path = skeleton(tmp_path / "later.npz", slice(20, 100))
    assert train("--motion", path, "-o", other) == 0
    assert train("--motion", path, "-o", out, "--resume") == 0
    assert out.read_bytes() == other.read_bytes()


def test_what_is_no_training_set_cannot_be_gone_on_with(
    tmp_path: Path, capsys: pytest.CaptureFixture[str]
) -> None:
    out = tmp_path / "set.npz"
    out.write_text("text")
    assert train("--motion", skeleton(tmp_path / "run.npz"), "-o", out, "--resume") == 1
    assert "Leave out --resume." in capsys.readouterr().err
    assert out.read_text() == "text"


def test_markers_on_skin_have_no_dictionaries(
    tmp_path: Path, capsys: pytest.CaptureFixture[str]
) -> None:
    out = tmp_path / "set.npz"
    walk = Path(str(files("mocapmend_resources") / "samples" / "walk_cmu_02_01.c3d"))
    assert train("--motion", walk, "-o", out) == 1
    assert "markers on skin" in capsys.readouterr().err
    assert not out.exists()


@pytest.mark.parametrize("dictionary", ["examples", "trained"])
def test_a_skeleton_is_repaired_from_the_shipped_set(
    run_json: Json, tmp_path: Path, dictionary: str
) -> None:
    path = skeleton(tmp_path / "lost.npz", slice(0, 120), slice(50, 70))
    out = tmp_path / "out.npz"
    options = ["--method", "bone-dictionary", "--max-error", "inf"]
    options += ["--param", "training=cmu-31-joints", "--param", f"dictionary={dictionary}"]
    code, done = run_json("repair", path, "-o", out, *options)
    assert code == 0
    assert [row["filled"] for row in done["gaps"]] == [True] * 3
    before, after = (read_recording(file).recording for file in (path, out))
    truth = read_recording(skeleton(tmp_path / "whole.npz", slice(0, 120))).recording
    kept = before.present
    np.testing.assert_array_equal(after.points[kept], before.points[kept])
    for gap in find_gaps(before.present):
        missed = after.points[gap.start : gap.stop, gap.marker]
        missed = missed - truth.points[gap.start : gap.stop, gap.marker]
        assert np.sqrt(np.mean(np.sum(missed**2, axis=1))) < 60


def test_trained_dictionaries_need_a_set_that_has_them(
    tmp_path: Path, capsys: pytest.CaptureFixture[str]
) -> None:
    bare, path = tmp_path / "bare.npz", skeleton(tmp_path / "lost.npz", lost=slice(50, 60))
    whole = skeleton(tmp_path / "run.npz")
    assert main(["train", "sparse", "--motion", str(whole), "-o", str(bare)]) == 0
    repair = ["repair", str(path), "-o", str(tmp_path / "out.npz"), "--method", "bone-dictionary"]
    for name, reason in (("", "none is given"), (str(bare), "has no trained dictionaries")):
        params = ["--param", "dictionary=trained", "--param", f"training={name}"]
        assert main([*repair, *params]) == 1
        assert reason in capsys.readouterr().err
