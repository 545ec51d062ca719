"""Integers that cannot hold a repair become floats, and nothing else changes."""

from pathlib import Path

import numpy as np
import pytest
from c3d_synthetic import MACHINES, Machine, Synthetic, encode, walk

from mocapmend.errors import MocapmendError
from mocapmend.files import C3DFile, RepairRecord, SampleRun, check_files, read_c3d, save_patched
from mocapmend.files.second_reader import Claim

SCALE = 0.125
BEYOND = 33_000 * SCALE


def written(folder: Path, machine: Machine, **more: object) -> C3DFile:
    """Write integers with unsigned analog data, a gap of A, and stale coordinates in it."""
    points = walk()
    fourth = np.full(points.shape[:2], 0x0203)
    fourth[10:14, 0] = -1
    spec = Synthetic(
        points,
        machine,
        False,
        SCALE,
        fourth,
        analog=np.linspace(-32768, 32767, 240).round().reshape(40, 2, 3),
        labels=["A", "B", "C", "D", "E"],
        parameters={"ANALOG:FORMAT": "UNSIGNED", "ANALOG:OFFSET": [5, -9, 40_000]},
        **more,  # type: ignore[arg-type]
    )
    path = folder / "integers.c3d"
    path.write_bytes(encode(spec))
    return read_c3d(path)


def record(source: C3DFile, marker: int, start: int, stop: int) -> RepairRecord:
    first = source.recording.first_frame
    return RepairRecord(
        source.recording.labels[marker],
        source.stored_points[marker] + 1,
        first + start,
        first + stop - 1,
        "linear",
    )


REPAIR = SampleRun(0, 10, np.full((4, 3), BEYOND))


@pytest.mark.parametrize("machine", MACHINES)
def test_every_other_value_decodes_the_same(machine: Machine, tmp_path: Path) -> None:
    source = written(tmp_path, machine, events=[("Foot", 0.1)])
    out = tmp_path / "out.c3d"
    saved = save_patched(source, [REPAIR], out, repairs=[record(source, 0, 10, 14)])
    assert saved.converted
    floats = read_c3d(out)
    assert floats.layout.is_float
    expected = source.recording.points.copy()
    expected[10:14, 0] = np.float32(BEYOND)
    np.testing.assert_array_equal(floats.recording.points, expected)
    kept = source.recording.present
    np.testing.assert_array_equal(floats.residuals[kept], source.residuals[kept])
    np.testing.assert_array_equal(floats.read_analog(), source.read_analog())
    assert (floats.events, floats.recording.labels) == (source.events, source.recording.labels)
    assert floats.layout.header.scale == -SCALE
    assert floats.layout.parameters.number("POINT:SCALE") == -SCALE
    assert floats.provenance is not None
    assert floats.provenance.converted
    assert floats.warnings == source.warnings


@pytest.mark.parametrize("machine", MACHINES)
def test_the_proofs_see_the_conversion(machine: Machine, tmp_path: Path) -> None:
    source = written(tmp_path, machine)
    out = tmp_path / "out.c3d"
    save_patched(source, [REPAIR], out, repairs=[record(source, 0, 10, 14)])
    report = check_files(source.path, out)
    assert report.passed
    assert report.changed_samples == 4
    assert any("became floats" in sentence for sentence in report.allowed)
    assert "4 of 4 written samples" in Claim.of(source, out, [REPAIR]).confirm()


@pytest.mark.parametrize("what", ["sample", "fourth word", "analog value", "scale"])
def test_a_wrong_conversion_is_found(what: str, tmp_path: Path) -> None:
    source = written(tmp_path, "intel")
    out = tmp_path / "out.c3d"
    save_patched(source, [REPAIR], out, repairs=[record(source, 0, 10, 14)])
    layout = read_c3d(out).layout
    at = {
        "sample": layout.data_start + 16 + 3,
        "fourth word": layout.data_start + 16 + 15,
        "analog value": layout.data_start + layout.points * 16 + 1,
        "scale": 14,
    }[what]
    raw = bytearray(out.read_bytes())
    raw[at] ^= 1
    out.write_bytes(raw)
    report = check_files(source.path, out)
    assert not report.passed
    assert report.other_differences


