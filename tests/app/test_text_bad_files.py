"""Text files and archives that cannot be read: one clear message each, and nothing else."""

import io
import os
import random
import tracemalloc
from pathlib import Path

import numpy as np
import pytest
from hypothesis import given
from hypothesis import strategies as st
from kinect_samples import REST_39, led_by, person, rows, with_orientations, with_states
from text_samples import (
    LONG,
    MOTIVE,
    NEXUS,
    POINTS,
    QUALISYS,
    QUALISYS_ROWS,
    TRC,
    WIDE,
)  # fmt: skip

from mocapmend.errors import MocapmendError
from mocapmend.files import read_recording
from mocapmend.files.formats.text import BLOCK, LONGEST_LINE
from mocapmend.files.source import Source

SUFFIXES = (".trc", ".csv", ".tsv", ".txt", ".npz")
HEAD = "frame,time,a_x,a_y,a_z\n"


def npz() -> bytes:
    buffer = io.BytesIO()
    np.savez(buffer, pos=POINTS, fps=50.0, names=["a", "b"], units="mm", up="z", bones=[[0, 1]])
    return buffer.getvalue()


FILES = {
    "trc": (".trc", TRC.encode()),
    "trc.txt": (".txt", TRC.encode("utf-16")),
    "wide": (".csv", ("# rate_hz=50\n# unit=mm\n" + WIDE).encode()),
    "long": (".csv", ("# rate_hz=50\n# unit=mm\n" + LONG).encode()),
    "qualisys": (".tsv", (QUALISYS + "\n".join(QUALISYS_ROWS)).encode()),
    "motive": (".csv", MOTIVE.encode()),
    "nexus": (".csv", NEXUS.encode()),
    "npz": (".npz", npz()),
    "kinect": (".txt", rows(with_orientations(person(4)), " ", " \r").encode()),
    "states": (".csv", rows(with_states(person(4)), end=",").encode()),
    "times": (".csv", rows(led_by(np.arange(4) / 30, person(4))).encode()),
    "vicon": (".txt", rows(person(4, REST_39)).encode()),
}
TOKENS = [
    b"\0",
    b"\xff",
    b'"',
    b",",
    b"\t",
    b"\n",
    b"-",
    b"1e400",
    b"nan",
    b"99999999999",
    b"#",
    b"\n\n",
]


def assert_sound(source: Source, size: int) -> None:
    recording = source.recording
    assert recording.points.nbytes <= 100 * size + 30_000_000
    assert np.isfinite(recording.points[recording.present]).all()
    assert np.isnan(recording.points[~recording.present]).all()
    assert all(label and "\n" not in label for label in recording.labels)
    assert all(a < recording.markers and b < recording.markers for a, b in source.bones)
    assert all(np.isfinite([event.frame, event.time]).all() for event in source.events)
    assert all(text.endswith(".") for text in source.warnings)


def read_or_refuse(path: Path) -> bool:
    try:
        source = read_recording(path)
    except MocapmendError as error:
        assert error.what.endswith(".")
        assert error.where == str(path)
        assert error.todo
        return False
    assert_sound(source, path.stat().st_size)
    return True


@given(data=st.data())
@pytest.mark.parametrize("name", FILES)
def test_mutants_open_or_are_refused(
    name: str, data: st.DataObject, tmp_path_factory: pytest.TempPathFactory
) -> None:
    suffix, original = FILES[name]
    raw = bytearray(original)
    for _ in range(data.draw(st.integers(1, 4))):
        at = data.draw(st.integers(0, len(raw)))
        kind = data.draw(st.sampled_from(["flip", "cut", "cut out", "splice", "insert"]))
        if kind == "flip" and at < len(raw):
            raw[at] ^= 1 << data.draw(st.integers(0, 7))
        elif kind == "cut":
            del raw[at:]
        elif kind == "cut out":
            del raw[at : at + data.draw(st.integers(1, 100))]
        elif kind == "splice":
            start = data.draw(st.integers(0, len(raw)))
            raw[at:at] = raw[start : start + data.draw(st.integers(1, 200))]
        else:
            raw[at:at] = data.draw(st.sampled_from(TOKENS))
    path = tmp_path_factory.mktemp("mutant") / f"file{suffix}"
    path.write_bytes(raw)
    read_or_refuse(path)


