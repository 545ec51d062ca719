"""What principal components, the low-dimensional smoother and completion have in common."""

import json

import numpy as np
import pytest
from hypothesis import given, settings
from hypothesis import strategies as st
from synthetic import bending_body, fill_with, punch, record

from mocapmend.engine import load
from mocapmend_algorithms import Gap, no_progress

FAINT = {"missing_weight": "1e-6", "components": "99.9999"}
EXACT = [
    ("pca-r1", FAINT),
    ("pca-r1", {**FAINT, "meet_edges": "false"}),
    ("pca-r2", {**FAINT, "meet_edges": "false"}),
    ("burke-lasenby", {"components": "99.9999", "noise_mm": "0.001", "meet_edges": "false"}),
]
EVERY = pytest.mark.parametrize("method", ["pca-r1", "pca-r2", "burke-lasenby", "tsmc"])


def errors(result, points):
    return np.concatenate(
        [
            np.linalg.norm(p.values - points[p.gap.start : p.gap.stop, p.gap.marker], axis=1)
            for p in result.patches
        ]
    )


@pytest.mark.parametrize("variant", EXACT, ids=str)
@settings(max_examples=10)
@given(seed=st.integers(0, 100), start=st.integers(0, 200), length=st.integers(1, 100))
def test_recovers_motion_of_low_rank_exactly(variant, seed, start, length):
    points = bending_body(300, 12, seed=seed, modes=2)
    # Of motion that is exactly of low rank, Burke and Lasenby's rule drops the last direction.
    points += np.random.default_rng(seed).normal(0, 1e-3, points.shape)
    gaps = [Gap(3, start, start + length), Gap(7, start, start + length)]
    result = fill_with(variant, record(punch(points, gaps)), gaps)
    assert len(result.patches) == 2
    assert errors(result, points).max() < 0.05


@EVERY
def test_a_mirrored_and_turned_recording_is_filled_alike(method):
    points = bending_body(200, 9)
    gaps = [Gap(2, 60, 90), Gap(5, 0, 20)]
    here = fill_with((method, {}), record(punch(points, gaps)), gaps)
    there = fill_with((method, {}), record(punch(-points[:, :, [1, 2, 0]] + 1e3, gaps)), gaps)
    for a, b in zip(here.patches, there.patches, strict=True):
        np.testing.assert_allclose(b.values, -a.values[:, [1, 2, 0]] + 1e3, atol=1e-3)


@EVERY
def test_a_marker_that_is_hardly_seen_does_not_stop_the_others(method):
    points = bending_body(300, 12)
    points[5:, 11] = np.nan
    gaps = [Gap(2, 100, 130)]
    result = fill_with((method, {}), record(punch(points, gaps)), [*gaps, Gap(11, 5, 300)])
    assert [p.gap for p in result.patches] == gaps
    assert "only 5 frames show the marker" in result.unfilled[0].reason


@EVERY
def test_helps_more_than_a_straight_line(method):
    points = bending_body(600, 14, modes=4) + np.random.default_rng(2).normal(0, 0.5, (600, 14, 3))
    gaps = [Gap(4, 200, 320)]
    recording = record(punch(points, gaps))
    model = errors(fill_with((method, {}), recording, gaps), points)
    line = errors(fill_with(("linear", {}), recording, gaps), points)
    assert model.mean() < 0.2 * line.mean()


@EVERY
def test_the_band_holds_about_what_it_says(method):
    inside = []
    for seed in range(6):
        points = bending_body(900, 10, seed=seed, modes=12)
        points += np.random.default_rng(seed).normal(0, 1.0, points.shape)
        gaps = [Gap(2, 300, 360), Gap(6, 310, 350), Gap(8, 700, 730)]
        result = fill_with((method, {}), record(punch(points, gaps)), gaps)
        radius = np.concatenate([p.r90 for p in result.patches])
        inside.append(errors(result, points) <= radius)
    assert 0.8 < np.mean(np.concatenate(inside)) < 0.99


@EVERY
def test_a_long_recording_of_many_markers_needs_little_memory(method):
    import tracemalloc

    points = np.tile(bending_body(500, 40), (40, 1, 1))
    gaps = [Gap(3, 9000, 9500), Gap(8, 100, 150), Gap(9, 100, 150)]
    recording = record(punch(points, gaps))
    tracemalloc.start()
    fill_with((method, {}), recording, gaps)
    peak = tracemalloc.get_traced_memory()[1]
    tracemalloc.stop()
    assert peak < 5 * recording.points.nbytes + 100e6


@pytest.mark.parametrize(
    ("method", "peer"),
    [
        ("pca-r1", "Gloersen-Federolf 2016 R1"),
        ("pca-r2", "Gloersen-Federolf 2016 R2"),
        ("burke-lasenby", "Burke-Lasenby 2016 (pyCGM2-like)"),
    ],
)
def test_as_printed_is_as_wrong_as_the_published_programs(shared, method, peer):
    cases = json.loads((shared / "peers" / "cases.json").read_text())
    cases = [c for c in cases if c["case"].startswith("P2_85_02") and peer in c["peers"]]
    source, _ = load(shared / cases[0]["file"], no_progress)
    points, ratios = source.recording.points, []
    for case in cases:
        gaps = sorted(Gap(*gap) for gap in case["gaps"])
        recording = source.recording.with_points(punch(points, gaps))
        result = fill_with((method, {"meet_edges": "false"}), recording, gaps)
        rmse = np.sqrt(np.mean(errors(result, points) ** 2))
        ratios.append(np.log(rmse / case["peers"][peer]["rmse_mm"]))
    assert abs(np.mean(ratios)) < 0.1
