"""The repair record: in the file, beside it, read again, reverted, replaced."""

import json
import math
from dataclasses import replace
from io import BytesIO
from pathlib import Path
from typing import Any

import numpy as np
import pytest
from c3d_synthetic import MACHINES, Machine, Synthetic, encode, walk
from hypothesis import HealthCheck, given, settings
from hypothesis import strategies as st
from repaired_files import write_three_gaps

from mocapmend import engine
from mocapmend.files import (
    C3DFile,
    RepairRecord,
    SampleRun,
    check_files,
    read_c3d,
    save_patched,
)
from mocapmend.files.c3d_group import NAME, encode_group
from mocapmend.files.c3d_head import free_group, insert_group, leading_blocks, remove_group
from mocapmend.files.c3d_layout import read_layout
from mocapmend.files.c3d_numbers import Processor
from mocapmend.files.provenance import Provenance
from mocapmend.files.records import line
from mocapmend.files.sidecar import hash_file, sidecar_path
from mocapmend_algorithms import Gap, find_gaps, no_progress
from mocapmend_algorithms.fill.limits import Limits
from mocapmend_algorithms.fill.registry import METHODS

ALL = Limits(max_error_mm=math.inf)
GAPS = (Gap(0, 10, 14), Gap(0, 20, 21), Gap(2, 10, 14))


def written(folder: Path, machine: Machine = "intel", **more: Any) -> C3DFile:
    """Write a file with three gaps and analog data."""
    return write_three_gaps(folder, machine, analog=np.arange(240.0).reshape(40, 2, 3), **more)


def repair(source: C3DFile, gaps: tuple[Gap, ...] | None = None) -> engine.Changes:
    """Fill gaps by straight lines."""
    params = METHODS["linear"].params()
    found = find_gaps(source.measured.present) if gaps is None else list(gaps)
    result = engine.fill(source.measured, found, "linear", params, ALL, no_progress)
    return engine.changes_of(source, result, "linear", params)


def export(source: C3DFile, changes: engine.Changes, out: Path) -> engine.Exported:
    return engine.export(source, changes, out, False, False, no_progress)


def reopen(source: C3DFile, gap: Gap) -> engine.Changes:
    """Turn one of the file's repairs back into a gap."""
    pairs = zip(source.repaired, source.repairs, strict=True)
    kept = [record for other, record in pairs if other != gap]
    run = SampleRun(gap.marker, gap.start, np.full((gap.length, 3), np.nan))
    return engine.Changes((run,), tuple(kept))


# --- in the file -----------------------------------------------------------------------------


@pytest.mark.parametrize("machine", MACHINES)
def test_a_repaired_file_says_what_was_repaired(machine: Machine, tmp_path: Path) -> None:
    source = written(tmp_path, machine)
    out = tmp_path / "out.c3d"
    done = export(source, repair(source), out)
    assert done.saved.record == "group"
    assert not sidecar_path(out).exists()
    again = read_c3d(out)
    assert again.repaired == GAPS
    assert [(r.marker, r.point, r.first_frame, r.last_frame) for r in again.repairs] == [
        ("A", 1, 111, 114),
        ("A", 1, 121, 121),
        ("C", 4, 111, 114),
    ]
    assert {r.method for r in again.repairs} == {"linear"}
    assert again.provenance is not None
    assert again.provenance.inputs == (hash_file(source.path),)
    np.testing.assert_array_equal(again.measured.points, source.recording.points)
    assert again.recording.present.all()
    assert again.warnings == source.warnings


def test_without_edits_a_repaired_file_is_copied(tmp_path: Path) -> None:
    source = written(tmp_path)
    first, second = tmp_path / "first.c3d", tmp_path / "second.c3d"
    export(source, repair(source), first)
    done = export(read_c3d(first), engine.Changes((), read_c3d(first).repairs), second)
    assert done.saved.record == "group"
    assert second.read_bytes() == first.read_bytes()


def test_a_repair_can_be_reverted_to_missing(tmp_path: Path) -> None:
    source = written(tmp_path)
    first, second = tmp_path / "first.c3d", tmp_path / "second.c3d"
    export(source, repair(source), first)
    repaired = read_c3d(first)
    done = export(repaired, reopen(repaired, GAPS[1]), second)
    assert done.check is not None
    assert done.check.changed_samples == 1
    again = read_c3d(second)
    assert again.repaired == (GAPS[0], GAPS[2])
    assert find_gaps(again.recording.present) == [GAPS[1]]
    assert check_files(source.path, second).passed
    np.testing.assert_array_equal(again.measured.points, source.recording.points)


