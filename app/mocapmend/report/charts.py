"""Curves to be drawn: small even for long recordings, without losing a peak or a gap."""

from collections.abc import Callable, Iterator, Sequence
from dataclasses import dataclass
from math import ceil, floor, log10

import numpy as np

from mocapmend_algorithms.arrays import BoolArray, FloatArray
from mocapmend_algorithms.gaps import runs

WIDTH, HEIGHT = 400, 250
LEFT, RIGHT, TOP, BOTTOM = 58, 12, 12, 42
PLOT_WIDTH, PLOT_HEIGHT = WIDTH - LEFT - RIGHT, HEIGHT - TOP - BOTTOM
Placed = Callable[[float, float], tuple[float, float]]
"""Puts a point of a chart in its place on a page."""
TIME = "time (s)"
STEPS = (1.0, 2.0, 2.5, 5.0, 10.0)


@dataclass(frozen=True)
class Tick:
    """A labelled place on an axis."""

    at: float
    text: str


@dataclass(frozen=True, eq=False)
class Line:
    """A curve.

    Attributes
    ----------
    style : str
        "before" or "after".
    pieces : tuple of ndarray, shape (points, 2)
        Its unbroken parts in the chart's own units, y downwards; a lone sample is a line of no
        length, which round ends make a dot.
    """

    style: str
    pieces: tuple[FloatArray, ...]

    @property
    def path(self) -> str:
        """The curve as the data of an SVG path."""
        texts = (" ".join(f"{x:.1f} {y:.1f}" for x, y in piece.tolist()) for piece in self.pieces)
        return "".join("M{} {}L{}".format(*text.split(" ", 2)) for text in texts)


@dataclass(frozen=True, eq=False)
class Chart:
    """What is drawn, within `WIDTH` and `HEIGHT`.

    Attributes
    ----------
    title, y_label, x_label : str
        Above, beside and below the chart.
    x_ticks, y_ticks : tuple of Tick
        In the chart's own units.
    lines : tuple of Line
        From back to front.
    bands : tuple of (float, float)
        Left side and width of the shaded stretches.
    """

    title: str
    y_label: str
    x_ticks: tuple[Tick, ...]
    y_ticks: tuple[Tick, ...]
    lines: tuple[Line, ...]
    bands: tuple[tuple[float, float], ...] = ()
    x_label: str = TIME


def draw(
    title: str,
    y_label: str,
    rate: float,
    before: FloatArray,
    after: FloatArray,
    *,
    top: float | None = None,
    changed: BoolArray | None = None,
    x_label: str = TIME,
) -> Chart:
    """Draw a quantity before and after.

    Parameters
    ----------
    title, y_label : str
        Titles of chart and axis.
    rate : float
        Frames per second (Hz).
    before, after : ndarray, shape (frames,)
        The curves; NaN interrupts them.
    top : float, optional
        Upper end of the axis; by default what the values need.
    changed : ndarray of bool, shape (frames,), optional
        What to shade.
    x_label : str
        What the other axis is in place of time, which then runs from 0 in steps of 1 / `rate`.
    """
    frames = len(after)
    seconds = max(frames - 1, 1) / rate
    across = PLOT_WIDTH / max(frames - 1, 1)
    y_ticks = _value_ticks(np.concatenate((before, after)), top)
    low, high = y_ticks[0], y_ticks[-1]
    scale = PLOT_HEIGHT / (high - low)

    def line(style: str, values: FloatArray) -> Line:
        return Line(style, tuple(_pieces(LEFT, across, TOP + (high - values) * scale)))

    return Chart(
        title,
        y_label,
        tuple(
            Tick(round(LEFT + PLOT_WIDTH * at / seconds, 1), text)
            for at, text in _labelled([t for t in _nice(0.0, seconds, 6) if t <= seconds * 1.001])
        ),
        tuple(Tick(round(TOP + (high - at) * scale, 1), text) for at, text in _labelled(y_ticks)),
        (line("after", after), line("before", before)),
        _bands(changed, across) if changed is not None else (),
        x_label,
    )


