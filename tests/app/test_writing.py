"""Every format written as every other: what comes back, what is lost, and what is kept safe."""

import errno
import json
from collections.abc import Callable
from dataclasses import replace
from pathlib import Path
from typing import BinaryIO

import numpy as np
import pytest
from c3d_synthetic import walk
from recording_samples import NO_LIMITS, SOURCES, TARGETS, changes_in, digest, repair, write_sample

from mocapmend import engine
from mocapmend.errors import MocapmendError
from mocapmend.files import Provenance, RepairRecord, Source, read_c3d, read_recording
from mocapmend.files import atomic as atomic_module
from mocapmend.files.sidecar import sidecar_path
from mocapmend_algorithms import Cancelled, Progress, find_gaps, no_progress
from mocapmend_algorithms.fill.registry import METHODS

NONE = engine.Changes((), ())
IMPORTED = [kind for kind in SOURCES if kind != "c3d"]


def content(folder: Path) -> dict[str, bytes]:
    return {path.name: path.read_bytes() for path in folder.iterdir()}


def export(
    source: Source,
    out: Path,
    changes: engine.Changes = NONE,
    progress: Progress = no_progress,
    **allowed: bool,
) -> engine.Exported:
    replaced, truncated = (allowed.get(key, False) for key in ("replace_source", "truncated"))
    return engine.export(source, changes, out, replaced, truncated, progress)


# --- what comes back -----------------------------------------------------------------------------


@pytest.mark.parametrize("target", TARGETS)
@pytest.mark.parametrize("kind", SOURCES)
def test_a_repaired_recording_comes_back(kind: str, target: str, tmp_path: Path) -> None:
    path, out = write_sample(tmp_path, kind), tmp_path / f"out.{target}"
    source = read_recording(path)
    changes = changes_in(source)
    done = export(source, out, changes)
    back = read_recording(out)

    expected = source.recording.points.copy()
    for run in changes.runs:
        expected[run.start : run.start + len(run.values), run.marker] = run.values
    if target == "c3d":
        expected = expected.astype(np.float32)
    given, read = source.recording, back.recording
    np.testing.assert_array_equal(
        read.points, expected * (given.mm if read.unit != given.unit else 1)
    )
    assert read.labels == given.labels
    assert read.rate == (np.float32(given.rate) if target == "c3d" else given.rate)
    assert read.unit == ("mm" if (target, given.unit) == ("trc", "in") else given.unit)
    assert read.first_frame == given.first_frame
    assert read.up == given.up or target == "trc"
    assert not back.truncated

    points = [source.stored_points.index(record.point - 1) for record in changes.repairs]
    if not (kind == target == "c3d"):
        assert back.stored_points == tuple(range(given.markers))
        repairs = [
            replace(record, point=point + 1)
            for record, point in zip(changes.repairs, points, strict=True)
        ]
    else:
        repairs = list(changes.repairs)
        assert done.check is not None
    assert len(repairs) == 2
    assert [as_read(record) for record in repairs] == list(back.repairs)
    assert back.provenance is not None
    assert back.provenance.inputs == (digest(path),)
    np.testing.assert_array_equal(back.measured.present, source.recording.present)
    assert done.saved.record == ("group" if target == "c3d" else "sidecar")
    assert sidecar_path(out).exists() == (target != "c3d")
    assert done.saved.samples == sum(len(run.values) for run in changes.runs)


def as_read(record: RepairRecord) -> RepairRecord:
    """Return a record as a file holds it: with rounded errors."""
    return RepairRecord.from_json(record.as_json())


@pytest.mark.parametrize("target", TARGETS)
@pytest.mark.parametrize("kind", SOURCES)
def test_a_second_repair_names_both_inputs(kind: str, target: str, tmp_path: Path) -> None:
    path = write_sample(tmp_path, kind)
    first, second = tmp_path / f"first.{target}", tmp_path / f"second.{target}"
    source = repair(path, first, gaps=slice(1))
    between = repair(first, second, "pchip")
    back = read_recording(second)
    assert len(between.repairs) == 1
    assert [record.method for record in back.repairs] == ["linear", "pchip"]
    assert back.repairs[:1] == between.repairs
    assert back.provenance is not None
    assert back.provenance.inputs == (digest(path), digest(first))
    np.testing.assert_array_equal(back.measured.present, source.recording.present)
    assert back.recording.present.all()