def test_reverting_everything_gives_the_head_of_the_original(tmp_path: Path) -> None:
    source = written(tmp_path)
    first, second = tmp_path / "first.c3d", tmp_path / "second.c3d"
    export(source, repair(source), first)
    repaired = read_c3d(first)
    runs = [SampleRun(g.marker, g.start, np.full((g.length, 3), np.nan)) for g in GAPS]
    export(repaired, engine.Changes(tuple(runs), ()), second)
    # The gaps were written as this program writes them: the files are the same.
    assert second.read_bytes() == source.path.read_bytes()


def test_a_repair_can_be_made_anew(tmp_path: Path) -> None:
    source = written(tmp_path)
    first, second = tmp_path / "first.c3d", tmp_path / "second.c3d"
    export(source, repair(source), first)
    repaired = read_c3d(first)
    params = METHODS["kalman"].params()
    result = engine.fill(repaired.measured, [GAPS[0]], "kalman", params, ALL, no_progress)
    changes = engine.changes_of(repaired, result, "kalman", params)
    kept = tuple(r for r in changes.repairs if (r.marker, r.method) != ("A", "linear"))
    kept += (repaired.repairs[1],)
    export(repaired, replace(changes, repairs=kept), second)
    again = read_c3d(second)
    assert again.repaired == GAPS
    assert [r.method for r in again.repairs] == ["kalman", "linear", "linear"]
    assert again.provenance is not None
    assert again.provenance.inputs == (hash_file(source.path), hash_file(first))
    assert check_files(source.path, second).passed
    assert check_files(first, second).passed


def test_repairs_in_two_steps(tmp_path: Path) -> None:
    source = written(tmp_path)
    first, second, at_once = (tmp_path / f"{name}.c3d" for name in ("first", "second", "at_once"))
    export(source, repair(source, GAPS[:1]), first)
    halfway = read_c3d(first)
    export(halfway, repair(halfway, GAPS[1:]), second)
    export(source, repair(source), at_once)
    assert read_c3d(second).repairs == read_c3d(at_once).repairs
    np.testing.assert_array_equal(
        read_c3d(second).recording.points, read_c3d(at_once).recording.points
    )


LABELS = st.text(st.characters(codec="utf-8", exclude_characters="\0"), min_size=1, max_size=30)
PARAMETERS = st.none() | st.booleans() | st.integers() | LABELS | st.lists(LABELS).map(tuple)
RECORDS = st.builds(
    RepairRecord,
    LABELS,
    st.just(1),
    st.just(111),
    st.just(114),
    st.sampled_from(["cubic", "a method of the future"]),
    st.dictionaries(LABELS, PARAMETERS, max_size=3),
    st.lists(LABELS, max_size=40).map(tuple),
    st.floats(0.001, 1e6).map(lambda x: float(f"{x:.4g}")) | st.just(math.nan),
    st.just(math.nan),
)


@settings(max_examples=40, suppress_health_check=[HealthCheck.function_scoped_fixture])
@given(record=RECORDS, machine=st.sampled_from(MACHINES), converted=st.booleans())
def test_every_record_comes_back(
    record: RepairRecord, machine: Machine, converted: bool, tmp_path: Path
) -> None:
    source = written(tmp_path, machine)
    head = source.path.read_bytes()[: source.layout.data_start]
    provenance = Provenance((record,), ("f" * 64, "0" * 64), converted)
    group = encode_group(provenance, 100, source.layout.processor)
    assert len(group) % 512 == 0
    changed = insert_group(head, source.layout, group)
    assert changed is not None
    path = tmp_path / "with_group.c3d"
    path.write_bytes(changed + source.path.read_bytes()[source.layout.data_start :])
    # The samples of this gap are missing in it: the record is read, and then found wanting.
    points = source.recording.points.copy()
    points[10:14, 0] = 1.0
    run = SampleRun(0, 10, points[10:14, 0])
    save_patched(read_c3d(path), [run], tmp_path / "out.c3d", repairs=[record])
    [back] = read_c3d(tmp_path / "out.c3d").repairs
    assert repr(back) == repr(record)


