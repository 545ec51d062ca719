"""Files that cannot be read or only in part: one clear message each, and nothing else."""

import os
import random
import stat
from collections.abc import Callable
from pathlib import Path

import numpy as np
import pytest
from c3d_synthetic import ENCODINGS, Synthetic, encode, walk

from mocapmend.errors import MocapmendError
from mocapmend.files import C3DFile, read_c3d, save_patched

MUTANTS = 60
"""Per file; nine files."""


@pytest.mark.parametrize(
    ("content", "message"),
    [
        (b"", "The file is empty."),
        (b"\x02", "This is not a C3D file."),
        (b"PK\x03\x04" * 500, "This is not a C3D file."),
        (b"\x02\x50", "The file ends before its parameter section"),
        (b"\x02\x50" + bytes(2000), "unknown number format"),
        (encode(Synthetic(walk()))[:700], "The file ends before its data begin."),
    ],
)
def test_what_is_no_c3d_file(content: bytes, message: str, tmp_path: Path) -> None:
    path = tmp_path / "bad.c3d"
    path.write_bytes(content)
    with pytest.raises(MocapmendError) as caught:
        read_c3d(path)
    assert message in caught.value.what
    assert caught.value.where == str(path)
    assert caught.value.todo


def test_a_missing_file_and_a_folder(tmp_path: Path) -> None:
    with pytest.raises(MocapmendError, match="There is no such file"):
        read_c3d(tmp_path / "missing.c3d")
    with pytest.raises(MocapmendError, match="This is a folder"):
        read_c3d(tmp_path)


@pytest.mark.skipif(not hasattr(os, "mkfifo"), reason="no pipes in this system's folders")
def test_a_pipe_is_not_waited_for(tmp_path: Path) -> None:
    os.mkfifo(tmp_path / "pipe.c3d")
    with pytest.raises(MocapmendError, match="not an ordinary file"):
        read_c3d(tmp_path / "pipe.c3d")


def test_a_file_that_may_not_be_read(tmp_path: Path, monkeypatch: pytest.MonkeyPatch) -> None:
    path = tmp_path / "secret.c3d"
    path.write_bytes(encode(Synthetic(walk())))

    def refuse(*_: object, **__: object) -> None:
        raise PermissionError(13, "Permission denied")

    # Root may read everything, so permissions alone are no test.
    monkeypatch.setattr(Path, "open", refuse)
    with pytest.raises(MocapmendError, match="You may not read this file"):
        read_c3d(path)


@pytest.mark.parametrize("is_float", [True, False])
def test_a_truncated_file_opens_with_exact_counts(is_float: bool, tmp_path: Path) -> None:
    points = walk()
    raw = encode(Synthetic(points, is_float=is_float, scale=0.125))
    path = tmp_path / "cut.c3d"
    path.write_bytes(raw)
    layout = read_c3d(path).layout
    path.write_bytes(raw[: layout.data_start + 29 * layout.frame_bytes + 7])
    file = read_c3d(path)
    assert file.truncated
    assert (file.layout.frames, file.layout.frames_promised) == (29, 40)
    np.testing.assert_array_equal(file.recording.points, points[:29])
    assert [text for text in file.warnings if "40 frames, but only 29 are there" in text]
    with pytest.raises(MocapmendError, match=r"truncated: 29 of 40"):
        save_patched(file, [], tmp_path / "out.c3d")
    assert not (tmp_path / "out.c3d").exists()
    save_patched(file, [], tmp_path / "out.c3d", accept_truncated=True)
    assert (tmp_path / "out.c3d").read_bytes() == path.read_bytes()


def test_a_long_truncated_file_keeps_what_is_there(tmp_path: Path) -> None:
    points = walk(70_000, 1)
    raw = encode(Synthetic(points))
    path = tmp_path / "cut.c3d"
    path.write_bytes(raw[:-16_000])
    file = read_c3d(path)
    assert file.layout.frames_promised == 70_000
    assert 68_900 < file.layout.frames < 70_000


