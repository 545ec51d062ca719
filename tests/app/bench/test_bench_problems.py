"""`bench problems`: errors of known place, and tables that say how well they are found."""

import json
from importlib.resources import files
from pathlib import Path
from typing import Any

import numpy as np
import pytest
from jsonschema import Draft202012Validator

from mocapmend.bench import main
from mocapmend.bench.problems import command, injections, recordings, trials, untouched
from mocapmend.bench.problems.corruption import RATE, Canvas, Corruptor, Injected
from mocapmend.bench.problems.experiments import EXPERIMENTS
from mocapmend.bench.problems.rivals import acceleration, best_threshold, speed
from mocapmend.bench.problems.scores import Score, flagged
from mocapmend.files import read_recording
from mocapmend_algorithms import Recording
from mocapmend_algorithms.problems import BadRun

FRAMES, MARKERS = 400, 12


def swaying(seed: int = 0) -> Recording:
    """Make a stiff body that sways; its markers are at least 120 mm apart."""
    rng = np.random.default_rng(seed)
    grid = 130.0 * np.stack(np.meshgrid(range(3), range(2), range(2)), axis=-1).reshape(-1, 3)
    t = np.arange(FRAMES) / 100.0
    way = np.stack((400.0 * np.sin(t), 300.0 * np.cos(1.3 * t), 50.0 * np.sin(2.0 * t)), axis=1)
    grid = grid + rng.uniform(-8.0, 8.0, grid.shape)
    points = way[:, None] + grid + 0.1 * rng.normal(size=(FRAMES, MARKERS, 3))
    return Recording(points, tuple(f"M{k}" for k in range(MARKERS)), 100.0)


@pytest.fixture
def data(tmp_path: Path, monkeypatch: pytest.MonkeyPatch) -> Path:
    """Write recordings of a training and a validation half, one of them clean."""
    for seed, name in enumerate(("a.npz", "b.npz")):
        recording = swaying(seed)
        np.savez(
            tmp_path / name, pos=recording.points, names=recording.labels, fps=100.0, units="mm"
        )
    for module in (recordings, trials, command):
        monkeypatch.setattr(module, "HALVES", {"train": ("a.npz",), "validation": ("b.npz",)})
    monkeypatch.setattr(command, "CLEAN", ("a.npz",))
    monkeypatch.setattr(command, "KNOWN", ())
    recordings.load.cache_clear()
    trials.own_errors.cache_clear()
    return tmp_path


# --- errors that are put in ----------------------------------------------------------------------


@pytest.mark.parametrize("experiment", EXPERIMENTS, ids=lambda each: each.key)
def test_errors_are_put_in_at_the_rate_and_are_what_they_say(experiment: Any) -> None:
    corruptor = Corruptor(experiment.corrupt, 3)
    total = 0
    put_in: list[int] = []
    for seed in range(40):
        source = swaying(seed)
        canvas = corruptor.corrupted(source)
        truth = canvas.truth()
        put_in += [error.samples for error in canvas.errors]
        total += source.present.size
        now, before = canvas.recording.points, source.points
        kept = ~truth[:, :MARKERS]
        same = (now[:, :MARKERS] == before).all(axis=2) | np.isnan(now[:, :MARKERS, 0])
        # Nothing else has changed, but that gaps may hide some of it.
        assert same[kept].all()
        for error in canvas.errors:
            for marker in error.markers:
                some = now[error.start : error.stop, marker]
                if error.belongs_to is not None:
                    assert np.array_equal(some, before[error.start : error.stop, error.belongs_to])
                else:
                    assert not (some == before[error.start : error.stop, marker]).all()
    if experiment.key == "swaps-near":
        assert put_in == []  # No two markers are as near here.
    else:
        # The last one may overshoot.
        assert RATE * total <= sum(put_in) < RATE * total + max(put_in)


def test_the_same_seed_puts_in_the_same_errors() -> None:
    one, two = (
        Corruptor(injections.spike(20, 200, 1, 5), 5).corrupted(swaying()) for _ in range(2)
    )
    assert one.errors == two.errors
    assert np.array_equal(one.points, two.points)


# --- scores --------------------------------------------------------------------------------------