@pytest.mark.parametrize("target", TARGETS)
def test_a_record_goes_from_format_to_format(target: str, tmp_path: Path) -> None:
    path = write_sample(tmp_path, "c3d")
    source = repair(path, tmp_path / "one.trc")
    export_as(tmp_path / "one.trc", tmp_path / f"two.{target}")
    export_as(tmp_path / f"two.{target}", tmp_path / "three.npz")
    back = read_recording(tmp_path / "three.npz")
    assert [(record.marker, record.point) for record in back.repairs] == [("B", 2), ("D", 4)]
    np.testing.assert_array_equal(back.measured.present, source.recording.present)
    inputs = [digest(tmp_path / name) for name in ("walk.c3d", "one.trc", f"two.{target}")]
    assert back.provenance is not None
    assert back.provenance.inputs == tuple(inputs)


def export_as(path: Path, out: Path) -> None:
    source = read_recording(path)
    export(source, out, engine.Changes((), source.repairs))


@pytest.mark.parametrize("target", TARGETS[1:])
@pytest.mark.parametrize("name", ["gait_plug_in_gait", "sprint_basketball"])
def test_real_recordings_there_and_back(
    name: str, target: str, samples: Path, tmp_path: Path
) -> None:
    there, back = tmp_path / f"there.{target}", tmp_path / "back.c3d"
    source = read_recording(samples / f"{name}.c3d")
    inside = [gap for gap in find_gaps(source.recording.present) if gap.length < 20]
    params = METHODS["linear"].params()
    result = engine.fill(source.measured, inside[:200], "linear", params, NO_LIMITS, no_progress)
    changes = engine.changes_of(source, result, "linear", params)
    assert len(changes.repairs) > 40
    export(source, there, changes)
    export_as(there, back)
    final = read_c3d(back)
    repaired = engine.repaired(source.recording, result).points
    np.testing.assert_array_equal(final.recording.points, repaired.astype(np.float32))
    assert final.recording.labels == source.recording.labels
    assert final.recording.first_frame == source.recording.first_frame
    np.testing.assert_array_equal(final.measured.present, source.recording.present)
    assert [record.method for record in final.repairs] == ["linear"] * len(changes.repairs)


@pytest.mark.parametrize("target", TARGETS)
@pytest.mark.parametrize("kind", IMPORTED)
def test_without_repairs_there_is_no_record(kind: str, target: str, tmp_path: Path) -> None:
    path, out = write_sample(tmp_path, kind), tmp_path / f"out.{target}"
    done = export(read_recording(path), out)
    assert (done.saved.record, done.saved.samples, done.check) == ("", 0, None)
    assert read_recording(out).provenance is None
    assert not sidecar_path(out).exists()


def test_filled_samples_are_marked_where_the_format_can(tmp_path: Path) -> None:
    path = write_sample(tmp_path, "csv")
    repair(path, tmp_path / "out.long.csv", gaps=slice(1))
    repair(path, tmp_path / "out.npz", gaps=slice(1))
    lines = (tmp_path / "out.long.csv").read_text().splitlines()
    states = [line.rpartition(",")[2] for line in lines]
    assert [states.count(state) for state in ("measured", "filled", "missing")] == [145, 5, 10]
    with np.load(tmp_path / "out.npz") as arrays:
        filled = arrays["filled"]
    assert np.argwhere(filled).tolist() == [[frame, 1] for frame in range(10, 15)]


def test_events_go_into_a_new_c3d(tmp_path: Path) -> None:
    path = write_sample(tmp_path, "tsv")
    source = repair(path, tmp_path / "out.c3d")
    events = read_c3d(tmp_path / "out.c3d").events
    assert [(event.label, event.frame) for event in events] == [
        ("Toe off", pytest.approx(2)),
        ("Heel strike", pytest.approx(16)),
    ]
    assert [event.frame for event in source.events] == [2, 16]


def test_bones_go_into_an_npz(tmp_path: Path) -> None:
    for kind in ("bvh", "amc", "npz"):
        source = repair(write_sample(tmp_path, kind), tmp_path / f"out_{kind}.npz")
        assert source.bones
        assert read_recording(tmp_path / f"out_{kind}.npz").bones == source.bones


