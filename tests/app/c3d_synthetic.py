"""A small writer of C3D files for tests, written apart from the program's own reader."""

import struct
from dataclasses import dataclass, field
from typing import Any, Literal

import numpy as np
from numpy.typing import NDArray

Machine = Literal["intel", "dec", "mips"]
MACHINES: tuple[Machine, ...] = ("intel", "dec", "mips")
CODES = {"intel": 84, "dec": 85, "mips": 86}
ENCODINGS = [(machine, is_float) for machine in MACHINES for is_float in (False, True)]
"""The six encodings of a C3D file."""

Value = str | list[str] | list[int] | list[float] | NDArray[Any]
"""An array is stored with its last axis first, as C3D files have it."""


@dataclass(frozen=True)
class Synthetic:
    """What a file shall hold.

    Attributes
    ----------
    points : ndarray, shape (frames, points, 3)
        Coordinates as they are stored; integers are divided by the scale.
    fourth : ndarray, shape (frames, points), optional
        The fourth words; 0 everywhere by default.
    analog : ndarray, shape (frames, samples, channels), optional
        Analog values as they are stored.
    parameters : dict
        Parameters to add or replace by "GROUP:NAME"; None leaves one out.
    header : dict
        Words of the header to replace by their number (from 1).
    events : list of (label, seconds)
        Header events.
    """

    points: NDArray[np.float64]
    machine: Machine = "intel"
    is_float: bool = True
    scale: float = 0.1
    fourth: NDArray[np.float64] | None = None
    analog: NDArray[np.float64] | None = None
    rate: float = 100.0
    first_frame: int = 1
    labels: list[str] | None = None
    parameters: dict[str, Value | None] = field(default_factory=dict)
    header: dict[int, int] = field(default_factory=dict)
    events: list[tuple[str, float]] = field(default_factory=list)


def walk(frames: int = 40, markers: int = 5, seed: int = 0) -> NDArray[np.float64]:
    """Return smooth trajectories in mm that are exact in float32 and in tenths of integers."""
    rng = np.random.default_rng(seed)
    steps = rng.normal(0, 3, (frames, markers, 3))
    points = 800.0 + 200.0 * rng.normal(size=(markers, 3)) + np.cumsum(steps, axis=0)
    return np.round(points * 8) / 8


def dec_floats(values: NDArray[np.float64]) -> bytes:
    """Encode VAX F floats: exponent 2 higher than IEEE, halves swapped; zero stays zero."""
    bits = np.ascontiguousarray(values, "<f4").view("<u4").copy()
    bits[bits & 0x7F800000 != 0] += 2 << 23
    halves = np.stack([bits >> 16, bits & 0xFFFF], axis=-1)
    return halves.astype("<u2").tobytes()


def numbers(values: NDArray[np.float64], machine: Machine, kind: str) -> bytes:
    """Encode floats ("f") or 16-bit integers ("i")."""
    values = np.asarray(values, np.float64)
    if kind == "i":
        wrapped = np.asarray(values, np.int64) & 0xFFFF
        return wrapped.astype(">u2" if machine == "mips" else "<u2").tobytes()
    if machine == "dec":
        return dec_floats(values)
    return values.astype(">f4" if machine == "mips" else "<f4").tobytes()


def parameter(group: int, name: str, value: Value, machine: Machine) -> bytes:
    """Encode one parameter record."""
    if isinstance(value, np.ndarray):
        is_float = value.dtype.kind == "f"
        kind, dimensions = 4 if is_float else 2, list(value.shape[::-1])
        data = numbers(value, machine, "f" if is_float else "i")
    elif isinstance(value, str) or (value and isinstance(value[0], str)):
        texts = [text.encode() for text in ([value] if isinstance(value, str) else value)]
        width = max(map(len, texts))
        dimensions = [width] if isinstance(value, str) else [width, len(texts)]
        kind, data = -1, b"".join(text.ljust(width) for text in texts)
    elif value and isinstance(value[0], float):
        kind, dimensions, data = 4, [len(value)], numbers(np.array(value), machine, "f")
    else:
        kind, dimensions, data = 2, [len(value)], numbers(np.array(value), machine, "i")
    body = struct.pack("bB", kind, len(dimensions)) + bytes(dimensions) + data + b"\0"
    return record(group, name, body, machine)


