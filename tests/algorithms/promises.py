"""The contract of all methods, as checks that their tests share."""

import numpy as np
import pytest
from synthetic import fill_with

from mocapmend_algorithms import Cancelled, find_gaps


def check_same_bytes(one, other):
    """Two patches are the same to the last bit."""
    assert one.gap == other.gap
    assert one.values.tobytes() == other.values.tobytes()
    assert one.sigma.tobytes() == other.sigma.tobytes()
    assert one.r90.tobytes() == other.r90.tobytes()


def check_bands(result):
    """Values are finite, and a band is known where there were self-tests."""
    for patch in result.patches:
        assert patch.values.shape == (patch.gap.length, 3)
        assert np.isfinite(patch.values).all()
        assert patch.sigma.shape == patch.r90.shape == (patch.gap.length,)
        known = result.notes[patch.gap]["self_tests"] > 0
        assert np.isfinite(patch.sigma).all() == np.isfinite(patch.r90).all() == known
        assert not (patch.sigma < 0).any()
        assert not (patch.r90 < 0).any()


def check_fills_only_what_it_is_given(variant, recording):
    """Every gap is filled or has a reason, in order, and the input stays; return the result."""
    before = recording.points.tobytes()
    gaps = find_gaps(recording.present)
    result = fill_with(variant, recording, gaps)
    assert recording.points.tobytes() == before
    done, left = [p.gap for p in result.patches], [u.gap for u in result.unfilled]
    assert sorted(done + left) == gaps
    assert done == sorted(done)
    assert left == sorted(left)
    assert all(u.reason for u in result.unfilled)
    assert set(result.notes) == set(done)
    check_bands(result)
    return result


def check_each_gap_stands_alone(variant, recording, gaps, some):
    """What a gap is filled with does not depend on which others are filled, nor on the order."""
    whole = {p.gap: p for p in fill_with(variant, recording, gaps).patches}
    for patch in fill_with(variant, recording, some[::-1]).patches:
        check_same_bytes(patch, whole[patch.gap])


def check_progress_and_cancel(variant, recording, gaps):
    """Progress rises to 1, and an exception from it ends the fill."""
    calls = []
    fill_with(variant, recording, gaps, calls.append)
    assert calls == sorted(calls)
    assert len(calls) > len(gaps)
    assert calls[-1] == 1.0

    def cancel(fraction):
        if fraction > 0.3:
            raise Cancelled

    with pytest.raises(Cancelled):
        fill_with(variant, recording, gaps, cancel)