def _value_ticks(values: FloatArray, top: float | None) -> list[float]:
    """Choose ticks that enclose the values."""
    known = values[np.isfinite(values)]
    low, high = (float(known.min()), float(known.max())) if known.size else (0.0, 1.0)
    high = high if top is None else top
    # A constant must not look like noise.
    least = max(0.004 * abs(high), 1e-6)
    if high - low < least:
        low, high = (high - least, high) if top is not None else (low - least, high + least)
    ticks = _nice(low, high, 5)
    return [tick for tick in ticks if tick <= top * (1 + 1e-9)] if top is not None else ticks


def _nice(low: float, high: float, most: int) -> list[float]:
    """Return round numbers from at or below `low` to at or above `high`."""
    rough = (high - low) / most
    power = 10.0 ** floor(log10(rough))
    step = next(s * power for s in STEPS if s * power >= rough * (1 - 1e-9))
    first, last = floor(low / step + 1e-9), ceil(high / step - 1e-9)
    return [k * step for k in range(first, last + 1)]


def _labelled(ticks: Sequence[float]) -> list[tuple[float, str]]:
    """Write numbers with as many decimals as their distance needs."""
    step = ticks[1] - ticks[0] if len(ticks) > 1 else 1.0
    decimals = max(0, -floor(log10(step) + 1e-9))
    if abs(step * 10**decimals - round(step * 10**decimals)) > 1e-6:
        decimals += 1
    return [(tick, f"{tick + 0.0:.{decimals}f}") for tick in ticks]


def _pieces(left: float, across: float, heights: FloatArray) -> Iterator[FloatArray]:
    """Yield the unbroken parts of a curve, which NaN interrupts."""
    frames, values = _thin(heights)
    points = np.stack((left + across * frames, values.round(1)), axis=1)
    for start, stop in runs(~np.isnan(values)):
        piece = points[start:stop]
        yield piece if stop - start > 1 else np.repeat(piece, 2, axis=0)


def _thin(values: FloatArray) -> tuple[FloatArray, FloatArray]:
    """Keep what can be seen: per pixel column the lowest and highest value, and every break."""
    frames = np.arange(len(values), dtype=np.float64)
    size = len(values) // (2 * PLOT_WIDTH)
    if size > 1:
        padded = np.full(-(-len(values) // size) * size, np.nan)
        padded[: len(values)] = values
        columns = padded.reshape(-1, size)
        gone = np.isnan(columns)
        lowest = np.where(gone, np.inf, columns).argmin(axis=1)
        highest = np.where(gone, -np.inf, columns).argmax(axis=1)
        ends = np.sort(np.stack((lowest, highest), axis=1), axis=1)
        chosen = (np.arange(len(columns))[:, None] * size + ends).ravel()
        # A column without a value keeps its NaN, which may lie in the padding.
        frames, values = chosen.astype(np.float64), padded[chosen]
    level = np.zeros(len(values), dtype=np.bool_)
    level[1:-1] = (values[1:-1] == values[:-2]) & (values[1:-1] == values[2:])
    blank = np.zeros(len(values), dtype=np.bool_)
    blank[1:] = np.isnan(values[1:]) & np.isnan(values[:-1])
    keep = ~(level | blank)
    return frames[keep], values[keep]


def _bands(changed: BoolArray, across: float) -> tuple[tuple[float, float], ...]:
    """Shade runs of frames, joined where they are less than a pixel apart."""
    bands: list[tuple[float, float]] = []
    for start, stop in runs(changed):
        left, right = LEFT + across * (start - 0.5), LEFT + across * (stop - 0.5)
        left, right = max(left, LEFT), min(right, LEFT + PLOT_WIDTH)
        if bands and left - bands[-1][1] < 1:
            bands[-1] = (bands[-1][0], right)
        else:
            bands.append((left, right))
    return tuple((round(a, 1), round(max(b - a, 1.0), 1)) for a, b in bands)
