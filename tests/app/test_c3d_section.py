"""Writing parameter sections: what is written is parsed again, in every number format."""

import io

import numpy as np
import pytest
from hypothesis import given
from hypothesis import strategies as st
from hypothesis.extra.numpy import arrays

from mocapmend.errors import MocapmendError
from mocapmend.files.c3d_header import read_header
from mocapmend.files.c3d_layout import read_layout
from mocapmend.files.c3d_numbers import Processor
from mocapmend.files.c3d_parameters import Parameters, parse_parameters
from mocapmend.files.c3d_section import (
    float_header,
    float_record,
    group_record,
    integer_record,
    parameter_section,
    text_record,
    text_records,
)

each_processor = pytest.mark.parametrize("processor", list(Processor))
FLOATS = st.floats(-(2.0**120), 2.0**120, width=32, allow_subnormal=False)


def parsed(records: list[bytes], processor: Processor) -> Parameters:
    raw = group_record(7, "GROUP", processor, "for µ people") + b"".join(records)
    return parse_parameters(raw + b"\0\0", 0, processor)


@each_processor
@given(arrays(np.int64, st.integers(0, 255), elements=st.integers(-32768, 65535)))
def test_integers(processor: Processor, values: np.ndarray) -> None:
    parameters = parsed([integer_record(7, "N", values, processor)], processor)
    np.testing.assert_array_equal(
        parameters.numbers("GROUP:N", unsigned=True), np.where(values < 0, values + 65536, values)
    )


@each_processor
@given(arrays(np.float32, st.tuples(st.integers(0, 255), st.integers(1, 3)), elements=FLOATS))
def test_floats_with_the_last_axis_first(processor: Processor, values: np.ndarray) -> None:
    parameters = parsed([float_record(7, "X", values, processor)], processor)
    assert parameters["GROUP:X"].dimensions == values.shape[::-1]
    np.testing.assert_array_equal(parameters.numbers("GROUP:X"), values.ravel())


@each_processor
def test_single_values_have_no_dimensions(processor: Processor) -> None:
    records = [
        integer_record(7, "N", 65535, processor),
        float_record(7, "X", -2.5, processor),
        text_record(7, "T", b"some text", processor),
    ]
    parameters = parsed(records, processor)
    assert [parameters[f"GROUP:{name}"].dimensions for name in "NXT"] == [(), (), (9,)]
    assert parameters.number("GROUP:N", unsigned=True) == 65535
    assert parameters.number("GROUP:X") == -2.5
    assert parameters.texts("GROUP:T") == ("some text",)


@each_processor
@given(st.lists(st.text("aäµ本😀 -_:", max_size=60).map(str.strip), min_size=1, max_size=700))
def test_texts_of_any_number(processor: Processor, texts: list[str]) -> None:
    records = text_records(7, "T", [text.encode() for text in texts], processor)
    assert parsed(records, processor).texts("GROUP:T") == tuple(texts)


def test_records_of_long_texts_stay_below_the_links_of_other_readers() -> None:
    rows = [b"%03d" % i + bytes(range(60, 120)) * 4 for i in range(300)]
    records = text_records(7, "T", rows, Processor.INTEL)
    assert max(map(len, records)) <= 32767
    assert len(parsed(records, Processor.INTEL).texts("GROUP:T")) == 300


def test_no_texts_are_an_empty_table() -> None:
    (record,) = text_records(7, "T", [], Processor.INTEL)
    parameters = parsed([record], Processor.INTEL)
    assert parameters["GROUP:T"].dimensions == (1, 0)
    assert parameters.texts("GROUP:T") == ()


@pytest.mark.parametrize("number", [-32769, 65536])
def test_numbers_of_more_than_16_bits(number: int) -> None:
    with pytest.raises(ValueError, match="16 bits"):
        integer_record(1, "N", number, Processor.INTEL)


def test_dimensions_of_more_than_a_byte() -> None:
    with pytest.raises(ValueError, match="above 255"):
        integer_record(1, "N", np.zeros(256), Processor.INTEL)
    with pytest.raises(ValueError, match="above 255"):
        text_record(1, "T", [b"a" * 256], Processor.INTEL)
    with pytest.raises(ValueError, match="above 255"):
        text_record(1, "T", [b"a"] * 256, Processor.INTEL)


def one_text(length: int) -> list[bytes]:
    rows = [b"x" * 255] * (length // 255)
    return [group_record(1, "GROUP", Processor.MIPS), *text_records(1, "T", rows, Processor.MIPS)]


def test_a_section_of_255_blocks_and_no_more() -> None:
    section = parameter_section(lambda _: one_text(130_305), Processor.MIPS, "some.c3d")
    assert len(section) == 255 * 512
    with pytest.raises(MocapmendError, match=r"some\.c3d.*room for 130560"):
        parameter_section(lambda _: one_text(130_560), Processor.MIPS, "some.c3d")


@each_processor
def test_header_and_section_make_a_file(processor: Processor) -> None:
    def records(data_block: int) -> list[bytes]:
        return [
            group_record(1, "POINT", processor),
            integer_record(1, "USED", 2, processor),
            integer_record(1, "DATA_START", data_block, processor),
            float_record(1, "SCALE", -1.0, processor),
            float_record(1, "RATE", 120.0, processor),
        ]

    section = parameter_section(records, processor, "")
    header = float_header(
        points=2, analog=0, first=70_001, last=70_002, data_block=3, analog_samples=1,
        rate=120.0, processor=processor,
    )  # fmt: skip
    words = read_header(header, processor)
    assert (words.first, words.last, words.points, words.analog) == (65535, 65535, 2, 0)
    raw = header + section + bytes(2 * 2 * 16)
    layout = read_layout(io.BytesIO(raw), len(raw), "")
    assert (layout.processor, layout.data_start, layout.rate) == (processor, 1024, 120.0)
    assert (layout.is_float, layout.scale, layout.points) == (True, 1.0, 2)
