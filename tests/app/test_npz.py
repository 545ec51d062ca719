"""NumPy archives: good ones, and those that try to do harm."""

import io
import json
import pickle
import struct
import tracemalloc
import zipfile
from pathlib import Path
from typing import Any

import numpy as np
import pytest
from hypothesis import given
from text_samples import POINTS, assert_same, recordings

from mocapmend.errors import MocapmendError
from mocapmend.files import read_recording
from mocapmend.files.formats import write_npz
from mocapmend_algorithms.recording import Recording

GOOD: dict[str, Any] = {
    "pos": POINTS.astype(np.float32), "fps": np.float32(120), "names": np.array(["LASI", "Hüfte"]),
    "units": "cm", "up": "y",
}  # fmt: skip


def save(tmp_path: Path, **arrays: Any) -> Path:
    path = tmp_path / "file.npz"
    np.savez_compressed(path, **arrays)
    return path


def test_a_file_by_hand(tmp_path: Path) -> None:
    source = read_recording(save(tmp_path, **GOOD))
    recording = source.recording
    assert source.kind == "NumPy"
    np.testing.assert_array_equal(recording.points, POINTS.astype(np.float32))
    assert recording.points.dtype == np.float64
    assert recording.labels == ("LASI", "Hüfte")
    assert (recording.rate, recording.unit, recording.up) == (120.0, "cm", "+y")
    assert source.warnings == ()


@pytest.mark.parametrize(
    "pos",
    [
        np.nan_to_num(POINTS * 10).astype(">i2"),
        np.nan_to_num(POINTS * 10).astype(np.uint8),
        POINTS.astype(">f8"),
        POINTS.astype(np.float16),
        np.asfortranarray(POINTS),
        np.empty((0, 2, 3)),
    ],
)
def test_kinds_of_numbers(pos: np.ndarray[Any, Any], tmp_path: Path) -> None:
    recording = read_recording(save(tmp_path, **(GOOD | {"pos": pos}))).recording
    np.testing.assert_array_equal(recording.points, pos)


def test_only_positions(tmp_path: Path) -> None:
    source = read_recording(save(tmp_path, pos=POINTS))
    assert source.recording.labels == ("point 1", "point 2")
    assert (source.recording.rate, source.recording.unit) == (100.0, "m")
    assert len(source.warnings) == 4


def test_parents_become_bones(tmp_path: Path) -> None:
    path = save(tmp_path, **GOOD, parents=np.array([-1, 0], np.int16))
    assert read_recording(path).bones == ((0, 1),)


@pytest.mark.parametrize(
    "wrong",
    [
        {"parents": np.array([-1, 5])},
        {"parents": np.array([0])},
        {"parents": np.array([-1.0, 0.0])},
        {"bones": np.array([[0, 1, 1]])},
        {"bones": np.array([[0, -1]])},
    ],
)
def test_bones_that_do_not_fit_are_ignored(wrong: dict[str, Any], tmp_path: Path) -> None:
    source = read_recording(save(tmp_path, **GOOD, **wrong))
    assert source.bones == ()
    assert any("ignored" in text for text in source.warnings)


@given(recordings())
def test_round_trip(tmp_path_factory: pytest.TempPathFactory, recording: Recording) -> None:
    path = tmp_path_factory.mktemp("npz") / "file.npz"
    bones = [(0, recording.markers - 1)] if recording.markers > 1 else []
    assert write_npz(recording, path, bones=bones, filled=recording.present) == ()
    source = read_recording(path)
    assert_same(source.recording, recording)
    assert source.recording.first_frame == recording.first_frame
    assert source.bones == tuple(bones)


