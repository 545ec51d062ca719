"""Gaps that the user keeps open travel with the file: in it, beside it, and never as repairs."""

import json
import math
from dataclasses import replace
from pathlib import Path
from typing import Any

import numpy as np
import pytest
from c3d_synthetic import MACHINES, Machine, Synthetic, encode, walk
from repaired_files import write_three_gaps

from mocapmend import engine
from mocapmend.files import (
    C3DFile,
    KeptGap,
    SampleRun,
    Source,
    check_files,
    read_c3d,
    read_recording,
    save_patched,
)
from mocapmend.files.records import LEFT_OPEN, NEVER_FILLED
from mocapmend.files.sidecar import sidecar_path
from mocapmend_algorithms import Gap, find_gaps, no_progress
from mocapmend_algorithms.fill.limits import Limits
from mocapmend_algorithms.fill.registry import METHODS

NEVER, LEFT, OTHER = Gap(0, 10, 14), Gap(2, 10, 14), Gap(0, 20, 21)
NAME = b"KEPT_OPEN"


def kept(source: Source, *, left: bool = True) -> tuple[KeptGap, ...]:
    """Protect one gap, and leave another one open."""
    never = engine.kept_gap(source, NEVER, never=True, reason=NEVER_FILLED)
    return (never, engine.kept_gap(source, LEFT, never=False, reason=LEFT_OPEN))[: 1 + left]


def repair(source: Source, *gaps: Gap) -> engine.Changes:
    """Fill gaps by straight lines."""
    params, limits = METHODS["linear"].params(), Limits(max_error_mm=math.inf)
    result = engine.fill(source.measured, gaps, "linear", params, limits, no_progress)
    return engine.changes_of(source, result, "linear", params)


def export(source: Source, changes: engine.Changes, out: Path) -> engine.Exported:
    return engine.export(source, changes, out, False, False, no_progress)


@pytest.mark.parametrize("machine", MACHINES)
def test_they_are_entries_of_their_own(machine: Machine, tmp_path: Path) -> None:
    source = write_three_gaps(tmp_path, machine)
    out = tmp_path / "out.c3d"
    done = export(source, replace(repair(source, OTHER), kept_open=kept(source)), out)
    assert done.saved.record == "group"
    assert done.saved.samples == 1
    assert done.check is not None
    assert done.check.changed_samples == 1
    again = read_c3d(out)
    assert again.repaired == (OTHER,)
    assert again.kept_open == {
        NEVER: KeptGap("A", 1, 111, 114, never=True, reason=NEVER_FILLED),
        LEFT: KeptGap("C", 4, 111, 114, never=False, reason=LEFT_OPEN),
    }
    assert find_gaps(again.recording.present) == [NEVER, LEFT]
    assert again.warnings == source.warnings
    assert check_files(source.path, out).passed


def test_they_alone_are_worth_a_record_and_taken_off_leave_the_original(tmp_path: Path) -> None:
    source = write_three_gaps(tmp_path)
    first, second, third = (tmp_path / f"{name}.c3d" for name in ("first", "second", "third"))
    done = export(source, engine.Changes((), (), kept(source)), first)
    assert done.saved.record == "group"
    assert done.check is not None
    assert (done.check.changed, done.check.passed) == ((), True)
    marked = read_c3d(first)
    assert marked.recording.points.tobytes() == source.recording.points.tobytes()
    export(marked, engine.Changes((), (), tuple(marked.kept_open.values())), second)
    assert second.read_bytes() == first.read_bytes()
    export(marked, engine.Changes((), ()), third)
    assert third.read_bytes() == source.path.read_bytes()


def test_a_record_without_them_does_not_name_them(tmp_path: Path) -> None:
    source = write_three_gaps(tmp_path)
    out, table = tmp_path / "out.c3d", tmp_path / "out.csv"
    export(source, repair(source, OTHER), out)
    export(source, repair(source, OTHER), table)
    assert NAME not in out.read_bytes()
    assert "kept_open" not in json.loads(sidecar_path(table).read_text())
    assert read_c3d(out).kept_open == read_recording(table).kept_open == {}