def test_a_file_that_is_cut_where_its_data_begin(tmp_path: Path) -> None:
    path = tmp_path / "cut.c3d"
    raw = encode(Synthetic(walk()))
    path.write_bytes(raw)
    start = read_c3d(path).layout.data_start
    path.write_bytes(raw[:start])
    file = read_c3d(path)
    assert file.truncated
    assert file.recording.points.shape == (0, 5, 3)


def test_a_source_that_changed_is_noticed(tmp_path: Path) -> None:
    path = tmp_path / "file.c3d"
    path.write_bytes(encode(Synthetic(walk(), analog=np.ones((40, 1, 2)))))
    file = read_c3d(path)
    path.write_bytes(encode(Synthetic(walk(41), analog=np.ones((41, 1, 2)))))
    with pytest.raises(MocapmendError, match="changed since it was opened"):
        file.read_analog()
    with pytest.raises(MocapmendError, match="changed since it was opened"):
        save_patched(file, [], tmp_path / "out.c3d")
    assert [entry.name for entry in tmp_path.iterdir()] == ["file.c3d"]


def flip(raw: bytearray, rng: random.Random) -> None:
    for _ in range(rng.choice([1, 3, 20])):
        raw[rng.randrange(len(raw))] ^= 1 << rng.randrange(8)


def flip_head(raw: bytearray, rng: random.Random) -> None:
    for _ in range(rng.choice([1, 3, 20, 200])):
        raw[rng.randrange(2, min(len(raw), 2048))] = rng.randrange(256)


def words(raw: bytearray, rng: random.Random) -> None:
    for _ in range(3):
        at = rng.randrange(2, 24)
        raw[at : at + 2] = rng.choice([b"\0\0", b"\xff\xff", b"\0\x80", b"\xff\x7f"])


def cut(raw: bytearray, rng: random.Random) -> None:
    del raw[rng.randrange(len(raw)) :]


def cut_out(raw: bytearray, rng: random.Random) -> None:
    at = rng.randrange(len(raw))
    del raw[at : at + rng.choice([1, 2, 511, 512, 5000])]


def splice(raw: bytearray, rng: random.Random) -> None:
    start, to = rng.randrange(len(raw)), rng.randrange(len(raw))
    raw[to:to] = raw[start : start + rng.choice([1, 4, 512, 3000])]


MUTATIONS: list[Callable[[bytearray, random.Random], None]] = [
    flip, flip_head, words, cut, cut_out, splice,
]  # fmt: skip
SYNTHETIC = [
    Synthetic(walk(), machine, is_float, 0.125, analog=np.ones((40, 2, 3)), events=[("HS", 0.1)])
    for machine, is_float in ENCODINGS
]


@pytest.mark.parametrize("number", range(9))
def test_mutants_open_or_are_refused(number: int, samples: Path, tmp_path: Path) -> None:
    originals = sorted(samples.glob("*.c3d"))
    sources = [encode(spec) for spec in SYNTHETIC] + [path.read_bytes() for path in originals]
    path = tmp_path / "mutant.c3d"
    rng = random.Random(number)
    opened = 0
    for _ in range(MUTANTS):
        raw = bytearray(sources[number])
        for mutate in rng.choices(MUTATIONS, k=rng.choice([1, 1, 2])):
            if len(raw) > 2:
                mutate(raw, rng)
        path.write_bytes(raw)
        try:
            file = read_c3d(path)
        except MocapmendError as error:
            assert error.what.endswith(".")
            continue
        opened += 1
        assert_sound(file, len(raw))
    assert opened > MUTANTS // 4


def assert_sound(file: C3DFile, size: int) -> None:
    recording = file.recording
    assert recording.points.nbytes <= 3 * size
    assert file.residuals.shape == recording.points.shape[:2]
    assert np.isfinite(recording.points[recording.present]).all()
    assert len(file.analog_labels) == file.layout.channels
    assert file.layout.data_stop <= size
    file.read_analog()


def test_a_new_file_has_ordinary_permissions(tmp_path: Path) -> None:
    path = tmp_path / "file.c3d"
    path.write_bytes(encode(Synthetic(walk())))
    out = tmp_path / "out.c3d"
    save_patched(read_c3d(path), [], out)
    assert stat.S_IMODE(out.stat().st_mode) == stat.S_IMODE(path.stat().st_mode)
