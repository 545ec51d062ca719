"""How unlike the known postures a posture is."""

import numpy as np
import pytest
from known_errors import recurring_body
from synthetic import record

from mocapmend_algorithms.fill.novelty import Novelty


@pytest.fixture
def points():
    return recurring_body()


def test_postures_seen_before_are_not_novel_and_strange_ones_are(points):
    points[300:320, 2:, 0] += 400.0 * np.arange(4)
    recording = record(points)
    observed = recording.present.copy()
    observed[250:350, 0] = False
    novelty = Novelty.of(recording, observed, np.array([0]), 250, 350)
    found = novelty(observed, 250, 350)
    assert found.shape == (100,)
    assert found[:50].max() < 20
    assert found[50:70].min() > 100


def test_novelty_is_unknown_without_markers_to_compare(points):
    points[:, 2:] = np.nan
    recording = record(points)
    novelty = Novelty.of(recording, recording.present, np.array([0]), 10, 20)
    np.testing.assert_array_equal(novelty(recording.present, 10, 20), np.zeros(10))
