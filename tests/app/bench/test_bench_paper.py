"""`bench paper`: its trials, losses, errors, cache and report, on walks made for the test."""

import functools
import json
import math
import sys
from collections.abc import Iterator, Sequence
from dataclasses import replace
from pathlib import Path
from typing import Any

import numpy as np
import pytest

from mocapmend.bench import main
from mocapmend.bench.paper import command, rivals, tables, trained, trials
from mocapmend.bench.paper.trials import (
    REGIONS,
    MotionSet,
    Trial,
    bone_rmse,
    cases,
    read_joints,
    read_trials,
    rmse,
    spectrum,
    with_noise,
)
from mocapmend.errors import MocapmendError
from mocapmend_algorithms import Recording
from mocapmend_algorithms.sparse.body import PARTS, find_body
from mocapmend_algorithms.sparse.bone_space import signed_squares
from mocapmend_algorithms.sparse.part_training import PartSettings

sys.path.insert(0, str(Path(__file__).parents[2] / "algorithms"))
from joint_samples import walker

FRAMES = 120
MADE = {
    "basketball": MotionSet(("06_03", "06_04", "06_06"), ("06_04",), ("06_06",)),
    "punch": MotionSet(("02_05_first1200",), (), ()),
}
PIECES = ((0, 120), (120, 200), (200, 280), (280, 360))
FEW = ["--atoms", "20", "--rounds", "1"]


def write(path: Path, recording: Recording, order: Sequence[int] | None = None) -> None:
    """Write a recording as the shared ones are."""
    order = range(recording.markers) if order is None else order
    body = find_body(recording, recording.present)
    places = list(order)
    parents = [places.index(p) if p >= 0 else -1 for p in body.parents[places].tolist()]
    np.savez(
        path,
        pos=recording.points[:, places].astype(np.float32),
        fps=np.float32(recording.rate),
        names=np.array([recording.labels[at] for at in places]),
        parents=np.array(parents, dtype=np.int16),
        units=recording.unit,
        up=recording.up[1:],
    )


@functools.cache
def long_walk() -> Recording:
    """Make one long walk at 120 Hz."""
    walk: Recording = walker(600, rate=120.0)
    return walk


def piece(start: int, frames: int = FRAMES) -> Recording:
    """Cut a piece out of the long walk."""
    walk = long_walk()
    return walk.with_points(walk.points[start : start + frames].copy())


@pytest.fixture(scope="module")
def folder(tmp_path_factory: pytest.TempPathFactory) -> Path:
    """Return a folder of made-up trials."""
    folder = tmp_path_factory.mktemp("data")
    (folder / trials.FOLDER).mkdir()
    for at, name in enumerate(MADE["basketball"].trials):
        write(folder / trials.FOLDER / f"{name}.npz", piece(150 * at))
    backwards = list(range(31))[::-1]
    write(folder / trials.FOLDER / "02_05_first1200.npz", piece(0, 360), backwards)
    write(folder / trials.FOLDER / "49_18.npz", piece(500, 60))
    return folder


@pytest.fixture(autouse=True)
def cache(tmp_path: Path, monkeypatch: pytest.MonkeyPatch) -> Path:
    """Keep to the made-up trials and to a cache folder of the test's own."""
    monkeypatch.setattr(trials, "MOTIONS", MADE)
    monkeypatch.setattr(command, "MOTIONS", MADE)
    monkeypatch.setattr(trials, "PUNCH_PIECES", PIECES)
    monkeypatch.setattr(trained, "user_cache_path", lambda name: tmp_path / "cache" / name)
    return tmp_path / "cache" / "mocapmend" / "bench-paper"


def run(folder: Path, capsys: pytest.CaptureFixture[str], *more: str) -> dict[str, Any]:
    """Run the command and return its JSON document."""
    assert main(["paper", "--data", str(folder), *FEW, *more, "--json"]) == 0

    def refuse(constant: str) -> float:
        raise AssertionError(f"{constant} is no JSON")

    document: dict[str, Any] = json.loads(capsys.readouterr().out, parse_constant=refuse)
    return document