def test_numpy_reads_what_we_write(tmp_path: Path) -> None:
    filled = np.ones((3, 2), bool)
    write_npz(Recording(POINTS.copy(), ("a", "b"), 50.0), tmp_path / "file.npz", filled=filled)
    with np.load(tmp_path / "file.npz", allow_pickle=False) as arrays:
        np.testing.assert_array_equal(arrays["pos"], POINTS)
        assert arrays["fps"] == 50
        assert arrays["names"].tolist() == ["a", "b"]
        assert (str(arrays["units"]), str(arrays["up"])) == ("mm", "z")
        np.testing.assert_array_equal(arrays["filled"], ~np.isnan(POINTS[..., 0]))


def test_the_shared_recordings(shared: Path) -> None:
    paths = [*(shared / "cmu_markers").glob("*.npz"), *(shared / "cmu_joints").glob("*.npz")]
    assert paths
    for path in paths:
        source = read_recording(path)
        with np.load(path) as arrays:
            np.testing.assert_array_equal(source.recording.points, arrays["pos"])
            assert source.recording.labels == tuple(arrays["names"])
            assert source.recording.up == f"+{arrays['up']}"
            assert len(source.bones) == np.count_nonzero(arrays.get("parents", np.array(-1)) >= 0)
        assert source.warnings == ()


class Bomb:
    def __reduce__(self) -> tuple[Any, ...]:
        return (Path.write_text, (Path("exploded"), "boom"))


@pytest.mark.parametrize(
    ("arrays", "message"),
    [
        ({"fps": np.array(1.0)}, "no array “pos”"),
        (GOOD | {"pos": POINTS[0]}, "must hold numbers"),
        (GOOD | {"pos": POINTS[..., :2]}, "must hold numbers"),
        (GOOD | {"pos": POINTS.astype(str)}, "must hold numbers"),
        (GOOD | {"pos": POINTS.astype(complex)}, "no array of numbers or text"),
        (GOOD | {"pos": np.empty((0, 30_000, 3))}, "30000 markers"),
        (GOOD | {"names": np.array(["one"])}, "each of the 2 markers"),
        (GOOD | {"names": np.arange(2)}, "each of the 2 markers"),
    ],
)
def test_what_is_no_recording(arrays: dict[str, Any], message: str, tmp_path: Path) -> None:
    path = save(tmp_path, **arrays)
    with pytest.raises(MocapmendError, match=message) as caught:
        read_recording(path)
    assert caught.value.where == str(path)
    assert caught.value.todo


@pytest.mark.parametrize("code", [0xD800, 0x110000, 0x7F000000, 0xFFFFFFFF])
@pytest.mark.parametrize("order", ["<", ">"])
def test_texts_of_no_characters_are_no_texts(code: int, order: str, tmp_path: Path) -> None:
    damaged = np.array([ord("m"), code], order + "u4").view(order + "U1")
    unit = np.array([code, ord("m")], order + "u4").view(order + "U2")[0:1]
    file = read_recording(save(tmp_path, pos=np.ones((4, 2, 3)), names=damaged, units=unit))
    assert (
        file.recording.labels
        == read_recording(save(tmp_path, pos=np.ones((4, 2, 3)))).recording.labels
    )
    assert file.recording.unit == "m"


def test_nothing_is_unpickled(tmp_path: Path, monkeypatch: pytest.MonkeyPatch) -> None:
    monkeypatch.chdir(tmp_path)
    path = save(tmp_path, **GOOD | {"names": np.array([Bomb(), Bomb()], object)})
    with pytest.raises(MocapmendError, match="no array of numbers or text"):
        read_recording(path)
    path.write_bytes(pickle.dumps(Bomb()))
    with pytest.raises(MocapmendError, match=r"not an \.npz file"):
        read_recording(path)
    assert not (tmp_path / "exploded").exists()


def npy(header: str, data: bytes = b"") -> bytes:
    text = header.encode()
    return b"\x93NUMPY\1\0" + struct.pack("<H", len(text)) + text + data


