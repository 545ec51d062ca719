"""Fragments, ragged ends, frozen samples, broken bones, far points, coinciding points."""

from dataclasses import replace

import numpy as np
import pytest
from bodies import body, changed, found_by, spans

from mocapmend_algorithms.names import is_unlabelled

NAN = np.nan


# --- fragments -----------------------------------------------------------------------------------


def with_piece(marker, start, stop, label):
    clean = body()
    points = clean.points.copy()
    piece = np.full((clean.frames, 1, 3), NAN)
    piece[start:stop, 0] = points[start:stop, marker]
    points[start - 5 : stop + 5, marker] = NAN
    labels = (*clean.labels, label)
    return replace(clean, points=np.concatenate((points, piece), axis=1), labels=labels)


@pytest.mark.parametrize("label", ["*15", "", "Unlabeled 7", "U_12", "ARM3"])
def test_a_piece_finds_its_marker(label):
    (run,) = found_by("fragments", with_piece(8, 200, 260, label))
    assert spans([run]) == [(15, 200, 260)]
    assert run.other == 8
    assert "ARM3" in run.reason
    assert run.score > 0.7


def test_a_point_that_fits_nowhere_is_a_ghost():
    def ghost(points):
        points[200:260, 15] = (9000.0, 0.0, 0.0)

    recording = changed(with_piece(8, 200, 260, "*0"), ghost)
    (run,) = found_by("fragments", recording)
    assert run.other is None
    assert np.isnan(run.deviation)
    assert not found_by("fragments", recording, ghosts=False)


def test_two_markers_of_one_name_that_are_both_seen_are_no_pieces():
    clean = body()
    assert not found_by("fragments", replace(clean, labels=("ARM1", *clean.labels[1:])))


@pytest.mark.parametrize("label", ["LASI", "NEW1X", "UPPER", "C7", "Bob:LANK"])
def test_labels_of_markers_are_labels(label):
    assert not is_unlabelled(label)


# --- ragged ends ---------------------------------------------------------------------------------


@pytest.mark.parametrize("unit", ["mm", "m"])
@pytest.mark.parametrize("after", [False, True])
def test_an_end_that_bends_away_is_found(unit, after):
    clean = body(unit=unit)
    bend = np.outer([10.0, 20.0, 30.0, 40.0], [0.6, 0.0, 0.8])

    def corrupt(points):
        points[300:340, 7] = NAN
        if after:
            points[340:344, 7] += bend[::-1]
        else:
            points[296:300, 7] += bend

    (run,) = found_by("tails", changed(clean, corrupt))
    assert spans([run]) == [(7, 340, 344) if after else (7, 296, 300)]
    assert run.deviation * clean.mm == pytest.approx(25.0, rel=0.1)
    assert ("after" if after else "before") in run.reason


def test_many_ends_are_told_apart():
    bend = np.outer([10.0, 20.0, 30.0, 40.0], [0.6, 0.0, 0.8])

    def corrupt(points):
        for marker in range(15):
            # Pieces of many lengths: those after the gap are 40 frames long, and more.
            start = 640 - 37 * marker
            points[start : start + 40 - marker, marker] = NAN
            points[start - 4 : start, marker] += bend

    runs = found_by("tails", changed(body(), corrupt))
    assert spans(runs) == [(m, 636 - 37 * m, 640 - 37 * m) for m in range(15)]


@pytest.mark.parametrize("speed", [1.0, 3.0])
def test_ends_that_go_on_are_not_ragged(speed):
    def gaps(points):
        for marker in range(15):
            points[30 * marker + 60 : 30 * marker + 80, marker] = NAN

    assert not found_by("tails", changed(body(speed=speed), gaps))


# --- frozen --------------------------------------------------------------------------------------


def freeze(marker, start, stop):
    def corrupt(points):
        points[start:stop, marker] = points[start - 1, marker]

    return corrupt


@pytest.mark.parametrize("length", [3, 10, 40])
def test_repeats_are_found_with_the_way_that_is_missing(length):
    clean = body()
    (run,) = found_by("frozen", changed(clean, freeze(6, 200, 200 + length)))
    assert spans([run]) == [(6, 200, 200 + length)]
    way = np.linalg.norm(clean.points[200 + length, 6] - clean.points[199, 6])
    assert run.deviation == pytest.approx(way / 2)


