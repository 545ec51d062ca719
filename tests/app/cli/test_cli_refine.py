"""`mocapmend refine` and `train refine`: joints in, computed markers out, and nothing hidden."""

from collections.abc import Callable
from pathlib import Path
from typing import Any

import numpy as np
import pytest
from refine_files import write_model, write_pair, write_pairs

from mocapmend.cli import main
from mocapmend.files import check_files, read_c3d, read_recording
from mocapmend.refine.card import card_text
from mocapmend.refine.profiles import profile_named, profiles
from mocapmend_algorithms.refine.model import read_model

Json = Callable[..., tuple[int, Any]]
PROFILES = tuple(profiles())


@pytest.fixture(params=PROFILES)
def profile(request: pytest.FixtureRequest) -> Any:
    """Return each profile that ships with the program."""
    return profile_named(request.param)


# --- refine ----------------------------------------------------------------------------------


def test_joints_become_markers(run_json: Json, tmp_path: Path, profile: Any) -> None:
    recording, _ = write_pair(tmp_path, profile)
    model = write_model(tmp_path / "model.npz", profile)
    before = recording.read_bytes()
    out = tmp_path / "out.c3d"
    code, made = run_json("refine", recording, "-o", out, "--model", model)
    assert code == 0
    assert recording.read_bytes() == before
    assert made["markers"] == list(profile.outputs)
    assert made["comparison"] is None
    written = read_c3d(out)
    given = read_recording(recording)
    assert written.recording.labels == profile.outputs
    assert written.recording.frames == given.recording.frames
    assert written.recording.rate == given.recording.rate
    assert written.recording.up == given.recording.up
    record = written.provenance.refined
    assert (record.model, record.profile) == ("model", profile.id)
    assert record.parameters == {"stride": "60", "cutoff_hz": None}
    assert any("none was measured" in warning for warning in written.warnings)
    code, told = run_json("info", out)
    assert code == 0
    assert told["refined"] == record.as_json()
    code, told = run_json("info", recording)
    assert told["refined"] is None


@pytest.mark.parametrize("ending", [".csv", ".trc", ".npz", ".long.csv"])
def test_other_formats_have_the_record_beside_them(
    run_json: Json, tmp_path: Path, ending: str
) -> None:
    profile = profile_named(PROFILES[0])
    recording, _ = write_pair(tmp_path, profile)
    model = write_model(tmp_path / "model.npz", profile)
    out = tmp_path / f"out{ending}"
    code, made = run_json("refine", recording, "-o", out, "--model", model, "--cutoff", 6)
    assert code == 0
    assert made["repair_record"]["place"] == "sidecar"
    found = read_recording(out)
    assert found.recording.labels == profile.outputs
    assert found.provenance.refined.parameters["cutoff_hz"] == 6


def test_the_record_outlives_a_repair(run_json: Json, tmp_path: Path) -> None:
    profile = profile_named(PROFILES[0])
    recording, _ = write_pair(tmp_path, profile)
    model = write_model(tmp_path / "model.npz", profile)
    out, copy, table = (tmp_path / name for name in ("out.c3d", "copy.c3d", "copy.csv"))
    assert run_json("refine", recording, "-o", out, "--model", model)[0] == 0
    code, _ = run_json("repair", out, "-o", copy, "--max-error", "inf")
    assert code == 0
    record = read_c3d(out).provenance.refined
    assert read_c3d(copy).provenance.refined == record
    assert check_files(out, copy).passed
    code, _ = run_json("convert", copy, "-o", table)
    assert code == 0
    assert read_recording(table).provenance.refined == record


def test_a_reference_is_measured_against(run_json: Json, tmp_path: Path, profile: Any) -> None:
    recording, reference = write_pair(tmp_path, profile, lag=12)
    model = write_model(tmp_path / "model.npz", profile, copies=True)
    out = tmp_path / "out.c3d"
    arguments = ["refine", recording, "-o", out, "--model", model, "--reference", reference]
    code, made = run_json(*arguments)
    assert code == 0
    found = made["comparison"]
    assert found["lag_s"] == pytest.approx(12 / 30, abs=0.02)
    assert found["frames"] > 100
    assert found["position_mm2"] > 0
    assert found["reference_bones_mm2"] >= 0
    assert set(found["rms_mm"]) == set(profile.outputs)


