"""Labels of an invented body and of a bundled walk, whose truth is known."""

from dataclasses import replace

import numpy as np
import pytest
from body_samples import LABELS, body, share_right, unlabelled

from mocapmend.files import read_c3d
from mocapmend_algorithms import Cancelled, Recording, no_progress
from mocapmend_algorithms.labelling import (
    LabelModel,
    LabelParams,
    changes,
    label,
    labelled_recording,
)
from mocapmend_algorithms.names import without_subject

SURE = 0.8


@pytest.fixture(scope="module")
def model():
    return LabelModel.learn([body()])


def labelled(recording, model, **params):
    return label(recording, model, LabelParams(**params), no_progress)


def by_point(labelling):
    return {
        p.piece.point: None if p.label is None else labelling.labels[p.label]
        for p in labelling.proposals
    }


@pytest.mark.parametrize("up", ["+z", "-z", "+y", "-x"])
def test_a_turned_moved_smaller_body_in_another_pose_and_in_pieces(model, up):
    trial = body(phase=1.0, pace=1.3, scale=0.8, seed=1)
    recording, truth = unlabelled(trial, turn=2.0, shift=(500, -3000, 40), pieces=3, ghosts=4)
    points = recording.points
    axes = {"+z": points, "-z": points * (1, -1, -1), "+y": points[..., [1, 2, 0]],
            "-x": points[..., [2, 1, 0]] * (-1, 1, 1)}  # fmt: skip
    turned = replace(recording, points=axes[up] / 1000.0, up=up, unit="m")
    found = labelled(turned, model)
    assert share_right(found, truth) == 1.0
    assert found.scale == pytest.approx(0.8, abs=0.02)
    ghosts = [p for p in found.proposals if truth[p.piece.point] is None]
    assert all(p.label is None or p.confidence < SURE for p in ghosts)


def test_half_labelled_points_keep_their_names_and_those_in_doubt_do_not(model):
    recording, truth = unlabelled(body(phase=0.5, seed=2))
    names = [truth[k] if k % 2 else "" for k in range(recording.markers)]
    first, second = [k for k in range(recording.markers) if names[k]][:2]
    names[first], names[second] = names[second], names[first]
    stray = next(k for k, name in enumerate(names) if not name)
    wrong = replace(recording, labels=tuple(names))
    kept = by_point(labelled(wrong, model))
    assert (kept[first], kept[second]) == (truth[second], truth[first])
    doubted = labelled(wrong, model, doubted=(names[first], names[second]))
    assert by_point(doubted) == dict(enumerate(truth))
    assert {p.piece.point for p in doubted.proposals if p.kept} == {
        k for k, name in enumerate(names) if name and k not in {first, second}
    }
    anew = labelled(wrong, model, keep_names=False)
    assert by_point(anew) == dict(enumerate(truth))
    names[stray] = "Racket"
    racket = labelled(replace(wrong, labels=tuple(names)), model)
    assert [(p.label, p.kept) for p in racket.proposals if p.piece.point == stray] == [(None, True)]


def test_points_that_swap_are_cut_and_put_right(model):
    trial = body(phase=0.5, seed=3)
    points = trial.points.copy()
    a, b = LABELS.index("LANK"), LABELS.index("RWRA")
    points[100:, [a, b]] = points[100:, [b, a]]
    recording, _ = unlabelled(trial.with_points(points))
    found = labelled(recording, model)
    result = labelled_recording(recording, changes(found, recording))
    assert sorted(result.labels) == sorted(LABELS)
    for name, point in zip(LABELS, trial.points.swapaxes(0, 1), strict=True):
        assert np.array_equal(result.points[:, result.labels.index(name)], point)


def test_missing_markers_leave_their_labels_free(model):
    trial = body(seed=4)
    absent = {"LANK", "C7", "RWRA", "LHEAD"}
    some = [k for k, name in enumerate(LABELS) if name not in absent]
    part = replace(trial, points=trial.points[:, some], labels=tuple(LABELS[k] for k in some))
    recording, truth = unlabelled(part)
    assert by_point(labelled(recording, model)) == dict(enumerate(truth))