def test_a_conversion_that_no_record_declares_is_a_difference(tmp_path: Path) -> None:
    source = written(tmp_path, "intel")
    out = tmp_path / "out.c3d"
    save_patched(source, [REPAIR], out, repairs=[record(source, 0, 10, 14)])
    raw = out.read_bytes()
    assert raw.count(b"MOCAPMEND") == 1
    out.write_bytes(raw.replace(b"MOCAPMEND", b"SOMEOTHER"))
    assert not check_files(source.path, out).passed


def test_where_header_and_parameter_disagree_the_scale_in_use_is_kept(tmp_path: Path) -> None:
    source = written(tmp_path, "intel")
    raw = bytearray(source.path.read_bytes())
    at = source.layout.parameters["POINT:SCALE"].data
    raw[at : at + 4] = np.float32(0.5).tobytes()
    source.path.write_bytes(raw)
    source = read_c3d(source.path)
    save_patched(source, [REPAIR], tmp_path / "out.c3d", repairs=[record(source, 0, 10, 14)])
    floats = read_c3d(tmp_path / "out.c3d")
    np.testing.assert_array_equal(floats.recording.points[:10], source.recording.points[:10])
    np.testing.assert_array_equal(floats.residuals[:10], source.residuals[:10])


def test_what_follows_the_data_stays(tmp_path: Path) -> None:
    source = written(tmp_path, "intel")
    tail = b"what follows the data" * 60
    source.path.write_bytes(source.path.read_bytes() + tail)
    source = read_c3d(source.path)
    out = tmp_path / "out.c3d"
    save_patched(source, [REPAIR], out, repairs=[record(source, 0, 10, 14)])
    assert out.read_bytes().rstrip(b"\0").endswith(tail)
    assert out.stat().st_size - source.path.stat().st_size - 512 == 2 * 40 * (5 * 4 + 6) + 480
    assert check_files(source.path, out).passed


def test_a_truncated_file_can_be_converted(tmp_path: Path) -> None:
    source = written(tmp_path, "intel")
    layout = source.layout
    source.path.write_bytes(
        source.path.read_bytes()[: layout.data_start + 20 * layout.frame_bytes + 7]
    )
    source = read_c3d(source.path)
    assert source.truncated
    out = tmp_path / "out.c3d"
    repairs = [record(source, 0, 10, 14)]
    save_patched(source, [REPAIR], out, repairs=repairs, accept_truncated=True)
    floats = read_c3d(out)
    assert (floats.recording.frames, floats.frames_promised) == (20, 40)
    assert check_files(source.path, out).passed


def test_data_before_the_parameters_cannot_be_converted(tmp_path: Path) -> None:
    source = written(tmp_path, "intel")
    layout, raw = source.layout, source.path.read_bytes()
    data = raw[layout.data_start : layout.data_stop].ljust(
        -(-(layout.data_stop - layout.data_start) // 512) * 512, b"\0"
    )
    section = raw[layout.parameters_start : layout.data_start]
    header = bytearray(raw[:512])
    header[0] = 2 + len(data) // 512
    header[16:18] = (2).to_bytes(2, "little")
    at = layout.parameters["POINT:DATA_START"].data - layout.parameters_start
    section = section[:at] + (2).to_bytes(2, "little") + section[at + 2 :]
    source.path.write_bytes(bytes(header) + data + section)
    moved = read_c3d(source.path)
    np.testing.assert_array_equal(moved.recording.points, source.recording.points)
    with pytest.raises(MocapmendError, match="does not allow to convert"):
        save_patched(moved, [REPAIR], tmp_path / "out.c3d", repairs=[record(moved, 0, 10, 14)])
    small = SampleRun(0, 10, np.full((4, 3), 1.0))
    saved = save_patched(moved, [small], tmp_path / "out.c3d", repairs=[record(moved, 0, 10, 14)])
    assert saved.record == "sidecar"
    assert len(read_c3d(tmp_path / "out.c3d").repaired) == 1