def test_a_calibration_takes_the_mean_error_away(run_json: Json, tmp_path: Path) -> None:
    profile = profile_named(PROFILES[0])
    recording, reference = write_pair(tmp_path, profile)
    pair = write_pair(tmp_path, profile, "other", seed=1)
    model = write_model(tmp_path / "model.npz", profile, copies=True)
    words = ["refine", recording, "--model", model, "--reference", reference]
    code, plain = run_json(*words, "-o", tmp_path / "plain.c3d")
    assert code == 0
    out = tmp_path / "out.c3d"
    code, made = run_json(*words, "-o", out, "--calibrate", *pair, "--calibrate", *pair)
    assert code == 0
    assert made["calibrated_with"] == [[str(path) for path in pair]] * 2
    ratio = made["comparison"]["position_mm2"] / plain["comparison"]["position_mm2"]
    assert ratio < 0.6
    record = read_c3d(out).provenance.refined
    assert len(record.parameters["calibration_sha256"]) == 4
    own = ("--calibrate", recording, reference)
    code, wrong = run_json(*words, "-o", out, "--overwrite", *own)
    assert code == 1
    assert wrong["error"]["what"] == "A recording cannot calibrate itself."
    code, wrong = run_json(*words, "-o", out, "--overwrite", "--calibrate", pair[1], pair[0])
    assert code == 1
    assert wrong["error"]["where"] == str(pair[1])


def test_missing_joints_are_bridged_and_told(
    run_json: Json, tmp_path: Path, capsys: pytest.CaptureFixture[str]
) -> None:
    profile = profile_named(PROFILES[0])
    recording, _ = write_pair(tmp_path, profile, hole=(3, 20, 29))
    model = write_model(tmp_path / "model.npz", profile)
    out = tmp_path / "out.c3d"
    code, made = run_json("refine", recording, "-o", out, "--model", model)
    assert code == 0
    assert made["bridged_frames"] == {profile.inputs[3]: 9}
    assert np.isfinite(read_c3d(out).recording.points).all()


def test_people_read_what_was_done(tmp_path: Path, capsys: pytest.CaptureFixture[str]) -> None:
    profile = profile_named(PROFILES[0])
    recording, reference = write_pair(tmp_path, profile, hole=(3, 20, 29))
    model = write_model(tmp_path / "model.npz", profile, copies=True)
    out = tmp_path / "out.c3d"
    words = ["refine", recording, "-o", out, "--model", model, "--reference", reference]
    assert main([str(word) for word in words]) == 0
    said = capsys.readouterr()
    assert "39 markers computed in 150 frames" in said.out
    assert "reference itself" in said.out
    assert "was missing in 9 frames and was bridged" in said.err


def test_the_card_is_shown(
    run_json: Json, tmp_path: Path, capsys: pytest.CaptureFixture[str]
) -> None:
    profile = profile_named(PROFILES[0])
    model = write_model(tmp_path / "model.npz", profile)
    code, made = run_json("refine", "--card", "--model", model)
    assert code == 0
    assert made["card"]["about"] == "random weights"
    assert main(["refine", "--card", "--model", str(model)]) == 0
    assert "an estimate, not a measurement" in capsys.readouterr().out


def test_a_profile_is_never_taken_for_another(run_json: Json, tmp_path: Path) -> None:
    one, other = (profile_named(name) for name in PROFILES)
    recording, _ = write_pair(tmp_path, other)
    model = write_model(tmp_path / "model.npz", one)
    code, made = run_json("refine", recording, "-o", tmp_path / "out.c3d", "--model", model)
    assert code == 1
    assert "the network is for other points" in made["error"]["what"].lower()
    assert f"the profile {other.id}" in made["error"]["todo"]
    assert not (tmp_path / "out.c3d").exists()


def test_joints_that_are_never_seen_are_to_be_put_right_first(
    run_json: Json, tmp_path: Path
) -> None:
    profile = profile_named(PROFILES[0])
    recording, _ = write_pair(tmp_path, profile, hole=(4, 0, 149))
    model = write_model(tmp_path / "model.npz", profile)
    code, made = run_json("refine", recording, "-o", tmp_path / "out.c3d", "--model", model)
    assert code == 1
    assert f"never seen: {profile.inputs[4]}" in made["error"]["what"]
    assert made["error"]["todo"].startswith("Put the recording right first")


@pytest.mark.parametrize("model", ["nobody", "model.txt", "folder"])
def test_what_is_no_network_is_refused(run_json: Json, tmp_path: Path, model: str) -> None:
    recording, _ = write_pair(tmp_path, profile_named(PROFILES[0]))
    (tmp_path / "model.txt").write_text("hello")
    (tmp_path / "folder").mkdir()
    code, made = run_json(
        "refine", recording, "-o", tmp_path / "o.c3d", "--model", tmp_path / model
    )
    assert code == 1
    assert "train refine" in made["error"]["todo"]


