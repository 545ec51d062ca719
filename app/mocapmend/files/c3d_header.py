"""What header and parameters of a C3D file say, and which to believe.

They repeat each other, and in real files they disagree; every disagreement leaves a warning.
"""

import struct
from dataclasses import dataclass
from itertools import product

import numpy as np

from mocapmend.files.c3d_numbers import Processor, decode_floats
from mocapmend.files.c3d_parameters import Parameters

MOST_FIRST = 1_000_000_000
"""No recording is that long: a larger number of the first frame is damage."""
HIGHEST_RATE = 1e6
BLOCK = 512
ASSUMED_RATE = 100.0


@dataclass(frozen=True)
class Header:
    """What the first block of the file says.

    Attributes
    ----------
    analog : int
        Analog values per frame, all channels together.
    first, last : int
        The first and last frame.
    scale : float
        Length per integer step; negative if the file holds floats.
    data_block : int
        The block where the data begin, counted from 1.
    analog_samples : int
        Analog samples per frame and channel.
    label_ranges_key : int
        Says whether the file has a section of labels and ranges.
    event_words : bytes
        The part of the block that holds events.
    """

    points: int
    analog: int
    first: int
    last: int
    scale: float
    data_block: int
    analog_samples: int
    rate: float
    label_ranges_key: int
    event_words: bytes


def read_header(block: bytes, processor: Processor) -> Header:
    """Decode the first block of a file."""
    points, analog, first, last, _ = struct.unpack_from(processor.byte_order + "5H", block, 2)
    data_block, samples = struct.unpack_from(processor.byte_order + "2H", block, 16)
    scale, _, rate = decode_floats(block[12:24], processor).tolist()
    (key,) = struct.unpack_from(processor.byte_order + "H", block, 294)
    return Header(
        points, analog, first, last, scale, data_block, samples, rate, key, block[298:468]
    )


def point_scale(header: Header, parameters: Parameters, warnings: list[str]) -> float:
    """Return the scale; negative for floats.

    Where header and parameter differ, integers follow the header (with the parameter the people
    of a real file of Motion Analysis are 60 cm tall) and floats, of which the scale gives only
    the residuals, the parameter (with the header those of a real file are 50 mm).
    """
    stated = parameters.number("POINT:SCALE")
    order = (stated, header.scale) if (stated or 0) < 0 else (header.scale, stated)
    usable = [v for v in order if v is not None and 1e-12 < abs(v) < 1e12]
    if not usable:
        warnings.append("The file states no usable scale; floats in its own unit are assumed.")
        return -1.0
    if stated is not None and stated != header.scale:
        warnings.append(
            f"The header's scale ({header.scale:g}) and POINT:SCALE ({stated:g}) differ; "
            f"{usable[0]:g} is used."
        )
    return usable[0]


def frame_rate(header: Header, parameters: Parameters, warnings: list[str]) -> float:
    """Return the frames per second: the parameter's, else the header's."""
    stated = parameters.number("POINT:RATE")
    usable = [v for v in (stated, header.rate) if v is not None and 0 < v < HIGHEST_RATE]
    if not usable:
        warnings.append(f"The file states no frame rate; {ASSUMED_RATE:g} Hz is assumed.")
        return ASSUMED_RATE
    if stated is not None and stated != header.rate:
        warnings.append(
            f"The header's frame rate ({header.rate:g} Hz) and POINT:RATE ({stated:g} Hz) "
            f"differ; {usable[0]:g} Hz is used."
        )
    return usable[0]


def _two_words(parameters: Parameters, key: str) -> int | None:
    """Read a frame number that is stored as low and high 16 bits."""
    words = parameters.numbers(key, unsigned=True)
    if len(words) == 0 or not np.isfinite(words).all():
        return None
    value = int(words[0]) + (65536 * int(words[1]) if len(words) > 1 else 0)
    return value if 0 <= value < 2**32 else None


