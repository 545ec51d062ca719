"""The methods that look at other markers, on real recordings."""

import numpy as np
import pytest
from donor_samples import rms, truth_of
from synthetic import fill_with, punch

from mocapmend.files import read_recording
from mocapmend_algorithms import Gap, Recording, find_gaps, no_progress
from mocapmend_algorithms.fill.limits import Limits, fill_within
from mocapmend_algorithms.fill.registry import METHODS

NAMES = ["gait_plug_in_gait", "sprint_basketball", "walk_cmu_02_01"]
EVERY = pytest.mark.parametrize("name", NAMES)
DONOR_METHODS = ["rigid", "pattern", "local-frame", "auto"]
AUTO = ("auto", {})


def opened(samples, name):
    return read_recording(samples / f"{name}.c3d").recording


def hidden_gaps(recording, seconds, count, *, seed=0):
    """Stretches in which a marker is seen, with as much of it around."""
    rng = np.random.default_rng(seed)
    length = max(1, round(seconds * recording.rate))
    gaps = []
    while len(gaps) < count:
        marker = int(rng.integers(recording.markers))
        start = int(rng.integers(length, recording.frames - 2 * length))
        if recording.present[start - length : start + 2 * length, marker].all():
            gaps.append(Gap(marker, start, start + length))
    return gaps


def filled(recording, gap, variant=AUTO):
    """Hide a gap alone and fill it; return the patch and its 3-D error in mm."""
    (patch,) = fill_with(variant, hidden(recording, [gap]), [gap]).patches
    return patch, rms(patch.values, truth_of(recording.points, gap)) * recording.mm


def hidden(recording, gaps):
    return recording.with_points(punch(recording.points, gaps))


@pytest.mark.parametrize(("name", "share"), [*zip(NAMES, [0.1, 0.3, 0.3], strict=True)])
def test_auto_is_far_better_than_a_spline_over_half_a_second(samples, name, share):
    recording = opened(samples, name)
    gaps = hidden_gaps(recording, 0.5, 8)
    ours = np.mean([filled(recording, gap)[1] for gap in gaps])
    spline = np.mean([filled(recording, gap, ("cubic", {}))[1] for gap in gaps])
    assert ours < share * spline


@pytest.mark.parametrize(
    ("name", "seconds"), [*[(name, 0.5) for name in NAMES], (NAMES[0], 0.1), (NAMES[2], 0.1)]
)
def test_autos_band_and_expected_error_are_true(samples, name, seconds):
    recording = opened(samples, name)
    inside, expected, true = [], [], []
    for gap in hidden_gaps(recording, seconds, 14, seed=1):
        patch, error = filled(recording, gap)
        apart = np.linalg.norm(patch.values - truth_of(recording.points, gap), axis=1)
        inside.append(np.mean(apart <= patch.r90))
        expected.append(patch.expected_error * recording.mm)
        true.append(error)
    assert 0.75 < np.mean(inside) <= 1.0
    assert 0.4 < np.median(np.array(expected) / np.maximum(true, 1e-9)) < 4.0


@EVERY
def test_autos_limit_is_the_users(samples, name):
    recording = opened(samples, name)
    gaps = sorted(hidden_gaps(recording, 0.5, 4))
    holed, auto = hidden(recording, gaps), METHODS["auto"]
    everything = Limits(max_error_mm=np.inf)
    patches = fill_within(holed, gaps, auto, auto.params(), everything, no_progress).patches
    errors = {patch.gap: patch.expected_error * recording.mm for patch in patches}
    limit = float(np.median(list(errors.values())))
    allowed = Limits(max_error_mm=limit)
    result = fill_within(holed, gaps, auto, auto.params(), allowed, no_progress)
    assert [p.gap for p in result.patches] == [gap for gap in errors if errors[gap] <= limit]
    for unfilled in result.unfilled:
        assert "expected error" in unfilled.reason
        assert "above the limit" in unfilled.reason