@pytest.mark.parametrize(
    "words",
    [
        ["--cutoff", "0"],
        ["--cutoff", "40"],
        ["--cutoff", "six"],
        ["--stride", "7"],
        [],
    ],
)
def test_wrong_usage(tmp_path: Path, words: list[str]) -> None:
    with pytest.raises(SystemExit) as stop:
        main(["refine", *(["x.c3d", "-o", "y.c3d"] if words else []), *words])
    assert stop.value.code == 2


# --- train refine ----------------------------------------------------------------------------


def train(run_json: Json, folder: Path, *words: object) -> tuple[int, Any]:
    pytest.importorskip("torch", reason="PyTorch is not installed")
    small = ["--stacks", 1, "--width", 6, "--rounds", 2, "--first-rounds", 2]
    return run_json("train", "refine", "--pairs", folder / "pairs.csv", *small, *words)


def test_a_network_is_trained_on_pairs_of_files(
    run_json: Json, tmp_path: Path, profile: Any
) -> None:
    write_pairs(tmp_path, profile, 3)
    out = tmp_path / "model.npz"
    words = ["-o", out, "--profile", profile.id, "--hold-out", "repetitions=2", "--seed", 5]
    words += ["--curve", tmp_path / "curve.csv"]
    code, made = train(run_json, tmp_path, *words)
    assert code == 0
    assert made["card"]["pairs"] == 2
    assert made["card"]["measured_on"] == 1
    assert [stage for stage, _, _ in made["card"]["curve"]] == ["perceptual"] * 2 + ["stack"] * 2
    model = read_model(out)
    assert model.profile == profile
    assert model.card == made["card"]
    assert not list(tmp_path.glob("*.training"))
    rows = (tmp_path / "curve.csv").read_text().splitlines()
    assert rows[0] == "stage,round,loss"
    assert [row.split(",")[:2] for row in rows[1:]] == [
        ["perceptual", "1"], ["perceptual", "2"], ["stack", "1"], ["stack", "2"],
    ]  # fmt: skip
    recording = read_recording(tmp_path / "0.c3d")
    code, _ = run_json("refine", recording.path, "-o", tmp_path / "out.c3d", "--model", out)
    assert code == 0


def test_the_card_says_how_good_it_is_on_new_people(run_json: Json, tmp_path: Path) -> None:
    profile = profile_named(PROFILES[0])
    write_pairs(tmp_path, profile, 3)
    apart, out = tmp_path / "apart.npz", tmp_path / "model.npz"
    code, other = train(run_json, tmp_path, "-o", apart, "--hold-out", "performers=2")
    assert code == 0
    code, made = train(run_json, tmp_path, "-o", out, "--new-people", apart)
    assert code == 0
    assert made["card"]["new_people"] == {
        name: other["card"][name] for name in ("held_out", "measured_on", "figures")
    }
    assert "--new-people apart.npz" in made["card"]["command"]
    assert "figures" not in made["card"]
    code, card = run_json("refine", "--card", "--model", out)
    assert code == 0
    assert card["card"]["new_people"]["held_out"] == "performers 2"
    text = card_text(read_model(out))
    assert "the same training without some people (performers 2; pairs: 1)" in text


def test_new_people_are_those_of_the_same_training(run_json: Json, tmp_path: Path) -> None:
    write_pairs(tmp_path, profile_named(PROFILES[0]), 3)
    apart, out = tmp_path / "apart.npz", tmp_path / "model.npz"
    assert train(run_json, tmp_path, "-o", apart, "--hold-out", "repetitions=2")[0] == 0
    code, made = train(run_json, tmp_path, "-o", out, "--new-people", apart, "--seed", 1)
    assert code == 1
    assert "other settings" in made["error"]["what"]
    code, made = train(run_json, tmp_path, "-o", out, "--new-people", apart)
    assert code == 1
    assert "not measured on performers" in made["error"]["what"]
    code, made = train(run_json, tmp_path, "-o", out, "--new-people", tmp_path / "pairs.csv")
    assert code == 1
    assert "not a model" in made["error"]["what"]
    assert not out.exists()


def test_the_card_s_command_makes_the_same_network(run_json: Json, tmp_path: Path) -> None:
    profile = profile_named(PROFILES[0])
    write_pairs(tmp_path, profile, 2)
    first, second = tmp_path / "first.npz", tmp_path / "second.npz"
    code, made = train(run_json, tmp_path, "-o", first, "--no-changes", "--projected")
    assert code == 0
    words = made["card"]["command"].split()[3:]
    words[words.index("--pairs") + 1] = str(tmp_path / "pairs.csv")
    words[words.index("-o") + 1] = str(second)
    code, _ = run_json("train", "refine", *words)
    assert code == 0
    one, other = read_model(first), read_model(second)
    for name, array in one.weights.items():
        np.testing.assert_array_equal(array, other.weights[name])


