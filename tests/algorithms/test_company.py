"""Which markers are seen together, and how far they are apart."""

import numpy as np
from synthetic import record

from mocapmend_algorithms.fill.company import mean_distances, seen_together


def test_mean_distances_leave_out_what_is_missing():
    points = np.zeros((4, 3, 3))
    points[:, 1, 0] = [1, 2, 3, 1000]
    points[3, 1] = points[:, 2] = np.nan
    recording = record(points)
    away = mean_distances(recording, recording.present, 0)
    np.testing.assert_allclose(away, [0.0, 2.0, np.inf])


def test_markers_that_are_hardly_seen_are_left_out():
    observed = np.ones((100, 5), dtype=bool)
    observed[20:40, 1] = observed[40:, 2] = observed[:99, 4] = False
    everybody = np.arange(5)
    markers, frames = seen_together(observed, everybody, 0)
    assert markers.tolist() == [0, 1, 3]
    assert frames.tolist() == [*range(20), *range(40, 100)]
    markers, frames = seen_together(observed, everybody, 2)
    assert markers.tolist() == [0, 1, 2, 3]
    assert frames.tolist() == list(range(20))
    markers, frames = seen_together(observed, everybody, 4)
    assert frames.tolist() == [99]
    assert 4 in markers