@EVERY
@pytest.mark.parametrize("method", DONOR_METHODS)
def test_real_gaps_are_filled_or_refused_with_a_reason(samples, name, method):
    recording = opened(samples, name)
    gaps = find_gaps(recording.present)
    gaps = gaps[:: max(1, len(gaps) // 12)]
    check(recording, gaps, fill_with((method, {}), recording, gaps))


def check(recording, gaps, result):
    """Make sure that all is finite, in the room where it claims to be exact, or has a reason."""
    assert len(result.patches) + len(result.unfilled) == len(gaps)
    assert all(unfilled.reason for unfilled in result.unfilled)
    low, high = (f(recording.points, axis=(0, 1)) for f in (np.nanmin, np.nanmax))
    margin = 500 / recording.mm
    for patch in result.patches:
        assert np.isfinite(patch.values).all()
        if patch.expected_error * recording.mm < 50:
            assert ((patch.values > low - margin) & (patch.values < high + margin)).all()
        if result.notes[patch.gap]["self_tests"]:
            assert np.isfinite(patch.r90).all()
            assert (patch.r90 >= 0).all()


def hard_cases(recording):
    """Recordings with hard gaps, by what makes them hard."""
    rate, frames = round(recording.rate), recording.frames
    # A marker that is seen most of the time, and those that move with it.
    marker = int(np.argmax(recording.present.sum(axis=0)))
    apart = np.linalg.norm(recording.points - recording.points[:, [marker]], axis=2)
    spread = np.std(np.where(np.isnan(apart), 1e6, apart), axis=0)
    segment = np.argsort(spread)[:5].tolist()
    middle = frames // 2
    yield "a whole segment", [Gap(m, middle, middle + rate) for m in sorted(segment)]
    yield "the start", [Gap(marker, 0, rate)]
    yield "the end", [Gap(marker, frames - rate, frames)]
    yield "long", [Gap(marker, rate // 2, min(frames - rate // 4, rate // 2 + 5 * rate))]
    yield "one frame", [Gap(marker, middle, middle + 1)]


@EVERY
@pytest.mark.parametrize("method", DONOR_METHODS)
def test_hard_gaps_are_filled_or_refused_with_a_reason(samples, name, method):
    recording = opened(samples, name)
    for what, gaps in hard_cases(recording):
        holed = hidden(recording, gaps)
        result = fill_with((method, {}), holed, gaps)
        check(holed, gaps, result)
        assert result.patches or method != "auto", what


@EVERY
@pytest.mark.parametrize("method", DONOR_METHODS)
def test_twenty_frames_are_filled_or_refused_with_a_reason(samples, name, method):
    whole = opened(samples, name)
    points = whole.points[100:120]
    recording = Recording(np.array(points), whole.labels, whole.rate, whole.unit, whole.up)
    marker = int(np.argmax(recording.present.sum(axis=0)))
    gaps = [Gap(marker, 8, 12)]
    check(recording, gaps, fill_with((method, {}), hidden(recording, gaps), gaps))


@EVERY
@pytest.mark.parametrize("method", DONOR_METHODS)
def test_a_third_missing_is_filled_or_refused_with_a_reason(samples, name, method):
    whole = opened(samples, name)
    points = np.array(whole.points[:400])
    points[np.random.default_rng(0).random(points.shape[:2]) < 0.3] = np.nan
    recording = whole.with_points(points)
    marker = int(np.argmax(recording.present.sum(axis=0)))
    gaps = [gap for gap in find_gaps(recording.present) if gap.marker == marker][:12]
    result = fill_with((method, {}), recording, gaps)
    check(recording, gaps, result)
    if method == "auto":
        assert len(result.patches) >= 0.75 * len(gaps)
        kept = [p for p in result.patches if whole.present[p.gap.start : p.gap.stop, marker].all()]
        errors = [rms(p.values, truth_of(whole.points, p.gap)) * whole.mm for p in kept]
        assert np.median(errors) < 5.0


@pytest.mark.shared
def test_real_markers_are_filled_within_their_band(shared):
    inside, errors, splines = [], [], []
    for name in ("132_43", "141_16", "143_22", "135_07"):
        data = np.load(shared / "cmu_markers" / f"{name}.npz")
        labels = tuple(str(label) for label in data["names"])
        recording = Recording(data["pos"].astype(np.float64), labels, 120.0)
        for gap in hidden_gaps(recording, 0.5, 12):
            patch, error = filled(recording, gap)
            apart = np.linalg.norm(patch.values - truth_of(recording.points, gap), axis=1)
            inside.append(np.mean(apart <= patch.r90))
            errors.append(error)
            splines.append(filled(recording, gap, ("cubic", {}))[1])
    assert 0.78 < np.mean(inside) <= 1.0
    assert np.mean(errors) < 0.2 * np.mean(splines)
