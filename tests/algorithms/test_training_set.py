"""Training sets: what is gathered, and what a file gives back."""

import io
import json
import os
import struct
import tracemalloc
import zipfile
from dataclasses import replace
from typing import get_args

import numpy as np
import pytest
from hypothesis import given
from hypothesis import strategies as st
from synthetic import bending_body, record

from mocapmend_algorithms.recording import Recording, UpAxis
from mocapmend_algorithms.sparse.training_set import (
    TrainingSet,
    TrainingSetError,
    encode_training_set,
    gather,
    read_training_set,
    up_vector,
    write_training_set,
)


def body(frames=30, markers=5, labels=None, unit="mm", up="+z"):
    points = bending_body(frames, markers)
    labels = labels or tuple(f"M{marker}" for marker in range(markers))
    scale = {"mm": 1.0, "m": 0.001}[unit]
    return Recording(points * scale, labels, 100.0, unit, up)


def test_recordings_are_gathered_by_label_in_mm_and_without_incomplete_frames():
    one = body(unit="m")
    points = one.points.copy()
    points[10:12, 2] = np.nan
    other = body(labels=("Ann:M4", "Ann:M3", "Ann:M2", "Ann:M1", "Ann:new"))
    training = gather([one.with_points(points), other], "two walks")
    assert training.labels == ("M1", "M2", "M3", "M4")
    assert training.lengths == (10, 18, 30)
    assert training.about == "two walks"
    first, _, last = training.motions("+z")
    np.testing.assert_allclose(first, one.points[:10, 1:5] * 1000, rtol=1e-12)
    np.testing.assert_array_equal(last, other.points[:, [3, 2, 1, 0]])


def test_markers_can_be_chosen_and_fragments_only_by_name():
    recordings = [body(labels=("A", "*2", "B", "C", "D")), body(labels=("D", "C", "*2", "A", "E"))]
    assert gather(recordings).labels == ("A", "C", "D")
    assert gather(recordings, markers=("D", "*2")).labels == ("*2", "D")
    with pytest.raises(TrainingSetError, match="not every recording has one marker 'B'"):
        gather(recordings, markers=("A", "B"))


def test_a_file_gives_the_set_back(tmp_path):
    atoms = {"trunk": np.arange(12.0).reshape(4, 3)}
    made = gather([body()])
    made = TrainingSet(
        made.labels, 120.0, made.poses, made.lengths, "+y", "a walk", atoms, {"atoms": 3}
    )
    write_training_set(made, tmp_path / "set.npz")
    read = read_training_set(tmp_path / "set.npz")
    np.testing.assert_allclose(read.poses, made.poses, rtol=1e-6)
    np.testing.assert_array_equal(read.atoms["trunk"], atoms["trunk"])
    for name in ("labels", "rate", "lengths", "up", "about", "settings"):
        assert getattr(read, name) == getattr(made, name)


@pytest.mark.parametrize("start", get_args(UpAxis))
@pytest.mark.parametrize("stop", get_args(UpAxis))
def test_motion_is_turned_so_that_up_is_up(start, stop):
    training = gather([body(up=start)])
    (motion,) = training.motions(stop)
    here, there = training.poses @ up_vector(start), motion @ up_vector(stop)
    np.testing.assert_allclose(there, here, atol=1e-9)
    volume = np.linalg.det(motion[0, 1:4] - motion[0, 0])
    assert volume == pytest.approx(np.linalg.det(training.poses[0, 1:4] - training.poses[0, 0]))


def test_markers_are_found_whatever_their_case_and_prefix():
    training = gather([body()])
    labels = ["Bo:m4", "Bo:M0", "other", "Bo:m1", "Bo:M2", "Bo:M3"]
    assert training.places_of(labels).tolist() == [1, 3, 4, 5, 0]


@pytest.mark.parametrize("up", ["+x", "+y", "-y", "-z"])
def test_recordings_that_lie_are_set_upright(up):
    upright = body()
    (lying,) = gather([upright]).motions(up)
    turned = replace(upright.with_points(lying), up=up)
    together = gather([upright, turned])
    first, second = together.motions("+z")
    np.testing.assert_allclose(first, second, atol=1e-9)
    assert together.up == upright.up