def archive(tmp_path: Path, content: bytes, name: str = "pos.npy") -> Path:
    path = tmp_path / "file.npz"
    with zipfile.ZipFile(path, "w", zipfile.ZIP_DEFLATED) as out:
        out.writestr(name, content)
    return path


HEADERS = (
    "{'descr': '<f8', 'fortran_order': False, 'shape': (1000000, 1000, 3), }",
    "{'descr': '<f8', 'fortran_order': False, 'shape': (99999999999, 99999999999, 3), }",
    "{'descr': '<f8', 'fortran_order': False, 'shape': (0, 999999999999999999, 3), }",
    "{'descr': '<f8', 'fortran_order': False, 'shape': (-1, 2, 3), }",
    "{'descr': '<f3', 'fortran_order': False, 'shape': (0, 2, 3), }",
    "{'descr': '<f999999999', 'fortran_order': False, 'shape': (0, 2, 3), }",
    "{'descr': '|O', 'fortran_order': False, 'shape': (1, 2, 3), }",
    "{'descr': [('a', '<f8')], 'fortran_order': False, 'shape': (1, 2, 3), }",
    "__import__('os').abort()",
    "",
)


@pytest.mark.parametrize("header", HEADERS)
def test_headers_that_lie(header: str, tmp_path: Path) -> None:
    with pytest.raises(MocapmendError):
        read_recording(archive(tmp_path, npy(header)))


def test_a_bomb_is_refused_before_it_goes_off(tmp_path: Path) -> None:
    data = bytes(100 << 20)
    shape = (len(data) // 24, 1, 3)
    header = f"{{'descr': '<f8', 'fortran_order': False, 'shape': {shape}, }}"
    with pytest.raises(MocapmendError, match="not believable"):
        read_recording(archive(tmp_path, npy(header, data[: shape[0] * 24])))


def test_a_directory_that_lies_about_sizes(tmp_path: Path) -> None:
    path = save(tmp_path, **GOOD)
    raw = bytearray(path.read_bytes())
    at = raw.index(b"PK\1\2")
    struct.pack_into("<I", raw, at + 24, 10**6)
    path.write_bytes(raw)
    with pytest.raises(MocapmendError):
        read_recording(path)


def test_a_stream_that_grows_beyond_its_declared_size(tmp_path: Path) -> None:
    declared = "{'descr': '<f8', 'fortran_order': False, 'shape': (100, 1, 3), }"
    path = archive(tmp_path, npy(declared, bytes(200 << 20)))
    raw = bytearray(path.read_bytes())
    struct.pack_into("<I", raw, raw.index(b"PK\1\2") + 24, len(npy(declared)) + 2400)
    path.write_bytes(raw)
    tracemalloc.start()
    with pytest.raises(MocapmendError, match="“pos” is damaged"):
        read_recording(path)
    _, most = tracemalloc.get_traced_memory()
    tracemalloc.stop()
    assert most < 10_000_000


def test_a_directory_that_is_too_long(tmp_path: Path) -> None:
    path = tmp_path / "file.npz"
    with zipfile.ZipFile(path, "w") as out:
        for i in range(100):
            out.writestr(f"{i}{'x' * 20_000}", b"")
    with pytest.raises(MocapmendError, match=r"not an \.npz file"):
        read_recording(path)


def test_names_that_lead_elsewhere_are_only_names(tmp_path: Path) -> None:
    buffer = io.BytesIO()
    np.save(buffer, POINTS)
    folder = tmp_path / "inner"
    folder.mkdir()
    with pytest.raises(MocapmendError, match="no array “pos”"):
        read_recording(archive(folder, buffer.getvalue(), "../pos.npy"))
    assert [entry.name for entry in tmp_path.rglob("*")] == ["inner", "file.npz"]


def test_other_archives(tmp_path: Path) -> None:
    path = archive(tmp_path, json.dumps({"pos": 1}).encode(), "pos.json")
    with pytest.raises(MocapmendError, match="no array “pos”"):
        read_recording(path)
