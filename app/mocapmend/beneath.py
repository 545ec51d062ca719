"""What lies beneath the smoothing of a document, and taking smoothing off."""

from collections.abc import Collection, Iterable, Sequence

import numpy as np

from mocapmend.document import Document
from mocapmend.edits import Edit
from mocapmend.shared_recording import SharedRecording
from mocapmend.state import ABSENT, SampleState
from mocapmend_algorithms import Gap


def beneath(document: Document, run: Gap) -> Edit:
    """Return what a run would hold without smoothing, as the edit that takes it off.

    What was smoothed when the file was opened stays so: what was measured is not in it.
    """
    rows, marker = slice(run.start, run.stop), run.marker
    states = document.state[rows, marker].copy()
    states[states == SampleState.SMOOTHED] = SampleState.MEASURED
    for earlier in document.smoothed_earlier:
        if earlier.marker == marker and _overlap(earlier, run):
            inside = states[max(0, earlier.start - run.start) : earlier.stop - run.start]
            inside[inside == SampleState.MEASURED] = SampleState.SMOOTHED
    values = document.base.points[rows, marker].copy()
    values[np.isin(states, ABSENT)] = np.nan
    # What is filled is one gap: those beside each other would be one.
    for first, end in document.runs(marker, SampleState.FILLED).tolist():
        gap = Gap(marker, first, end)
        if _overlap(gap, run):
            start, stop = max(gap.start, run.start), min(gap.stop, run.stop)
            filled = document.repairs[gap].patch.values[start - gap.start : stop - gap.start]
            values[start - run.start : stop - run.start] = filled
    return Edit(
        run,
        values,
        states,
        document.repairs.get(run),
        document.read(run).reason,
        document.smoothed_earlier.get(run),
    )


def changes_smoothing_alone(document: Document, edit: Edit) -> bool:
    """Say whether an edit leaves what lies beneath the smoothing as it is."""
    if edit.smoothed is not None:
        return True
    if edit.gap not in document.smoothed:
        return False
    former = beneath(document, edit.gap)
    return (
        edit.repair is former.repair
        and edit.reason == former.reason
        and np.array_equal(edit.states, former.states)
        and np.array_equal(edit.values, former.values, equal_nan=True)
    )


def without_smoothing(
    document: Document, runs: Collection[Gap], smoothed_anew: Collection[Gap] = ()
) -> list[Edit]:
    """Return the edits that take smoothing off where other changes need it.

    Parameters
    ----------
    document : Document
        The recording.
    runs : collection of Gap
        Where what lies beneath changes. All smoothing of the samples on end around them depends on
        that: what lies beyond a gap makes no difference to it.
    smoothed_anew : collection of Gap
        Where only the smoothing changes: what overlaps them is taken off.
    """
    changed, replaced = _by_marker(runs), _by_marker(smoothed_anew)
    return [
        beneath(document, run)
        for run, made in sorted(document.smoothed.items(), key=lambda item: item[0])
        if document.smoothed_earlier.get(run) is not made
        and (
            _meets(document, run, changed.get(run.marker, ()))
            or any(_overlap(run, other) for other in replaced.get(run.marker, ()))
        )
    ]


def share_beneath(document: Document) -> SharedRecording:
    """Return the current samples without smoothing for a background job."""
    return document.share_with(without_smoothing(document, document.smoothed))


def _meets(document: Document, run: Gap, others: Sequence[Gap]) -> bool:
    """Say whether one of some runs of a marker has to do with the samples around a run."""
    if not others:
        return False
    states = document.state[:, run.marker]
    missing = np.flatnonzero(np.isin(states, ABSENT))
    before, after = np.searchsorted(missing, (run.start, run.stop))
    start = missing[before - 1] if before else 0
    stop = missing[after] + 1 if after < len(missing) else len(states)
    return any(start < other.stop and other.start < stop for other in others)


def _by_marker(runs: Iterable[Gap]) -> dict[int, list[Gap]]:
    of_marker: dict[int, list[Gap]] = {}
    for run in runs:
        of_marker.setdefault(run.marker, []).append(run)
    return of_marker


def _overlap(one: Gap, other: Gap) -> bool:
    return one.start < other.stop and other.start < one.stop