# --- what is said about it -----------------------------------------------------------------------


@pytest.mark.parametrize(
    ("kind", "target", "lost"),
    [
        ("c3d", "npz", "analog data, model outputs, residuals, events"),
        ("c3d", "trc", "analog data, model outputs, residuals, events, the axis that points up"),
        ("tsv", "csv", "events"),
        ("tsv", "c3d", ""),
        ("csv", "csv", ""),
        ("csv", "trc", "the axis that points up"),
        ("bvh", "csv", "bones"),
        ("amc", "c3d", "bones"),
        ("bvh", "npz", ""),
    ],
)
def test_notes_say_what_is_lost(kind: str, target: str, lost: str, tmp_path: Path) -> None:
    done = export(read_recording(write_sample(tmp_path, kind)), tmp_path / f"out.{target}")
    notes = [note for note in done.sentences if "markers alone" in note]
    assert notes == ([f"The new file has the markers alone, without {lost}."] if lost else [])
    assert all(sentence.endswith(".") for sentence in done.sentences)


def test_the_notes_of_the_writers_are_told(tmp_path: Path) -> None:
    source = read_recording(write_sample(tmp_path, "csv"))
    done = export(source, tmp_path / "out.trc")
    assert any("written in mm, not in" in note for note in done.saved.notes)


# --- what is refused -----------------------------------------------------------------------------


@pytest.mark.parametrize("name", ["out", "out.", "out.xlsx", "out.bvh", "out.txt", "out.c3d.gz"])
@pytest.mark.parametrize("kind", IMPORTED)
def test_other_endings_are_refused(kind: str, name: str, tmp_path: Path) -> None:
    source = read_recording(write_sample(tmp_path, kind))
    before = content(tmp_path)
    with pytest.raises(MocapmendError, match="cannot be written") as raised:
        export(source, tmp_path / name, changes_in(source))
    assert ".trc" in raised.value.todo
    assert content(tmp_path) == before


@pytest.mark.parametrize("name", ["out.bvh", "out.txt", "out.tsv", "out.AMC"])
def test_a_c3d_does_not_get_the_name_of_another_format(name: str, tmp_path: Path) -> None:
    source = read_recording(write_sample(tmp_path, "c3d"))
    with pytest.raises(MocapmendError, match="cannot be written"):
        export(source, tmp_path / name)
    assert not (tmp_path / name).exists()


@pytest.mark.parametrize("name", ["out.C3D", "out", "out.c3d.bak"])
def test_a_c3d_may_have_any_other_name(name: str, tmp_path: Path) -> None:
    path = write_sample(tmp_path, "c3d")
    done = export(read_recording(path), tmp_path / name)
    assert done.check is not None
    assert done.check.identical
    assert digest(tmp_path / name) == digest(path)
    assert read_recording(tmp_path / name).kind == "C3D"


@pytest.mark.parametrize("name", ["out.TRC", "out.Long.CSV", "out.NPZ", "out.C3D"])
def test_endings_may_be_in_capitals(name: str, tmp_path: Path) -> None:
    source = repair(write_sample(tmp_path, "csv"), tmp_path / name)
    np.testing.assert_array_equal(
        read_recording(tmp_path / name).measured.present, source.recording.present
    )


@pytest.mark.parametrize("kind", ["c3d", "trc", "csv", "npz"])
def test_the_source_is_replaced_only_when_that_is_meant(kind: str, tmp_path: Path) -> None:
    path = write_sample(tmp_path, kind)
    source = read_recording(path)
    original, before = digest(path), content(tmp_path)
    with pytest.raises(MocapmendError, match="the file that the data come from"):
        export(source, path, changes_in(source))
    assert content(tmp_path) == before
    export(source, path, changes_in(source), replace_source=True)
    back = read_recording(path)
    assert back.provenance is not None
    assert back.provenance.inputs == (original,)
    np.testing.assert_array_equal(back.measured.present, source.recording.present)


