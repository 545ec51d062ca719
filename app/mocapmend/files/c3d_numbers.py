"""Numbers as the three kinds of processor store them in a C3D file.

Intel and DEC store little-endian, MIPS big-endian. A DEC float (VAX F) has its two 16-bit words
swapped against an Intel one, and reads four times too large as an IEEE float.
"""

from enum import IntEnum

import numpy as np
from numpy.typing import NDArray

FLOAT32_MAX = float(np.finfo(np.float32).max)


class Processor(IntEnum):
    """The processor whose number formats a file uses, by its code in the parameter section."""

    INTEL = 84
    DEC = 85
    MIPS = 86

    @property
    def byte_order(self) -> str:
        """The numpy code of the byte order."""
        return ">" if self is Processor.MIPS else "<"

    @property
    def largest(self) -> float:
        """The largest magnitude that `encode_floats` can store."""
        return FLOAT32_MAX / 4.0 if self is Processor.DEC else FLOAT32_MAX


def decode_floats(raw: bytes | NDArray[np.uint8], processor: Processor) -> NDArray[np.float32]:
    """Decode four-byte floats.

    Parameters
    ----------
    raw : bytes or ndarray of uint8, contiguous along the last axis
        A multiple of four bytes; an array keeps its leading axes.
    processor : Processor
        The format.

    Returns
    -------
    ndarray of float32
        Native, or a view of `raw` in the byte order of the file.
    """
    array = np.frombuffer(raw, np.uint8) if isinstance(raw, bytes) else raw
    if processor is not Processor.DEC:
        return array.view(processor.byte_order + "f4")
    bits = array.view("<u4")
    swapped = ((bits >> np.uint32(16)) | (bits << np.uint32(16))).view(np.float32)
    return np.asarray(swapped * np.float32(0.25), np.float32)


def encode_floats(values: NDArray[np.float32], processor: Processor) -> NDArray[np.uint8]:
    """Encode floats so that `decode_floats` returns exactly them; 4 bytes along the last axis.

    Magnitudes above `Processor.largest` are the caller's to refuse.
    """
    if processor is not Processor.DEC:
        return np.ascontiguousarray(values, processor.byte_order + "f4").view(np.uint8)
    bits = np.ascontiguousarray(values * np.float32(4.0)).view(np.uint32)
    swapped = (bits >> np.uint32(16)) | (bits << np.uint32(16))
    return np.ascontiguousarray(swapped, "<u4").view(np.uint8)


def decode_integers(
    raw: bytes | NDArray[np.uint8], processor: Processor, *, unsigned: bool = False
) -> NDArray[np.int16] | NDArray[np.uint16]:
    """View two-byte integers; an array keeps its leading axes."""
    array = np.frombuffer(raw, np.uint8) if isinstance(raw, bytes) else raw
    return array.view(processor.byte_order + ("u2" if unsigned else "i2"))


def encode_integers(values: NDArray[np.int16], processor: Processor) -> NDArray[np.uint8]:
    """Encode two-byte integers; 2 bytes along the last axis."""
    return np.ascontiguousarray(values, processor.byte_order + "i2").view(np.uint8)