def test_a_later_fill_leaves_them_but_for_the_one_that_it_fills(tmp_path: Path) -> None:
    source = write_three_gaps(tmp_path)
    first, second = tmp_path / "first.c3d", tmp_path / "second.c3d"
    export(source, engine.Changes((), (), kept(source)), first)
    marked = read_c3d(first)
    export(marked, repair(marked, LEFT), second)
    again = read_c3d(second)
    assert again.repaired == (LEFT,)
    assert set(again.kept_open) == {NEVER}
    assert check_files(first, second).passed


@pytest.mark.parametrize("name", ["out.csv", "out.trc", "out.npz", "new.c3d"])
def test_files_of_other_formats_keep_them(name: str, tmp_path: Path) -> None:
    source = write_three_gaps(tmp_path)
    table, out = tmp_path / "table.csv", tmp_path / name
    export(source, engine.Changes((), (), kept(source)), table)
    read = read_recording(table)
    assert set(read.kept_open) == {NEVER, LEFT}
    export(read, engine.Changes((), (), tuple(read.kept_open.values())), out)
    again = read_recording(out)
    assert set(again.kept_open) == {NEVER, LEFT}
    assert again.kept_open[LEFT].point == 3, "the model output is left out"
    assert again.repairs == ()


def crowded(folder: Path) -> C3DFile:
    """Write a file with more gaps than its parameters can list."""
    points = walk(2100, 1)
    fourth = np.zeros(points.shape[:2])
    fourth[1:-1:2], points[1:-1:2] = -1.0, 0.0
    path = folder / "crowded.c3d"
    path.write_bytes(encode(Synthetic(points, fourth=fourth)))
    return read_c3d(path)


def test_many_go_beside_the_file(tmp_path: Path) -> None:
    source, out = crowded(tmp_path), tmp_path / "out.c3d"
    gaps = find_gaps(source.recording.present)
    never = [engine.kept_gap(source, gap, never=True, reason="r" * 99) for gap in gaps]
    done = export(source, engine.Changes((), (), tuple(never)), out)
    assert done.saved.record == "sidecar"
    assert out.read_bytes() == source.path.read_bytes()
    assert list(read_c3d(out).kept_open) == gaps
    assert check_files(source.path, out).identical


# --- the check -------------------------------------------------------------------------------


@pytest.mark.parametrize("listed", [True, False], ids=["listed", "not listed"])
def test_samples_in_a_gap_kept_open_may_not_differ(tmp_path: Path, listed: bool) -> None:
    source, out = write_three_gaps(tmp_path), tmp_path / "out.c3d"
    filled = repair(source, NEVER)
    repairs = filled.repairs if listed else ()
    save_patched(source, filled.runs, out, repairs=repairs, kept_open=kept(source))
    found = check_files(source.path, out)
    [said] = found.other_differences
    assert said.startswith("Marker A: 4 samples differ although the repair record keeps the gap")
    assert not found.passed


def test_a_repair_may_be_reopened_and_its_gap_protected(tmp_path: Path) -> None:
    source = write_three_gaps(tmp_path)
    first, second = tmp_path / "first.c3d", tmp_path / "second.c3d"
    export(source, repair(source, NEVER), first)
    repaired = read_c3d(first)
    cleared = SampleRun(0, 10, np.full((4, 3), np.nan))
    export(repaired, engine.Changes((cleared,), (), kept(repaired, left=False)), second)
    again = read_c3d(second)
    assert (again.repaired, set(again.kept_open)) == ((), {NEVER})
    assert check_files(source.path, second).passed


# --- records that cannot be used -------------------------------------------------------------

GOOD: dict[str, Any] = {
    "marker": "A",
    "point": 1,
    "first_frame": 111,
    "last_frame": 114,
    "never": True,
    "reason": NEVER_FILLED,
}