@pytest.mark.parametrize("size", range(0, 600, 7))
def test_the_group_fills_whole_blocks(size: int) -> None:
    program = "x" * (size % 250)
    records = (RepairRecord("M" * (size // 3), 1, 1, 2, "cubic"),)
    group = encode_group(Provenance(records, ("0" * 64,), program=program), 5, Processor.MIPS)
    assert len(group) % 512 == 0


def test_insertion_is_undone_exactly(samples: Path) -> None:
    for path in sorted(samples.glob("*.c3d")):
        source = read_c3d(path)
        head = path.read_bytes()[: source.layout.data_start]
        number = free_group(head, source.layout)
        assert number is not None
        records = tuple(RepairRecord(f"M{i}", i, 1, 2, "cubic") for i in range(1, 300))
        group = encode_group(Provenance(records, ("0" * 64,)), number, source.layout.processor)
        changed = insert_group(head, source.layout, group)
        assert changed is not None
        out = path.read_bytes()[source.layout.data_start :]
        with_group = read_layout(BytesIO(changed), len(changed) + len(out), "")
        blocks = leading_blocks(changed, with_group, NAME)
        assert blocks == len(group) // 512
        assert remove_group(changed, with_group, blocks) == head


# --- records that cannot be used -------------------------------------------------------------


def test_a_sample_that_went_missing_again_is_no_repair(tmp_path: Path) -> None:
    source = written(tmp_path)
    out = tmp_path / "out.c3d"
    export(source, repair(source), out)
    layout = read_c3d(out).layout
    raw = bytearray(out.read_bytes())
    at = layout.data_start + 11 * layout.frame_bytes
    raw[at : at + 16] = bytes(12) + np.float32(-1).tobytes()
    out.write_bytes(raw)
    again = read_c3d(out)
    assert again.repaired == GAPS[1:]
    assert any("1 of 3 repairs" in warning for warning in again.warnings)


def test_what_another_program_changed_can_still_be_copied(tmp_path: Path) -> None:
    source = written(tmp_path)
    first, second = tmp_path / "first.c3d", tmp_path / "second.c3d"
    export(source, repair(source), first)
    layout = read_c3d(first).layout
    raw = bytearray(first.read_bytes())
    at = layout.data_start + 11 * layout.frame_bytes
    raw[at : at + 16] = bytes(12) + np.float32(-1).tobytes()
    first.write_bytes(raw)
    changed = read_c3d(first)
    done = export(changed, engine.Changes((), changed.repairs), second)
    assert done.check is not None
    assert done.check.identical
    assert second.read_bytes() == bytes(raw)


@pytest.mark.parametrize("damage", ["not JSON", "later format", "no hash", "other group"])
def test_a_damaged_group_is_a_warning(damage: str, tmp_path: Path) -> None:
    source = written(tmp_path)
    out = tmp_path / "out.c3d"
    export(source, repair(source), out)
    raw = out.read_bytes()
    if damage == "later format":
        at = read_c3d(out).layout.parameters[f"{NAME}:FORMAT"].data
        out.write_bytes(raw[:at] + b"\x09" + raw[at + 1 :])
    elif damage == "no hash":
        at = read_c3d(out).layout.parameters[f"{NAME}:INPUTS"].data
        out.write_bytes(raw[:at] + "é".encode() + raw[at + 2 :])
    elif damage == "not JSON":
        out.write_bytes(raw.replace(b'{"marker"', b'{{marker"', 1))
    else:
        out.write_bytes(raw.replace(b"MOCAPMEND", b"SOMETHING"))
    assert out.read_bytes() != raw
    again = read_c3d(out)
    assert again.repaired == ()
    assert any("repair record" in warning for warning in again.warnings) == (
        damage != "other group"
    )
    done = save_patched(again, [SampleRun(3, 0, np.ones((1, 3)))], tmp_path / "more.c3d")
    assert done.samples == 1


# --- beside the file -------------------------------------------------------------------------


def crowded(folder: Path) -> C3DFile:
    """Write a file with more gaps than its parameters can list."""
    points = np.tile(walk(2100, 1), (1, 1, 1))
    fourth = np.zeros(points.shape[:2])
    fourth[1:-1:2] = -1.0
    points[1:-1:2] = 0.0
    path = folder / "crowded.c3d"
    path.write_bytes(encode(Synthetic(points, fourth=fourth)))
    return read_c3d(path)


def test_many_repairs_go_beside_the_file(tmp_path: Path) -> None:
    source = crowded(tmp_path)
    out = tmp_path / "out.c3d"
    done = export(source, repair(source), out)
    assert done.saved.record == "sidecar"
    assert out.stat().st_size == source.path.stat().st_size
    assert done.check is not None
    assert done.check.allowed == ()
    again = read_c3d(out)
    assert len(again.repaired) == 1049
    np.testing.assert_array_equal(again.measured.points, source.recording.points)
    assert check_files(source.path, out).passed


def test_a_sidecar_belongs_to_one_state_of_the_file(tmp_path: Path) -> None:
    source = crowded(tmp_path)
    out = tmp_path / "out.c3d"
    export(source, repair(source), out)
    raw = bytearray(out.read_bytes())
    raw[-1] ^= 1
    out.write_bytes(raw)
    again = read_c3d(out)
    assert again.repaired == ()
    assert any("another state of this file" in warning for warning in again.warnings)


@pytest.mark.parametrize(
    "text",
    ["", "[]", "{", '{"mocapmend_provenance": 7}', '{"mocapmend_provenance": 1}', "[" * 9999],
)
def test_a_damaged_sidecar_is_a_warning(text: str, tmp_path: Path) -> None:
    source = written(tmp_path)
    sidecar_path(source.path).write_text(text)
    again = read_c3d(source.path)
    assert again.repaired == ()
    assert any("repair record" in warning for warning in again.warnings)


def test_a_copy_keeps_its_sidecar(tmp_path: Path) -> None:
    source = crowded(tmp_path)
    first, second = tmp_path / "first.c3d", tmp_path / "second.c3d"
    export(source, repair(source), first)
    repaired = read_c3d(first)
    export(repaired, engine.Changes((), repaired.repairs), second)
    assert second.read_bytes() == first.read_bytes()
    assert sidecar_path(second).read_bytes() == sidecar_path(first).read_bytes()


def test_a_file_that_is_replaced_loses_its_sidecar(tmp_path: Path) -> None:
    source = crowded(tmp_path)
    out = tmp_path / "out.c3d"
    export(source, repair(source), out)
    assert sidecar_path(out).exists()
    export(source, repair(source, (find_gaps(source.recording.present)[0],)), out)
    assert not sidecar_path(out).exists()
    assert len(read_c3d(out).repaired) == 1


def test_a_file_of_that_name_that_is_no_record_is_left_alone(tmp_path: Path) -> None:
    source = written(tmp_path)
    out = tmp_path / "out.c3d"
    sidecar_path(out).write_text("my notes")
    export(source, repair(source), out)
    assert sidecar_path(out).read_text() == "my notes"


def test_the_sprint_needs_a_sidecar(sprint: Path, tmp_path: Path) -> None:
    source = read_c3d(sprint)
    params = METHODS["cubic"].params()
    gaps = find_gaps(source.recording.present)
    result = engine.fill(source.measured, gaps, "cubic", params, ALL, no_progress)
    done = export(source, engine.changes_of(source, result, "cubic", params), tmp_path / "out.c3d")
    assert done.saved.record == "sidecar"
    document = json.loads(sidecar_path(tmp_path / "out.c3d").read_text())
    assert len(document["repairs"]) == 780
    assert document["inputs"] == [hash_file(sprint)]
    assert document["output_sha256"] == hash_file(tmp_path / "out.c3d")
    again = read_c3d(tmp_path / "out.c3d")
    assert len(again.repaired) == 780
    np.testing.assert_array_equal(again.measured.points, source.recording.points)


# --- the check -------------------------------------------------------------------------------


def test_a_sample_that_the_record_does_not_list_is_a_difference(tmp_path: Path) -> None:
    source = written(tmp_path)
    out = tmp_path / "out.c3d"
    export(source, repair(source, GAPS[:1]), out)
    layout = read_c3d(out).layout
    raw = bytearray(out.read_bytes())
    at = layout.data_start + 20 * layout.frame_bytes
    raw[at : at + 16] = np.array([1, 2, 3, 0], np.float32).tobytes()
    out.write_bytes(raw)
    report = check_files(source.path, out)
    expected = (
        "Marker A: 1 sample differs without an entry in the repair record, the first at frame 121."
    )
    assert report.other_differences == (expected,)


def test_another_original_is_a_difference(tmp_path: Path) -> None:
    source = written(tmp_path)
    out = tmp_path / "out.c3d"
    export(source, repair(source), out)
    raw = bytearray(source.path.read_bytes())
    at = source.layout.data_start + source.layout.frame_bytes - 1
    raw[at] ^= 1
    source.path.write_bytes(raw)
    report = check_files(source.path, out)
    assert "The repair record names another original." in report.other_differences
    assert any("Analog channel" in sentence for sentence in report.other_differences)


@pytest.mark.parametrize("where", ["header", "parameter", "record"])
def test_a_change_beside_the_record_is_found(where: str, tmp_path: Path) -> None:
    source = written(tmp_path)
    out = tmp_path / "out.c3d"
    export(source, repair(source), out)
    layout = read_c3d(out).layout
    at = {
        "header": 400,
        "parameter": layout.parameters["POINT:UNITS"].data,
        "record": layout.parameters[f"{NAME}:INPUTS"].data,
    }[where]
    raw = bytearray(out.read_bytes())
    raw[at] ^= 1
    out.write_bytes(raw)
    report = check_files(source.path, out)
    assert not report.passed


def test_a_parameter_may_be_a_list_of_names() -> None:
    record = RepairRecord("A", 1, 11, 14, "kalman", {"donors": ("B", "Ψ D"), "noise_mm": None})
    assert RepairRecord.from_json(json.loads(line(record))).parameters == record.parameters
    for wrong in ([1.0], ["B", None], [["B"]], ["B" * 2000], {"B": "C"}):
        data = record.as_json() | {"parameters": {"donors": wrong}}
        with pytest.raises(ValueError, match="neither a number nor a text, nor a list"):
            RepairRecord.from_json(data)
