"""Numbers of the three processors, against struct and against bits written down by hand."""

import struct

import numpy as np
import pytest
from c3d_synthetic import dec_floats
from hypothesis import given
from hypothesis import strategies as st

from mocapmend.files.c3d_numbers import (
    Processor,
    decode_floats,
    decode_integers,
    encode_floats,
    encode_integers,
)

PROCESSORS = list(Processor)
NORMAL = st.floats(-(2.0**120), 2.0**120, width=32).filter(lambda x: x == 0 or abs(x) > 2e-38)


@pytest.mark.parametrize(
    ("value", "stored"),
    [
        (1.0, "8040 0000"),
        (-1.0, "80c0 0000"),
        (0.0, "0000 0000"),
        (0.5, "0040 0000"),
        (100.0, "c843 0000"),
        (-0.1, "ccbe cdcc"),
    ],
)
def test_dec_floats_by_hand(value: float, stored: str) -> None:
    raw = bytes.fromhex(stored)
    assert encode_floats(np.array([value], np.float32), Processor.DEC).tobytes() == raw
    assert decode_floats(raw, Processor.DEC)[0] == np.float32(value)


@given(st.lists(NORMAL, min_size=1))
def test_dec_floats_against_the_bits(values: list[float]) -> None:
    array = np.array(values, np.float32)
    array[array == 0] = 0.0
    assert encode_floats(array, Processor.DEC).tobytes() == dec_floats(array)


@given(st.lists(st.floats(width=32, allow_nan=False, allow_infinity=False), min_size=1))
@pytest.mark.parametrize("processor", PROCESSORS)
def test_floats_come_back_bit_for_bit(processor: Processor, values: list[float]) -> None:
    array = np.array(values, np.float32)
    array[np.abs(array) > processor.largest] = 1.0
    raw = encode_floats(array, processor)
    assert decode_floats(raw.tobytes(), processor).astype("<f4").tobytes() == array.tobytes()


@given(st.lists(st.integers(-32768, 32767), min_size=1))
@pytest.mark.parametrize("processor", PROCESSORS)
def test_integers_against_struct(processor: Processor, values: list[int]) -> None:
    raw = struct.pack(f"{processor.byte_order}{len(values)}h", *values)
    assert encode_integers(np.array(values, np.int16), processor).tobytes() == raw
    assert decode_integers(raw, processor).tolist() == values
    unsigned = [value % 65536 for value in values]
    assert decode_integers(raw, processor, unsigned=True).tolist() == unsigned


@pytest.mark.parametrize("processor", [Processor.INTEL, Processor.MIPS])
def test_ieee_floats_against_struct(processor: Processor) -> None:
    raw = struct.pack(f"{processor.byte_order}3f", 1.5, -0.1, 3e38)
    assert decode_floats(raw, processor).tolist() == np.array([1.5, -0.1, 3e38], "f4").tolist()
    assert encode_floats(np.array([1.5, -0.1, 3e38], np.float32), processor).tobytes() == raw


def test_an_array_keeps_its_leading_axes() -> None:
    raw = np.arange(2 * 3 * 8, dtype=np.uint8).reshape(2, 3, 8)
    for processor in PROCESSORS:
        assert decode_floats(raw, processor).shape == (2, 3, 2)
        assert decode_integers(raw, processor).shape == (2, 3, 4)