def first_frame(header: Header, parameters: Parameters, warnings: list[str]) -> int:
    """Return the number of the first frame; the header's has only 16 bits."""
    stated = _two_words(parameters, "TRIAL:ACTUAL_START_FIELD")
    if stated is None:
        return header.first
    if stated > MOST_FIRST:
        warnings.append(
            f"TRIAL:ACTUAL_START_FIELD says that the first frame is {stated}; the header's "
            f"{header.first} is used."
        )
        return header.first
    if header.first not in {stated % 65536, 65535}:
        warnings.append(
            f"The header's first frame ({header.first}) and TRIAL:ACTUAL_START_FIELD ({stated}) "
            f"differ; {stated} is used."
        )
    return stated


def _frame_counts(header: Header, parameters: Parameters) -> list[tuple[str, int]]:
    """Return the differing statements of the number of frames, the most trusted first."""
    stated: list[tuple[str, int]] = []

    def add(name: str, count: int) -> None:
        # Words of 16 bits wrap round or stop at the largest number: that is no contradiction.
        known = any(
            count in {n, n % 65536} or (n > 65535 and count in {65534, 65535}) for _, n in stated
        )
        if 0 < count < 2**32 and not known:
            stated.append((name, count))

    first = _two_words(parameters, "TRIAL:ACTUAL_START_FIELD")
    last = _two_words(parameters, "TRIAL:ACTUAL_END_FIELD")
    if first is not None and last is not None:
        add("TRIAL:ACTUAL_END_FIELD", last - first + 1)
    for key in ("POINT:LONG_FRAMES", "POINT:FRAMES"):
        add(key, int(parameters.number(key, unsigned=True) or 0))
    if header.last != 65535 or not stated:
        add("the header", header.last - header.first + 1)
    return stated


def sample_counts(
    header: Header, parameters: Parameters, available: int, word: int, warnings: list[str]
) -> tuple[int, int, int, int]:
    """Find the numbers of points, analog values, frames stored and frames promised.

    Of contradicting statements about points and analog values, the pair is used with which the
    frames fill the available bytes best; of those about frames, the first that fits into them.
    """
    used = parameters.number("POINT:USED", unsigned=True)
    points_stated = [header.points] if used is None else [int(used), header.points]
    analog_stated = [header.analog, *_analog_from_parameters(header, parameters)]
    pairs = list(product(dict.fromkeys(points_stated), dict.fromkeys(analog_stated)))
    stated = _frame_counts(header, parameters)

    def fitting(points: int, analog: int) -> list[int]:
        return [n for _, n in stated if n * word * (4 * points + analog) <= available]

    def rank(pair: tuple[int, int]) -> int:
        counts = fitting(*pair)
        if not counts:
            return 2
        return int(available - counts[0] * word * (4 * pair[0] + pair[1]) >= BLOCK)

    points, analog = min(pairs, key=rank)
    if len(pairs) > 1:
        warnings.append(
            "Header and parameters disagree on the numbers of points and analog values per "
            f"frame; {points} and {analog} are used."
        )
    promised = next(iter([*fitting(points, analog), *(n for _, n in stated)]), 0)
    if len(stated) > 1:
        listed = ", ".join(f"{name} {count}" for name, count in stated)
        warnings.append(
            f"The file states different numbers of frames ({listed}); {promised} is used."
        )
    frame = word * (4 * points + analog)
    if frame == 0:
        return points, analog, 0, 0
    return points, analog, min(promised, available // frame), promised


def _analog_from_parameters(header: Header, parameters: Parameters) -> list[int]:
    used = parameters.number("ANALOG:USED", unsigned=True)
    return [] if used is None else [int(used) * max(header.analog_samples, 1)]


def analog_shape(
    header: Header, parameters: Parameters, analog: int, warnings: list[str]
) -> tuple[int, int]:
    """Split the analog values of a frame into channels and samples."""
    if analog == 0:
        return 0, 0
    used = int(parameters.number("ANALOG:USED", unsigned=True) or 0)
    samples = header.analog_samples
    if used and analog % used == 0:
        return used, analog // used
    if samples and analog % samples == 0:
        return analog // samples, samples
    warnings.append(
        f"The {analog} analog values of a frame cannot be split into channels; "
        "they are taken for one sample of each."
    )
    return analog, 1
