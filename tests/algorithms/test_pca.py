"""Fills by principal components: what moves with the body, and who helps in R1 and R2."""

import numpy as np
import pytest
from synthetic import bending_body, fill_with, punch, record, smooth_motion

from mocapmend_algorithms import Gap


@pytest.mark.parametrize("method", ["pca-r1", "pca-r2"])
def test_a_common_motion_of_all_markers_changes_nothing(method):
    points, path = bending_body(200, 9), 50 * smooth_motion(200, 1, seed=9)
    gaps = [Gap(2, 60, 90), Gap(5, 0, 20)]
    variant = (method, {"meet_edges": "false"})
    here = fill_with(variant, record(punch(points, gaps)), gaps)
    there = fill_with(variant, record(punch(points + path, gaps)), gaps)
    for a, b in zip(here.patches, there.patches, strict=True):
        moved = a.values + path[a.gap.start : a.gap.stop, 0]
        np.testing.assert_allclose(b.values, moved, atol=1e-4)
        np.testing.assert_allclose(b.r90, a.r90, atol=1e-4)


def test_r1_needs_markers_without_gaps_and_r2_does_not():
    points = bending_body(400, 12)
    gaps = [Gap(marker, 20 + 30 * marker, 30 + 30 * marker) for marker in range(12)]
    recording = record(punch(points, gaps))
    refused = fill_with(("pca-r1", {}), recording, gaps)
    assert not refused.patches
    assert {u.reason for u in refused.unfilled} == {
        "of the other markers, 0 have no gap at all: this method needs 3"
    }
    filled = fill_with(("pca-r2", {"near": "10"}), recording, gaps)
    assert [p.gap for p in filled.patches] == gaps
    assert {filled.notes[gap]["helpers"] for gap in gaps} == {11}
    for patch in filled.patches:
        truth = points[patch.gap.start : patch.gap.stop, patch.gap.marker]
        assert np.linalg.norm(patch.values - truth, axis=1).max() < 30


def test_r2_does_without_markers_that_are_missing_in_the_gap_or_far_and_unsure():
    points = bending_body(300, 12)
    points[:, 11] += 5000.0
    gaps = [Gap(0, 100, 120), Gap(1, 110, 130), Gap(11, 200, 210)]
    result = fill_with(("pca-r2", {}), record(punch(points, gaps)), gaps)
    assert result.notes[gaps[0]]["helpers"] == 9
    alone = [gaps[0], gaps[2]]
    result = fill_with(("pca-r2", {}), record(punch(points, alone)), alone)
    assert result.notes[gaps[0]]["helpers"] == 10