def test_one_frame_few_points_and_none(model):
    recording, truth = unlabelled(body(1, phase=0.4))
    assert by_point(labelled(recording, model)) == dict(enumerate(truth))
    few = labelled(replace(recording, points=recording.points[:, :3], labels=("", "", "")), model)
    assert [(p.label, p.confidence <= SURE) for p in few.proposals] == [(None, True)] * 3
    for shape in ((50, 0, 3), (0, 4, 3)):
        nothing = labelled(Recording(np.zeros(shape), ("",) * shape[1], 100.0), model)
        assert nothing.proposals == ()
        assert np.isnan(nothing.scale)
    hidden = Recording(np.full((5, 2, 3), np.nan), ("", ""), 100.0)
    assert labelled(hidden, model).proposals == ()


def test_markers_that_are_all_in_one_place_can_be_learned_and_labelled():
    heap = Recording(np.zeros((9, 6, 3)), tuple("ABCDEF"), 100.0)
    found = labelled(replace(heap, labels=("",) * 6), LabelModel.learn([heap]))
    assert all(p.label is None or p.confidence < SURE for p in found.proposals)


def test_a_body_with_two_like_sides_is_not_said_to_be_sure():
    # A cross of sticks: turned by 180 degrees it is the same.
    t = np.linspace(0.0, 3.0, 120)[:, None]
    half = np.array([[100.0, 0, 0], [200, 60, 0], [300, -60, 40], [150, 0, 120]])
    places = np.concatenate([half, half * (-1, -1, 1), [[0, 0, 300], [0, 0, 0]]])
    sway = 15.0 * np.sin(t[:, :, None] + np.arange(10)[None, :, None] % 4)
    points = places[None] + sway * (0, 0, 1)
    names = ("LA", "LB", "LC", "LD", "RA", "RB", "RC", "RD", "TOP", "MID")
    trial = Recording(points, names, 100.0)
    recording, truth = unlabelled(trial, turn=0.6)
    found = labelled(recording, LabelModel.learn([trial]))
    sides = [p for p in found.proposals if truth[p.piece.point][0] in "LR" and p.label is not None]
    assert len(sides) >= 6
    assert all(p.confidence < SURE for p in sides)
    assert any("left and right can hardly be told apart" in p.reason for p in sides)
    top = next(p for p in found.proposals if truth[p.piece.point] == "TOP")
    assert found.labels[top.label] == "TOP"


def test_no_label_is_given_twice_at_a_frame_and_every_sample_is_in_a_piece(model):
    recording, _ = unlabelled(body(phase=2.0, seed=5), pieces=4, ghosts=8)
    found = labelled(recording, model)
    covered = np.zeros(recording.present.shape, int)
    for p in found.proposals:
        covered[p.piece.start : p.piece.stop, p.piece.point] += 1
    assert np.array_equal(covered == 1, recording.present)
    assert covered.max() == 1
    given = found.by_sample(recording.present.shape)
    for row in given:
        assert len(set(row[row >= 0])) == (row >= 0).sum()
    assert all(0.0 <= p.confidence <= 1.0 and p.reason.endswith(".") for p in found.proposals)


def test_a_bundled_walk_labels_its_other_half(samples):
    walk = read_c3d(samples / "walk_cmu_02_01.c3d").recording
    half = walk.frames // 2
    model = LabelModel.learn([walk.with_points(walk.points[:half].copy())])
    rest = walk.with_points(walk.points[half:].copy())
    recording, truth = unlabelled(rest, turn=-1.0, pieces=2, ghosts=3)
    bare = [name and without_subject(name) for name in truth]
    assert share_right(labelled(recording, model), bare) >= 0.99


def test_it_can_be_cancelled_and_tells_how_far_it_is(model):
    recording, _ = unlabelled(body(60))
    seen = []
    label(recording, model, LabelParams(), seen.append)
    assert seen == sorted(seen)
    assert seen[-1] == 1.0
    assert len(seen) > 100

    def stop(fraction):
        if fraction > 0.2:
            raise Cancelled

    with pytest.raises(Cancelled):
        label(recording, model, LabelParams(), stop)
