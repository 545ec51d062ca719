"""`bench fuzz`: damaged files open or are refused, and the fuzzer notices when they do not."""

import json
import os
import random
from collections import Counter
from collections.abc import Callable
from io import BytesIO
from pathlib import Path
from zipfile import ZipFile

import numpy as np
import pytest
from c3d_synthetic import Synthetic, encode

from mocapmend.bench import fuzz, hunt, main, seeds, small_files, trial
from mocapmend.bench.mutate import MUTATIONS, Damage, mutate, mutate_member
from mocapmend.bench.small_files import SMALL_FILES
from mocapmend.errors import MocapmendError
from mocapmend.files import read_c3d
from mocapmend.files.c3d_numbers import Processor

MUTANTS = 300


def refuse(path: Path, meter: trial.Meter) -> None:
    raise MocapmendError("No.", str(path))


def raise_another(path: Path, meter: trial.Meter) -> None:
    raise ValueError("planted")


def warn(path: Path, meter: trial.Meter) -> None:
    np.float64(1.0) / np.float64(0.0)


def allocate(path: Path, meter: trial.Meter) -> None:
    with meter:
        np.empty(250_000_000, np.uint8)


def hang(path: Path, meter: trial.Meter) -> None:
    while True:
        pass


def crash(path: Path, meter: trial.Meter) -> None:
    os._exit(3)


@pytest.fixture(scope="module")
def good() -> list[seeds.Seed]:
    """Return the seeds that need no folder."""
    return seeds.all_seeds()


def test_mutants_open_or_are_refused(good: list[seeds.Seed], tmp_path: Path) -> None:
    plan = hunt.Plan(good, seed=1)
    outcomes = [plan.attempt(number, tmp_path) for number in range(MUTANTS)]
    assert [each.detail for each in outcomes if each.result == "failed"] == []
    assert max(each.extra_mb for each in outcomes) < trial.MOST_EXTRA_MB
    results = Counter(each.result for each in outcomes)
    assert results["opened"] > MUTANTS // 4
    assert results["refused"] > MUTANTS // 10
    assert list(tmp_path.iterdir()) == []


@pytest.mark.parametrize(
    ("use", "fault"),
    [
        (refuse, ""),
        (raise_another, "ValueError: planted"),
        (warn, "RuntimeWarning: divide by zero encountered in scalar divide"),
        (allocate, "large: 250 MB more than the file"),
    ],
)
def test_what_goes_wrong_is_noticed(use: trial.Use, fault: str, tmp_path: Path) -> None:
    path = tmp_path / "file.c3d"
    path.write_bytes(b"x")
    assert trial.attempt(path, use).fault == fault


def test_a_slow_file_gets_a_second_chance(tmp_path: Path, monkeypatch: pytest.MonkeyPatch) -> None:
    path = tmp_path / "file.c3d"
    path.write_bytes(b"x")
    now = 0.0
    left = [3.0, 2.5, 5.0, 0.5]

    def tick(_path: Path, _meter: trial.Meter) -> None:
        nonlocal now
        now += left.pop(0)

    monkeypatch.setattr(trial.time, "perf_counter", lambda: now)
    assert trial.attempt(path, tick).fault == "slow: 2.5 s"
    assert trial.attempt(path, tick).fault == ""


def test_a_failed_proof_is_a_fault(
    samples: Path, tmp_path: Path, monkeypatch: pytest.MonkeyPatch
) -> None:
    path = tmp_path / "walk.c3d"
    path.write_bytes((samples / "walk_cmu_02_01.c3d").read_bytes())

    def fail(todo: str) -> Callable[..., None]:
        def export(*_: object) -> None:
            raise MocapmendError("No.", "", todo)

        return export

    monkeypatch.setattr(trial.engine, "export", fail("Please report this."))
    assert trial.attempt(path).fault.startswith("AssertionError: a proof failed: No.")
    monkeypatch.setattr(trial.engine, "export", fail("Choose another name."))
    outcome = trial.attempt(path)
    assert (outcome.result, outcome.fault) == ("opened", "")


@pytest.mark.parametrize(
    ("use", "patience_s", "fault"),
    [
        (hang, 0.3, "no answer after 0.3 s"),
        (crash, 60.0, "the process ended with exit code 3"),
    ],
)
def test_a_hang_or_a_crash_costs_one_file(
    use: trial.Use, patience_s: float, fault: str, good: list[seeds.Seed]
) -> None:
    outcomes = dict(hunt.hunt(hunt.Plan(good[:1], 1, use), 3, patience_s=patience_s))
    assert sorted(outcomes) == [0, 1, 2]
    assert {each.fault for each in outcomes.values()} == {fault}


def test_a_number_says_everything_about_a_mutant(good: list[seeds.Seed]) -> None:
    plan = hunt.Plan(good, seed=7)
    files = [plan.content(number) for number in range(60)]
    assert files == [hunt.Plan(good, seed=7).content(number) for number in range(60)]
    assert files != [hunt.Plan(good, seed=8).content(number) for number in range(60)]


@pytest.mark.parametrize("mutation", MUTATIONS)
def test_every_mutation_changes_files_of_any_size(
    mutation: Callable[[bytearray, Damage], None],
) -> None:
    changed = 0
    for number, size in enumerate((1, 2, 3, 511, 5000) * 20):
        rng = random.Random(number)
        before = rng.randbytes(size)
        raw = bytearray(before)
        mutation(raw, Damage(rng, 1024, b"B" * 3000))
        changed += raw != before
    assert changed > 30


def test_damage_is_spread_over_the_parts_of_a_file() -> None:
    damage = Damage(random.Random(1), 2048, b"")
    places = [damage.place(bytearray(10_000)) for _ in range(3000)]
    assert sum(at < 512 for at in places) > 1000
    assert sum(512 <= at < 2048 for at in places) > 800
    assert sum(at >= 2048 for at in places) > 600


