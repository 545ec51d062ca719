"""Saving: only the given samples change, and nothing is ever left half done."""

import errno
import os
from pathlib import Path
from typing import BinaryIO

import numpy as np
import pytest
from c3d_synthetic import ENCODINGS, Machine, Synthetic, encode, walk
from hypothesis import HealthCheck, given, settings
from hypothesis import strategies as st
from hypothesis.extra.numpy import arrays

from mocapmend.errors import MocapmendError
from mocapmend.files import C3DFile, SampleRun, read_c3d, save_patched
from mocapmend.files import c3d_patch as patch_module
from mocapmend_algorithms import Cancelled

SCALE = 0.125


def written(folder: Path, machine: Machine = "intel", is_float: bool = True) -> C3DFile:
    """Write a file with a model output among its markers, analog data and gaps."""
    points = walk()
    fourth = np.full(points.shape[:2], 0x0203)
    fourth[10:20, 3] = -1
    points[10:20, 3] = 0
    spec = Synthetic(
        points,
        machine,
        is_float,
        SCALE,
        fourth,
        analog=np.arange(40.0 * 2 * 3).reshape(40, 2, 3),
        first_frame=101,
        labels=["A", "Angle", "B", "C", "D"],
        parameters={"POINT:ANGLES": ["Angle"]},
    )
    path = folder / "source.c3d"
    path.write_bytes(encode(spec) + b"what follows the data")
    return read_c3d(path)


