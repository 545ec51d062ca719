"""Undo commands come back from JSON to the bit, and only those that fit the recording."""

import json
from dataclasses import replace

import numpy as np
import pytest
from hypothesis import HealthCheck, given, settings
from hypothesis import strategies as st

from mocapmend.document import Document
from mocapmend.edits import Edit, Repair
from mocapmend.journal.edits import decode, encode
from mocapmend.journal.file import Record
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
    patch = Patch(gap, np.reshape(values, (-1, 3)), sigma, r90)
    edit = Edit.fill(patch, method, PARAMS[method])
    donors = tuple(draw(st.lists(st.text(), max_size=2)))
    return replace(edit, repair=Repair(method, PARAMS[method], patch, donors))


@st.composite
def gaps(draw: st.DrawFn) -> Gap:
    start = draw(st.integers(0, FRAMES - 1))
    return Gap(draw(st.integers(0, MARKERS - 1)), start, draw(st.integers(start + 1, FRAMES)))


@st.composite
def kept_open(draw: st.DrawFn) -> Edit:
    state = draw(st.sampled_from([SampleState.MISSING, SampleState.NEVER]))
    return Edit.clear(draw(gaps()), state, draw(st.none() | st.text()))


def same_bits(one: np.ndarray, other: np.ndarray) -> bool:
    return (
        one.dtype == other.dtype and one.shape == other.shape and one.tobytes() == other.tobytes()
    )


@settings(suppress_health_check=[HealthCheck.function_scoped_fixture])
@given(
    edits=st.lists(st.one_of(fills(), kept_open()), min_size=1, max_size=5),
    text=st.text(),
)
def test_edits_come_back(small: Document, edits: list[Edit], text: str) -> None:
    event, data = encode(text, edits)
    again_text, again = decode(json.loads(json.dumps(event)), data, small.original)
    assert again_text == text
    assert [edit.gap for edit in again] == [edit.gap for edit in edits]
    for one, other in zip(edits, again, strict=True):
        assert same_bits(one.values, other.values)
        assert same_bits(one.states, other.states)
        assert one.reason == other.reason
        assert (one.repair is None) == (other.repair is None)
        if one.repair is not None and other.repair is not None:
            assert one.repair.method == other.repair.method
            assert one.repair.params == other.repair.params
            assert one.repair.donors == other.repair.donors
            assert one.repair.patch.gap == other.repair.patch.gap
            for name in ("values", "sigma", "r90"):
                assert same_bits(getattr(one.repair.patch, name), getattr(other.repair.patch, name))


def record_of(
    *,
    corners: tuple[int, ...] = (0, 2, 5),
    fill: int = 0,
    state: int = SampleState.FILLED,
    value: float = 1.0,
    samples: int = 3,
    filled: int = 3,
    more: bytes = b"",
    **fields: object,
) -> Record:
    """Return the record of one fill, or of what is none."""
    event = {"step": "fill", "ways": [["linear", {}, []]], "gaps": 1, "samples": 3, "filled": 3}
    data = (
        np.array(corners, "<i8"),
        np.array([fill], "<i4"),
        np.full(samples, state, "u1"),
        np.full(3 * samples, value, "<f8"),
        np.full(2 * filled, 0.5, "<f8"),
    )
    return {**event, **fields}, b"".join(part.tobytes() for part in data) + more


def test_the_layout_is_as_in_the_journals_of_before(small: Document) -> None:
    text, (edit,) = decode(*record_of(), small.original)
    assert text == "fill"
    assert edit.gap == Gap(0, 2, 5)
    assert (edit.values == 1.0).all()
    assert edit.repair is not None
    assert edit.repair.params == LinearParams()
    assert edit.repair.patch.sigma.tolist() == edit.repair.patch.r90.tolist() == [0.5, 0.5, 0.5]
    assert encode(text, [edit]) == record_of(ways=[["linear", {"edges": "leave"}, []]])


def missing(state: int = SampleState.MISSING, **fields: object) -> Record:
    """Return the record of one gap."""
    event, data = record_of(fill=-1, state=state, value=np.nan, filled=0, **fields)
    return {**event, "ways": [], "filled": 0}, data


def test_reasons_are_beside_the_layout_of_before(small: Document) -> None:
    step = [Edit.clear(Gap(0, 2, 5)), Edit.clear(Gap(0, 2, 5), SampleState.NEVER)]
    for edit in step:
        state = int(edit.states[0])
        assert encode("x", [edit]) == missing(state, step="x")
        (again,) = decode(*missing(state), small.original)[1]
        assert again.reason is None
        said = replace(edit, reason="it fell off")
        assert encode("x", [said]) == missing(state, step="x", reasons={"0": said.reason})


@pytest.mark.parametrize(
    "record",
    [
        record_of(step=3),
        record_of(corners=(MARKERS, 2, 5)),
        record_of(corners=(-1, 2, 5)),
        record_of(corners=(0, -1, 2)),
        record_of(corners=(0, FRAMES - 2, FRAMES + 1)),
        record_of(corners=(0, 5, 2)),
        record_of(corners=(0, -(2**63), 2**63 - 1)),
        record_of(corners=(0, 2, 6)),
        record_of(corners=(0, 2)),
        record_of(gaps=0, corners=(), samples=0, filled=0),
        record_of(gaps=-1),
        record_of(gaps=1.0),
        record_of(gaps=True),
        record_of(gaps=None),
        record_of(gaps=10**300),
        record_of(samples=2),
        record_of(samples=4),
        record_of(filled=2),
        record_of(more=b"x"),
        record_of(value=np.nan),
        record_of(value=np.inf),
        record_of(state=9),
        record_of(state=SampleState.MISSING),
        record_of(fill=1),
        record_of(fill=-2),
        record_of(fill=-1),
        record_of(ways=[]),
        record_of(ways=[["unknown", {}, []]]),
        record_of(ways=[["linear", {"unknown": 1}, []]]),
        record_of(ways=[["linear", 7, []]]),
        record_of(ways=[["constant", {"hold": ["before"]}, []]]),
        record_of(ways=[[["linear"], {}, []]]),
        record_of(ways=[["linear", {}]]),
        record_of(ways=[["linear", {}, 5]]),
        record_of(ways=[["linear", {}, [5]]]),
        record_of(ways=[3]),
        record_of(reasons={"0": "of a fill"}),
        missing(reasons={"1": "of none"}),
        missing(reasons={"-1": "of none"}),
        missing(reasons={"first": "of none"}),
        missing(reasons={"0": 7}),
        missing(reasons=["a list"]),
        ({"step": "fill"}, b""),
    ],
)
def test_what_does_not_fit_the_recording_is_refused(small: Document, record: Record) -> None:
    with pytest.raises((AttributeError, KeyError, TypeError, ValueError)):
        decode(*record, small.original)