@pytest.mark.parametrize("kind", ["c3d", "trc", "bvh"])
def test_a_truncated_source_is_saved_only_when_that_is_accepted(kind: str, tmp_path: Path) -> None:
    path, out = write_sample(tmp_path, kind), tmp_path / "out.npz"
    raw = path.read_bytes()
    path.write_bytes(raw[: -len(raw) // 4])
    source = read_recording(path)
    assert source.truncated
    with pytest.raises(MocapmendError, match="is truncated"):
        export(source, out)
    assert not out.exists()
    export(source, out, truncated=True)
    back = read_recording(out)
    assert back.recording.frames == source.recording.frames
    assert not back.truncated


@pytest.mark.parametrize("target", TARGETS)
def test_a_source_that_was_changed_is_not_named_as_input(target: str, tmp_path: Path) -> None:
    path = write_sample(tmp_path, "csv")
    source = read_recording(path)
    path.write_bytes(path.read_bytes() + b"# more\n")
    before = content(tmp_path)
    with pytest.raises(MocapmendError, match="changed since it was opened"):
        export(source, tmp_path / f"out.{target}", changes_in(source))
    path.unlink()
    with pytest.raises(MocapmendError, match="no such file"):
        export(source, tmp_path / f"out.{target}", changes_in(source))
    assert not set(content(tmp_path)) - set(before)


# --- the record of a file that is replaced -------------------------------------------------------


@pytest.fixture(params=["c3d in a group", "c3d beside", "trc", "long.csv", "npz"])
def repaired(
    request: pytest.FixtureRequest, tmp_path: Path, monkeypatch: pytest.MonkeyPatch
) -> Path:
    """Write a repaired file into a folder of its own; return it."""
    kind = request.param.split()[0]
    if request.param == "c3d beside":
        monkeypatch.setattr("mocapmend.files.c3d_target._with_group", lambda *_: None)
        monkeypatch.setattr("mocapmend.files.writing.room_for_records", lambda *_: 0)
    folder = tmp_path / "repaired"
    folder.mkdir()
    repair(write_sample(tmp_path, "c3d"), folder / f"out.{kind}")
    assert sidecar_path(folder / f"out.{kind}").exists() == (request.param != "c3d in a group")
    return folder / f"out.{kind}"


@pytest.mark.parametrize("kind", ["c3d", "csv"])
@pytest.mark.parametrize("step", ["write the file", "write the record", "replace the file"])
def test_a_failed_overwrite_loses_neither_file_nor_record(
    kind: str, step: str, repaired: Path, tmp_path: Path, monkeypatch: pytest.MonkeyPatch
) -> None:
    source = read_recording(write_sample(tmp_path, kind))
    before, record = content(repaired.parent), read_recording(repaired).provenance
    victim = sidecar_path(repaired) if step.endswith("record") else repaired
    if step.endswith("record") and not victim.exists():
        pytest.skip("the record goes into the file")
    write, place = atomic_module._write_through, Path.replace

    def full(temporary: Path, target: Path, content: Callable[[BinaryIO], None]) -> None:
        write(temporary, target, content)
        if target == victim:
            raise OSError(errno.ENOSPC, "No space left on device")

    def in_use(temporary: Path, target: Path) -> Path:
        if target == victim:
            raise PermissionError(errno.EACCES, "in use by another program")
        return place(temporary, target)

    with monkeypatch.context() as patch:
        if step.startswith("write"):
            patch.setattr(atomic_module, "_write_through", full)
        else:
            patch.setattr(Path, "replace", in_use)
        with pytest.raises(MocapmendError):
            export(source, repaired, changes_in(source, "cubic"))
    assert content(repaired.parent) == before
    assert read_recording(repaired).provenance == record


@pytest.mark.parametrize("kind", ["c3d", "csv"])
def test_a_cancelled_overwrite_loses_neither_file_nor_record(
    kind: str, repaired: Path, tmp_path: Path
) -> None:
    source = read_recording(write_sample(tmp_path, kind))
    changes = changes_in(source, "cubic")
    before = content(repaired.parent)
    shares: list[float] = []
    export(source, tmp_path / repaired.name, changes, shares.append)
    assert shares[-1] == 1.0
    for limit in sorted(set(shares)):

        def cancel(share: float, limit: float = limit) -> None:
            if share >= limit:
                raise Cancelled

        with pytest.raises(Cancelled):
            export(source, repaired, changes, cancel)
        assert content(repaired.parent) == before


@pytest.mark.parametrize("kind", ["c3d", "csv"])
def test_an_overwrite_takes_the_former_record_along(
    kind: str, repaired: Path, tmp_path: Path
) -> None:
    source = read_recording(write_sample(tmp_path, kind))
    export(source, repaired)
    assert content(repaired.parent).keys() == {repaired.name}
    back = read_recording(repaired)
    assert back.provenance is None
    assert not any("record" in warning for warning in back.warnings)


def test_an_overwrite_writes_its_own_record(repaired: Path, tmp_path: Path) -> None:
    path = write_sample(tmp_path, "csv")
    repair(path, repaired, "cubic", slice(1))
    back = read_recording(repaired)
    assert [record.method for record in back.repairs] == ["cubic"]
    assert back.provenance is not None
    assert back.provenance.inputs == (digest(path),)
    assert not any("record" in warning for warning in back.warnings)


def test_what_is_no_record_is_not_removed(tmp_path: Path) -> None:
    path, out = write_sample(tmp_path, "csv"), tmp_path / "out.trc"
    sidecar_path(out).write_text('{"something": "else"}')
    export(read_recording(path), out)
    assert sidecar_path(out).read_text() == '{"something": "else"}'


def test_a_folder_in_the_place_of_the_record_is_noticed_before(tmp_path: Path) -> None:
    path, out = write_sample(tmp_path, "csv"), tmp_path / "out.trc"
    sidecar_path(out).mkdir()
    with pytest.raises(MocapmendError, match="folder or a device") as raised:
        repair(path, out)
    assert raised.value.where == str(sidecar_path(out))
    assert not out.exists()


def test_the_record_is_beside_the_file_that_a_link_leads_to(tmp_path: Path) -> None:
    path = write_sample(tmp_path, "trc")
    (tmp_path / "links").mkdir()
    link = tmp_path / "links" / "walk.trc"
    link.symlink_to(path)
    source = read_recording(link)
    export(source, link, changes_in(source), replace_source=True)
    assert link.is_symlink()
    assert len(read_recording(path).repairs) == 2
    assert len(read_recording(link).repairs) == 2


# --- damaged records -----------------------------------------------------------------------------


@pytest.mark.parametrize(
    ("key", "value"),
    [
        ("parameters", {"noise_mm": float("nan")}),
        ("parameters", {"noise_mm": [[[1]]]}),
        ("first_frame", 10**400),
        ("point", -(10**400)),
        ("r90_mm", 10**400),
        ("expected_error_mm", float("inf")),
        ("marker", "M" * 100_000),
        ("donors", ["D" * 100_000]),
        ("inputs", ["input"]),
        ("inputs", ["\N{LATIN SMALL LETTER E WITH ACUTE}" * 64]),
        ("inputs", "0" * 64),
    ],
)
def test_a_damaged_record_is_left_out(key: str, value: object, tmp_path: Path) -> None:
    path, out = tmp_path / "out.csv", tmp_path / "again.c3d"
    repair(write_sample(tmp_path, "csv"), path)
    record = json.loads(sidecar_path(path).read_text())
    place = record if key == "inputs" else record["repairs"][0]
    place[key] = value
    sidecar_path(path).write_text(json.dumps(record))
    source = read_recording(path)
    assert source.provenance is None
    (warning,) = (text for text in source.warnings if "repair record" in text)
    assert "cannot be used" in warning
    assert len(warning) < 300
    export(source, out, engine.Changes((), source.repairs))
    assert read_c3d(out).provenance is None


# --- many repairs --------------------------------------------------------------------------------


def test_more_repairs_than_a_new_c3d_has_room_for_go_beside_it(tmp_path: Path) -> None:
    points = walk(1700, 2)
    points[1:1699:2, 0] = np.nan
    np.savez(tmp_path / "walk.npz", pos=points, fps=100.0, units="mm", up="z")
    source = read_recording(tmp_path / "walk.npz")
    assert len(find_gaps(source.recording.present)) == 849
    out = tmp_path / "out.c3d"
    done = export(source, out, changes_in(source))
    assert done.saved.record == "sidecar"
    back = read_recording(out)
    assert len(back.repairs) == 849
    assert isinstance(back.provenance, Provenance)
    np.testing.assert_array_equal(back.measured.present, source.recording.present)
    export(source, out, changes_in(source, gaps=slice(100)))
    assert not sidecar_path(out).exists()
    assert len(read_recording(out).repairs) == 100
