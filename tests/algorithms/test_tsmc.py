"""Completion of trajectory segments: what moves with the body, who helps, degenerate input."""

import numpy as np
import pytest
from synthetic import bending_body, body_motion, fill_with, punch, record, smooth_motion

from mocapmend.engine import load
from mocapmend_algorithms import Gap, no_progress

PLAIN = {"weight_scale_mm": "10000", "missing_weight": "1"}


def rmse(result, points):
    errors = [p.values - points[p.gap.start : p.gap.stop, p.gap.marker] for p in result.patches]
    return float(np.sqrt(np.mean(np.sum(np.concatenate(errors) ** 2, axis=1))))


@pytest.mark.parametrize("params", [{}, PLAIN, {"meet_edges": "false"}], ids=str)
def test_a_common_motion_of_all_markers_changes_nothing(params):
    points, path = bending_body(200, 9), 50 * smooth_motion(200, 1, seed=9)
    gaps = [Gap(2, 60, 90), Gap(5, 0, 20)]
    here = fill_with(("tsmc", params), record(punch(points, gaps)), gaps)
    there = fill_with(("tsmc", params), record(punch(points + path, gaps)), gaps)
    for a, b in zip(here.patches, there.patches, strict=True):
        np.testing.assert_allclose(
            b.values, a.values + path[a.gap.start : a.gap.stop, 0], atol=1e-4
        )


def test_turning_the_axes_turns_the_values():
    points = bending_body(200, 9)
    turn = np.linalg.qr(np.random.default_rng(0).normal(size=(3, 3)))[0]
    gaps = [Gap(2, 60, 90), Gap(5, 0, 20)]
    here = fill_with(("tsmc", {}), record(punch(points, gaps)), gaps)
    there = fill_with(("tsmc", {}), record(punch(points @ turn, gaps)), gaps)
    for a, b in zip(here.patches, there.patches, strict=True):
        np.testing.assert_allclose(b.values, a.values @ turn, atol=1e-3)
        np.testing.assert_allclose(b.r90, a.r90, atol=1e-3)


def test_still_markers_are_found_where_they_were():
    points = np.tile(np.random.default_rng(0).uniform(-500, 500, (8, 3)), (120, 1, 1))
    gaps = [Gap(1, 30, 60), Gap(2, 30, 60), Gap(3, 100, 120)]
    result = fill_with(("tsmc", {}), record(punch(points, gaps)), gaps)
    assert len(result.patches) == 3
    assert rmse(result, points) < 1e-6


def test_frames_in_which_all_is_missing_stay_open_and_hurt_nothing_else():
    points = bending_body(200, 9)
    whole = [Gap(marker, 150, 160) for marker in range(9)]
    gaps = [Gap(2, 60, 90), *whole]
    result = fill_with(("tsmc", {}), record(punch(points, gaps)), gaps)
    assert [p.gap for p in result.patches] == gaps[:1]
    assert {u.reason for u in result.unfilled} == {
        "of the other markers, 0 are seen throughout the gap: this method needs 3"
    }
    assert rmse(result, points) < 20


def test_markers_that_are_missing_together_are_filled_by_one_matrix():
    points = bending_body(300, 12)
    gaps = [Gap(1, 100, 140), Gap(2, 100, 140), Gap(3, 120, 160)]
    notes = fill_with(("tsmc", PLAIN), record(punch(points, gaps)), gaps).notes
    assert notes[gaps[0]]["helpers"] == notes[gaps[1]]["helpers"] == 9
    assert notes[gaps[2]]["helpers"] == 9
    assert notes[gaps[0]]["complete_frames"] == 300 - 42


def test_only_what_is_around_the_gap_counts():
    points = bending_body(1000, 9)
    gaps = [Gap(2, 500, 520)]
    variant = ("tsmc", {"around_s": "1", "weight_scale_mm": "10000"})
    here = fill_with(variant, record(punch(points, gaps)), gaps)
    points[:300] += smooth_motion(300, 9, seed=5)
    there = fill_with(variant, record(punch(points, gaps)), gaps)
    assert here.notes[gaps[0]]["complete_frames"] == 200
    np.testing.assert_allclose(there.patches[0].values, here.patches[0].values, atol=1.0)


def test_far_markers_are_left_out_but_not_the_last_three():
    points = body_motion(300, 12)
    points[:, 6:] += [5000.0, 0.0, 0.0]
    gaps = [Gap(0, 100, 130)]
    recording = record(punch(points, gaps))
    assert fill_with(("tsmc", {}), recording, gaps).notes[gaps[0]]["helpers"] == 5
    lonely = fill_with(("tsmc", {"weight_scale_mm": "10"}), recording, gaps)
    assert lonely.notes[gaps[0]]["helpers"] == 3


def test_fills_a_real_walk_better_than_a_spline_and_says_how_well(samples):
    source, _ = load(samples / "walk_cmu_02_01.c3d", no_progress)
    recording, inside, ratios = source.recording, [], []
    for marker in (5, 12, 17, 24):
        gaps = [Gap(marker, 120, 200)]
        punched = recording.with_points(punch(recording.points, gaps))
        filled = fill_with(("tsmc", {}), punched, gaps)
        spline = fill_with(("cubic", {}), punched, gaps)
        ratios.append(rmse(filled, recording.points) / rmse(spline, recording.points))
        (patch,) = filled.patches
        errors = np.linalg.norm(patch.values - recording.points[120:200, marker], axis=1)
        inside.append(errors <= patch.r90)
    assert max(ratios) < 0.5
    assert np.mean(inside) > 0.7
