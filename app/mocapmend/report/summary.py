"""The figures of the report, fast enough to be computed after every edit."""

from collections.abc import Iterator, Sequence

import numpy as np

from mocapmend.names import short_names
from mocapmend.report.model import MarkerRow, OpenGap, RepairRow, Report
from mocapmend.report.put_right import NOTHING_PUT_RIGHT, PutRight, marked
from mocapmend_algorithms import Progress, Recording, find_gaps
from mocapmend_algorithms.arrays import BoolArray, IntArray
from mocapmend_algorithms.fill.contract import Unfilled
from mocapmend_algorithms.gaps import count_gaps
from mocapmend_algorithms.metrics import (
    bone_lengths,
    bone_spread,
    success_curves,
    tracked,
)
from mocapmend_algorithms.skeleton import Skeleton

MOST_CURVES = 6
CHUNK = 256
"""Frames measured at a time: what fits into the processor's cache is several times as fast."""
NOT_ASKED = "no repair was asked for"


def summarise(
    before: Recording,
    after: Recording,
    skeleton: Skeleton,
    repairs: Sequence[RepairRow],
    unfilled: Sequence[Unfilled],
    progress: Progress,
    done: PutRight = NOTHING_PUT_RIGHT,
) -> Report:
    """Compare a recording with its repaired form.

    Parameters
    ----------
    before, after : Recording
        Of equal shape.
    skeleton : Skeleton
        The bones to measure.
    repairs : sequence of RepairRow
        How gaps were filled.
    unfilled : sequence of Unfilled
        Why gaps were left open. Gaps that are open and not among them are listed too.
    progress : Progress
        Called often.
    done : PutRight
        What was put right besides. A bad sample was not tracked before, and a sample that was
        smoothed and nothing else is no repaired one.

    Returns
    -------
    Report
    """
    counted = np.logical_or.reduce(before.present | after.present, axis=0)
    wrong = done.wrong_in(before)
    touched = _changed_samples(before, after)
    progress(0.2)
    bones = np.array(skeleton.bones, dtype=np.int64).reshape(-1, 2)
    spread_before = bone_spread(bone_lengths(before.points, bones))
    progress(0.6)
    # A repaired end says nothing about a bone whose other end is missing.
    mended = touched & ~_merely_smoothed(before, repairs, done)
    seen = _either(mended, bones) & ~_either(~after.present, bones)
    repaired = np.count_nonzero(seen, axis=0)
    moved = np.flatnonzero(np.logical_or.reduce(_either(touched, bones), axis=0))
    spread_after = spread_before.copy()
    spread_after[moved] = bone_spread(bone_lengths(after.points, bones[moved]))
    shown = np.argsort(-repaired, kind="stable")[: min(MOST_CURVES, np.count_nonzero(repaired))]
    names = short_names(before.labels)
    was_tracked, is_tracked = tracked(before, bad=wrong), tracked(after)
    segments = _counted_segments(skeleton, counted)
    progress(0.9)
    report = Report(
        rate=before.rate,
        first_frame=before.first_frame,
        frames=before.frames,
        unit=before.unit,
        success_before=success_curves(was_tracked, counted=counted),
        success_after=success_curves(is_tracked, counted=counted),
        segments=len(segments),
        segment_success=(
            success_curves(was_tracked, counted=counted, segments=segments),
            success_curves(is_tracked, counted=counted, segments=segments),
        )
        if segments
        else None,
        bones=tuple(skeleton.bones),
        bone_names=tuple(f"{names[a]} – {names[b]}" for a, b in skeleton.bones),
        spread_before=spread_before,
        spread_after=spread_after,
        bone_repairs=repaired,
        shown_bones=tuple(shown.tolist()),
        lengths_before=bone_lengths(before.points, bones[shown]),
        lengths_after=bone_lengths(after.points, bones[shown]),
        changed=seen[:, shown],
        markers=tuple(_marker_rows(before, after, repairs)),
        labels=before.labels,
        repairs=tuple(repairs),
        open_gaps=_open_gaps(after, unfilled),
        missing_before=int(np.count_nonzero(~before.present)),
        wrong_before=int(np.count_nonzero(wrong)),
        altered=int(np.count_nonzero(touched & before.present)),
    )
    progress(1.0)
    return report


def _merely_smoothed(
    before: Recording, repairs: Sequence[RepairRow], done: PutRight
) -> BoolArray | np.bool_:
    """Say which samples were measured, right, and only smoothed, shape (frames, markers)."""
    if not done.smoothed:
        return np.False_
    smoothed = marked((row.run for row in done.smoothed), before)
    others = marked([*(row.gap for row in repairs), *done.bad], before)
    return smoothed & before.present & ~others


def _chunks(frames: int) -> Iterator[slice]:
    return (slice(start, start + CHUNK) for start in range(0, frames, CHUNK))


def _changed_samples(before: Recording, after: Recording) -> BoolArray:
    """Say which samples differ in any bit, shape (frames, markers)."""
    changed = np.zeros(before.present.shape, dtype=np.bool_)
    # Compared as integers, because NaN differs from itself.
    old, new = before.points.view(np.int64), after.points.view(np.int64)
    for rows in _chunks(before.frames):
        differs = old[rows] != new[rows]
        if differs.any():
            changed[rows] = differs.any(axis=2)
    return changed


def _counted_segments(skeleton: Skeleton, counted: BoolArray) -> list[tuple[int, ...]]:
    """Return the markers of each segment that is seen at all."""
    return [part.markers for part in skeleton.segments if counted[list(part.markers)].any()]


def _either(mask: BoolArray, bones: IntArray) -> BoolArray:
    """Say where either end of a bone is marked, shape (frames, bones)."""
    return np.asarray(mask[:, bones[:, 0]] | mask[:, bones[:, 1]])


def _marker_rows(
    before: Recording, after: Recording, repairs: Sequence[RepairRow]
) -> Iterator[MarkerRow]:
    by_marker: dict[int, list[RepairRow]] = {}
    for repair in repairs:
        by_marker.setdefault(repair.gap.marker, []).append(repair)
    frames = max(before.frames, 1)
    missing_before = np.count_nonzero(~before.present, axis=0)
    missing_after = np.count_nonzero(~after.present, axis=0)
    filled = np.count_nonzero(after.present & ~before.present, axis=0)
    gaps_before, longest_before = count_gaps(before.present)
    gaps_after, longest_after = count_gaps(after.present)
    for marker, label in enumerate(before.labels):
        own = by_marker.get(marker, [])
        lengths: dict[str, int] = {}
        for repair in own:
            lengths[repair.method] = lengths.get(repair.method, 0) + repair.gap.length
        errors = [r.expected_error_mm for r in own if not np.isnan(r.expected_error_mm)]
        yield MarkerRow(
            label=label,
            missing_before=100 * int(missing_before[marker]) / frames,
            missing_after=100 * int(missing_after[marker]) / frames,
            gaps_before=gaps_before[marker],
            gaps_after=gaps_after[marker],
            longest_before=longest_before[marker],
            longest_after=longest_after[marker],
            filled=int(filled[marker]),
            unfilled=int(missing_after[marker]),
            filled_by=tuple((name, 100 * count / frames) for name, count in lengths.items()),
            worst_error_mm=max(errors, default=float("nan")),
        )


def _open_gaps(after: Recording, unfilled: Sequence[Unfilled]) -> tuple[OpenGap, ...]:
    reasons = {entry.gap: entry.reason for entry in unfilled}
    return tuple(OpenGap(gap, reasons.get(gap, NOT_ASKED)) for gap in find_gaps(after.present))
