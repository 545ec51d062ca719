"""A large recording for the benchmarks: real format, invented motion."""

from pathlib import Path

import numpy as np

from mocapmend.files.c3d_header import BLOCK
from mocapmend.files.c3d_numbers import Processor
from mocapmend.files.c3d_section import (
    LARGEST_WORD,
    float_header,
    float_record,
    group_record,
    integer_record,
    parameter_section,
    text_record,
    text_records,
)

INTEL = Processor.INTEL


def write_recording(
    path: Path,
    *,
    frames: int,
    markers: int,
    analog: int = 0,
    analog_per_frame: int = 10,
    gaps: int = 0,
    rate: float = 200.0,
    seed: int = 1,
) -> None:
    """Write an Intel float C3D of walking sine waves.

    Parameters
    ----------
    path : Path
        Where the file goes.
    frames, markers : int
        Size of the recording.
    analog : int
        Analog channels.
    analog_per_frame : int
        Analog samples of each channel per frame.
    gaps : int
        Missing runs of 3 to 60 frames, spread over all markers.
    rate : float
        Frames per second.
    seed : int
        The same seed gives the same bytes.
    """
    parameters = parameter_section(
        lambda block: _records(frames, markers, analog, analog_per_frame, rate, block),
        INTEL,
        str(path),
    )
    header = float_header(
        points=markers,
        analog=analog * analog_per_frame,
        first=1,
        last=frames,
        data_block=2 + len(parameters) // BLOCK,
        analog_samples=analog_per_frame,
        rate=rate,
        processor=INTEL,
    )
    rng = np.random.default_rng(seed)
    missing = _missing(rng, frames, markers, gaps)
    width = 4 * markers + analog * analog_per_frame
    with path.open("wb") as file:
        file.write(header)
        file.write(parameters)
        for start in range(0, frames, 4096):
            stop = min(frames, start + 4096)
            block = np.zeros((stop - start, width), np.float32)
            points = block[:, : 4 * markers].reshape(stop - start, markers, 4)
            points[:, :, :3] = _motion(np.arange(start, stop) / rate, markers)
            points[missing[start:stop]] = (0.0, 0.0, 0.0, -1.0)
            block[:, 4 * markers :] = rng.normal(size=(stop - start, width - 4 * markers))
            block.tofile(file)
        file.write(b"\0" * (-file.tell() % BLOCK))


def _motion(seconds: np.ndarray, markers: int) -> np.ndarray:
    order = np.arange(markers)
    phase = 2 * np.pi * (seconds[:, None] * (0.8 + 0.004 * order) + 0.37 * order)
    x = 900.0 * np.sin(0.2 * seconds)[:, None] + 120.0 * np.sin(phase)
    y = 40.0 * (order % 5) + 60.0 * np.cos(phase)
    z = 60.0 + 1700.0 * order / max(1, markers) + 25.0 * np.sin(2 * phase)
    return np.stack((x, y, z), axis=2)


def _missing(rng: np.random.Generator, frames: int, markers: int, gaps: int) -> np.ndarray:
    missing = np.zeros((frames, markers), bool)
    for marker, start, length in zip(
        rng.integers(0, markers, gaps),
        rng.integers(5, max(6, frames - 70), gaps),
        rng.integers(3, 61, gaps),
        strict=True,
    ):
        missing[start : start + length, marker] = True
    return missing


def _records(
    frames: int, markers: int, analog: int, per_frame: int, rate: float, data_block: int
) -> list[bytes]:
    """Return the records of the parameter section."""

    def texts(group: int, name: str, letter: str, count: int) -> list[bytes]:
        rows = [f"{letter}{k:03d}".encode() for k in range(count)]
        return text_records(group, name, rows, INTEL)

    return [
        group_record(1, "POINT", INTEL),
        integer_record(1, "USED", markers, INTEL),
        integer_record(1, "DATA_START", data_block, INTEL),
        float_record(1, "SCALE", -1.0, INTEL),
        float_record(1, "RATE", rate, INTEL),
        integer_record(1, "FRAMES", min(frames, LARGEST_WORD), INTEL),
        text_record(1, "UNITS", b"mm", INTEL),
        *texts(1, "LABELS", "M", markers),
        text_record(1, "X_SCREEN", b"+X", INTEL),
        text_record(1, "Y_SCREEN", b"+Z", INTEL),
        group_record(2, "ANALOG", INTEL),
        integer_record(2, "USED", analog, INTEL),
        float_record(2, "RATE", rate * per_frame, INTEL),
        float_record(2, "GEN_SCALE", 1.0, INTEL),
        *texts(2, "LABELS", "A", analog),
        float_record(2, "SCALE", np.ones(analog), INTEL),
        integer_record(2, "OFFSET", np.zeros(analog), INTEL),
        group_record(3, "TRIAL", INTEL),
        integer_record(3, "ACTUAL_START_FIELD", [1, 0], INTEL),
        integer_record(3, "ACTUAL_END_FIELD", divmod(frames, 65_536)[::-1], INTEL),
    ]