def record(group: int, name: str, body: bytes, machine: Machine) -> bytes:
    """Encode the head of a record before its body."""
    order = ">" if machine == "mips" else "<"
    head = struct.pack("bb", len(name), group) + name.encode()
    return head + struct.pack(order + "H", len(body) + 2) + body


def section(parameters: dict[str, Value | None], machine: Machine) -> bytes:
    """Encode a parameter section, filled up to whole blocks."""
    groups = sorted({key.split(":")[0] for key in parameters})
    raw = b""
    for key, value in parameters.items():
        group, name = key.split(":")
        if value is not None:
            raw += parameter(groups.index(group) + 1, name, value, machine)
    raw += b"".join(record(-groups.index(g) - 1, g, b"\0", machine) for g in groups)
    blocks = -(-(len(raw) + 6) // 512)
    lead = bytes([1, 80, blocks, CODES[machine]])
    return (lead + raw).ljust(512 * blocks, b"\0")


def standard_parameters(spec: Synthetic) -> dict[str, Value | None]:
    """Return the parameters that every good file has."""
    frames, points, _ = spec.points.shape
    labels = spec.labels or [f"M{i + 1:03}" for i in range(points)]
    last = spec.first_frame + frames - 1
    scale = -spec.scale if spec.is_float else spec.scale
    found: dict[str, Value | None] = {
        "POINT:USED": [points],
        "POINT:SCALE": [scale],
        "POINT:RATE": [spec.rate],
        "POINT:DATA_START": [0],
        "POINT:FRAMES": [min(frames, 65535)],
        "POINT:UNITS": "mm",
        "POINT:X_SCREEN": "+X",
        "POINT:Y_SCREEN": "+Z",
        "TRIAL:ACTUAL_START_FIELD": [spec.first_frame % 65536, spec.first_frame // 65536],
        "TRIAL:ACTUAL_END_FIELD": [last % 65536, last // 65536],
        "ANALOG:USED": [0 if spec.analog is None else spec.analog.shape[2]],
    }
    for part in range(0, points, 255):
        name = "POINT:LABELS" + (str(part // 255 + 1) if part else "")
        found[name] = labels[part : part + 255]
    return found


def encode(spec: Synthetic) -> bytes:
    """Encode the whole file."""
    frames, points, _ = spec.points.shape
    samples, channels = (0, 0) if spec.analog is None else spec.analog.shape[1:]
    parameters = standard_parameters(spec) | spec.parameters
    blocks = len(section(parameters, spec.machine)) // 512
    if parameters["POINT:DATA_START"] == [0]:
        parameters["POINT:DATA_START"] = [2 + blocks]
    scale = -spec.scale if spec.is_float else spec.scale
    last = spec.first_frame + frames - 1
    words = np.zeros(256)
    words[1:6] = points, samples * channels, spec.first_frame, last, 10
    words[8:10] = 2 + blocks, samples
    if spec.events:
        words[149:151] = 12345, len(spec.events)
    for number, value in spec.header.items():
        words[number - 1] = value
    header = bytearray(numbers(words, spec.machine, "i"))
    header[0:2] = 2, 80
    for start, value in ((12, scale), (20, spec.rate)):
        if start // 2 + 1 not in spec.header:
            header[start : start + 4] = numbers(np.array([value]), spec.machine, "f")
    for i, (label, seconds) in enumerate(spec.events):
        header[304 + 4 * i : 308 + 4 * i] = numbers(np.array([seconds]), spec.machine, "f")
        header[396 + 4 * i : 400 + 4 * i] = label.encode().ljust(4)[:4]
    return bytes(header) + section(parameters, spec.machine) + _data(spec)


def _data(spec: Synthetic) -> bytes:
    frames, points, _ = spec.points.shape
    xyz = spec.points if spec.is_float else np.rint(spec.points / spec.scale)
    fourth = np.zeros((frames, points)) if spec.fourth is None else spec.fourth
    rows = np.concatenate([xyz, fourth[..., None]], axis=2).reshape(frames, 4 * points)
    if spec.analog is not None:
        rows = np.concatenate([rows, spec.analog.reshape(frames, -1)], axis=1)
    raw = numbers(rows, spec.machine, "f" if spec.is_float else "i")
    return raw.ljust(-(-len(raw) // 512) * 512, b"\0")