@pytest.mark.parametrize(
    "wrong",
    [
        {"marker": 7},
        {"point": True},
        {"first_frame": 1.5},
        {"last_frame": 2**60},
        {"never": 1},
        {"never": None},
        {"reason": None},
        {"reason": "r" * 2000},
        {"reason": ["because"]},
    ],
)
def test_what_is_no_gap_kept_open(wrong: dict[str, Any]) -> None:
    assert KeptGap.from_json(GOOD | {"of later": 1}).as_json() == GOOD
    with pytest.raises(ValueError, match="of a gap kept open is"):
        KeptGap.from_json(GOOD | wrong)
    (key,) = wrong
    with pytest.raises(ValueError, match="missing or of another kind"):
        KeptGap.from_json({name: GOOD[name] for name in GOOD if name != key})


@pytest.mark.parametrize("data", [None, 7, {}, "text", [1], [[]]])
def test_a_sidecar_whose_list_is_none_is_a_warning(data: object, tmp_path: Path) -> None:
    source, out = write_three_gaps(tmp_path), tmp_path / "out.csv"
    export(source, engine.Changes((), (), kept(source)), out)
    beside = sidecar_path(out)
    beside.write_text(json.dumps(json.loads(beside.read_text()) | {"kept_open": data}))
    again = read_recording(out)
    assert again.kept_open == {}
    assert any("gap" in warning and "cannot be used" in warning for warning in again.warnings)


@pytest.mark.parametrize(
    ("old", "new"),
    [
        (b'"never":true', b'"never":1234'),
        (b'{"marker"', b'{{marker"'),
        (b'"reason":"', b'"reason":{"'),
        (b'"point":1,', b'"point":[,'),
    ],
)
def test_a_damaged_entry_is_a_warning(old: bytes, new: bytes, tmp_path: Path) -> None:
    source, out = write_three_gaps(tmp_path), tmp_path / "out.c3d"
    export(source, engine.Changes((), (), kept(source)), out)
    raw = out.read_bytes()
    assert old in raw
    at = raw.index(old)
    out.write_bytes(raw[:at] + new[: len(old)] + raw[at + len(old) :])
    again = read_c3d(out)
    assert again.kept_open == {}
    assert any("repair record cannot be used" in warning for warning in again.warnings)


def test_flipped_bits_of_a_record_never_stop_the_reader(tmp_path: Path) -> None:
    source, out = write_three_gaps(tmp_path), tmp_path / "out.c3d"
    export(source, replace(repair(source, OTHER), kept_open=kept(source)), out)
    raw = out.read_bytes()
    start = raw.index(NAME)
    rng = np.random.default_rng(1)
    for at in rng.integers(start, raw.rindex(b"}"), 150).tolist():
        damaged = bytearray(raw)
        damaged[at] ^= 1 << int(rng.integers(8))
        out.write_bytes(damaged)
        again = read_c3d(out)
        assert {entry.place for entry in again.kept_open.values()} <= {(1, 111), (4, 111)}


def test_gaps_that_are_not_there_are_left_out(tmp_path: Path) -> None:
    source, out = write_three_gaps(tmp_path), tmp_path / "out.c3d"
    never, left = kept(source)
    wrong = (
        never,
        replace(left, last_frame=113),
        replace(left, point=2),
        replace(left, point=99),
        replace(left, first_frame=-(2**50)),
    )
    save_patched(source, (), out, kept_open=wrong)
    again = read_c3d(out)
    assert again.kept_open == {NEVER: never}
    assert again.warnings[-1] == (
        "4 of 5 gaps that the repair record keeps open are not in the file any more."
    )


def test_a_gap_that_is_listed_as_repaired_too_is_a_repair(tmp_path: Path) -> None:
    source, out = write_three_gaps(tmp_path), tmp_path / "out.c3d"
    filled = repair(source, NEVER)
    save_patched(source, filled.runs, out, repairs=filled.repairs, kept_open=kept(source))
    again = read_c3d(out)
    assert again.repaired == (NEVER,)
    assert set(again.kept_open) == {LEFT}
