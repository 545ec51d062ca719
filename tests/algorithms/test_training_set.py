"""Training sets: what is gathered, and what a file gives back."""

from typing import get_args

import numpy as np
import pytest
from synthetic import bending_body, record

from mocapmend_algorithms.recording import Recording, UpAxis
from mocapmend_algorithms.sparse.training_set import (
    TrainingSet,
    TrainingSetError,
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
        ([body(), body(up="+y")], "different up axes"),
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
        ({"lengths": [29]}, "contradicts itself"),
        ({"up": "north"}, "says that north points up"),
        ({"rate": 0}, "no numbers"),
        ({"labels": 5}, "not a training set"),
    ],
)
def test_heads_that_contradict_the_arrays_are_refused(tmp_path, change, message):
    import json

    path = tmp_path / "set.npz"
    write_training_set(gather([body()]), path)
    with np.load(path) as archive:
        head, poses = json.loads(str(archive["head"])), archive["poses"]
    np.savez(path, head=np.array(json.dumps(head | change)), poses=poses)
    with pytest.raises(TrainingSetError, match=message):
        read_training_set(path)