@pytest.mark.parametrize("suffix", SUFFIXES)
@pytest.mark.parametrize(
    ("content", "message"),
    [
        (b"", "file is empty|is damaged"),
        (random.Random(1).randbytes(20_000), "not a text file|npz"),
        (b"\x7fELF" + bytes(5000), "not a text file|npz"),
        (b"\xff\xfe" + random.Random(2).randbytes(3001), "TRC|no row|npz"),
        (b"Dear diary,\n\ntoday I walked.\n" * 9, "TRC|no row|npz"),
        (b"\n" * 5000, "TRC|no row|npz"),
        (b"1,2,3\n" * 100, "TRC|no row|npz"),
    ],
)
def test_what_is_no_recording(content: bytes, message: str, suffix: str, tmp_path: Path) -> None:
    path = tmp_path / f"file{suffix}"
    path.write_bytes(content)
    with pytest.raises(MocapmendError, match=message):
        read_recording(path)
    assert not read_or_refuse(path)


@pytest.mark.parametrize("suffix", SUFFIXES)
def test_what_is_no_file(suffix: str, tmp_path: Path) -> None:
    path = tmp_path / f"file{suffix}"
    with pytest.raises(MocapmendError, match="There is no such file"):
        read_recording(path)
    path.mkdir()
    with pytest.raises(MocapmendError, match="This is a folder"):
        read_recording(path)


@pytest.mark.skipif(not hasattr(os, "mkfifo"), reason="no pipes in this system's folders")
@pytest.mark.parametrize("suffix", SUFFIXES)
def test_a_pipe_is_not_waited_for(suffix: str, tmp_path: Path) -> None:
    path = tmp_path / f"file{suffix}"
    os.mkfifo(path)
    with pytest.raises(MocapmendError, match="not an ordinary file"):
        read_recording(path)


@pytest.mark.parametrize(
    ("name", "old", "new"),
    [
        ("trc", b"\t3\t2\tmm", b"\t2000000000\t2000000000\tmm"),
        ("trc", b"\t3\t2\tmm", b"\t1e300\t-7\tmm"),
        ("qualisys", b"NO_OF_FRAMES\t3", b"NO_OF_FRAMES\t2000000000"),
        ("qualisys", b"NO_OF_MARKERS\t2", b"NO_OF_MARKERS\t2000000000"),
        ("motive", b"Exported Frames,3", b"Exported Frames,2000000000"),
        ("wide", b"\n3,", b"\n2000000000,"),
        ("long", b"\n3,", b"\n2000000000,"),
        ("nexus", b"\n103,", b"\n2000000000,"),
    ],
)
def test_counts_are_not_believed(name: str, old: bytes, new: bytes, tmp_path: Path) -> None:
    suffix, raw = FILES[name]
    assert old in raw
    path = tmp_path / f"file{suffix}"
    path.write_bytes(raw.replace(old, new))
    tracemalloc.start()
    source = read_recording(path)
    peak = tracemalloc.get_traced_memory()[1]
    tracemalloc.stop()
    assert peak < 20_000_000
    assert source.recording.points.shape == (3, 2, 3)
    assert source.warnings


