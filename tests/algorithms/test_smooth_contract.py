"""What every smoothing method promises."""

import dataclasses
import json

import numpy as np
import pytest
from hypothesis import given, settings
from smooth_samples import CHOOSE_ALONE, FIXED, VARIANTS, noisy, rms, smooth_with, whole
from synthetic import broken_recordings, punch, record, smooth_motion

from mocapmend_algorithms import Cancelled, Gap
from mocapmend_algorithms.smooth.registry import (
    SMOOTHERS,
    SUGGESTED,
    parse_params,
    restore_params,
    smoother,
    smoother_label,
)
from mocapmend_algorithms.smooth.stretches import FADE_S, LEAST_FADE

every_variant = pytest.mark.parametrize("variant", VARIANTS, ids=str)


def test_the_methods_and_their_order():
    assert list(SMOOTHERS) == ["butterworth", "savgol", "gcv", "kalman-smoother"]
    for key, entry in SMOOTHERS.items():
        assert smoother(key) is entry
        assert smoother_label(key) == entry.label
        assert entry.help.endswith(".")
        for field in dataclasses.fields(entry.params):
            assert field.metadata["label"]
            assert field.metadata["help"].endswith(".")
    assert SUGGESTED in SMOOTHERS
    assert smoother_label("of tomorrow") == "of tomorrow"
    with pytest.raises(KeyError, match="butterworth, savgol"):
        smoother("magic")


