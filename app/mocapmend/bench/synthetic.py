"""A large recording for the benchmarks: real format, invented motion."""

import struct
from pathlib import Path

import numpy as np

BLOCK = 512


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
    parameters = _parameters(frames, markers, analog, analog_per_frame, rate)
    data_block = 2 + len(parameters) // BLOCK
    header = bytearray(BLOCK)
    struct.pack_into("<BB4HHf", header, 0, 2, 80, markers, analog * analog_per_frame, 1,
                     min(frames, 65_535), 10, -1.0)  # fmt: skip
    struct.pack_into("<HHf", header, 16, data_block, analog_per_frame, rate)
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


def _parameters(frames: int, markers: int, analog: int, per_frame: int, rate: float) -> bytes:
    """Return the parameter section, padded to whole blocks."""
    labels = [f"M{k:03d}" for k in range(markers)]
    channels = [f"A{k:03d}" for k in range(analog)]
    halves = np.array([frames % 65_536, frames // 65_536], "<u2")
    entries = [
        _group(1, "POINT"),
        _number(1, "USED", "<h", markers),
        _number(1, "SCALE", "<f", -1.0),
        _number(1, "RATE", "<f", rate),
        _number(1, "FRAMES", "<H", min(frames, 65_535)),
        _texts(1, "UNITS", ["mm"]),
        _texts(1, "LABELS", labels),
        _texts(1, "X_SCREEN", ["+X"]),
        _texts(1, "Y_SCREEN", ["+Z"]),
        _group(2, "ANALOG"),
        _number(2, "USED", "<h", analog),
        _number(2, "RATE", "<f", rate * per_frame),
        _number(2, "GEN_SCALE", "<f", 1.0),
        _texts(2, "LABELS", channels),
        _array(2, "SCALE", np.ones(analog, "<f4"), 4),
        _array(2, "OFFSET", np.zeros(analog, "<i2"), 2),
        _group(3, "TRIAL"),
        _array(3, "ACTUAL_START_FIELD", np.array([1, 0], "<u2"), 2),
        _array(3, "ACTUAL_END_FIELD", halves, 2),
    ]
    # DATA_START depends on the size of the section that it stands in: it never changes that size.
    size = 4 + sum(map(len, entries)) + len(_number(1, "DATA_START", "<h", 0)) + 2
    blocks = -(-size // BLOCK)
    entries.insert(1, _number(1, "DATA_START", "<h", 2 + blocks))
    section = bytes([1, 80, blocks, 84]) + b"".join(entries) + b"\0\0"
    return section.ljust(blocks * BLOCK, b"\0")


def _group(number: int, name: str) -> bytes:
    return struct.pack("<bb", len(name), -number) + name.encode() + struct.pack("<hB", 3, 0)


def _entry(group: int, name: str, body: bytes) -> bytes:
    head = struct.pack("<bb", len(name), group) + name.encode()
    return head + struct.pack("<h", len(body) + 3) + body + b"\0"


def _number(group: int, name: str, form: str, value: float) -> bytes:
    kind = {"h": 2, "H": 2, "f": 4}[form[-1]]
    return _entry(group, name, struct.pack("<bB", kind, 0) + struct.pack(form, value))


def _array(group: int, name: str, values: np.ndarray, kind: int) -> bytes:
    return _entry(group, name, struct.pack("<bBB", kind, 1, len(values)) + values.tobytes())


def _texts(group: int, name: str, texts: list[str]) -> bytes:
    width = max((len(text) for text in texts), default=0)
    body = "".join(text.ljust(width) for text in texts).encode()
    return _entry(group, name, struct.pack("<bBBB", -1, 2, width, len(texts)) + body)