@pytest.fixture
def few(monkeypatch: pytest.MonkeyPatch) -> None:
    """Leave out what takes longest: rivals that no target names, regions, rates."""
    every = rivals.rivals

    def some(dictionaries: Any) -> list[rivals.Rival]:
        return [
            rival for rival in every(dictionaries) if rival.name not in ("Kalman", "local-frame")
        ]

    monkeypatch.setattr(rivals, "rivals", some)
    monkeypatch.setattr(tables, "RATES", (0.2, 0.5))
    fewer = {points: dict(list(places.items())[1:3]) for points, places in REGIONS.items()}
    monkeypatch.setattr(trials, "REGIONS", fewer)


def numbers(value: Any) -> Iterator[float]:
    """Return all numbers of a document."""
    if isinstance(value, dict):
        value = list(value.values())
    if isinstance(value, list):
        for one in value:
            yield from numbers(one)
    elif isinstance(value, float):
        yield value


# --- the run ---------------------------------------------------------------------------------


def test_the_report_has_all_tables(
    folder: Path, capsys: pytest.CaptureFixture[str], few: None
) -> None:
    document = run(folder, capsys, "--motion", "basketball")
    assert document["title"] == "The experiment of W18: basketball 06_04"
    tables = ("summary", "rows", "noise_free", "sweep", "spectrum", "training", "targets")
    for key in tables:
        assert document[key], key
        assert all(value is not None for row in document[key] for value in row.values()), key
    assert all(map(math.isfinite, numbers(document)))
    methods = {row["method"] for row in document["summary"]}
    assert {"spline", "TSMC", "SMBS", "W18, as printed", "W18, best"} <= methods
    assert len(document["rows"]) == len(methods) * 2 * 2 * len(REGIONS)
    assert [row["rate"] for row in document["sweep"]] == [20, 50]
    (training,) = document["training"]
    assert training["frames"] == 2 * FRAMES
    assert (training["atoms"], training["rounds"]) == (20, 1)
    assert training["never_rises"] is True
    for row in document["noise_free"]:
        assert row["bones_after_cm"] < 1e-5 < row["bones_before_cm"]
    summary = {(row["method"], row["projected"]): row for row in document["summary"]}
    for points in (3, 6):
        key = f"basketball_{points}"
        spline, best = summary["spline", False][key], summary["W18, best", False][key]
        assert best < 0.5 * spline
        mine = [
            row["rmse_cm"]
            for row in document["rows"]
            if (row["method"], row["projected"], row["points"]) == ("spline", False, points)
        ]
        assert spline == pytest.approx(math.sqrt(sum(x * x for x in mine) / len(mine)))
        # Lengths are measured under the noise, and so a little off.
        bones = f"{key}_bones"
        assert summary["spline", True][bones] < 0.01 < 0.1 < summary["spline", False][bones]


def test_a_file_to_test_does_not_teach(
    folder: Path, capsys: pytest.CaptureFixture[str], monkeypatch: pytest.MonkeyPatch
) -> None:
    seen = []

    def off(case: trials.Case) -> Any:
        seen.append(case.trial)
        return case.trial.truth.points[case.start : case.stop][:, case.lost] + 1

    names = [rival.name for rival in rivals.rivals(lambda case: {})]
    table = [rivals.Rival(name, {"off": off}, "off") for name in names]
    monkeypatch.setattr(rivals, "rivals", lambda dictionaries: table)
    path = folder / trials.FOLDER / "06_03.npz"
    document = run(folder, capsys, "--motion", "basketball", "--test", str(path))
    assert document["title"] == "The experiment of W18: basketball 06_03"
    assert {row["test"] for row in document["rows"]} == {"06_03"}
    assert document["training"][0]["frames"] == 2 * FRAMES
    assert "sweep" not in document
    assert "spectrum" not in document
    (trial,) = set(seen)
    truth = trial.truth.points[0, 0, 0]
    assert truth == read_joints(folder, "06_03").points[0, 0, 0]
    assert truth not in teachers_of(trial)
    for row in document["rows"]:
        if not row["projected"]:
            assert row["rmse_cm"] == pytest.approx(math.sqrt(3))