def test_a_marker_that_never_goes_on_is_told_by_its_neighbours():
    clean = body()
    (run,) = found_by("frozen", changed(clean, freeze(6, 400, clean.frames)))
    assert spans([run]) == [(6, 400, clean.frames)]


def test_a_marker_that_jumps_and_stands_still_is_wrong_from_the_jump_on():
    def corrupt(points):
        points[400:, 6] = (*points[400, 6, :2], 0.0)

    clean = body()
    (run,) = found_by("frozen", changed(clean, corrupt))
    assert spans([run]) == [(6, 400, clean.frames)]
    assert run.deviation == pytest.approx(clean.points[400, 6, 2], rel=0.05)


def test_files_with_many_repeats_are_not_full_of_frozen_markers():
    still = body(noise=0.0)
    still = still.with_points(np.repeat(still.points[:1], 300, axis=0))
    held = body(noise=0.0).points[::4].repeat(4, axis=0)
    assert not found_by("frozen", still)
    assert not found_by("frozen", still.with_points(held))


def test_a_foot_that_stands_while_the_body_moves_is_not_frozen():
    def stand(points):
        stance = points[200, 14].copy()
        reach = (np.arange(30)[:, None] + 1) / 31
        points[170:200, 14] = points[169, 14] + reach * (stance - points[169, 14])
        points[200:260, 14] = stance
        points[260:290, 14] = stance + reach * (points[290, 14] - stance)

    assert not found_by("frozen", changed(body(noise=0.0), stand))


# --- broken bones --------------------------------------------------------------------------------


@pytest.mark.parametrize(("start", "stop"), [(200, 203), (200, 260)])
def test_a_marker_that_is_elsewhere_for_a_while_breaks_its_bones(start, stop):
    def corrupt(points):
        points[start:stop, 8] += (0.0, 60.0, 60.0)

    (run,) = found_by("bone-breaks", changed(body(), corrupt))
    assert spans([run]) == [(8, start, stop)]
    assert run.deviation == pytest.approx(85.0, rel=0.2)


def test_the_break_may_be_between_gaps():
    def corrupt(points):
        points[200:230, 8] += (0.0, 60.0, 60.0)
        points[190:200, 8] = points[230:240, 8] = NAN
        points[150:180, 3] += (0.0, 90.0, 0.0)

    runs = found_by("bone-breaks", changed(body(), corrupt))
    assert (3, 150, 180) in spans(runs)


def test_whole_bodies_keep_their_bones():
    assert not found_by("bone-breaks", body(noise=1.0))


# --- far -----------------------------------------------------------------------------------------


def test_points_far_from_the_body_are_found():
    def corrupt(points):
        points[100:110, 2] -= (0.0, 3000.0, 0.0)
        points[:, 9] += (8000.0, 0.0, 0.0)

    recording = changed(body(), corrupt)
    (run,) = found_by("far", recording)
    # The second one is always there: a thing on the floor of the laboratory.
    assert spans([run]) == [(2, 100, 110)]
    assert run.deviation == pytest.approx(3000.0, rel=0.1)
    assert not found_by("far", recording, least_mm=4000.0)


# --- reflections ---------------------------------------------------------------------------------


def test_of_two_points_in_one_place_the_one_that_is_not_at_home_is_wrong():
    rng = np.random.default_rng(3)

    def corrupt(points):
        points[100:130, 9] = points[100:130, 6] + rng.uniform(-1.0, 1.0, (30, 3))

    (run,) = found_by("reflections", changed(body(), corrupt))
    assert spans([run]) == [(9, 100, 130)]
    assert run.other == 6
    usual = np.median(np.linalg.norm(body().points[:, 9] - body().points[:, 6], axis=1))
    assert run.deviation == pytest.approx(usual, rel=0.05)


def test_two_names_of_one_point_are_left_alone():
    clean = body()
    double = np.concatenate((clean.points, clean.points[:, :1] + 0.5), axis=1)
    recording = replace(clean, points=double, labels=(*clean.labels, "TWIN"))
    assert not found_by("reflections", recording)


def test_points_that_are_hardly_ever_seen_together_are_left_alone():
    def corrupt(points):
        points[:3000, 9] = points[3100:, 9] = NAN
        points[3000:3020, 9] = points[3000:3020, 6] + 1.0

    assert not found_by("reflections", changed(body(60.0), corrupt))
