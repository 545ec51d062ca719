"""`bench kinect`: its rivals, calibration, networks and tables."""

import json
from pathlib import Path

import numpy as np
import pytest
from packed_pairs import write_packed
from refine_files import ASIDE, body

from mocapmend.bench import main
from mocapmend.bench.kinect import command
from mocapmend.bench.kinect.command import PAIRS
from mocapmend.bench.kinect.few_shot import calibrated
from mocapmend.bench.kinect.networks import (
    BRA_S_C,
    NETWORKS,
    Rounds,
    Shelf,
    settings_of,
)
from mocapmend.bench.kinect.rivals import SMOOTHED, raw_errors, rivals
from mocapmend.bench.kinect.tables import Row, targets
from mocapmend.refine.profiles import profile_named
from mocapmend_algorithms.arrays import FloatArray
from mocapmend_algorithms.refine.measures import Errors
from mocapmend_algorithms.refine.preparing import turned
from mocapmend_algorithms.refine.train.pairs import Pair

PROFILE = profile_named("kinect22-pig39")


def pair(seed: int, heading: float = 0.0, **who: int) -> Pair:
    joints, markers = body(PROFILE, 200, seed)
    both = [one - one[:, :1] for one in (joints, markers)]
    return Pair(*(turned(one[None], np.array([heading]))[0] for one in both), **who)


def test_regressions_find_what_is_linear() -> None:
    pairs = [pair(seed) for seed in range(4)]
    for name, predict in rivals(pairs[:3], PROFILE).items():
        error = predict(pairs[3].joints) - pairs[3].markers
        assert np.sqrt((error**2).mean()) < 0.6 * ASIDE, name


@pytest.mark.parametrize("name", [name for name in SMOOTHED if "raw" not in name])
def test_smoothing_takes_noise_away_and_keeps_the_motion(name: str) -> None:
    joints = pair(0).joints
    noise = np.random.default_rng(0).normal(0, 10, joints.shape)
    left = SMOOTHED[name](joints + noise) - joints
    assert np.sqrt((left[20:-20] ** 2).mean()) < 7


def test_raw_joints_are_measured_where_they_match() -> None:
    one = pair(0)
    found = raw_errors([one], PROFILE)
    inputs, outputs = (list(side) for side in zip(*PROFILE.matches, strict=True))
    expected = np.mean((one.joints[:, inputs] - one.markers[:, outputs]) ** 2)
    assert found.position == pytest.approx(expected)
    assert np.isnan(found.bones)


def test_a_calibration_takes_a_constant_error_away_whatever_the_heading() -> None:
    aside = np.random.default_rng(1).normal(0, 30, (39, 3))
    pairs = [
        pair(seed, heading=0.9 * seed, performer=seed % 2, movement=seed % 3, repetition=seed)
        for seed in range(12)
    ]

    def predict(joints: FloatArray) -> FloatArray:
        (one,) = [one for one in pairs if one.joints is joints]
        own = np.array([0.9 * one.repetition])
        return one.markers + turned(np.broadcast_to(aside, (1, *one.markers.shape)), own)[0]

    found = calibrated("a", pairs, predict, PROFILE)
    assert found.before.position == pytest.approx((aside**2).mean(), rel=1e-6)
    assert found.one.position < 0.05 * found.before.position
    assert found.each.position < 0.02 * found.before.position
    assert found.before.frames == found.one.frames == found.each.frames == 6 * 200


def test_networks_are_trained_once_and_found_again(
    tmp_path: Path, monkeypatch: pytest.MonkeyPatch
) -> None:
    pytest.importorskip("torch", reason="PyTorch is not installed")
    from mocapmend_algorithms.refine.train import settings

    monkeypatch.setattr(settings.Settings, "width", 4)
    shelf = Shelf(tmp_path)
    asked = BRA_S_C.settings(Rounds(1, 1, 0))
    assert shelf.find("BRA-S-C", "seen", asked) is None
    shelf.train("BRA-S-C", "seen", asked, [pair(0)])
    (path,) = tmp_path.iterdir()
    stamp = path.stat().st_mtime_ns
    shelf.train("BRA-S-C", "seen", asked, [pair(1)])
    assert path.stat().st_mtime_ns == stamp
    found = shelf.find("BRA-S-C", "seen", asked)
    assert found is not None
    assert found.shape.perceptual
    assert found.shape.stacks == 6
    assert found.mirrored
    assert settings_of(found) == asked
    assert shelf.find("BRA-S-C", "unseen", asked) is None
    assert Shelf(None).find("BRA-S-C", "seen", asked) is None


def test_the_networks_are_the_paper_s() -> None:
    names = {network.name for network in NETWORKS}
    assert names == {"BRA", *(f"BRA-S-{n}" for n in range(2, 7)), "BRA-S-C"}


def test_the_tables_are_printed(
    tmp_path: Path, capsys: pytest.CaptureFixture[str], monkeypatch: pytest.MonkeyPatch
) -> None:
    monkeypatch.setattr(command, "FRAMES_TIMED", {60: 120, 1: 4})
    monkeypatch.setattr(command, "SOME", 1)
    (tmp_path / "kinect").mkdir()
    path = write_packed(tmp_path / PAIRS, PROFILE, performers=9, repetitions=8)
    assert path.exists()
    assert main(["kinect", "--data", str(tmp_path), "--json"]) == 0
    found = json.loads(capsys.readouterr().out)
    assert {row["split"] for row in found["ways"]} == {"seen", "unseen"}
    ridge = [row for row in found["ways"] if row["way"] == "ridge on Butterworth"]
    assert [row["position_ratio"] for row in ridge] == [1, 1]
    assert [row["network"] for row in found["structures"]] == ["BRA", "BRA-S-6", "BRA-S-C"]
    assert [row["way"] for row in found["ways"] if "ships" in row["way"]] == [
        "ships", "ships, 6 Hz", "ships, mirror left out", "ships, mirror left out, 6 Hz",
    ]  # fmt: skip
    monkeypatch.setattr(command, "names", tuple)
    assert main(["kinect", "--data", str(tmp_path)]) == 0
    assert "| unseen | ridge on Savitzky-Golay |" in capsys.readouterr().out


def test_targets_are_held_against_what_was_reached() -> None:
    one, ridge = Errors(40.0, 20.0, 0.9, 10), Errors(100.0, 100.0, 1.0, 10)
    rows = [Row("seen", "a", one, ridge), Row("seen", "b", one, ridge)]
    grid = targets(rows, "a", "b", 1500.0)
    reached = [row["reached"] for row in grid.rows]
    assert reached == pytest.approx([0.4, 0.2, 0.9, 1.5])