def test_settings_are_tried_on_the_validation_trials(
    folder: Path, capsys: pytest.CaptureFixture[str], monkeypatch: pytest.MonkeyPatch
) -> None:
    def found(case: trials.Case) -> Any:
        assert case.trial.name == "06_06"
        assert [t.frames for t in case.trial.teachers] == [FRAMES]
        return case.trial.truth.points[case.start : case.stop][:, case.lost]

    table = [
        rivals.Rival(
            "a", {"good": found, "off": lambda case: found(case) + np.array([0, 3, 4])}, "good"
        ),
        rivals.Rival("b", {"only": found}, "only"),
    ]
    monkeypatch.setattr(rivals, "rivals", lambda dictionaries: table)
    document = run(folder, capsys, "--motion", "basketball", "--tune")
    good, off = document["settings"]
    assert good == {
        "method": "a",
        "setting": "good",
        "chosen": True,
        "basketball_3": 0,
        "basketball_6": 0,
    }
    assert (off["setting"], off["chosen"]) == ("off", False)
    assert off["basketball_6"] == pytest.approx(5)


# --- trials ----------------------------------------------------------------------------------


def teachers_of(trial: Trial) -> list[float]:
    """Tell teachers by where they begin."""
    return [float(teacher.points[0, 0, 0]) for teacher in trial.teachers]


def test_tests_and_validation_do_not_teach_each_other(folder: Path) -> None:
    begins = {
        name: float(read_joints(folder, name).points[0, 0, 0]) for name in MADE["basketball"].trials
    }
    (trial,) = read_trials("basketball", folder, None, validate=False)
    assert trial.name == "06_04"
    assert teachers_of(trial) == [begins["06_03"], begins["06_06"]]
    (trial,) = read_trials("basketball", folder, None, validate=True)
    assert trial.name == "06_06"
    assert teachers_of(trial) == [begins["06_03"]]
    path = folder / trials.FOLDER / "06_06.npz"
    (trial,) = read_trials("basketball", folder, path, validate=False)
    assert trial.name == "06_06"
    assert teachers_of(trial) == [begins["06_03"], begins["06_04"]]


def test_the_one_trial_of_punches_is_divided(folder: Path) -> None:
    made = read_trials("punch", folder, None, validate=False)
    assert [trial.name for trial in made] == ["02_05 frames 201-280", "02_05 frames 281-360"]
    (validation,) = read_trials("punch", folder, None, validate=True)
    assert validation.name == "02_05 frames 121-200"
    whole = piece(0, 360)
    for trial, (a, b) in zip([validation, *made], PIECES[1:], strict=True):
        np.testing.assert_allclose(trial.truth.points, whole.points[a:b], atol=1e-3)
        assert [teacher.frames for teacher in trial.teachers] == [120]


def test_joints_are_read_in_centimetres_and_in_the_order_of_the_parts(tmp_path: Path) -> None:
    (tmp_path / trials.FOLDER).mkdir()
    walk = piece(0, 50)
    labels = tuple(f"Ann:{label.upper()}" for label in walk.labels)
    millimetres = replace(walk, points=10 * walk.points, unit="mm", labels=labels)
    order = np.random.default_rng(0).permutation(31).tolist()
    write(tmp_path / trials.FOLDER / "x.npz", millimetres, order)
    read = read_joints(tmp_path, "x")
    assert read.labels == tuple(name for part in PARTS for name in part)
    assert (read.unit, read.rate, read.up) == ("cm", 120.0, "+y")
    np.testing.assert_allclose(read.points, walk.points, atol=1e-3)


# --- what is lost ----------------------------------------------------------------------------


@pytest.mark.parametrize("points", REGIONS)
def test_lost_points_are_joined_by_bones(points: int) -> None:
    walk = piece(0, 10)
    edges = find_body(walk, walk.present).edges
    for names in REGIONS[points].values():
        lost = {walk.labels.index(name) for name in names}
        assert len(lost) == points
        reached = {min(lost)}
        for _ in lost:
            at = np.isin(edges, list(reached)).any(axis=1)
            reached |= lost & set(edges[at].ravel().tolist())
        assert reached == lost


@pytest.mark.parametrize("share", [0.1, 0.4, 0.6])
def test_a_case_loses_the_region_in_the_middle_frames(folder: Path, share: float) -> None:
    (trial,) = read_trials("basketball", folder, None, validate=False)
    length = round(share * FRAMES)
    for case in cases(trial, 3, share, noise=False):
        assert case.stop - case.start == length
        assert abs((case.start + case.stop) - FRAMES) <= 1
        names = {case.recording.labels[marker] for marker in case.lost}
        assert names == set(REGIONS[3][case.region])
        missing = ~case.recording.present
        assert missing.sum() == 3 * length
        for gap in case.gaps:
            assert missing[gap.start : gap.stop, gap.marker].all()
        left = case.recording.points[~missing]
        np.testing.assert_array_equal(left, trial.truth.points[~missing])


