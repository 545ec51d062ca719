"""`bench labels`: what it makes of recordings, and how it counts, on bodies made for the test."""

import json
import sys
from importlib.resources import files
from pathlib import Path

import numpy as np
import pytest
from jsonschema import Draft202012Validator

from mocapmend.bench import main
from mocapmend.bench.labels import pairs, scrambling, trials
from mocapmend.bench.labels.naive import label_naively
from mocapmend.bench.labels.pairs import ACROSS, OTHER_SET, SAME
from mocapmend.bench.labels.scrambling import GHOST, NOTHING, scramble
from mocapmend.errors import MocapmendError
from mocapmend_algorithms.labelling import LabelModel

sys.path.insert(0, str(Path(__file__).parents[2] / "algorithms" / "labelling"))
from body_samples import LABELS, body

MADE = {"132_32": 0.0, "132_43": 1.0, "127_07": 2.0}


@pytest.fixture
def data(tmp_path: Path, monkeypatch: pytest.MonkeyPatch) -> Path:
    """Write three recordings; the third has another label set."""
    folder = tmp_path / pairs.FOLDER
    folder.mkdir()
    for name, phase in MADE.items():
        made = body(120, phase=phase)
        labels = [f"X{label}" if name == "127_07" else label for label in LABELS]
        np.savez(
            folder / f"{name}.npz", pos=made.points, fps=100.0, names=np.array(labels), units="mm",
            up="z",
        )  # fmt: skip
    monkeypatch.setattr(pairs, "FILES", {name: f"{name}.npz" for name in MADE})
    pairs.load.cache_clear()
    trials.model_of.cache_clear()
    return tmp_path


def test_scrambling_keeps_every_sample_that_is_not_hidden() -> None:
    made = body(400)
    scrambled = scramble(made, 5)
    recording, truth = scrambled.recording, scrambled.truth
    assert np.array_equal(truth != NOTHING, recording.present)
    assert all(label.startswith("*") for label in recording.labels)
    heights, real = recording.points[:, :, 2], made.points[:, :, 2]
    shown = np.zeros(real.shape, int)
    for frame, point in np.argwhere(truth >= 0).tolist():
        assert heights[frame, point] == real[frame, truth[frame, point]]
        shown[frame, truth[frame, point]] += 1
    assert shown.max() == 1
    hidden = 1.0 - shown.mean()
    assert 0.01 < hidden < 0.2
    assert (truth == GHOST).any()
    assert scrambled.pieces > recording.markers > made.markers
    again = scramble(made, 5)
    np.testing.assert_array_equal(again.recording.points, recording.points)
    assert not (scramble(made, 6, ghosts=False).truth == GHOST).any()


def test_kept_names_are_those_of_the_points_that_hold_them() -> None:
    scrambled = scramble(body(200), 2, keep=0.5)
    kept = 0
    for point, label in enumerate(scrambled.recording.labels):
        if not label.startswith("*"):
            kept += 1
            held = set(scrambled.truth[:, point].tolist()) - {NOTHING}
            assert held <= {LABELS.index(label)}
    assert 8 <= kept <= 30


def test_the_rival_labels_a_pose_that_stands_still_and_not_one_that_moves() -> None:
    model = LabelModel.learn([body(60, noise=0.0)])
    still = body(60, noise=0.0)
    pose = model.poses[0] + (100.0, 200.0, 900.0)
    right = label_naively(still.with_points(np.repeat(pose[None], 2, axis=0)), model)
    assert (right == np.arange(len(LABELS))).all()
    moving = label_naively(body(60, phase=2.5), model)
    assert 0.1 < (moving == np.arange(len(LABELS))).mean() < 0.99


def test_pairs_are_of_one_half_and_know_their_kind(data: Path) -> None:
    kinds = {(pair.target, pair.source): pair.kind for pair in pairs.pairs(data)}
    assert kinds["132_32", "132_43"] == SAME
    assert kinds["127_07", "132_43"] == OTHER_SET
    assert len(kinds) == 6
    assert {pair.half for pair in pairs.pairs(data)} == {"train"}
    assert ACROSS not in kinds.values()


def test_the_report_counts_and_keeps_to_the_schema(
    data: Path, capsys: pytest.CaptureFixture[str]
) -> None:
    arguments = ["labels", "--data", str(data), "--kind", SAME, "--recordings", "132_32"]
    assert main([*arguments, "--json"]) == 0
    document = json.loads(capsys.readouterr().out)
    schema = files("mocapmend_resources").joinpath("schemas/cli.json").read_text("utf-8")
    Draft202012Validator(json.loads(schema)).validate(document)
    bare, named = document["summary"]
    assert (bare["named"], named["named"]) == ("0%", "50%")
    assert bare["met"] is (bare["right"] >= 0.99)
    assert bare["right"] > bare["naive"]
    assert named["samples"] < bare["samples"]
    assert sum(row["pieces"] for row in document["confidence"]) > 0
    # Occlusions are chosen anew for every seed, so that a trial tells which it was.
    assert [trial["seed"] for trial in document["trials"]] == [1, 1]
    assert str(scrambling.STATIC_GHOSTS) in document["notes"][1]


def test_what_is_not_there_is_one_clear_error(data: Path) -> None:
    with pytest.raises(MocapmendError, match="No pair"):
        main(["labels", "--data", str(data), "--half", "validation"])
    with pytest.raises(MocapmendError):
        main(["labels", "--data", str(data / "nowhere")])


@pytest.mark.shared
def test_a_subject_s_other_trial_labels_a_walk(shared: Path) -> None:
    pairs.load.cache_clear()
    trials.model_of.cache_clear()
    (pair,) = [
        pair for pair in pairs.pairs(shared) if (pair.target, pair.source) == ("132_32", "132_43")
    ]
    trial = trials.attempt(shared, pair, 1, 0.0, naive=False)
    assert trial.right / trial.samples >= 0.99
