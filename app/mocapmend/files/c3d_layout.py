"""Where everything lies in a C3D file."""

from dataclasses import dataclass
from typing import BinaryIO

from mocapmend.errors import MocapmendError
from mocapmend.files.c3d_header import (
    BLOCK,
    Header,
    analog_shape,
    first_frame,
    frame_rate,
    point_scale,
    read_header,
    sample_counts,
)
from mocapmend.files.c3d_numbers import Processor
from mocapmend.files.c3d_parameters import Parameters, parse_parameters
from mocapmend.files.opening import ANOTHER_FILE, cannot_read

MAGIC = 0x50
LONGEST_SECTION = 1 << 18


@dataclass(frozen=True, eq=False)
class Layout:
    """Where the samples of a file are and how they are stored.

    Attributes
    ----------
    size : int
        Bytes in the file.
    processor : Processor
        The number format.
    is_float : bool
        Whether samples are floats (four bytes) or integers (two).
    scale : float
        Length per integer step, and the unit of residuals; positive.
    data_start : int
        The byte where the first frame begins.
    points : int
        Points per frame, markers and model outputs together.
    channels, analog_samples : int
        Analog channels, and samples of each per frame.
    frames : int
        Whole frames that the file holds.
    frames_promised : int
        Frames that the file says it holds.
    rate : float
        Frames per second (Hz).
    first_frame : int
        Number of the first frame as the file counts it.
    header : Header
        What the first block says.
    parameters_start : int
        The byte where the parameter section begins.
    parameters : Parameters
        The decoded parameters.
    warnings : tuple of str
        What was odd and what was assumed, as sentences.
    """

    size: int
    processor: Processor
    is_float: bool
    scale: float
    data_start: int
    points: int
    channels: int
    analog_samples: int
    frames: int
    frames_promised: int
    rate: float
    first_frame: int
    header: Header
    parameters_start: int
    parameters: Parameters
    warnings: tuple[str, ...]

    @property
    def word(self) -> int:
        """Bytes per stored number."""
        return 4 if self.is_float else 2

    @property
    def slot(self) -> int:
        """Bytes per stored point: x, y, z and the fourth word."""
        return 4 * self.word

    @property
    def frame_bytes(self) -> int:
        """Bytes per frame, points and analog together."""
        return self.word * (4 * self.points + self.channels * self.analog_samples)

    @property
    def data_stop(self) -> int:
        """The byte after the last whole frame."""
        return self.data_start + self.frames * self.frame_bytes

    @property
    def truncated(self) -> bool:
        """Whether the file holds fewer frames than it says."""
        return self.frames < self.frames_promised

    @property
    def analog_rate(self) -> float:
        """Analog samples per second and channel (Hz), 0 without analog."""
        return self.rate * self.analog_samples


def read_layout(stream: BinaryIO, size: int, where: str) -> Layout:
    """Read header and parameter section.

    Parameters
    ----------
    stream : binary file
        The file.
    size : int
        Its size in bytes.
    where : str
        Its name for messages.

    Raises
    ------
    MocapmendError
        If it cannot be read, is not a C3D file, or its damage leaves no way to find the data.
    """
    try:
        return _read_layout(stream, size, where)
    except OSError as error:
        raise cannot_read(where, error) from error


def _read_layout(stream: BinaryIO, size: int, where: str) -> Layout:
    warnings: list[str] = []
    stream.seek(0)
    block = stream.read(BLOCK)
    start, processor = _find_parameters(stream, block, size, where)
    header = read_header(block, processor)
    parameters = _read_parameters(stream, start, processor, header)
    if parameters.duplicates:
        names = ", ".join(sorted(set(parameters.duplicates))[:5])
        warnings.append(f"Parameters occur more than once, and the first is used: {names}.")
    data_start = _data_start(header, parameters, start, size, where, warnings)
    available = max((start if data_start < start else size) - data_start, 0)
    scale = point_scale(header, parameters, warnings)
    word = 4 if scale < 0 else 2
    points, analog, frames, promised = sample_counts(header, parameters, available, word, warnings)
    channels, samples = analog_shape(header, parameters, analog, warnings)
    return Layout(
        size=size,
        processor=processor,
        is_float=scale < 0,
        scale=abs(scale),
        data_start=data_start,
        points=points,
        channels=channels,
        analog_samples=samples,
        frames=frames,
        frames_promised=promised,
        rate=frame_rate(header, parameters, warnings),
        first_frame=first_frame(header, parameters, warnings),
        header=header,
        parameters_start=start,
        parameters=parameters,
        warnings=tuple(warnings),
    )


def _find_parameters(
    stream: BinaryIO, block: bytes, size: int, where: str
) -> tuple[int, Processor]:
    if size == 0:
        raise MocapmendError("The file is empty.", where, ANOTHER_FILE)
    if len(block) < 2 or block[1] != MAGIC:
        raise MocapmendError("This is not a C3D file.", where, ANOTHER_FILE)
    start = (max(block[0], 1) - 1) * BLOCK
    stream.seek(start)
    lead = stream.read(4)
    if len(block) < BLOCK or len(lead) < 4 or start < BLOCK:
        raise MocapmendError(
            "The file ends before its parameter section, or does not say where that is.",
            where,
            ANOTHER_FILE,
        )
    try:
        return start, Processor(lead[3])
    except ValueError:
        raise MocapmendError(
            f"The file names an unknown number format ({lead[3]}).", where, ANOTHER_FILE
        ) from None


def _read_parameters(
    stream: BinaryIO, start: int, processor: Processor, header: Header
) -> Parameters:
    stream.seek(start)
    lead = stream.read(4)
    # Some files declare too few blocks: what lies before the data belongs to the section too.
    stop = max(start + lead[2] * BLOCK, (header.data_block - 1) * BLOCK)
    raw = stream.read(min(stop - start - 4, LONGEST_SECTION)) if stop > start + 4 else b""
    return parse_parameters(raw, start + 4, processor)


def _data_start(
    header: Header,
    parameters: Parameters,
    start: int,
    size: int,
    where: str,
    warnings: list[str],
) -> int:
    """Find the first data byte: the header's word, else the parameter, else what follows."""
    stated = int(parameters.number("POINT:DATA_START", unsigned=True) or 0)
    outside = False
    for block in (header.data_block, stated):
        offset = (block - 1) * BLOCK
        if BLOCK <= offset <= start - BLOCK or parameters.stop <= offset <= size:
            if stated not in {0, header.data_block}:
                warnings.append(
                    f"The header puts the data at block {header.data_block} and "
                    f"POINT:DATA_START at block {stated}; {block} is used."
                )
            return offset
        outside = outside or offset > size
    if outside or parameters.stop > size:
        raise MocapmendError("The file ends before its data begin.", where, ANOTHER_FILE)
    offset = min(-(-parameters.stop // BLOCK) * BLOCK, size)
    warnings.append(
        "The file does not say where its data begin; they are taken to follow the parameters."
    )
    return offset