def test_noise_has_60_db_on_the_signed_squares() -> None:
    walk = piece(0, 200)
    body = find_body(walk, walk.present)
    noisy = with_noise(walk.points, body)
    a, b = body.edges.T
    squares, other = (signed_squares(p[:, a] - p[:, b]) for p in (walk.points, noisy))
    ratio = np.mean(squares**2) / np.mean((other - squares) ** 2)
    assert 10 * np.log10(ratio) == pytest.approx(60, abs=0.01)
    roots = body.parents < 0
    np.testing.assert_allclose(noisy[:, roots], walk.points[:, roots], rtol=1e-12)
    np.testing.assert_array_equal(with_noise(walk.points, body), noisy)


# --- errors ----------------------------------------------------------------------------------


def test_errors_that_are_known_are_measured(folder: Path) -> None:
    (trial,) = read_trials("basketball", folder, None, validate=False)
    case = next(case for case in cases(trial, 6, 0.4, noise=False) if case.region == "left arm")
    truth = trial.truth.points[case.start : case.stop][:, case.lost]
    assert rmse(case, truth) == 0
    assert bone_rmse(case, truth) < 1e-4
    assert rmse(case, truth + np.array([0, 3, 4])) == pytest.approx(5)
    # One of six points, in half of the frames.
    some = truth.copy()
    some[::2, 2] += [6, 0, 0]
    assert rmse(case, some) == pytest.approx(math.sqrt(36 / 12))
    # The thumb is 1 cm too far from the wrist: one of the six bones that touch, one of all 30.
    thumb, wrist = (
        case.lost.tolist().index(trial.truth.labels.index(name)) for name in ("lthumb", "lwrist")
    )
    far = truth.copy()
    away = far[:, thumb] - far[:, wrist]
    far[:, thumb] += away / np.linalg.norm(away, axis=1, keepdims=True)
    assert bone_rmse(case, far) == pytest.approx(math.sqrt(1 / 6), abs=1e-4)
    assert bone_rmse(case, far, everywhere=True) == pytest.approx(math.sqrt(1 / 30), abs=1e-4)
    far[3, thumb] = np.nan
    assert math.isnan(rmse(case, far))
    assert math.isnan(bone_rmse(case, far))


def test_projection_mends_bones(folder: Path) -> None:
    (trial,) = read_trials("basketball", folder, None, validate=False)
    for case in cases(trial, 3, 0.4, noise=False):
        truth = trial.truth.points[case.start : case.stop][:, case.lost]
        off = truth + np.random.default_rng(0).normal(0, 1, truth.shape)
        assert bone_rmse(case, off) > 0.5
        assert bone_rmse(case, rivals.project(case, off)) < 1e-4


def test_singular_values_are_shares_in_descending_order() -> None:
    walk = piece(0, 40)
    body = find_body(walk, walk.present)
    for values in spectrum(walk.points, body, 12):
        assert len(values) == 12
        assert list(values) == sorted(values, reverse=True)
        assert 0 < sum(values) <= 1
    still = np.tile(walk.points[:1], (40, 1, 1))
    for values in spectrum(still, body, 3):
        np.testing.assert_allclose(values, [1, 0, 0], atol=1e-6)


# --- the cache -------------------------------------------------------------------------------


@pytest.fixture
def trial(folder: Path) -> Trial:
    """Return a trial with little to learn from."""
    trial = read_trials("basketball", folder, None, validate=False)[0]
    short = [teacher.with_points(teacher.points[:50].copy()) for teacher in trial.teachers]
    return replace(trial, teachers=tuple(short))


TINY = PartSettings(atoms=10, rounds=1)


def test_what_was_trained_is_kept(
    trial: Trial, cache: Path, monkeypatch: pytest.MonkeyPatch
) -> None:
    first = trained.parts_for(trial, TINY)
    assert len(list(cache.iterdir())) == 1
    with monkeypatch.context() as patched:
        patched.setattr(trained, "train_part", None)
        again = trained.parts_for(trial, TINY)
    assert again.objectives == first.objectives
    assert (again.seconds, again.frames) == (first.seconds, first.frames)
    for at, dictionary in first.dictionaries.items():
        np.testing.assert_array_equal(again.dictionaries[at].atoms, dictionary.atoms)
        np.testing.assert_array_equal(again.dictionaries[at].mean, dictionary.mean)