def test_nothing_is_left_as_nothing() -> None:
    assert mutate(b"", Damage(random.Random(1), 512, b"x")) == b""


def test_as_many_points_as_a_frame_can_have_cost_little(tmp_path: Path) -> None:
    path = tmp_path / "wide.c3d"
    wide = Synthetic(np.ones((1, 65_535, 3)), is_float=False, labels=["A"])
    path.write_bytes(encode(wide))
    outcome = trial.attempt(path)
    assert (outcome.result, outcome.detail) == ("opened", "")
    assert outcome.extra_mb < trial.MOST_EXTRA_MB / 2


def test_damage_reaches_the_arrays_of_an_archive() -> None:
    raw = small_files.npz()
    changed = mutate_member(raw, Damage(random.Random(1), 512, b"x"))
    assert changed == mutate_member(raw, Damage(random.Random(1), 512, b"x"))
    with ZipFile(BytesIO(raw)) as before, ZipFile(BytesIO(changed)) as after:
        names = before.namelist()
        assert after.namelist() == names
        assert after.testzip() is None
        assert sum(before.read(name) != after.read(name) for name in names) == 1


def test_the_seeds_hold_the_six_encodings(good: list[seeds.Seed], tmp_path: Path) -> None:
    made = [seed for seed in good if seed.name == "synthetic.c3d"]
    points = []
    for seed in made:
        path = tmp_path / "synthetic.c3d"
        path.write_bytes(seed.raw)
        file = read_c3d(path)
        assert file.warnings == ()
        points.append(file.recording.points)
        analog = file.read_analog()
        assert analog.shape == (200, 3)
    assert len({seed.kind for seed in made}) == 6
    for other in points[1:]:
        np.testing.assert_allclose(other, points[0], atol=0.051)
    assert np.isnan(points[0]).any()
    assert {seed.kind.split()[1] for seed in made} == {each.name for each in Processor}


def test_every_seed_is_small_and_can_be_read(good: list[seeds.Seed], tmp_path: Path) -> None:
    assert len(good) >= 9
    for seed in good:
        assert len(seed.raw) <= seeds.KEPT_BYTES + 4096
        path = tmp_path / f"seed{seed.suffix}"
        path.write_bytes(seed.raw)
        for suffix, raw in seed.beside:
            path.with_suffix(suffix).write_bytes(raw)
        outcome = trial.attempt(path)
        assert (outcome.result, outcome.fault) == ("opened", ""), outcome.detail


def test_small_files_of_other_formats_are_text_or_archives() -> None:
    made = {kind: make() for kind, _, make in SMALL_FILES}
    assert made.pop("NPZ").startswith(b"PK")
    assert all(raw.decode().count("\n") > 20 for raw in made.values())


def test_files_of_a_folder_are_cut(samples: Path, tmp_path: Path) -> None:
    (tmp_path / "deep").mkdir()
    walk = (samples / "walk_cmu_02_01.c3d").read_bytes()
    (tmp_path / "deep" / "a.C3D").write_bytes(walk)
    (tmp_path / "noise.c3d").write_bytes(b"x" * 100_000)
    (tmp_path / "empty.c3d").write_bytes(b"")
    (tmp_path / "notes.md").write_text("no recording")
    found = {seed.name: seed for seed in seeds._of_folder(tmp_path)}
    assert sorted(found) == ["a.C3D", "noise.c3d"]
    assert walk.startswith(found["a.C3D"].raw)
    assert found["noise.c3d"].kind == "C3D, unreadable"
    assert len(found["noise.c3d"].raw) == seeds.KEPT_BYTES
    with pytest.raises(MocapmendError, match="no such folder"):
        seeds.all_seeds(tmp_path / "nowhere")


def test_the_command_prints_its_table(capsys: pytest.CaptureFixture[str]) -> None:
    assert main(["fuzz", "--mutants", "18", "--json"]) == 0
    document = json.loads(capsys.readouterr().out)
    assert document["command"] == "bench fuzz"
    figures = {row["what"]: row["figure"] for row in document["rows"]}
    assert figures["damaged files"] == 18
    assert figures["opened"] + figures["refused with a clear message"] == 18
    assert figures["failed otherwise"] == 0


def test_failures_end_the_command_with_1_and_are_kept(
    good: list[seeds.Seed],
    tmp_path: Path,
    monkeypatch: pytest.MonkeyPatch,
    capsys: pytest.CaptureFixture[str],
) -> None:
    outcomes = [
        (0, trial.Outcome("opened", "", 0.1, 1.0)),
        (1, trial.Outcome("failed", "Traceback\nValueError: planted\n", 0.2, 2.0)),
        (2, trial.Outcome("opened", "", 3.0, 3.0)),
    ]
    monkeypatch.setattr(fuzz, "hunt", lambda plan, mutants: iter(outcomes))
    assert main(["fuzz", "--mutants", "3", "--keep", str(tmp_path)]) == 1
    table = capsys.readouterr().out
    assert "| failed otherwise | 1 | none | 1.00 | <= 0 |" in table
    assert "| slower than 2 s | 1 | none | 1.00 | <= 0 |" in table
    assert "| slowest | 3e+03 ms | limit 2000 ms | 1.50 | <= 1 |" in table
    assert sorted(path.name for path in tmp_path.iterdir()) == ["1", "2"]
    error = (tmp_path / "1" / "error.txt").read_text()
    assert error.startswith("ValueError: planted\nfrom sprint_basketball.c3d\n")
    assert (tmp_path / "1" / "mutant.c3d").read_bytes() == hunt.Plan(good, 1).content(1)
