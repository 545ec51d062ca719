"""What donors lack is bridged by the motion of their neighbours."""

import numpy as np
import pytest
from donor_samples import body, jittery, rms, scattered
from synthetic import punch

from mocapmend_algorithms.alignment import align
from mocapmend_algorithms.fill.completion import NEARNESS, NEIGHBOURS, Completion
from mocapmend_algorithms.fill.donors import DonorDistances
from mocapmend_algorithms.gaps import Gap, find_gaps

RATE = 100.0


def completed(points, markers=None):
    """Bridge all gaps of some markers; return the completion and the points."""
    points = np.array(points)
    observed = ~np.isnan(points[:, :, 0])
    completion = Completion(points, observed, DonorDistances(points, observed), RATE)
    for marker in range(points.shape[1]) if markers is None else markers:
        completion.complete(marker)
    frames, markers = observed.shape
    return completion, completion.at(np.arange(frames), np.arange(markers))


def test_rigid_motion_is_found_again():
    points = body(300, 8, skin=0.0)
    gaps = [Gap(1, 50, 149), Gap(1, 200, 201), Gap(2, 90, 110), Gap(4, 105, 140), Gap(5, 108, 109)]
    _, found = completed(punch(points, gaps))
    np.testing.assert_allclose(found, points, atol=1e-8)


def test_all_gaps_are_bridged_as_one_alone_would_be():
    points = scattered(jittery(body(900, 9)), 0.3)
    observed = ~np.isnan(points[:, :, 0])
    known = DonorDistances(points, observed).to(4)
    order = known.best(len(known), NEARNESS)
    _, found = completed(points, [4])
    compared = 0
    for gap in find_gaps(observed):
        if gap.marker != 4 or gap.length > RATE or gap.kind(900) != "interior":
            continue
        around = slice(gap.start - 1, gap.stop + 1)
        seen = [place for place in order if observed[around, known.markers[place]].all()]
        best = np.array(seen[:NEIGHBOURS], dtype=int)
        ends = points[[gap.start - 1, gap.stop], 4]
        share = (np.arange(1, gap.length + 1) / (gap.length + 1))[:, None]
        if best.size:
            donors = points[around][:, known.markers[best]]
            frame = align(donors, donors[0], 1 / (known.spread[best] ** 2 + 1))
            ends = np.stack([frame[:1].to_local(ends[:1])[0], frame[-1:].to_local(ends[1:])[0]])
        expected = (1 - share) * ends[0] + share * ends[1]
        if best.size:
            expected = frame[1:-1].to_world(expected)
        np.testing.assert_allclose(found[gap.start : gap.stop, 4], expected, atol=1e-8)
        compared += 1
    assert compared > 5


def test_what_was_seen_stays_and_other_markers_are_not_touched():
    points = scattered(body(300, 6), 0.3)
    seen = ~np.isnan(points)
    _, found = completed(points, [0, 3])
    np.testing.assert_array_equal(found[seen], points[seen])
    others = [1, 2, 4, 5]
    np.testing.assert_array_equal(found[:, others], points[:, others])


def test_it_does_not_matter_who_is_bridged_first():
    points = scattered(body(300, 6), 0.3)
    _, one = completed(points, range(6))
    _, other = completed(points, [5, 3, 3, 0, 1, 2, 4])
    assert one.tobytes() == other.tobytes()


def test_long_gaps_and_those_at_the_edges_stay_open():
    points = punch(
        body(300, 6), [Gap(0, 0, 3), Gap(0, 290, 300), Gap(0, 50, 151), Gap(0, 160, 260)]
    )
    completion, found = completed(points)
    known = completion.known(0)
    np.testing.assert_array_equal(known, ~np.isnan(found[:, 0, 0]))
    assert not known[[*range(3), *range(290, 300), *range(50, 151)]].any()
    assert known[[*range(3, 50), *range(151, 290)]].all()
    np.testing.assert_array_equal(completion.known(1), True)


@pytest.mark.parametrize("markers", [1, 2, 3])
def test_few_neighbours_help_as_far_as_they_can(markers):
    points = body(200, markers, skin=0.0, turn=0.0)
    gap = Gap(0, 80, 120)
    _, found = completed(punch(points, [gap]))
    if markers > 1:
        np.testing.assert_allclose(found, points, atol=1e-8)
    else:
        straight = np.linspace(points[79, 0], points[120, 0], 42)[1:-1]
        np.testing.assert_allclose(found[80:120, 0], straight, atol=1e-9)


def test_skin_is_bridged_to_some_millimetres():
    points = body(300, 9)
    gap = Gap(2, 120, 160)
    _, found = completed(punch(points, [gap]))
    assert 0.1 < rms(found[120:160, 2], points[120:160, 2]) < 15