@every_variant
@settings(max_examples=15)
@given(broken_recordings())
def test_only_samples_that_are_there_change_and_only_in_the_runs(variant, recording):
    before = recording.points.tobytes()
    third = max(1, recording.frames // 3)
    runs = [Gap(0, 0, third), Gap(recording.markers - 1, third, recording.frames)]
    try:
        result = smooth_with(variant, recording, runs)
    except ValueError as error:
        assert str(error).startswith(("cutoff_hz", "window_ms"))
        return
    assert recording.points.tobytes() == before
    again = smooth_with(variant, recording, runs)
    for done, same in zip(result.runs, again.runs, strict=True):
        assert done.values.tobytes() == same.values.tobytes()
        assert done.chosen == same.chosen
    smoothed = result.applied(recording)
    np.testing.assert_array_equal(smoothed.present, recording.present)
    untouched = np.ones(recording.present.shape, dtype=bool)
    for done in result.runs:
        untouched[done.run.start : done.run.stop, done.run.marker] = False
        assert done.rms <= done.largest
        assert 0 <= done.step <= done.largest
    for left in result.untouched:
        marker, start, stop = left.stretch
        untouched[start:stop, marker] = True
        assert left.reason.endswith(".")
    np.testing.assert_array_equal(smoothed.points[untouched], recording.points[untouched])


@every_variant
def test_every_sample_of_a_run_is_smoothed_or_has_a_reason(variant):
    gaps = [Gap(0, 3, 4), Gap(0, 60, 70), Gap(0, 300, 305), Gap(1, 0, 400)]
    recording, _ = noisy()
    recording = record(punch(recording.points, gaps))
    result = smooth_with(variant, recording, whole(recording))
    assert [done.run for done in result.runs] == [Gap(0, 0, 400)]
    stretches = [left.stretch for left in result.untouched]
    assert stretches == [Gap(0, 0, 3), Gap(1, 0, 400)]
    assert "Only 3 samples on end" in result.untouched[0].reason
    assert result.untouched[1].reason == "There are no samples."
    moved = result.runs[0].shifts > 0
    assert moved[4:60].all()
    assert moved[70:300].all()
    assert moved[305:].all()


@every_variant
@pytest.mark.parametrize("rate", [25.0, 60.0, 120.0, 250.0, 1000.0])
def test_noise_is_reduced_at_every_rate(variant, rate):
    if rate < 60 and ("window_ms" in variant[1] or "cutoff_hz" in variant[1]):
        pytest.skip("the motion is faster than this filter lets through at the rate")
    recording, clean = noisy(round(max(300, 2 * rate)), rate=rate)
    smoothed = smooth_with(variant, recording, whole(recording)).applied(recording)
    before, after = rms(recording.points - clean), rms(smoothed.points - clean)
    assert after < (0.95 if rate < 60 else 0.65) * before


@pytest.mark.parametrize("method", SMOOTHERS)
@pytest.mark.parametrize("rate", [60.0, 120.0, 500.0])
def test_a_smooth_curve_is_nearly_left_alone(method, rate):
    recording = record(smooth_motion(400, 2, rate=rate), rate=rate)
    for done in smooth_with((method, {}), recording, whole(recording)).runs:
        assert done.rms < 0.1
        assert done.largest < 1.0


@every_variant
def test_the_unit_and_the_origin_do_not_matter(variant):
    runs = [Gap(0, 50, 300), Gap(1, 0, 400)]
    (millimetres, _), (metres, _) = noisy(), noisy(unit="m")
    away = np.array([1e5, -1e5, 0.0])
    moved = millimetres.with_points(millimetres.points + away)
    result = smooth_with(variant, millimetres, runs)
    for other, scale, shift in ((metres, 1000.0, 0.0), (moved, 1.0, away)):
        for done, same in zip(result.runs, smooth_with(variant, other, runs).runs, strict=True):
            np.testing.assert_allclose(done.values, same.values * scale - shift, atol=1e-6)
            assert done.rms == pytest.approx(same.rms * scale)
            assert done.largest == pytest.approx(same.largest * scale)
            assert done.step == pytest.approx(same.step * scale)


@pytest.mark.parametrize("method", SMOOTHERS)
def test_what_stands_still_stays_where_it_is(method):
    recording = record(np.full((200, 1, 3), 1234.5))
    (done,) = smooth_with((method, {}), recording, whole(recording)).runs
    np.testing.assert_allclose(done.values, 1234.5, rtol=1e-12)


@pytest.mark.parametrize("variant", FIXED, ids=str)
def test_pieces_do_not_look_across_a_gap(variant):
    recording, _ = noisy(markers=1)
    broken = punch(recording.points, [Gap(0, 200, 201)])
    other = broken.copy()
    other[201:] += 500.0
    run = [Gap(0, 0, 400)]
    (one,) = smooth_with(variant, record(broken), run).runs
    (two,) = smooth_with(variant, record(other), run).runs
    np.testing.assert_array_equal(one.values[:200], two.values[:200])
    alone = smooth_with(variant, record(broken[:200]), [Gap(0, 0, 200)]).runs[0]
    np.testing.assert_array_equal(one.values[:200], alone.values)


@pytest.mark.parametrize("variant", CHOOSE_ALONE, ids=str)
def test_runs_do_not_depend_on_each_other(variant):
    recording, _ = noisy()
    runs = [Gap(1, 50, 150), Gap(0, 20, 380), Gap(1, 150, 300)]
    together = smooth_with(variant, recording, runs)
    assert [done.run for done in together.runs] == runs
    for done in together.runs:
        (alone,) = smooth_with(variant, recording, [done.run]).runs
        assert done.values.tobytes() == alone.values.tobytes()


@every_variant
@pytest.mark.parametrize("rate", [50.0, 120.0, 500.0])
def test_runs_join_the_samples_around_them(variant, rate):
    recording, _ = noisy(400, 1, rate=rate)
    (done,) = smooth_with(variant, recording, [Gap(0, 100, 300)]).runs
    assert done.step == pytest.approx(done.shifts[[0, -1]].max())
    around = recording.points[98:302, 0]
    joined = np.concatenate((around[:2], done.values, around[-2:]))
    added = np.linalg.norm(np.diff(joined - around, axis=0), axis=1)
    assert max(added[1], added[-2]) <= done.step * (1 + 1e-9)
    assert done.step < 0.3 * np.sqrt(3) * 2.0


@pytest.mark.parametrize("variant", FIXED, ids=str)
@pytest.mark.parametrize("rate", [50.0, 120.0, 500.0])
def test_a_run_fades_into_the_samples_around_it(variant, rate):
    recording, _ = noisy(400, 1, rate=rate)
    (done,) = smooth_with(variant, recording, [Gap(0, 100, 300)]).runs
    (curve,) = smooth_with(variant, recording, whole(recording)).runs
    fade = max(LEAST_FADE, round(FADE_S * rate))
    share = done.shifts / curve.shifts[100:300]
    np.testing.assert_allclose(share[fade:-fade], 1.0)
    np.testing.assert_allclose(share[:fade], share[: -fade - 1 : -1])
    assert (np.diff(share[:fade]) > 0).all()
    assert share[0] < 0.15


@every_variant
def test_a_run_from_end_to_end_joins_nothing(variant):
    recording, _ = noisy()
    for done in smooth_with(variant, recording, whole(recording)).runs:
        assert done.step == 0.0


@every_variant
def test_a_short_run_takes_its_curve_from_the_samples_around_it(variant):
    recording, clean = noisy(markers=1)
    (done,) = smooth_with(variant, recording, [Gap(0, 180, 200)]).runs
    inside = slice(186, 194)
    before = rms(recording.points[inside, 0] - clean[inside, 0])
    assert rms(done.values[6:14] - clean[inside, 0]) < 0.8 * before


@every_variant
def test_what_a_record_needs_can_be_written_and_read_again(variant):
    recording, _ = noisy()
    result = smooth_with(variant, recording, [Gap(0, 50, 300)])
    assert result.method == variant[0]
    params = json.loads(json.dumps(result.params))
    entry = smoother(result.method)
    assert restore_params(entry, params) == parse_params(entry, variant[1])
    for done in result.runs:
        assert json.loads(json.dumps(done.chosen, allow_nan=False)) == done.chosen
        assert len(done.chosen["cutoff_hz"]) == 3


@every_variant
def test_progress_rises_to_one_and_cancels(variant):
    recording, _ = noisy()
    calls = []
    smooth_with(variant, recording, whole(recording), calls.append)
    assert calls == sorted(calls)
    assert len(calls) > recording.markers
    assert calls[-1] == 1.0

    def cancel(_):
        raise Cancelled

    with pytest.raises(Cancelled):
        smooth_with(variant, recording, whole(recording), cancel)


@pytest.mark.parametrize("method", SMOOTHERS)
@pytest.mark.parametrize("run", [(2, 0, 10), (-1, 0, 10), (0, 5, 5), (0, -1, 5), (0, 10, 401)])
def test_runs_outside_the_recording_are_refused(method, run):
    recording, _ = noisy()
    with pytest.raises(ValueError, match="is no stretch of the recording"):
        smooth_with((method, {}), recording, [Gap(*run)])


@pytest.mark.parametrize("method", SMOOTHERS)
def test_overlapping_runs_are_refused(method):
    recording, _ = noisy()
    with pytest.raises(ValueError, match="two stretches of M1 overlap"):
        smooth_with((method, {}), recording, [Gap(1, 0, 10), Gap(0, 0, 10), Gap(1, 9, 20)])


@pytest.mark.parametrize("method", SMOOTHERS)
def test_nothing_to_smooth_is_no_error(method):
    recording, _ = noisy()
    result = smooth_with((method, {}), recording, [])
    assert result.runs == result.untouched == ()
    assert result.applied(recording).points.tobytes() == recording.points.tobytes()
