"""The proof on bytes, and the second reader: what they allow and what they report."""

from pathlib import Path

import numpy as np
import pytest
from c3d_synthetic import ENCODINGS, Machine, Synthetic, encode, walk

from mocapmend.errors import MocapmendError
from mocapmend.files import (
    C3DFile,
    ChangedRun,
    Claim,
    SampleRun,
    check_files,
    read_c3d,
    save_patched,
)


@pytest.fixture(params=ENCODINGS, ids=lambda pair: f"{pair[0]}-{'float' if pair[1] else 'int'}")
def source(request: pytest.FixtureRequest, tmp_path: Path) -> C3DFile:
    machine: Machine
    machine, is_float = request.param
    points = walk()
    # Gaps of A in frames 9 to 11 and 30 to 39, and of D in frames 0 and 1.
    fourth = np.full(points.shape[:2], 5.0)
    for marker, start, stop in ((0, 9, 12), (0, 30, 40), (4, 0, 2)):
        points[start:stop, marker] = 0.0
        fourth[start:stop, marker] = -1.0
    spec = Synthetic(
        points,
        machine,
        is_float,
        0.125,
        fourth,
        analog=np.arange(40.0 * 2 * 3).reshape(40, 2, 3),
        first_frame=11,
        labels=["A", "B", "Angle", "C", "D"],
        parameters={
            "POINT:ANGLES": ["Angle"],
            "ANALOG:LABELS": ["Fx", "Fy", "Fz"],
            "ANALOG:RATE": [200.0],
        },
    )
    path = tmp_path / "original.c3d"
    path.write_bytes(encode(spec))
    return read_c3d(path)


def altered(source: C3DFile, at: int, value: bytes = b"\x99") -> Path:
    """Write a copy with other bytes at a place."""
    raw = bytearray(source.path.read_bytes())
    assert raw[at : at + len(value)] != value
    raw[at : at + len(value)] = value
    path = source.path.with_name("altered.c3d")
    path.write_bytes(raw)
    return path


def slot(source: C3DFile, frame: int, point: int) -> int:
    layout = source.layout
    return layout.data_start + frame * layout.frame_bytes + point * layout.slot


def test_the_same_file(source: C3DFile) -> None:
    report = check_files(source.path, source.path)
    assert report.identical
    assert report.passed
    assert (report.changed, report.changed_samples, report.other_differences) == ((), 0, ())


def test_repaired_samples_are_listed_and_confirmed(source: C3DFile, tmp_path: Path) -> None:
    runs = [
        SampleRun(3, 0, np.full((2, 3), 5.0)),
        SampleRun(0, 9, np.full((3, 3), -7.5)),
        SampleRun(0, 30, np.full((10, 3), 12.34)),
    ]
    out = tmp_path / "out.c3d"
    save_patched(source, runs, out)
    report = check_files(source.path, out)
    assert report.passed
    assert not report.identical
    assert report.changed == (
        ChangedRun("A", 0, 20, 22),
        ChangedRun("A", 0, 41, 50),
        ChangedRun("D", 4, 11, 12),
    )
    assert report.changed_samples == 15
    sentence = Claim.of(source, out, runs).confirm()
    assert "read 40 frames of both files: 15 of 15" in sentence


def test_a_measured_sample_may_not_change(source: C3DFile) -> None:
    report = check_files(source.path, altered(source, slot(source, 7, 3)))
    assert report.changed == (ChangedRun("C", 3, 18, 18),)
    assert not report.passed
    first = report.other_differences[0]
    assert first == "Marker C: 1 sample differs although measured, the first at frame 18."


@pytest.mark.parametrize("values", [1e3, np.nan], ids=["moved", "erased"])
def test_a_measured_sample_may_not_be_replaced_by_a_computed_one(
    source: C3DFile, tmp_path: Path, values: float
) -> None:
    out = tmp_path / "out.c3d"
    save_patched(source, [SampleRun(2, 5, np.full((4, 3), values))], out)
    report = check_files(source.path, out)
    assert not report.passed
    assert "4 samples differ although measured" in report.other_differences[0]


def test_a_filled_sample_must_be_there_and_marked_as_computed(source: C3DFile) -> None:
    layout = source.layout
    at = slot(source, 10, 0)
    fourth = at + 3 * layout.word
    byte = source.path.read_bytes()[fourth]
    report = check_files(source.path, altered(source, fourth, bytes([byte ^ 1])))
    assert not report.passed
    assert report.changed == (ChangedRun("A", 0, 21, 21),)
    assert any("without the mark of a computed sample" in text for text in report.other_differences)
    assert any("still missing" in text for text in report.other_differences)


def test_hardly_any_flipped_bit_passes(gait: Path, tmp_path: Path) -> None:
    raw = gait.read_bytes()
    rng = np.random.default_rng(3)
    flipped = tmp_path / "flipped.c3d"
    passed = 0
    for at in rng.integers(0, len(raw), 100).tolist():
        damaged = bytearray(raw)
        damaged[at] ^= 1 << int(rng.integers(8))
        flipped.write_bytes(damaged)
        passed += check_files(gait, flipped).passed
    # Of a missing sample, a flip may look like a repair.
    assert passed <= 2


