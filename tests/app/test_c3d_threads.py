"""Reading a C3D file by some threads at once: the same as by one."""

from dataclasses import replace
from pathlib import Path

import numpy as np
import pytest
from c3d_synthetic import ENCODINGS, Machine, Synthetic, encode, walk

from mocapmend.errors import MocapmendError
from mocapmend.files import Way, c3d_points, c3d_reader, read_c3d
from mocapmend.files.opening import Stamp


@pytest.fixture
def small_parts(monkeypatch: pytest.MonkeyPatch) -> None:
    """Let small files be read by threads, too."""
    monkeypatch.setattr(c3d_points, "PART_BYTES", 1)


@pytest.mark.usefixtures("small_parts")
@pytest.mark.parametrize("threads", [2, 3, 7, 50])
@pytest.mark.parametrize(("machine", "is_float"), ENCODINGS)
def test_every_part_is_read_once(
    machine: Machine, is_float: bool, threads: int, tmp_path: Path
) -> None:
    points = walk()
    points[11:13, 2] = 0.0
    fourth = np.full(points.shape[:2], 0x0305)
    fourth[3:30, 1] = -1
    path = tmp_path / "written.c3d"
    path.write_bytes(encode(Synthetic(points, machine, is_float, 0.125, fourth)))
    alone, shared = read_c3d(path), read_c3d(path, Way(threads=threads))
    np.testing.assert_array_equal(shared.recording.points, alone.recording.points)
    np.testing.assert_array_equal(shared.residuals, alone.residuals)
    np.testing.assert_array_equal(shared.recording.present, alone.recording.present)
    assert shared.warnings == alone.warnings
    assert "2 samples are exactly (0, 0, 0)" in shared.warnings[0]


@pytest.mark.parametrize("threads", [1, 3])
def test_what_is_present_is_what_has_coordinates(threads: int, tmp_path: Path) -> None:
    points = walk()
    points[5:9, 0] = np.nan
    path = tmp_path / "written.c3d"
    path.write_bytes(encode(Synthetic(points)))
    recording = read_c3d(path, Way(threads=threads)).recording
    np.testing.assert_array_equal(recording.present, ~np.isnan(recording.points[..., 0]))
    assert not recording.present.flags.writeable
    moved = recording.with_points(walk())
    assert moved.present.all()


@pytest.mark.usefixtures("small_parts")
@pytest.mark.parametrize("threads", [1, 2])
def test_a_file_that_changes_meanwhile_is_refused(
    threads: int, tmp_path: Path, monkeypatch: pytest.MonkeyPatch
) -> None:
    path = tmp_path / "written.c3d"
    path.write_bytes(encode(Synthetic(walk())))
    read_layout = c3d_reader.read_layout

    def then_append(stream: object, size: int, where: str) -> c3d_reader.Layout:
        layout = read_layout(stream, size, where)  # type: ignore[arg-type]
        with path.open("ab") as more:
            more.write(b"more")
        return layout

    monkeypatch.setattr(c3d_reader, "read_layout", then_append)
    with pytest.raises(MocapmendError, match="changed while it was read"):
        read_c3d(path, Way(threads=threads))


@pytest.mark.usefixtures("small_parts")
def test_an_error_of_one_part_is_the_error_of_all(tmp_path: Path) -> None:
    path = tmp_path / "written.c3d"
    path.write_bytes(encode(Synthetic(walk())))
    whole = read_c3d(path)
    promised = replace(whole.layout, frames=whole.recording.frames + 1000)
    with pytest.raises(MocapmendError, match="became shorter"):
        c3d_points.Points(path, promised, _stamp(path), (0, 1), Way(threads=4))


def _stamp(path: Path) -> Stamp:
    status = path.stat()
    return Stamp(status.st_size, status.st_mtime_ns)
