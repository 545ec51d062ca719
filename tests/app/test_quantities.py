"""What is derived from trajectories: speed, acceleration, residual, bone length."""

import numpy as np
import pytest

from mocapmend.commands import EditSamples
from mocapmend.document import Document
from mocapmend.edits import Edit
from mocapmend.files import C3DFile
from mocapmend.views import quantities
from mocapmend.views.quantities import Curve, Quantity, Series, motion
from mocapmend_algorithms import Gap
from mocapmend_algorithms.fill.contract import Patch

RATE = 100.0


@pytest.fixture
def gap(document: Document) -> Gap:
    return next(g for g in document.gaps if g.length > 10 and g.kind(293) == "interior")


def patch_of(gap: Gap) -> Patch:
    rng = np.random.default_rng(0)
    sigma = np.ones(gap.length)
    return Patch(gap, 500.0 + rng.normal(size=(gap.length, 3)), sigma, 2.5 * sigma)


def test_a_circle_has_constant_speed_and_acceleration() -> None:
    angle = 2 * np.pi * np.arange(200) / 200
    points = 300.0 * np.stack((np.cos(angle), np.sin(angle), 0 * angle), axis=1)
    speed, acceleration = motion(points, RATE)
    step = angle[1]
    np.testing.assert_allclose(speed[1:-1], 300.0 * np.sin(step) * RATE)
    np.testing.assert_allclose(acceleration[1:-1], 600.0 * (1 - np.cos(step)) * RATE**2)


def test_motion_is_unknown_beside_a_gap_and_at_the_ends() -> None:
    points = np.zeros((12, 3))
    points[6] = np.nan
    unknown = [0, 5, 6, 7, 11]
    for row in motion(points, RATE):
        assert np.flatnonzero(np.isnan(row)).tolist() == unknown


@pytest.mark.parametrize("frames", [0, 1, 2])
def test_too_few_frames_have_no_motion(frames: int) -> None:
    found = motion(np.zeros((frames, 3)), RATE)
    assert found.shape == (2, frames)
    assert np.isnan(found).all()


@pytest.mark.parametrize("quantity", [q for q in Quantity if q is not Quantity.RESIDUAL])
def test_a_preview_shows_what_the_repair_will(
    document: Document, gap: Gap, quantity: Quantity
) -> None:
    other = (gap.marker + 1) % document.original.markers
    curve = Curve(other, "#fff", gap.marker) if quantity is Quantity.BONE else Curve(gap.marker, "")
    series = Series(document)
    before = series.rows(quantity, curve).copy()
    frames, values = series.patched(quantity, curve, gap, patch_of(gap).values)
    assert (frames[0], frames[-1]) == (gap.start - 1, gap.stop)
    edit = Edit.fill(patch_of(gap), "linear", None)
    document.undo_stack.push(EditSamples(document, [edit], "fill"))
    series.forget({gap.marker})
    after = series.rows(quantity, curve)
    np.testing.assert_allclose(values, after[gap.start - 1 : gap.stop + 1])
    assert np.isnan(before[gap.start : gap.stop]).all()


def test_only_what_has_changed_is_computed_again(document: Document) -> None:
    series = Series(document)
    kept, changed = Curve(0, ""), Curve(1, "")
    pair = Curve(0, "", 1)
    before = [series.rows(Quantity.SPEED, kept), series.rows(Quantity.BONE, pair)]
    series.rows(Quantity.SPEED, changed)
    series.forget({1})
    assert np.shares_memory(series.rows(Quantity.SPEED, kept), before[0])
    assert not np.shares_memory(series.rows(Quantity.BONE, pair), before[1])


@pytest.mark.parametrize("quantity", Quantity)
def test_a_single_value_is_that_of_the_curve(document: Document, quantity: Quantity) -> None:
    series = Series(document)
    curve = Curve(3, "", 8) if quantity is Quantity.BONE else Curve(3, "")
    every = [series.value(quantity, curve, k) for k in range(document.original.frames)]
    np.testing.assert_array_equal(every, series.rows(quantity, curve))
    assert np.isfinite(every).any()


def test_many_curves_are_computed_a_portion_at_a_time(
    document: Document, monkeypatch: pytest.MonkeyPatch
) -> None:
    monkeypatch.setattr(quantities, "PORTION", 4 * document.original.frames)
    series = Series(document)
    few = [(Quantity.SPEED, Curve(marker, "")) for marker in (3, 8)]
    assert series.prepare(few), "two trajectories and what follows from them"
    assert len(series._envelopes) == 4
    many = [(quantity, Curve(k, "")) for k in range(10) for quantity in (Quantity.X, Quantity.Y)]
    done = []
    while not series.prepare(many):
        done.append(len(series._envelopes))
    assert done == [8, 12]
    series.forget({5})
    assert not series.prepare(many), "what is to be drawn now takes long enough"
    assert series.prepare(many)


def test_a_curve_longer_than_a_portion_is_computed_at_once(
    document: Document, monkeypatch: pytest.MonkeyPatch
) -> None:
    monkeypatch.setattr(quantities, "PORTION", 10)
    assert Series(document).prepare([(Quantity.X, Curve(3, ""))])


def test_residuals_are_those_of_the_file(document: Document) -> None:
    source = document.source
    assert isinstance(source, C3DFile)
    series = Series(document)
    assert series.has_residuals
    for marker in (0, 7):
        found = series.rows(Quantity.RESIDUAL, Curve(marker, ""))
        np.testing.assert_array_equal(found, source.residuals[:, marker])


def test_the_length_of_a_bone_is_the_distance_of_its_ends(document: Document) -> None:
    expected = np.linalg.norm(document.points[:, 3] - document.points[:, 8], axis=1)
    found = Series(document).rows(Quantity.BONE, Curve(3, "", 8))
    np.testing.assert_allclose(found, expected)
