"""Bones that get their lengths: what is less sure moves further, gap by gap."""

import numpy as np
import pytest
from joint_samples import NAMES, hidden, walker

from mocapmend_algorithms import Gap, find_gaps, no_progress
from mocapmend_algorithms.fill.contract import FillResult, Patch
from mocapmend_algorithms.fill.edges import Doubt
from mocapmend_algorithms.fill.keep_bones import projected
from mocapmend_algorithms.sparse.body import find_body
from mocapmend_algorithms.sparse.code_model import CodeSettings
from mocapmend_algorithms.sparse.examples import Motion
from mocapmend_algorithms.sparse.recovery import Recovery
from mocapmend_algorithms.sparse.rows import Rows
from mocapmend_algorithms.sparse.windows import Span

KNEE, FOOT = NAMES.index("ltibia"), NAMES.index("lfoot")
OFF_MM = 5.0


@pytest.fixture
def truth():
    return walker(60, unit="mm")


def moved(truth, spans, doubts):
    """Put knee and foot apart from the truth in some frames, and give the bones their lengths."""
    raw = truth
    for start, stop in spans:
        raw = hidden(raw, [KNEE, FOOT], start, stop)
    gaps = find_gaps(raw.present)
    away = np.random.default_rng(0).normal(scale=OFF_MM, size=(truth.frames, len(NAMES), 3))
    told = truth.points + away
    patches = tuple(
        Patch(gap, told[gap.start : gap.stop, gap.marker], *np.full((2, gap.length), np.nan))
        for gap in gaps
    )
    body = find_body(raw, raw.present)
    filled = projected(raw, raw.present, FillResult(patches, (), {}), body, doubts)
    return {
        patch.gap: np.linalg.norm(patch.values - before.values, axis=1).mean()
        for patch, before in zip(filled.patches, patches, strict=True)
    }


def doubt(knee, foot):
    order = np.argsort([KNEE, FOOT])
    return Doubt(np.sort([KNEE, FOOT]), np.diag(np.array([knee, foot])[order]))


def test_what_is_less_sure_moves_further(truth):
    gaps = [Gap(marker, 20, 40) for marker in (KNEE, FOOT)]
    alike = moved(truth, [(20, 40)], {})
    for unsure, sure in (gaps, gaps[::-1]):
        both = doubt(*(100.0 if gap is unsure else 1.0 for gap in gaps))
        result = moved(truth, [(20, 40)], dict.fromkeys(gaps, both))
        assert result[unsure] > alike[unsure]
        assert result[sure] < alike[sure]


def test_what_is_said_of_one_gap_holds_there_alone(truth):
    early = {Gap(marker, 10, 20): doubt(100.0, 1.0) for marker in (KNEE, FOOT)}
    late = {Gap(marker, 40, 50): doubt(1.0, 100.0) for marker in (KNEE, FOOT)}
    together = moved(truth, [(10, 20), (40, 50)], early | late)
    for spans, doubts in (([(10, 20)], early), ([(40, 50)], late)):
        for gap, size in moved(truth, spans, doubts).items():
            assert together[gap] == pytest.approx(size, abs=1e-6)


def test_one_that_nothing_is_said_of_is_as_unsure_as_the_others(truth):
    knee, foot = (Gap(marker, 20, 40) for marker in (KNEE, FOOT))
    alone = Doubt(np.array([KNEE]), np.array([[7.0]]))
    known = moved(truth, [(20, 40)], {knee: alone, foot: None})
    assert known == pytest.approx(moved(truth, [(20, 40)], {}), rel=1e-3)


def test_doubt_is_the_scatter_of_what_examples_are_missed_by():
    # Knees that jitter beside a body that does not: nothing tells them, and they tell the foot.
    truth = walker(400, unit="mm")
    jitter = np.random.default_rng(1).normal(scale=4.0, size=(400, 3))
    points = truth.points.copy()
    points[:, KNEE] += jitter
    points[:, FOOT] += jitter
    motion = Motion(points, truth.present)
    body = find_body(truth, truth.present)
    targets = np.sort([KNEE, FOOT])
    rows = Rows.along_bones(body, np.setdiff1d(np.arange(31), targets), targets)

    def asked(examples):
        codes = CodeSettings(40, examples, 0.1, guided=True)
        return Recovery(motion, (), rows, Span.over(6, 30), "+y", codes, no_progress).doubt

    covariance = asked(160)
    assert covariance.shape == (2, 2)
    np.testing.assert_allclose(covariance, 16.0, rtol=0.5)
    assert asked(0) is None