def test_other_settings_and_other_teachers_are_kept_apart(trial: Trial, cache: Path) -> None:
    trained.parts_for(trial, TINY)
    trained.parts_for(trial, replace(TINY, atoms=12))
    trained.parts_for(replace(trial, teachers=trial.teachers[:1]), TINY)
    assert len(list(cache.iterdir())) == 3
    # Who is repaired does not matter.
    trained.parts_for(replace(trial, name="other", truth=piece(0)), TINY)
    assert len(list(cache.iterdir())) == 3


@pytest.mark.parametrize("damage", ["empty", "cut", "flipped", "text", "pickle", "lacking", "head"])
def test_a_damaged_cache_file_is_made_anew(trial: Trial, cache: Path, damage: str) -> None:
    first = trained.parts_for(trial, TINY)
    (path,) = cache.iterdir()
    good = path.read_bytes()
    if damage == "lacking":
        np.savez(path, head=np.array("{}"))
    elif damage == "head":
        with np.load(path) as archive:
            arrays = {key: archive[key] for key in archive}
        np.savez(path, **(arrays | {"head": np.array("[1]")}))
    elif damage == "pickle":
        np.savez(path, head=np.array({"a": 1}, dtype=object))
    else:
        middle = len(good) // 2
        flipped = bytes(255 - byte for byte in good[middle : middle + 50])
        path.write_bytes(
            {
                "empty": b"",
                "cut": good[:middle],
                "flipped": good[:middle] + flipped + good[middle + 50 :],
                "text": b"no archive",
            }[damage]
        )
    again = trained.parts_for(trial, TINY)
    assert again.objectives == first.objectives
    with np.load(path) as archive:
        assert set(archive) == {"head", *(f"part {at}" for at in range(5))}


# --- what is refused -------------------------------------------------------------------------


def refused(*arguments: str) -> MocapmendError:
    """Run what must be refused."""
    with pytest.raises(MocapmendError) as caught:
        main(["paper", *FEW, *arguments])
    return caught.value


def test_a_folder_without_the_recordings_is_refused(tmp_path: Path) -> None:
    error = refused("--data", str(tmp_path))
    assert "There is no folder cmu_joints here." in str(error)
    assert str(tmp_path) in str(error)


def test_a_missing_trial_is_refused(tmp_path: Path) -> None:
    (tmp_path / trials.FOLDER).mkdir()
    assert "06_0" in str(refused("--data", str(tmp_path)))


def test_a_file_to_test_needs_its_motion(folder: Path) -> None:
    error = refused("--data", str(folder), "--test", "some.npz")
    assert "Which motion these recordings are of is not known." in str(error)
    assert "some.npz" in str(error)


def test_recordings_that_are_not_of_the_31_joints_are_refused(folder: Path, tmp_path: Path) -> None:
    walk = piece(0, 40)
    gap = walk.points.copy()
    gap[3, 4] = np.nan
    other = ("nose", *walk.labels[1:])
    for name, wrong in (("gap", walk.with_points(gap)), ("other", replace(walk, labels=other))):
        path = tmp_path / f"{name}.npz"
        np.savez(path, pos=wrong.points, fps=120.0, names=np.array(wrong.labels), units="cm")
        error = refused("--data", str(folder), "--motion", "basketball", "--test", str(path))
        assert "not a complete recording of the 31 joints" in str(error)
        assert str(path) in str(error)


def test_a_motion_whose_only_trial_is_to_be_repaired_has_no_teachers(folder: Path) -> None:
    path = folder / trials.FOLDER / "02_05_first1200.npz"
    error = refused("--data", str(folder), "--motion", "punch", "--test", str(path))
    assert "No other trial" in str(error)


def test_recordings_shorter_than_windows_are_refused(folder: Path, tmp_path: Path) -> None:
    path = tmp_path / "short.npz"
    write(path, piece(0, 49))
    error = refused("--data", str(folder), "--motion", "basketball", "--test", str(path))
    assert "This recording is too short: it has 49 frames." in str(error)
    assert str(path) in str(error)