def slot_mask(source: C3DFile, samples: set[tuple[int, int]]) -> np.ndarray:
    """Mark the bytes of (frame, point) in the file, by arithmetic of its own."""
    layout = source.layout
    mask = np.zeros(layout.size, bool)
    size = 16 if layout.is_float else 8
    for frame, point in samples:
        at = layout.data_start + frame * (5 * size + 6 * size // 4) + point * size
        mask[at : at + size] = True
    return mask


@pytest.mark.parametrize(("machine", "is_float"), ENCODINGS)
def test_without_edits_the_copy_is_the_same(
    machine: Machine, is_float: bool, tmp_path: Path
) -> None:
    source = written(tmp_path, machine, is_float)
    saved = save_patched(source, [], tmp_path / "out.c3d")
    assert saved.path.read_bytes() == source.path.read_bytes()
    assert (saved.samples, saved.notes) == (0, ())


VALUES = arrays(
    np.float64,
    st.tuples(st.integers(1, 12), st.just(3)),
    elements=st.floats(-4000, 4000) | st.sampled_from([0.0, SCALE / 3, -1e-50, 1e-30]),
)


@settings(max_examples=25, suppress_health_check=[HealthCheck.function_scoped_fixture])
@given(
    st.lists(st.tuples(st.integers(0, 3), st.integers(0, 28), VALUES, st.booleans()), max_size=4)
)
@pytest.mark.parametrize(("machine", "is_float"), ENCODINGS)
def test_only_the_samples_change(
    machine: Machine,
    is_float: bool,
    tmp_path: Path,
    edits: list[tuple[int, int, np.ndarray, bool]],
) -> None:
    source = written(tmp_path, machine, is_float)
    expected = source.recording.points.copy()
    runs, samples = [], set()
    for marker, start, values, remove in edits:
        values = np.full_like(values, np.nan) if remove else values
        runs.append(SampleRun(marker, start, values))
        stop = start + len(values)
        expected[start:stop, marker] = values
        samples |= {(frame, source.marker_points[marker]) for frame in range(start, stop)}
    out = tmp_path / "out.c3d"
    assert save_patched(source, runs, out).samples == len(samples)
    before = np.frombuffer(source.path.read_bytes(), np.uint8)
    after = np.frombuffer(out.read_bytes(), np.uint8)
    np.testing.assert_array_equal(
        before[~slot_mask(source, samples)], after[~slot_mask(source, samples)]
    )
    read = read_c3d(out)
    np.testing.assert_array_equal(read.recording.present, ~np.isnan(expected[..., 0]))
    if is_float:
        # (0, 0, 0) would mean missing: such a sample is moved by a millionth.
        zero = (expected.astype(np.float32) == 0).all(axis=2)
        np.testing.assert_array_equal(
            read.recording.points[~zero], expected.astype(np.float32)[~zero]
        )
        assert (np.abs(read.recording.points[zero]) <= 1.1e-6).all()
    else:
        rounded = np.abs(expected) <= SCALE / 2
        allowed = np.where(rounded.all(axis=2), SCALE * 1.5, SCALE / 2)[..., None]
        assert (np.abs(read.recording.points - expected) <= allowed + 1e-9)[
            ~np.isnan(expected)
        ].all()
    changed = np.zeros(expected.shape[:2], bool)
    for marker, start, values, _ in edits:
        changed[start : start + len(values), marker] = True
    residual = read.residuals[changed & read.recording.present]
    np.testing.assert_array_equal(residual, np.zeros_like(residual))


def test_a_sample_at_the_origin_is_moved_and_said(tmp_path: Path) -> None:
    for is_float, moved in ((True, 1e-6), (False, SCALE)):
        source = written(tmp_path, is_float=is_float)
        values = np.array([[0.0, 0.0, -0.0], [0.0, -SCALE / 4, 0.0], [1.0, 0.0, 0.0]])
        if is_float:
            values[1] = -1e-60
        saved = save_patched(source, [SampleRun(0, 5, values)], tmp_path / f"{is_float}.c3d")
        points = read_c3d(saved.path).recording.points[5:8, 0]
        assert np.abs(points).max(axis=1) == pytest.approx([moved, moved, 1.0])
        assert (points[1] <= 0).all()
        assert len(saved.notes) == 1
        assert saved.notes[0].startswith("2 samples at (0, 0, 0)")


def test_the_last_of_overlapping_runs_counts(tmp_path: Path) -> None:
    source = written(tmp_path)
    runs = [SampleRun(1, 0, np.full((10, 3), 1.0)), SampleRun(1, 5, np.full((10, 3), 2.0))]
    saved = save_patched(source, runs, tmp_path / "out.c3d")
    assert saved.samples == 15
    read = read_c3d(saved.path).recording.points[:15, 1, 0]
    assert read.tolist() == [1.0] * 5 + [2.0] * 10


@pytest.mark.parametrize(
    ("machine", "is_float", "value"),
    [
        ("intel", False, 1e39),
        ("intel", True, 1e39),
        ("mips", True, -np.inf),
        ("dec", True, 1e38),
    ],
)
def test_a_value_that_does_not_fit(
    machine: Machine, is_float: bool, value: float, tmp_path: Path
) -> None:
    source = written(tmp_path, machine, is_float)
    values = np.ones((4, 3))
    values[2, 1] = value
    with pytest.raises(MocapmendError, match=r"Marker C at frame 110: .* does not fit"):
        save_patched(source, [SampleRun(2, 7, values)], tmp_path / "out.c3d")
    assert [entry.name for entry in tmp_path.iterdir()] == ["source.c3d"]


def test_the_largest_integers_fit(tmp_path: Path) -> None:
    source = written(tmp_path, is_float=False)
    values = np.array([[32767, -32767, 0.0]]) * SCALE
    save_patched(source, [SampleRun(0, 0, values)], tmp_path / "out.c3d")
    read = read_c3d(tmp_path / "out.c3d").recording.points[0, 0]
    np.testing.assert_array_equal(read, values[0])


@pytest.mark.parametrize(
    "run",
    [
        SampleRun(4, 0, np.ones((1, 3))),
        SampleRun(-1, 0, np.ones((1, 3))),
        SampleRun(0, 39, np.ones((2, 3))),
        SampleRun(0, -1, np.ones((2, 3))),
        SampleRun(0, 0, np.ones((2, 2))),
        SampleRun(0, 0, np.array([[1.0, np.nan, 1.0]])),
    ],
)
def test_runs_that_make_no_sense(run: SampleRun, tmp_path: Path) -> None:
    with pytest.raises(ValueError, match=r"values|marker|coordinates"):
        save_patched(written(tmp_path), [run], tmp_path / "out.c3d")


def test_the_source_is_never_replaced_by_accident(tmp_path: Path) -> None:
    source = written(tmp_path)
    before = source.path.read_bytes()
    (tmp_path / "link.c3d").symlink_to(source.path)
    os.link(source.path, tmp_path / "hard.c3d")
    (tmp_path / "folder").mkdir()
    for name in ("source.c3d", "link.c3d", "hard.c3d", "folder/../source.c3d"):
        with pytest.raises(MocapmendError, match="file that the data come from"):
            save_patched(source, [SampleRun(0, 0, np.ones((1, 3)))], tmp_path / name)
    assert source.path.read_bytes() == before


def test_the_source_is_replaced_when_told_to(tmp_path: Path) -> None:
    source = written(tmp_path)
    source.path.chmod(0o640)
    (tmp_path / "link.c3d").symlink_to(source.path)
    run = SampleRun(0, 3, np.full((1, 3), 7.0))
    save_patched(source, [run], tmp_path / "link.c3d", replace_source=True)
    assert (tmp_path / "link.c3d").is_symlink()
    assert read_c3d(source.path).recording.points[3, 0].tolist() == [7.0] * 3
    assert source.path.stat().st_mode & 0o777 == 0o640


def test_another_file_is_replaced(tmp_path: Path) -> None:
    source = written(tmp_path)
    out = tmp_path / "out.c3d"
    out.write_bytes(b"old")
    save_patched(source, [], out)
    assert out.read_bytes() == source.path.read_bytes()


def test_places_where_nothing_can_be_written(tmp_path: Path) -> None:
    source = written(tmp_path)
    with pytest.raises(MocapmendError, match="folder does not exist"):
        save_patched(source, [], tmp_path / "missing" / "out.c3d")
    (tmp_path / "folder").mkdir()
    with pytest.raises(MocapmendError, match="a folder or a device of this name"):
        save_patched(source, [], tmp_path / "folder")
    with pytest.raises(MocapmendError, match="cannot be written"):
        save_patched(source, [], source.path / "out.c3d")
    if hasattr(os, "geteuid") and os.geteuid() != 0:
        (tmp_path / "folder").chmod(0o500)
        with pytest.raises(MocapmendError, match="may not write into this folder"):
            save_patched(source, [], tmp_path / "folder" / "out.c3d")
    assert sorted(entry.name for entry in tmp_path.iterdir()) == ["folder", "source.c3d"]


@pytest.mark.parametrize(
    ("number", "message"),
    [
        (errno.ENOSPC, "not enough space"),
        (errno.EACCES, "may not write into this folder"),
        (errno.EROFS, "may not write into this folder"),
        (errno.EIO, "cannot be written"),
    ],
)
def test_a_failing_disk(
    number: int, message: str, tmp_path: Path, monkeypatch: pytest.MonkeyPatch
) -> None:
    source = written(tmp_path)
    before = source.path.read_bytes()

    def fail(_: int) -> None:
        raise OSError(number, os.strerror(number))

    monkeypatch.setattr(os, "fsync", fail)
    with pytest.raises(MocapmendError, match=message):
        save_patched(source, [], tmp_path / "out.c3d")
    assert [entry.name for entry in tmp_path.iterdir()] == ["source.c3d"]
    assert source.path.read_bytes() == before


def test_a_disk_that_is_full(tmp_path: Path) -> None:
    resource = pytest.importorskip("resource")
    source = written(tmp_path)
    old = resource.getrlimit(resource.RLIMIT_FSIZE)
    resource.setrlimit(resource.RLIMIT_FSIZE, (2000, old[1]))
    try:
        with pytest.raises(MocapmendError, match="not enough space"):
            save_patched(source, [], tmp_path / "out.c3d")
    finally:
        resource.setrlimit(resource.RLIMIT_FSIZE, old)
    assert [entry.name for entry in tmp_path.iterdir()] == ["source.c3d"]


@pytest.mark.parametrize("when", [0.0, 0.4, 0.5, 0.9, 1.0])
def test_cancelling_leaves_nothing(when: float, tmp_path: Path) -> None:
    source = written(tmp_path)
    out = tmp_path / "out.c3d"
    out.write_bytes(b"old")

    def cancel(fraction: float, /) -> None:
        if fraction >= when:
            raise Cancelled

    with pytest.raises(Cancelled):
        save_patched(source, [], out, progress=cancel)
    assert out.read_bytes() == b"old"
    assert len(list(tmp_path.iterdir())) == 2


def test_progress_goes_from_0_to_1(tmp_path: Path) -> None:
    seen: list[float] = []
    save_patched(written(tmp_path), [], tmp_path / "out.c3d", progress=seen.append)
    assert seen == sorted(seen)
    assert (seen[0], seen[-1]) == (0.0, 1.0)


@pytest.mark.parametrize(("where", "what"), [(0, "outside"), (1, "repaired samples")])
@pytest.mark.parametrize("is_float", [True, False])
def test_a_write_that_goes_wrong_is_noticed(
    where: int, what: str, is_float: bool, tmp_path: Path, monkeypatch: pytest.MonkeyPatch
) -> None:
    source = written(tmp_path, is_float=is_float)
    layout = source.layout
    at = [layout.data_start + 3, layout.data_start + 2 * layout.frame_bytes + 1][where]
    write = patch_module._Copy.write

    def spoil(copy: patch_module._Copy, stream: BinaryIO) -> None:
        write(copy, stream)
        stream.seek(at)
        stream.write(b"\x55")

    monkeypatch.setattr(patch_module._Copy, "write", spoil)
    with pytest.raises(MocapmendError, match=rf"did not read back .*{what}"):
        save_patched(source, [SampleRun(0, 2, np.full((3, 3), 9.0))], tmp_path / "out.c3d")
    assert [entry.name for entry in tmp_path.iterdir()] == ["source.c3d"]