def test_another_marker_set_is_refused_with_the_markers_that_are_lacking():
    training = gather([body()])
    with pytest.raises(TrainingSetError, match=r"2 of its 5 are not in this recording \(M1, M3\)"):
        training.places_of(["M0", "M2", "M4"])
    with pytest.raises(TrainingSetError, match="more than one marker M0"):
        training.places_of(["M0", "a:M0", "M1", "M2", "M3", "M4"])


@pytest.mark.parametrize(
    ("recordings", "message"),
    [
        ([], "no recording to learn from"),
        ([body(), record(bending_body(20, 5), rate=50.0)], "different frame rates: 100 and 50 Hz"),
        ([body(), body(labels=tuple("abcde"))], "no marker in common"),
        ([record(np.full((4, 2, 3), np.nan))], "no frame of the recordings shows all"),
    ],
)
def test_what_cannot_be_learned_from_is_refused(recordings, message):
    with pytest.raises(TrainingSetError, match=message):
        gather(recordings)


def test_files_that_are_no_training_set_are_refused(tmp_path):
    path = tmp_path / "set.npz"
    with pytest.raises(TrainingSetError, match="no such training set"):
        read_training_set(path)
    write_training_set(gather([body()]), path)
    whole = path.read_bytes()
    for damaged in (b"", b"text", whole[: len(whole) // 2], whole[:-40]):
        path.write_bytes(damaged)
        with pytest.raises(TrainingSetError, match="not a training set"):
            read_training_set(path)
    np.savez(path, other=np.zeros(3))
    with pytest.raises(TrainingSetError, match="not a training set"):
        read_training_set(path)


@pytest.mark.parametrize(
    ("change", "message"),
    [
        ({"format": 9}, "format 9, not 1"),
        ({"format": "9" * 1000}, "format 9{20}, not 1"),
        ({"lengths": [29]}, "contradicts itself"),
        ({"up": "north"}, "says that north points up"),
        ({"rate": 0}, "no numbers"),
        ({"rate": 1e999}, "no numbers"),
        ({"lengths": [1e999]}, "not a training set"),
        ({"settings": 3}, "not a training set"),
        ({"about": "x" * 300_000}, "head of the training set is too long"),
        ({"labels": 5}, "not a training set"),
    ],
)
def test_heads_that_contradict_the_arrays_are_refused(tmp_path, change, message):
    path = tmp_path / "set.npz"
    write_training_set(gather([body()]), path)
    with np.load(path) as archive:
        head, poses = json.loads(str(archive["head"])), archive["poses"]
    np.savez(path, head=np.array(json.dumps(head | change)), poses=poses)
    with pytest.raises(TrainingSetError, match=message):
        read_training_set(path)


# --- rates -----------------------------------------------------------------------------------


def swinging(rate, frames):
    times = np.arange(frames) / rate
    phase = 2 * np.pi * 1.5 * times[:, None] + np.arange(4)
    return record(100 * np.stack([np.sin(phase), np.cos(phase), phase], axis=2), rate=rate)


@pytest.mark.parametrize("own", [50.0, 119.88, 120.0, 240.0])
def test_recordings_of_other_rates_are_sampled_anew(own):
    training = gather([swinging(own, 200)], rate=100.0)
    expected = swinging(100.0, int(199 / own * 100 + 1e-6) + 1)
    assert training.rate == 100
    assert training.lengths == (expected.frames,)
    np.testing.assert_allclose(training.poses, expected.points, atol=0.1)


def test_a_divisor_of_the_rate_takes_frames_as_they_are():
    recording = swinging(120.0, 81)
    training = gather([recording, swinging(40.0, 1)], rate=40.0)
    assert training.lengths == (27, 1)
    np.testing.assert_allclose(training.poses[:27], recording.points[::3], atol=1e-9)


def test_gaps_are_not_sampled_over():
    recording = swinging(120.0, 90)
    points = recording.points.copy()
    points[40:50] = np.nan
    training = gather([recording.with_points(points)], rate=60.0)
    assert training.lengths == (20, 20)
    np.testing.assert_allclose(training.poses[20:], recording.points[50::2], atol=1e-9)


# --- files -----------------------------------------------------------------------------------


def test_the_same_set_gives_the_same_bytes():
    made = replace(gather([body()]), atoms={"trunk": np.arange(12.0).reshape(4, 3)})
    data = encode_training_set(made)
    assert encode_training_set(replace(made)) == data
    with zipfile.ZipFile(io.BytesIO(data)) as archive:
        assert {info.date_time[0] for info in archive.infolist()} == {1980}
        assert {info.create_system for info in archive.infolist()} == {3}


def refuse(path, message):
    """Read a file that must be refused without much memory."""
    tracemalloc.start()
    try:
        with pytest.raises(TrainingSetError, match=message):
            read_training_set(path)
        assert tracemalloc.get_traced_memory()[1] < 20_000_000
    finally:
        tracemalloc.stop()


def archive(path, **members):
    """Write arrays, or bytes as they are, and a good head."""
    head = np.array(
        json.dumps(
            {
                "format": 1,
                "labels": ["A"],
                "rate": 100,
                "lengths": [1],
                "up": "+z",
                "about": "",
                "settings": {},
            }
        )
    )
    with zipfile.ZipFile(path, "w", zipfile.ZIP_DEFLATED) as made:
        for name, content in ({"head": head} | members).items():
            if not isinstance(content, bytes):
                stream = io.BytesIO()
                np.save(stream, content)
                content = stream.getvalue()
            made.writestr(f"{name}.npy", content)
    return path


def npy(shape, data=b""):
    text = f"{{'descr': '<f4', 'fortran_order': False, 'shape': {shape}, }}".encode()
    return b"\x93NUMPY\1\0" + struct.pack("<H", len(text)) + text + data


POSE = np.zeros((1, 1, 3), np.float32)


def test_the_hand_made_archive_is_good(tmp_path):
    assert read_training_set(archive(tmp_path / "set.npz", poses=POSE)).labels == ("A",)


@pytest.mark.parametrize(
    ("members", "message"),
    [
        ({"poses": npy((10**9, 1, 3))}, "not a training set"),
        ({"poses": npy((10**12, 10**12, 3))}, "not a training set"),
        ({"poses": npy((200_000_000 // 12, 1, 3), bytes(200_000_000 // 12 * 12))}, "believable"),
        ({"poses": POSE, "other": bytes(200_000_000)}, "believable"),
        ({"poses": POSE, **{f"atoms {i}": bytes(5_000_000) for i in range(20)}}, "believable"),
        ({"poses": POSE.astype(np.float64)}, "float64"),
        ({"poses": np.array(["a"])}, "<U1"),
        ({"poses": np.array([{}])}, "not a training set"),
        ({"poses": POSE, "atoms a": np.zeros(3, np.float32)}, "no table"),
        ({"poses": POSE, "atoms a": np.full((2, 2), np.nan, np.float32)}, "no numbers"),
        ({"poses": POSE, "head": np.array("[" * 100_000)}, "not a training set"),
        ({"poses": POSE, "head": np.array(["{}", "{}"])}, "not a training set"),
        ({"head": np.array("{}")}, "not a training set"),
    ],
)
def test_hostile_files_are_refused_before_they_take_memory(tmp_path, members, message):
    refuse(archive(tmp_path / "set.npz", **members), message)


def test_a_stream_that_grows_beyond_its_declared_size_is_cut(tmp_path):
    path = archive(tmp_path / "set.npz", poses=npy((1, 1, 3), bytes(200_000_000)))
    raw = bytearray(path.read_bytes())
    struct.pack_into("<I", raw, raw.rindex(b"PK\1\2") + 24, len(npy((1, 1, 3))) + 12)
    path.write_bytes(raw)
    refuse(path, "not a training set")


def test_folders_and_pipes_are_refused_and_nobody_waits(tmp_path):
    with pytest.raises(TrainingSetError, match="not a file"):
        read_training_set(tmp_path)
    if hasattr(os, "mkfifo"):
        os.mkfifo(tmp_path / "pipe")
        with pytest.raises(TrainingSetError, match="not a file"):
            read_training_set(tmp_path / "pipe")


@given(st.data())
def test_damaged_files_are_read_or_refused(tmp_path_factory, data):
    path = tmp_path_factory.getbasetemp() / "damaged.npz"
    raw = bytearray(encode_training_set(gather([body(frames=3)])))
    for _ in range(data.draw(st.integers(1, 4))):
        raw[data.draw(st.integers(0, len(raw) - 1))] = data.draw(st.integers(0, 255))
    path.write_bytes(raw[: data.draw(st.integers(len(raw) // 2, len(raw)))])
    try:
        read_training_set(path)
    except TrainingSetError as error:
        assert len(str(error)) < 200
