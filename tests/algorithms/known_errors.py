"""A whole-recording fill whose error is known, to test what is measured of it."""

import numpy as np
from synthetic import bending_body

from mocapmend_algorithms.fill.contract import FillResult, Patch


class Liar:
    """Fills with the truth plus an error, and notes what it was asked."""

    def __init__(self, truth, error):
        self.truth, self.error = truth, error
        self.asked = []

    def __call__(self, recording, observed, gaps, progress, /):
        self.asked.append((observed.copy(), list(gaps)))
        progress(1.0)
        patches = []
        for gap in gaps:
            assert not observed[gap.start : gap.stop, gap.marker].any()
            values = self.truth[gap.start : gap.stop, gap.marker] + self.error(gap)
            patches.append(Patch(gap, values, *np.full((2, gap.length), np.nan)))
        return FillResult(tuple(patches), (), {gap: {"helpers": 7} for gap in gaps})


def constant_error(gap):
    return np.full((gap.length, 3), 2.0)


def recurring_body():
    """Move so that every posture comes again: none is stranger than another."""
    return np.tile(bending_body(100, 6), (6, 1, 1))