def test_a_training_goes_on_where_it_was_broken_off(
    run_json: Json, tmp_path: Path, monkeypatch: pytest.MonkeyPatch
) -> None:
    pytest.importorskip("torch", reason="PyTorch is not installed")
    from mocapmend_algorithms.refine.train.loop import Training

    profile = profile_named(PROFILES[0])
    write_pairs(tmp_path, profile, 2)
    whole, parts = tmp_path / "whole.npz", tmp_path / "parts.npz"
    assert train(run_json, tmp_path, "-o", whole)[0] == 0
    done = Training.state

    def stop(training: Training) -> dict[str, Any]:
        if len(training.curve) == 3:
            raise KeyboardInterrupt
        return done(training)

    with monkeypatch.context() as patch:
        patch.setattr(Training, "state", stop)
        words = ["--stacks", "1", "--width", "6", "--rounds", "2", "--first-rounds", "2"]
        words += ["--pairs", str(tmp_path / "pairs.csv"), "-o", str(parts)]
        assert main(["train", "refine", *words]) == 130
    assert not parts.exists()
    code, made = train(run_json, tmp_path, "-o", parts)
    assert code == 1
    assert "already" in made["error"]["what"]
    code, made = train(run_json, tmp_path, "-o", parts, "--resume", "--seed", 3)
    assert code == 1
    assert "other pairs or settings" in made["error"]["what"]
    assert train(run_json, tmp_path, "-o", parts, "--resume")[0] == 0
    one, other = read_model(whole), read_model(parts)
    for name, array in one.weights.items():
        np.testing.assert_array_equal(array, other.weights[name])


def test_a_state_that_is_none_is_refused(run_json: Json, tmp_path: Path) -> None:
    write_pairs(tmp_path, profile_named(PROFILES[0]), 1)
    (tmp_path / "model.npz.training").write_text("hello")
    code, made = train(run_json, tmp_path, "-o", tmp_path / "model.npz", "--resume")
    assert code == 1
    assert "no state" in made["error"]["what"]


@pytest.mark.parametrize(
    ("text", "what"),
    [
        ("", "lists nothing"),
        ("recording,reference\n", "lists nothing"),
        ("recording\n0.c3d\n", "lacks its reference"),
        ("recording,reference,performer\n0.c3d,0_reference.c3d,Anna\n", "whole number"),
        ("recording,reference\n0.c3d,none.c3d\n", "no such file"),
        ("recording,reference\n0_reference.c3d,0.c3d\n", "cannot be used"),
        ("\x00\xff", "no list"),
    ],
)
def test_wrong_lists_are_refused(run_json: Json, tmp_path: Path, text: str, what: str) -> None:
    write_pairs(tmp_path, profile_named(PROFILES[0]), 1)
    (tmp_path / "pairs.csv").write_bytes(text.encode("latin-1"))
    code, made = train(run_json, tmp_path, "-o", tmp_path / "model.npz")
    assert code == 1
    assert what in made["error"]["what"]


def test_all_cannot_be_held_out(run_json: Json, tmp_path: Path) -> None:
    write_pairs(tmp_path, profile_named(PROFILES[0]), 1)
    words = ["-o", tmp_path / "model.npz", "--hold-out", "performers=0"]
    code, made = train(run_json, tmp_path, *words)
    assert code == 1
    assert "held out" in made["error"]["what"]


@pytest.mark.parametrize(
    "words",
    [
        ["--hold-out", "people=1"],
        ["--hold-out", "performers=a"],
        ["--stacks", "0"],
        ["--width", "1e9"],
        ["--seed", "-1"],
        ["--profile", "kinect"],
    ],
)
def test_wrong_usage_of_training(words: list[str]) -> None:
    with pytest.raises(SystemExit) as stop:
        main(["train", "refine", "--pairs", "p.csv", "-o", "m.npz", *words])
    assert stop.value.code == 2


def test_without_pytorch_it_says_what_to_install(
    run_json: Json, tmp_path: Path, monkeypatch: pytest.MonkeyPatch
) -> None:
    import sys

    write_pairs(tmp_path, profile_named(PROFILES[0]), 1)
    monkeypatch.setitem(sys.modules, "torch", None)
    for name in [name for name in sys.modules if name.startswith("mocapmend_algorithms.refine.tr")]:
        monkeypatch.delitem(sys.modules, name)
    words = ["--pairs", tmp_path / "pairs.csv", "-o", tmp_path / "model.npz"]
    code, made = run_json("train", "refine", *words)
    assert code == 1
    assert "PyTorch" in made["error"]["what"]
    assert "mocapmend[train]" in made["error"]["todo"]
