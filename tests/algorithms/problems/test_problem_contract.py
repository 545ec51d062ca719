"""What every detector keeps, and what they say together."""

import gc
import weakref
from dataclasses import replace

import numpy as np
import pytest
from bodies import body, changed, found_by

from mocapmend_algorithms import Cancelled, Recording, no_progress
from mocapmend_algorithms.problems import BadRun, detect
from mocapmend_algorithms.problems.detect import explained_once
from mocapmend_algorithms.problems.distances import distances_of
from mocapmend_algorithms.problems.registry import DETECTORS, chosen, detector, remedy
from mocapmend_algorithms.skeleton import Skeleton, skeleton_from_distances

NOTHING = Skeleton("", (), "none")
ALL = pytest.mark.parametrize("name", DETECTORS)


def wrecked():
    """Return a recording with something for each detector, and gaps."""
    rng = np.random.default_rng(5)

    def corrupt(points):
        points[100:102, 3] += 90.0
        points[150:180, [6, 8]] = points[150:180, [8, 6]]
        points[200:230, 5] = np.nan
        points[196:200, 5] += np.outer([15.0, 30.0, 45.0, 60.0], [1.0, 0.0, 0.0])
        points[300:320, 10] = points[299, 10]
        points[330:370, 12] += (0.0, 80.0, 80.0)
        points[400:405, 1] = rng.uniform(8000.0, 9000.0, (5, 3))
        points[450:480, 14] = points[450:480, 11] + rng.uniform(-1.0, 1.0, (30, 3))

    recording = changed(body(), corrupt)
    points = np.concatenate((recording.points, np.full((recording.frames, 1, 3), np.nan)), axis=1)
    points[500:550, 15] = points[500:550, 4]
    points[500:550, 4] = np.nan
    return replace(recording, points=points, labels=(*recording.labels, "*1"))


@ALL
@pytest.mark.parametrize(
    "shape", [(0, 0), (0, 3), (5, 0), (1, 1), (1, 8), (2, 2), (7, 5), (400, 1), (60, 2)]
)
@pytest.mark.parametrize("fill", ["zero", "missing", "noise", "half"])
def test_degenerate_recordings_have_no_errors_that_break_it(name, shape, fill):
    rng = np.random.default_rng(0)
    points = rng.normal(size=(*shape, 3)) * (fill in ("noise", "half"))
    if fill == "missing":
        points[:] = np.nan
    if fill == "half":
        points[rng.random(shape) < 0.5] = np.nan
    labels = tuple(f"M{k}" for k in range(shape[1]))
    way = detector(name)
    for unit in ("mm", "m"):
        recording = Recording(points.copy(), labels, 100.0, unit)
        runs = way.function(recording, NOTHING, way.params(), no_progress)
        if fill in ("zero", "missing"):
            assert runs == []


@ALL
def test_each_finds_its_own_and_says_it_properly(name):
    recording = wrecked()
    runs = found_by(name, recording)
    assert runs
    assert runs == sorted(runs, key=lambda run: (run.marker, run.start))
    for run in runs:
        assert run.kind == name
        assert 0 <= run.start < run.stop <= recording.frames
        assert 0.0 <= run.score <= 1.0
        assert run.other != run.marker
        assert run.reason.endswith(".")
        assert any(letter.isdigit() for letter in run.reason)
        assert isinstance(run.deviation, float)
        assert recording.present[run.start : run.stop, run.marker].any()


@ALL
def test_the_unit_does_not_matter(name):
    in_mm = wrecked()
    in_m = replace(in_mm, points=in_mm.points / 1000.0, unit="m")
    for a, b in zip(found_by(name, in_mm), found_by(name, in_m), strict=True):
        assert (a.marker, a.start, a.stop, a.other) == (b.marker, b.start, b.stop, b.other)
        assert b.deviation * 1000.0 == pytest.approx(a.deviation, nan_ok=True)


@ALL
def test_it_can_be_cancelled_and_reports_from_0_to_1(name):
    recording, way, told = wrecked(), detector(name), []
    way.function(recording, NOTHING, way.params(), told.append)
    assert told
    assert 0.0 <= min(told) <= max(told) <= 1.0
    assert told == sorted(told)

    def stop(fraction):
        raise Cancelled

    with pytest.raises(Cancelled):
        way.function(recording, NOTHING, way.params(), stop)


def test_the_registry_names_what_there_is():
    assert [way.id for way in chosen(None)] == list(DETECTORS)
    assert [way.id for way in chosen(["swaps", "spikes"])] == ["spikes", "swaps"]
    with pytest.raises(KeyError, match="the detectors are: spikes, swaps"):
        detector("spooks")
    swap = BadRun("swaps", 0, 1, 2, 1.0, 3.0, "", other=1)
    ghost = BadRun("fragments", 0, 1, 2, 1.0, np.nan, "")
    assert [remedy(run) for run in (swap, ghost)] == ["exchange", "missing"]
    assert (swap.harm, ghost.harm) == (3.0, 0.0)


def test_each_error_is_explained_once_and_by_its_own_kind():
    recording = wrecked()
    skeleton = skeleton_from_distances(recording, no_progress)
    told = []
    runs = detect(recording, skeleton, None, told.append)
    assert told == sorted(told)
    assert told[-1] == 1.0
    kinds = {(run.kind, run.marker, run.start, run.stop) for run in runs}
    assert {
        ("spikes", 3, 100, 102),
        ("swaps", 6, 150, 180),
        ("tails", 5, 196, 200),
        ("frozen", 10, 300, 320),
        ("bone-breaks", 12, 330, 370),
        ("far", 1, 400, 405),
        ("reflections", 14, 450, 480),
        ("fragments", 15, 500, 550),
    } <= kinds
    taken = np.zeros(recording.present.shape, dtype=int)
    for run in runs:
        taken[run.start : run.stop, run.marker] += 1
    assert taken.max() == 1


def test_a_swap_explains_the_jumps_at_its_ends():
    present = np.ones((100, 4), dtype=bool)
    swap = BadRun("swaps", 0, 40, 60, 0.9, 80.0, "", other=1)
    jump = BadRun("spikes", 0, 39, 41, 1.0, 80.0, "")
    mate = BadRun("bone-breaks", 1, 40, 60, 0.9, 80.0, "")
    other = BadRun("spikes", 2, 39, 41, 0.9, 80.0, "")
    late = BadRun("bone-breaks", 1, 55, 90, 0.9, 80.0, "It breaks by 80 mm.")
    runs = explained_once([jump, mate, other, late, swap], present)
    reason = "It breaks by 80 mm; the rest is explained otherwise."
    assert runs == [swap, replace(late, start=62, reason=reason), other]


def test_detectors_that_were_not_asked_for_say_nothing():
    recording = wrecked()
    runs = detect(recording, NOTHING, ["frozen", "far"], no_progress)
    assert {run.kind for run in runs} == {"frozen", "far"}


def test_parameters_go_to_the_detector_that_they_are_of():
    recording = wrecked()
    params = {"far": detector("far").params(least_mm=20_000.0)}
    runs = detect(recording, NOTHING, ["frozen", "far"], no_progress, params=params)
    assert {run.kind for run in runs} == {"frozen"}


def test_the_distances_are_measured_once_and_forgotten_with_the_recording():
    recording, told = body(1.0), []
    first = distances_of(recording, told.append)
    assert distances_of(recording, told.append) is first
    assert told[-1] == 1.0
    again = distances_of(body(1.0), told.append)
    assert again is not first
    assert np.array_equal(again.length, first.length, equal_nan=True)
    gone = weakref.ref(recording)
    del recording
    gc.collect()
    assert gone() is None