def test_the_score_of_a_find_by_hand() -> None:
    canvas = Canvas.of(swaying())
    canvas.add(Injected((2,), 100, 110))
    canvas.add(Injected((3,), 200, 204))
    found = flagged(
        (FRAMES, MARKERS),
        [
            BadRun("spikes", 2, 103, 112, 1.0, 1.0, ""),
            BadRun("spikes", 5, 50, 52, 1.0, 1.0, ""),
            BadRun("spikes", 6, 50, 53, 1.0, 1.0, ""),
        ],
    )
    own = np.zeros((FRAMES, MARKERS), dtype=bool)
    own[:, 6] = True
    score = Score()
    score.count(canvas, found, own)
    assert (score.right, score.false, score.earlier, score.missed) == (7, 4, 3, 7)
    assert (score.errors, score.found, score.latency[0]) == (2, 1, 3.0)
    assert score.precision == pytest.approx(7 / 11)
    assert score.strict_precision == pytest.approx(7 / 14)
    assert score.recall == pytest.approx(0.5)
    assert score.f1 == pytest.approx(14 / (14 + 4 + 7))
    assert score.strict_f1 == pytest.approx(14 / (14 + 7 + 7))


def test_simple_thresholds_measure_what_they_say() -> None:
    points = np.zeros((10, 1, 3))
    points[:, 0, 0] = np.arange(10) * 20.0  # 20 mm in 10 ms
    points[5, 0, 1] = 30.0
    recording = Recording(points, ("M",), 100.0)
    assert speed(recording)[2, 0] == pytest.approx(2.0)
    assert speed(recording)[5, 0] == pytest.approx(np.hypot(2.0, 3.0))
    assert acceleration(recording)[5, 0] == pytest.approx(600.0)
    sizes = np.array([1.0, 5.0, 4.0, 3.0, 2.0])
    assert best_threshold(sizes, np.array([False, True, True, False, False])) == 4.0


def test_a_swap_is_only_taken_back_exactly_by_its_very_frames() -> None:
    canvas = Corruptor(injections.swap(50, 1e9, 30), 1).corrupted(swaying())
    (error,) = canvas.errors[:1]
    a, b = sorted(error.markers)
    right = BadRun("swaps", a, error.start, error.stop, 1.0, 1.0, "", other=b)
    late = BadRun("swaps", a, error.start, error.stop + 1, 1.0, 1.0, "", other=b)
    assert trials._taken_back(canvas, [right]) == [True]
    assert trials._taken_back(canvas, [late]) == [False]
    assert error.stop - error.start > 1
    early = BadRun("swaps", a, error.start, error.stop - 1, 1.0, 1.0, "", b)
    assert trials._taken_back(canvas, [early]) == [False]
    assert trials._taken_back(canvas, []) == []


# --- the command ---------------------------------------------------------------------------------


def test_the_tables(data: Path, capsys: pytest.CaptureFixture[str]) -> None:
    asked = [
        "problems",
        "--data",
        str(data),
        "--only",
        "spikes-1,swaps,untouched",
        "--repeats",
        "4",
    ]
    assert main([*asked, "--json"]) == 0
    document = json.loads(capsys.readouterr().out, parse_constant=pytest.fail)
    text = files("mocapmend_resources").joinpath("schemas/cli.json").read_text("utf-8")
    Draft202012Validator(json.loads(text)).validate(document)
    ways = [(row["recordings"], row["way"].partition(",")[0]) for row in document["detectors"]]
    each = ["velocity threshold", "acceleration threshold"]
    assert ways == [
        (half, way)
        for kind in ("spikes", "swaps")
        for half in ("train", "validation")
        for way in (kind, *each)
    ]
    own = [row for row in document["detectors"] if row["way"] in ("spikes", "swaps")]
    assert all(row["f1"] > 0.95 for row in own)
    assert all(row["exact"] == 1.0 for row in own if row["way"] == "swaps" and row["count"])
    assert [row["share"] for row in document["untouched"]] == [0.0, 0.0]
    targets = {row["what"]: row["met"] for row in document["targets"]}
    assert targets["F1 of spikes: 1 frame, 20-200 mm"]
    assert main(asked) == 0
    printed = capsys.readouterr().out
    assert "| validation | spikes: 1 frame, 20-200 mm | spikes |" in printed
    with pytest.raises(SystemExit):
        main(["problems", "--only", "spooks"])


def test_the_worst_of_an_untouched_recording(data: Path) -> None:
    points = swaying().points.copy()
    points[77, 4] += 90.0
    np.savez(data / "c.npz", pos=points, names=swaying().labels, fps=100.0, units="mm")
    found = untouched.look(data, "c.npz")
    assert found.flagged["spikes"] == found.all_flagged == 1
    assert found.worst.startswith("spikes, M4, frame 78: For 1 frame it is 156 mm from where")


@pytest.mark.shared
def test_the_recordings_are_there_and_in_one_half(shared: Path) -> None:
    assert not set(recordings.TRAIN) & set(recordings.VALIDATION)
    for name in {*recordings.TRAIN, *recordings.VALIDATION, *recordings.CLEAN, *recordings.KNOWN}:
        assert read_recording(shared / name).measured.frames > 100