@pytest.mark.parametrize("suffix", [".trc", ".csv"])
@pytest.mark.parametrize("text", ["x", ",", "a_x,a_y,a_z,", '"'])
def test_a_line_without_an_end(text: str, suffix: str, tmp_path: Path) -> None:
    path = tmp_path / f"file{suffix}"
    path.write_text(text * (50_000_000 // len(text)))
    tracemalloc.start()
    with pytest.raises(MocapmendError, match="too long for a text file"):
        read_recording(path)
    peak = tracemalloc.get_traced_memory()[1]
    tracemalloc.stop()
    assert peak < 5 * (LONGEST_LINE + BLOCK)


def test_more_markers_than_anybody_has(tmp_path: Path) -> None:
    path = tmp_path / "file.csv"
    path.write_text("frame," + ",".join(f"{i}_x,{i}_y,{i}_z" for i in range(25_000)) + "\n1,2,3\n")
    with pytest.raises(MocapmendError, match="names 25000 markers; at most 20000"):
        read_recording(path)


def test_short_lines_under_a_wide_header_do_not_fill_the_memory(tmp_path: Path) -> None:
    path = tmp_path / "file.csv"
    head = "frame," + ",".join(f"{i}_x,{i}_y,{i}_z" for i in range(5000))
    path.write_text(head + "\n" + "".join(f"{i}\n" for i in range(100_000)))
    with pytest.raises(MocapmendError, match="end before their last column"):
        read_recording(path)


def test_samples_of_as_many_markers_as_frames_do_not_fill_the_memory(tmp_path: Path) -> None:
    path = tmp_path / "file.csv"
    rows = (f"{i},m{i},1,2,3\n" for i in range(15_000))
    path.write_text("frame,marker,x,y,z\n" + "".join(rows))
    with pytest.raises(MocapmendError, match="15000 lines are too few for 15000 markers"):
        read_recording(path)


@pytest.mark.parametrize(
    ("text", "message"),
    [
        (HEAD + "1,0.0,1,2,3\n2,0.1,1,two,3\n", "Line 3 has “two” where a number belongs"),
        (HEAD + "1,0.0,1,2,3\n\n2,0.1,1,1_0,3\n", "Line 4 has “1_0” where a number belongs"),
        (HEAD + '1,0.0,"1,2,3\n2,0.1,1,2,3\n', "quotation mark is not closed"),
        (HEAD.replace(",", ";") + "1;0;1.234,5;2;3\n", "has “1.234,5” where"),
        ("frame,marker,x,y,z\n1,a,1,2,3\n,a,1,2,3\n", "neither a frame nor a time"),
        ("frame,marker,x,y,z\n1,a,1,2,3\n2,a,1,?,3\n", "Line 3 has “[?]” where a number belongs"),
        ("frame,marker,x,y,z\n", "holds no marker"),
        ("frame,time,angle\n1,2,3\n", "no row that names columns of markers"),
    ],
)
def test_messages_say_where(text: str, message: str, tmp_path: Path) -> None:
    path = tmp_path / "file.csv"
    path.write_text(text)
    with pytest.raises(MocapmendError, match=message):
        read_recording(path)


def test_a_table_without_frames_opens_empty(tmp_path: Path) -> None:
    path = tmp_path / "file.csv"
    path.write_text(HEAD)
    source = read_recording(path)
    assert source.recording.points.shape == (0, 1, 3)
    assert any("nothing to repair" in text for text in source.warnings)


def test_lines_are_the_same_wherever_blocks_end(tmp_path: Path) -> None:
    path = tmp_path / "file.csv"
    points = np.random.default_rng(3).normal(size=(9000, 7, 3))
    points[points[..., 0] > 1] = np.nan
    names = ",".join(f"é{i}_{axis}" for i in range(7) for axis in "xyz")
    rows = [
        ",".join("" if np.isnan(x) else repr(x) for x in row)
        for row in points.reshape(9000, -1).tolist()
    ]
    for end in ("\n", "\r\n"):
        text = end.join(
            ["frame,time," + names, *(f"{i},{i / 100:.2f},{row}" for i, row in enumerate(rows))]
        )
        path.write_bytes(text.encode())
        assert path.stat().st_size > 2 * BLOCK
        recording = read_recording(path).recording
        np.testing.assert_array_equal(recording.points, points)
        assert recording.first_frame == 0
