"""The synthetic recording in each of the six encodings of a C3D file."""

import struct
from math import prod

import numpy as np

from mocapmend.files.c3d_header import BLOCK
from mocapmend.files.c3d_layout import Layout
from mocapmend.files.c3d_numbers import Processor, encode_floats, encode_integers
from mocapmend.files.c3d_parameters import FLOAT, INTEGER

SCALE = 0.1
"""Length per step of the integers."""


def transcode(raw: bytes, layout: Layout, processor: Processor, *, is_float: bool) -> bytes:
    """Write an Intel float C3D, whose scale is -1, in another encoding.

    Parameters
    ----------
    raw : bytes
        The file, made by `write_recording`.
    layout : Layout
        Its layout.
    processor : Processor
        The number format of the result.
    is_float : bool
        Whether it holds floats.

    Returns
    -------
    bytes
        The file; integers are rounded.
    """
    scale = _floats(np.array([-1.0 if is_float else SCALE]), processor)
    head = bytearray(raw[: layout.data_start])
    _swap_words(head, 2, BLOCK, processor)
    head[12:16] = scale
    head[20:24] = _floats(np.array([layout.rate]), processor)
    head[BLOCK + 3] = processor
    _transcode_parameters(head, processor, scale)
    count = layout.frames * layout.frame_bytes // 4
    words = np.frombuffer(raw, "<f4", count, layout.data_start).reshape(layout.frames, -1)
    if is_float:
        data = _floats(words, processor)
    else:
        data = encode_integers(_steps(words, layout.points), processor).tobytes()
    return bytes(head) + data.ljust(-(-len(data) // BLOCK) * BLOCK, b"\0")


def _floats(values: np.ndarray, processor: Processor) -> bytes:
    return encode_floats(np.asarray(values, np.float32), processor).tobytes()


def _steps(words: np.ndarray, points: int) -> np.ndarray:
    """Return coordinates and analog values in steps of the scale, fourth words as they are."""
    factor = np.full(words.shape[1], 1 / SCALE)
    factor[3 : 4 * points : 4] = 1.0
    steps: np.ndarray = np.rint(words * factor).astype(np.int16)
    return steps


def _swap_words(raw: bytearray, start: int, stop: int, processor: Processor) -> None:
    """Turn the 16-bit words of a little-endian range round, where the processor has them so."""
    if processor is Processor.MIPS:
        raw[start:stop] = np.frombuffer(bytes(raw[start:stop]), "<u2").astype(">u2").tobytes()


def _transcode_parameters(raw: bytearray, processor: Processor, scale: bytes) -> None:
    """Write the numbers of the parameter section in another format, and the scale of points."""
    at = BLOCK + 4
    while raw[at]:
        length, group = struct.unpack_from("bb", raw, at)
        name, link = bytes(raw[at + 2 : at + 2 + length]), at + 2 + length
        (offset,) = struct.unpack_from("<H", raw, link)
        if group > 0:
            kind, dimensions = struct.unpack_from("bB", raw, link + 2)
            start = link + 4 + dimensions
            stop = start + abs(kind) * prod(raw[link + 4 : start])
            if kind == INTEGER:
                _swap_words(raw, start, stop, processor)
            elif (group, name) == (1, b"SCALE"):
                raw[start:stop] = scale
            elif kind == FLOAT:
                raw[start:stop] = _floats(np.frombuffer(bytes(raw[start:stop]), "<f4"), processor)
        _swap_words(raw, link, link + 2, processor)
        at = link + offset
