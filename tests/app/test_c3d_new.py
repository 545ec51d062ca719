"""New C3D files: what is written is read again, by our reader and by others."""

import errno
import json
import os
import subprocess
import sys
import warnings
from importlib.util import find_spec
from pathlib import Path

import c3d
import numpy as np
import pytest
from c3d_synthetic import walk
from hypothesis import HealthCheck, given, settings
from hypothesis import strategies as st
from hypothesis.extra.numpy import arrays

from mocapmend.errors import MocapmendError
from mocapmend.files import C3DFile, Event, read_c3d
from mocapmend.files import c3d_new as new_module
from mocapmend.files.c3d_new import write_new_c3d
from mocapmend_algorithms import Cancelled, Recording
from mocapmend_algorithms.recording import MM_PER_UNIT, UpAxis

AXES: list[UpAxis] = ["+x", "-x", "+y", "-y", "+z", "-z"]


def recorded(points: np.ndarray, **values: object) -> Recording:
    labels = tuple(f"M{i + 1:03}" for i in range(points.shape[1]))
    return Recording(points, **{"labels": labels, "rate": 100.0} | values)  # type: ignore[arg-type]


def walking(frames: int = 40, markers: int = 5, **values: object) -> Recording:
    points = walk(frames, markers)
    points[frames // 3 : frames // 2, 1] = np.nan
    return recorded(points, **values)


def written(recording: Recording, folder: Path, events: tuple[Event, ...] = ()) -> C3DFile:
    write_new_c3d(recording, folder / "new.c3d", events=events)
    return read_c3d(folder / "new.c3d")


def at(frame: float, label: str = "Foot Strike", context: str = "Left") -> Event:
    return Event(label, context, frame, 0.0)


COORDINATES = st.one_of(
    st.floats(-(2.0**126), 2.0**126), st.sampled_from([0.0, -0.0, np.nan, 1e-50, -1e-46])
)
POINTS = arrays(
    np.float64,
    st.tuples(st.integers(1, 9), st.integers(1, 4), st.just(3)),
    elements=COORDINATES,
)
TEXTS = st.text(st.characters(exclude_categories=["Cs"]), max_size=300)


@settings(suppress_health_check=[HealthCheck.function_scoped_fixture])
@given(st.data())
def test_what_is_written_is_read(tmp_path: Path, data: st.DataObject) -> None:
    points = data.draw(POINTS)
    points[np.isnan(points).any(axis=2)] = np.nan
    markers = points.shape[1]
    rate = data.draw(st.floats(0.5, 5000.0, width=32))
    recording = recorded(
        points,
        labels=tuple(data.draw(st.lists(TEXTS, min_size=markers, max_size=markers))),
        rate=rate,
        unit=data.draw(st.sampled_from(sorted(MM_PER_UNIT))),
        up=data.draw(st.sampled_from(AXES)),
        first_frame=data.draw(st.sampled_from([0, 1, 148, 65_534, 65_535, 65_536, 70_001])),
    )
    moments = st.builds(at, st.floats(-100, 100_000), TEXTS, TEXTS)
    events = tuple(data.draw(st.lists(moments, max_size=4)))
    file = written(recording, tmp_path, events)
    read = file.recording
    np.testing.assert_array_equal(read.present, recording.present)
    expected = points.astype(np.float32)
    zero = (expected == 0).all(axis=2)
    np.testing.assert_array_equal(read.points[~zero], expected[~zero])
    assert (np.abs(read.points[zero]).max(axis=1) == np.float32(1e-6)).all()
    for name in ("rate", "unit", "up", "first_frame"):
        assert getattr(read, name) == getattr(recording, name)
    assert not file.residuals[read.present].any()
    # A float of 32 bits holds seconds below 60 to 2 microseconds.
    ordered = sorted(event.frame for event in events)
    assert [event.frame for event in file.events] == pytest.approx(ordered, abs=4e-6 * rate)
    assert all("label of another point" in text for text in file.warnings)


@pytest.mark.parametrize("up", AXES)
@pytest.mark.parametrize("side", [1, -1])
def test_every_up_axis_on_both_sides_of_the_floor(up: UpAxis, side: int, tmp_path: Path) -> None:
    file = written(recorded(np.abs(walk()) * side, up=up), tmp_path)
    assert file.recording.up == up
    assert file.warnings == ()
    screen = file.layout.parameters
    assert screen.text("POINT:X_SCREEN")[1] != screen.text("POINT:Y_SCREEN")[1]


@pytest.mark.parametrize("unit", sorted(MM_PER_UNIT))
@pytest.mark.parametrize("size", [1e-3, 1.0, 1e3])
def test_every_unit_for_small_and_large_numbers(unit: str, size: float, tmp_path: Path) -> None:
    file = written(recorded(walk() * size, unit=unit), tmp_path)
    assert file.recording.unit == unit
    assert file.warnings == ()


@pytest.mark.parametrize(
    ("frames", "markers", "first"),
    [
        (4, 300, 1), (70_000, 2, 70_001), (65_535, 1, 1), (65_536, 1, 0), (2, 1, 65_535),
        (1, 1, 10**9),
    ],
)  # fmt: skip
def test_many_markers_and_frames(frames: int, markers: int, first: int, tmp_path: Path) -> None:
    recording = walking(frames, markers, first_frame=first) if markers > 1 else recorded(
        walk(frames, markers), first_frame=first
    )  # fmt: skip
    file = written(recording, tmp_path)
    np.testing.assert_array_equal(file.recording.points, recording.points)
    assert file.recording.labels == recording.labels
    assert file.recording.first_frame == first
    assert (file.warnings, file.truncated) == ((), False)
    assert len(file.path.read_bytes()) % 512 == 0


def test_labels_of_every_kind(tmp_path: Path) -> None:
    labels = ("Füße:linke Ferse", "左足", "", "same", "same", "*1", "a" * 255)
    recording = recorded(walk(markers=7), labels=labels)
    assert write_new_c3d(recording, tmp_path / "new.c3d") == ()
    read = read_c3d(tmp_path / "new.c3d").recording.labels
    assert read == (*labels[:2], "point 3", *labels[3:])


def test_labels_that_are_cut_are_said(tmp_path: Path) -> None:
    labels = ("x" + "ß" * 200, "fine", " spaces ", "nul\0byte", "lone \udc80")
    recording = recorded(walk(markers=5), labels=labels)
    (note,) = write_new_c3d(recording, tmp_path / "new.c3d")
    assert "cut (4); the first is 'xß" in note
    read = read_c3d(tmp_path / "new.c3d").recording.labels
    assert read == ("x" + "ß" * 127, "fine", "spaces", "nul byte", "lone ?")


def test_long_labels_of_many_markers(tmp_path: Path) -> None:
    labels = tuple(f"{i:03}{'-long' * 40}" for i in range(300))
    assert written(recorded(walk(2, 300), labels=labels), tmp_path).recording.labels == labels


def test_a_sample_at_the_origin_is_moved_and_said(tmp_path: Path) -> None:
    points = walk()
    points[3:5, 2] = 0
    points[7, 1] = 0, -1e-60, 0
    (note,) = write_new_c3d(recorded(points), tmp_path / "new.c3d")
    assert note.startswith("3 samples at (0, 0, 0)")
    read = read_c3d(tmp_path / "new.c3d").recording
    assert read.present.all()
    assert read.points[3, 2] == pytest.approx([1e-6, 0, 0])
    assert read.points[7, 1] == pytest.approx([0, -1e-6, 0])


def test_events_are_in_order_and_at_their_frames(tmp_path: Path) -> None:
    events = (at(39.5, "Off"), at(0.0, "On", "Right"), at(6000.0, "Late", ""), at(-10.0, "Early"))
    file = written(walking(first_frame=480, rate=59.94), tmp_path, events)
    read = [(event.label, event.context, event.frame) for event in file.events]
    assert [row[:2] for row in read] == [
        ("Early", "Left"), ("On", "Right"), ("Off", "Left"), ("Late", ""),
    ]  # fmt: skip
    assert [row[2] for row in read] == pytest.approx([-10.0, 0.0, 39.5, 6000.0], abs=1e-3)
    assert file.events[1].time == pytest.approx(479 / 59.94)


def test_more_than_255_events(tmp_path: Path) -> None:
    events = tuple(at(float(i), f"E{i}") for i in range(600))
    read = written(walking(), tmp_path, events).events
    assert [event.label for event in read] == [event.label for event in events]
    assert [event.frame for event in read] == pytest.approx(range(600), abs=1e-3)


def test_a_file_without_events_has_no_such_group(tmp_path: Path) -> None:
    parameters = written(walking(), tmp_path).layout.parameters
    assert not [key for key in parameters if key.startswith("EVENT")]


@pytest.mark.parametrize(
    ("recording", "events", "message"),
    [
        (walking(markers=600, labels=("ä" * 127,) * 600), (), "has room for 130560"),
        (walking(), (at(1.0),) * 9000, "has room for 130560"),
        (walking(), (at(1.0),) * 66_000, "at most 65535 markers"),
        (recorded(walk(1, 65_536)), (), "at most 65535 markers"),
        (walking(first_frame=-1), (), "numbers its frames from 0"),
        (walking(first_frame=10**9), (), "numbers its frames from 0"),
        (walking(rate=1e-60), (), "frame rate of 1e-60 Hz"),
        (walking(rate=2e6), (), "frame rate of 2e\\+06 Hz"),
        (recorded(np.zeros((0, 3, 3))), (), "no samples"),
        (recorded(np.zeros((3, 0, 3))), (), "no samples"),
        (recorded(np.full((3, 2, 3), -4e38)), (), "M001 at frame 1: -4e\\+38 mm does not fit"),
        (recorded(np.full((3, 2, 3), np.inf)), (), "M001 at frame 1: inf mm does not fit"),
    ],
)  # fmt: skip
def test_what_does_not_fit(
    recording: Recording, events: tuple[Event, ...], message: str, tmp_path: Path
) -> None:
    with pytest.raises(MocapmendError, match=message) as caught:
        write_new_c3d(recording, tmp_path / "new.c3d", events=events)
    assert caught.value.where == str(tmp_path / "new.c3d")
    assert caught.value.todo
    assert list(tmp_path.iterdir()) == []


def test_the_largest_float_fits(tmp_path: Path) -> None:
    largest = float(np.finfo(np.float32).max)
    points = np.full((3, 1, 3), largest)
    points[1] *= -1
    np.testing.assert_array_equal(written(recorded(points), tmp_path).recording.points, points)


@pytest.mark.parametrize("stop", [0.0, 0.4, 0.7])
def test_cancelling_leaves_what_was_there(stop: float, tmp_path: Path) -> None:
    out = tmp_path / "new.c3d"
    out.write_bytes(b"old")

    def cancel(fraction: float) -> None:
        if fraction > stop:
            raise Cancelled

    with pytest.raises(Cancelled):
        write_new_c3d(walking(3000, 50), out, progress=cancel)
    assert [(path, path.read_bytes()) for path in tmp_path.iterdir()] == [(out, b"old")]


def test_progress_rises_from_block_to_block(tmp_path: Path) -> None:
    seen: list[float] = []
    write_new_c3d(walking(3000, 50), tmp_path / "new.c3d", progress=seen.append)
    assert len(seen) >= 6
    assert seen == sorted(seen)
    assert seen[-1] == 1.0


@pytest.mark.parametrize(
    ("number", "message"),
    [(errno.ENOSPC, "not enough space"), (errno.EACCES, "may not write"), (errno.EIO, "cannot be")],
)
def test_disk_errors(
    number: int, message: str, tmp_path: Path, monkeypatch: pytest.MonkeyPatch
) -> None:
    def fail(_: int) -> None:
        raise OSError(number, os.strerror(number))

    monkeypatch.setattr(os, "fsync", fail)
    with pytest.raises(MocapmendError, match=message):
        write_new_c3d(walking(), tmp_path / "new.c3d")
    assert list(tmp_path.iterdir()) == []


def test_places_where_nothing_can_be_written(tmp_path: Path) -> None:
    with pytest.raises(MocapmendError, match="folder does not exist"):
        write_new_c3d(walking(), tmp_path / "missing" / "new.c3d")
    with pytest.raises(MocapmendError, match="a folder or a device of this name"):
        write_new_c3d(walking(), tmp_path)


@pytest.mark.parametrize(
    ("mark", "replacement", "what"),
    [
        (b"M003", b"M0_3", "the labels"),
        (b"mm", b"cm", "unit and axes"),
        (b"+Z", b"-Z", "unit and axes"),
        (b"Foot Strike", b"Foot_Strike", "the events"),
        (np.float32(100).tobytes(), np.float32(101).tobytes(), "the frame rate"),
        (np.float32(walk()[2, 2, 0]).tobytes(), b"\0\0\0\1", "samples"),
        (np.float32(-1).tobytes() + walk()[15, 2].astype("<f4").tobytes(), bytes(16), "samples"),
    ],
)
def test_a_file_that_reads_back_differently_is_removed(
    mark: bytes, replacement: bytes, what: str, tmp_path: Path, monkeypatch: pytest.MonkeyPatch
) -> None:
    verify = new_module._verify

    def spoil(recording: Recording, parameters: object, path: Path, progress: object) -> None:
        raw = path.read_bytes()
        assert mark in raw
        path.write_bytes(raw.replace(mark, replacement))
        verify(recording, parameters, path, progress)  # type: ignore[arg-type]

    monkeypatch.setattr(new_module, "_verify", spoil)
    with pytest.raises(MocapmendError, match=rf"did not read back .*{what}"):
        write_new_c3d(walking(), tmp_path / "new.c3d", events=(at(3.0),))
    assert list(tmp_path.iterdir()) == []


@pytest.mark.parametrize(("frames", "markers", "first"), [(50, 300, 1), (40, 3, 0), (40, 3, 148)])
def test_the_c3d_library_reads_the_same(
    frames: int, markers: int, first: int, tmp_path: Path
) -> None:
    recording = walking(frames, markers, first_frame=first)
    write_new_c3d(recording, tmp_path / "new.c3d", events=(at(3.0),))
    with (tmp_path / "new.c3d").open("rb") as stream, warnings.catch_warnings():
        warnings.simplefilter("ignore")
        reader = c3d.Reader(stream)
        read = np.array([points for _, points, _ in reader.read_frames()])
    assert (reader.first_frame, reader.point_rate) == (first, 100.0)
    assert [label.strip() for label in reader.point_labels] == list(recording.labels[:255])
    np.testing.assert_array_equal(read[..., 3] >= 0, recording.present)
    present = recording.present
    np.testing.assert_array_equal(read[present][:, :3], recording.points[present])


EZC3D = """
import ezc3d, json, numpy, sys
file = ezc3d.c3d(sys.argv[1])
parameters = file["parameters"]
numpy.save(sys.argv[2], file["data"]["points"])
print(json.dumps([
    parameters["POINT"]["LABELS"]["value"],
    parameters["POINT"]["UNITS"]["value"],
    parameters["EVENT"]["LABELS"]["value"],
    parameters["EVENT"]["TIMES"]["value"].tolist(),
    file["header"]["points"]["frame_rate"],
]))
"""


@pytest.mark.skipif(find_spec("ezc3d") is None, reason="ezc3d is not installed")
def test_ezc3d_reads_the_same(tmp_path: Path) -> None:
    recording = walking(unit="cm", labels=("A b", "Füße", "C", "D", "E"))
    path = tmp_path / "new.c3d"
    write_new_c3d(recording, path, events=(at(3.0), at(6002.0, "Foot Off")))
    # In a process of its own: it may crash.
    done = subprocess.run(
        [sys.executable, "-c", EZC3D, str(path), str(tmp_path / "points.npy")],
        capture_output=True, text=True, check=True, encoding="utf-8",
        env={**os.environ, "PYTHONIOENCODING": "utf-8"},
    )  # fmt: skip
    labels, units, events, times, rate = json.loads(done.stdout)
    assert (labels, units, rate) == (list(recording.labels), ["cm"], 100.0)
    assert events == ["Foot Strike", "Foot Off"]
    assert times[0] == [0.0, 1.0]
    assert times[1] == pytest.approx([0.03, 0.02])
    read = np.load(tmp_path / "points.npy").transpose(2, 1, 0)[..., :3]
    np.testing.assert_array_equal(read, recording.points)