def test_a_model_output_and_an_analog_value(source: C3DFile) -> None:
    report = check_files(source.path, altered(source, slot(source, 7, 2)))
    assert report.changed == ()
    assert report.other_differences == (
        "Model output Angle: 1 sample differs, the first at frame 18.",
    )
    at = slot(source, 7, 5) + 4 * source.layout.word
    report = check_files(source.path, altered(source, at))
    assert report.other_differences == ("Analog channel Fy: 1 value differs.",)


def test_header_parameters_and_the_end(source: C3DFile) -> None:
    layout = source.layout
    places = {
        400: "the header",
        layout.parameters["POINT:UNITS"].stop - 3: "the parameter POINT:UNITS",
        layout.parameters["POINT:RATE"].start + 3: "the parameter POINT:RATE",
        layout.parameters.stop + 5: "blocks that nothing uses",
        layout.parameters_start: "the structure of the parameter section",
        layout.size - 1: "what follows the last frame",
    }
    for at, name in places.items():
        report = check_files(source.path, altered(source, at))
        assert report.other_differences == (f"1 byte differs in {name}.",)
        assert not report.passed


def test_another_size(source: C3DFile) -> None:
    raw = source.path.read_bytes()
    other = source.path.with_name("other.c3d")
    for size in (100, source.layout.data_start - 1, slot(source, 20, 2), len(raw) - 1):
        other.write_bytes(raw[:size])
        report = check_files(source.path, other)
        assert report.other_differences == (f"The sizes differ: {len(raw)} and {size} bytes.",)
        assert not report.identical
    other.write_bytes(raw + b"more")
    assert len(check_files(source.path, other).other_differences) == 1


def test_what_cannot_be_compared(source: C3DFile, tmp_path: Path) -> None:
    with pytest.raises(MocapmendError, match="no such file"):
        check_files(source.path, tmp_path / "missing.c3d")
    (tmp_path / "text.c3d").write_text("not a C3D file" * 100)
    with pytest.raises(MocapmendError, match="not a C3D file"):
        check_files(tmp_path / "text.c3d", source.path)


def test_the_second_reader_contradicts(source: C3DFile, tmp_path: Path) -> None:
    runs = [SampleRun(0, 9, np.full((3, 3), 12.5))]
    out = tmp_path / "out.c3d"
    save_patched(source, runs, out)
    assert "3 of 3" in Claim.of(source, out, runs).confirm()
    with pytest.raises(MocapmendError, match="data that were not written differ"):
        Claim.of(source, out, []).confirm()
    with pytest.raises(MocapmendError, match="written samples read differently"):
        Claim.of(source, source.path, runs).confirm()
    whole = out.read_bytes()
    out.write_bytes(whole[: slot(source, 30, 0)])
    with pytest.raises(MocapmendError, match="another number of frames"):
        Claim.of(source, out, runs).confirm()
    out.write_bytes(whole[:600])
    with pytest.raises(MocapmendError, match="it cannot read it"):
        Claim.of(source, out, runs).confirm()
    with pytest.raises(MocapmendError, match="no such file"):
        Claim.of(source, tmp_path / "missing.c3d", runs).confirm()


@pytest.mark.parametrize("machine", ["intel", "dec", "mips"])
def test_tiny_numbers_that_the_second_reader_takes_for_others(
    machine: Machine, tmp_path: Path
) -> None:
    path, out = tmp_path / "file.c3d", tmp_path / "out.c3d"
    path.write_bytes(encode(Synthetic(walk(), machine)))
    source = read_c3d(path)
    runs = [SampleRun(1, 3, np.array([[1e-39, 5.0, -1e-40]]))]
    save_patched(source, runs, out)
    assert "1 of 1 written samples decode" in Claim.of(source, out, runs).confirm()


def test_frames_that_only_the_second_reader_sees_are_not_compared(tmp_path: Path) -> None:
    path, out = tmp_path / "file.c3d", tmp_path / "out.c3d"
    path.write_bytes(encode(Synthetic(walk(), is_float=False, header={5: 45})) + bytes(range(250)))
    source = read_c3d(path)
    assert source.layout.frames == 40
    # Too large for the integers: the samples become floats, and what follows them stays as it is.
    runs = [SampleRun(1, 3, np.full((2, 3), 9000.0))]
    saved = save_patched(source, runs, out, repairs=())
    assert read_c3d(saved.path).layout.is_float
    assert "read 40 frames" in Claim.of(source, out, runs).confirm()


def test_a_file_that_the_second_reader_refuses(tmp_path: Path) -> None:
    path = tmp_path / "rate.c3d"
    path.write_bytes(encode(Synthetic(walk(), parameters={"POINT:RATE": [50.0]})))
    sentence = Claim.of(read_c3d(path), path, []).confirm()
    assert sentence.startswith("No second check, the c3d library cannot read this file: Assertion")


def test_a_file_that_the_second_reader_reads_otherwise(tmp_path: Path) -> None:
    path = tmp_path / "start.c3d"
    raw = bytearray(encode(Synthetic(walk())))
    raw[16:18] = b"\x01\x00"
    path.write_bytes(raw)
    source = read_c3d(path)
    np.testing.assert_array_equal(source.recording.points, walk())
    sentence = Claim.of(source, path, []).confirm()
    assert "it finds other numbers" in sentence
