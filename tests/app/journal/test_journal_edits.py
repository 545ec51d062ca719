"""Undo commands come back from JSON to the bit, and only those that fit the recording."""

import json

import numpy as np
import pytest
from hypothesis import HealthCheck, given, settings
from hypothesis import strategies as st

from mocapmend.document import Document, Edit
from mocapmend.journal.edits import _pack, decode, encode
from mocapmend.journal.file import Event
from mocapmend.state import SampleState
from mocapmend_algorithms import Gap
from mocapmend_algorithms.fill.contract import Patch
from mocapmend_algorithms.fill.interpolate import ConstantParams, LinearParams
from mocapmend_algorithms.fill.kalman import KalmanParams

FRAMES, MARKERS = 12, 3
PARAMS = {
    "linear": LinearParams(),
    "constant": ConstantParams("nearest"),
    "kalman": KalmanParams(noise_mm=0.1 + 0.2),
}

numbers = st.floats(allow_nan=False, allow_infinity=False)


@st.composite
def fills(draw: st.DrawFn) -> Edit:
    gap = draw(gaps())
    values = draw(st.lists(numbers, min_size=3 * gap.length, max_size=3 * gap.length))
    bands = draw(
        st.lists(st.floats(min_value=0.0), min_size=2 * gap.length, max_size=2 * gap.length)
    )
    sigma, r90 = np.array(bands).reshape(2, -1)
    method = draw(st.sampled_from(sorted(PARAMS)))
    return Edit.fill(Patch(gap, np.reshape(values, (-1, 3)), sigma, r90), method, PARAMS[method])


@st.composite
def gaps(draw: st.DrawFn) -> Gap:
    start = draw(st.integers(0, FRAMES - 1))
    return Gap(draw(st.integers(0, MARKERS - 1)), start, draw(st.integers(start + 1, FRAMES)))


def same_bits(one: np.ndarray, other: np.ndarray) -> bool:
    return (
        one.dtype == other.dtype and one.shape == other.shape and one.tobytes() == other.tobytes()
    )


@settings(suppress_health_check=[HealthCheck.function_scoped_fixture])
@given(
    edits=st.lists(st.one_of(fills(), gaps().map(Edit.clear)), min_size=1, max_size=5),
    text=st.text(),
)
def test_edits_come_back(small: Document, edits: list[Edit], text: str) -> None:
    event = json.loads(json.dumps(encode(text, edits)))
    again_text, again = decode(event, small.original)
    assert again_text == text
    assert [edit.gap for edit in again] == [edit.gap for edit in edits]
    for one, other in zip(edits, again, strict=True):
        assert same_bits(one.values, other.values)
        assert same_bits(one.states, other.states)
        assert (one.repair is None) == (other.repair is None)
        if one.repair is not None and other.repair is not None:
            assert one.repair.method == other.repair.method
            assert one.repair.params == other.repair.params
            assert one.repair.patch.gap == other.repair.patch.gap
            for name in ("values", "sigma", "r90"):
                assert same_bits(getattr(one.repair.patch, name), getattr(other.repair.patch, name))


@pytest.mark.parametrize(
    ("name", "value"),
    [
        ("step", 3),
        ("gaps", _pack([np.array([[MARKERS, 2, 5]])], "<i8")),
        ("gaps", _pack([np.array([[-1, 2, 5]])], "<i8")),
        ("gaps", _pack([np.array([[0, -1, 2]])], "<i8")),
        ("gaps", _pack([np.array([[0, FRAMES - 2, FRAMES + 1]])], "<i8")),
        ("gaps", _pack([np.array([[0, 5, 2]])], "<i8")),
        ("gaps", _pack([np.array([[0, -(2**63), 2**63 - 1]])], "<i8")),
        ("gaps", _pack([np.array([[0, 2]])], "<i8")),
        ("gaps", ""),
        ("gaps", "no base64!"),
        ("gaps", ["AAAA"]),
        ("gaps", None),
        ("values", _pack([np.zeros((2, 3))], "<f8")),
        ("values", _pack([np.full((3, 3), np.nan)], "<f8")),
        ("values", _pack([np.full((3, 3), np.inf)], "<f8")),
        ("values", _pack([np.zeros(1)], "<f8")[:-4]),
        ("states", _pack([np.full(3, 9)], "u1")),
        ("states", _pack([np.full(3, SampleState.MISSING)], "u1")),
        ("states", _pack([np.full(4, SampleState.FILLED)], "u1")),
        ("fills", _pack([np.array([1])], "<i4")),
        ("fills", _pack([np.array([-2])], "<i4")),
        ("fills", _pack([np.array([0, 0])], "<i4")),
        ("ways", [["unknown", {}]]),
        ("ways", [["linear", {"unknown": 1}]]),
        ("ways", [["linear", 7]]),
        ("ways", [["constant", {"hold": ["before"]}]]),
        ("ways", [[["linear"], {}]]),
        ("ways", [3]),
        ("sigma", _pack([np.zeros(4)], "<f8")),
        ("r90", ""),
    ],
)
def test_what_does_not_fit_the_recording_is_refused(
    small: Document, name: str, value: object
) -> None:
    event = fitting()
    decode(event, small.original)
    with pytest.raises((AttributeError, KeyError, TypeError, ValueError)):
        decode({**event, name: value}, small.original)
    with pytest.raises(KeyError):
        decode({key: each for key, each in event.items() if key != name}, small.original)


def fitting() -> Event:
    patch = Patch(Gap(0, 2, 5), np.ones((3, 3)), np.ones(3), np.ones(3))
    return encode("fill", [Edit.fill(patch, "linear", LinearParams())])
