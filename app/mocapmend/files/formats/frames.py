"""The frames of a table: one line each, with their numbers and times."""

from dataclasses import dataclass, field

import numpy as np
from numpy.typing import NDArray

from mocapmend.files.formats.cells import read_numbers
from mocapmend.files.formats.columns import Columns, check_count
from mocapmend.files.formats.text import Lines

BLOCK = 1 << 18
"""Numbers that are looked at together, so that they stay in the processor's cache."""
LARGEST_FRAME = 2**31 - 1
LARGEST_NUMBER = float(np.finfo(np.float32).max)
"""As in C3D files; the squares of much larger numbers overflow."""


@dataclass(frozen=True, eq=False)
class Frames:
    """Frames as a file has them, in its order.

    Attributes
    ----------
    numbers : ndarray, shape (frames,)
        The file's numbers of the frames, NaN without.
    times : ndarray, shape (frames,)
        Seconds, NaN without.
    points : ndarray, shape (frames, markers, 3)
        Coordinates, all three NaN where the marker is missing.
    """

    numbers: NDArray[np.float64]
    times: NDArray[np.float64]
    points: NDArray[np.float64]


@dataclass
class MissingRule:
    """Which samples are taken as missing, and how many had no mark of it.

    Attributes
    ----------
    zeros : bool
        Whether a sample at exactly (0, 0, 0) is missing.
    zero, incomplete, unusable : int
        Samples that were at zero, had only some coordinates, or impossible ones.
    """

    zeros: bool
    zero: int = field(default=0, init=False)
    incomplete: int = field(default=0, init=False)
    unusable: int = field(default=0, init=False)

    def apply(self, points: NDArray[np.float64]) -> None:
        """Make all three coordinates of missing samples NaN, in place; shape (n, ..., 3)."""
        step = max(len(points) * BLOCK // max(points.size, 1), 1)
        for start in range(0, len(points), step):
            self._apply(points[start : start + step])

    def _apply(self, points: NDArray[np.float64]) -> None:
        absent = np.isnan(points)
        unusable = (np.abs(points) > LARGEST_NUMBER).any(axis=-1)
        missing = absent.any(axis=-1)
        self.incomplete += int(np.count_nonzero(missing & ~absent.all(axis=-1)))
        self.unusable += int(np.count_nonzero(unusable & ~missing))
        missing |= unusable
        if self.zeros:
            zero = ~points.any(axis=-1)
            self.zero += int(np.count_nonzero(zero))
            missing |= zero
        points[missing] = np.nan

    def sentences(self) -> list[str]:
        """Return a warning for each kind that occurred."""
        kinds = (
            (self.zero, "exactly at (0, 0, 0)"),
            (self.incomplete, "without some of their coordinates"),
            (self.unusable, "impossibly far away"),
        )
        return [f"Samples {what} are taken as missing: {count}." for count, what in kinds if count]


def read_frames(
    lines: Lines,
    columns: Columns,
    separator: str | None,
    rule: MissingRule,
    warnings: list[str],
    *,
    quoted: bool = True,
    to_blank: bool = False,
) -> Frames:
    """Read all other lines of a file as frames.

    Parameters
    ----------
    lines : Lines
        Of which the header was skipped.
    columns : Columns
        What is where.
    separator : str or None
        Between cells, None for any number of spaces and tabs.
    rule : MissingRule
        What is missing.
    warnings : list of str
        Gets a sentence about a last line that is cut off.
    quoted : bool
        Whether cells may be enclosed in quotation marks.
    to_blank : bool
        Whether a blank line ends the table.

    Raises
    ------
    MocapmendError
        If what is there is no table of numbers.
    """
    check_count(lines, len(columns.first))
    used = [column + axis for column in columns.first for axis in range(3)]
    extra = [column for column in (columns.frame, columns.time) if column is not None]
    parts = []
    for every in lines.blocks():
        block = every.to_blank() if to_blank else every.without_blank()
        if lines.cut and _is_cut(block.lines[-1:], separator, max(used + extra)):
            warnings.append("The last line is cut off; it is left out.")
            del block.lines[-1]
        if block.lines:
            table = read_numbers(lines, block, extra + used, separator, quoted=quoted)
            parts.append(_frames(table, columns, rule))
        if to_blank and len(block.lines) < len(every.lines):
            break
    if not parts:
        return Frames(np.empty(0), np.empty(0), np.empty((0, len(columns.first), 3)))
    return Frames(
        np.concatenate([part.numbers for part in parts]),
        np.concatenate([part.times for part in parts]),
        np.concatenate([part.points for part in parts]),
    )


def _is_cut(last: list[str], separator: str | None, column: int) -> bool:
    return bool(last) and len(last[0].split(separator)) <= column


def _frames(table: NDArray[np.float64], columns: Columns, rule: MissingRule) -> Frames:
    nothing = np.full(len(table), np.nan)
    at = 0
    numbers = times = nothing
    if columns.frame is not None:
        numbers, at = table[:, at].copy(), at + 1
    if columns.time is not None:
        times, at = table[:, at] * columns.time_scale, at + 1
    points = table[:, at:].reshape(len(table), len(columns.first), 3)
    points = np.ascontiguousarray(points)
    rule.apply(points)
    if at:
        # Spreadsheets leave lines of empty cells behind a table.
        there = ~(np.isnan(numbers) & np.isnan(times) & np.isnan(points).all(axis=(1, 2)))
        if not there.all():
            return Frames(numbers[there], times[there], points[there])
    return Frames(numbers, times, points)
