"""Gaps that cover measured samples: hidden from their own fill, seen by all others."""

import numpy as np
from synthetic import body_motion, record

from mocapmend_algorithms import Gap, no_progress
from mocapmend_algorithms.fill.hiding import covers_measured, fill_hiding
from mocapmend_algorithms.fill.registry import METHODS


def test_a_covered_sample_is_hidden_from_its_own_fill_alone() -> None:
    recording = record(body_motion(200, 5))
    points = recording.points.copy()
    points[60:66, 1] = np.nan
    holed = recording.with_points(points)
    plain, wide = Gap(1, 60, 66), Gap(1, 58, 67)
    assert not covers_measured(holed, plain)
    assert covers_measured(holed, wide)
    method = METHODS["cubic"]
    result = fill_hiding(holed, [wide], method.function, method.params(), no_progress)
    # What stood in the covered samples makes no difference.
    bent_points = holed.points.copy()
    bent_points[58:60, 1] += 1000.0
    bent = recording.with_points(bent_points)
    again = fill_hiding(bent, [wide], method.function, method.params(), no_progress)
    assert result.patches[0].values.tobytes() == again.patches[0].values.tobytes()
    assert result.patches[0].gap == wide


def test_results_come_in_the_order_of_the_gaps() -> None:
    recording = record(body_motion(200, 5))
    points = recording.points.copy()
    points[60:66, 1] = points[100:105, 2] = points[20:24, 0] = np.nan
    holed = recording.with_points(points)
    gaps = [Gap(1, 59, 67), Gap(2, 100, 105), Gap(0, 19, 25)]
    method = METHODS["linear"]
    shares: list[float] = []
    result = fill_hiding(holed, gaps, method.function, method.params(), shares.append)
    assert [patch.gap for patch in result.patches] == gaps
    assert shares == sorted(shares)
    alone = method.function(holed, gaps[1:2], method.params(), no_progress)
    assert result.patches[1].values.tobytes() == alone.patches[0].values.tobytes()
