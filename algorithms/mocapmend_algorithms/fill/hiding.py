"""Gaps whose ragged ends are cut off: measured samples that a repair shall replace."""

from collections.abc import Sequence
from typing import Any

import numpy as np

from mocapmend_algorithms.fill.contract import FillFunction, FillResult
from mocapmend_algorithms.gaps import Gap
from mocapmend_algorithms.progress import Progress, part
from mocapmend_algorithms.recording import Recording


def covers_measured(recording: Recording, gap: Gap) -> bool:
    """Say whether there are measured samples inside a gap."""
    return bool(recording.present[gap.start : gap.stop, gap.marker].any())


def fill_hiding(
    recording: Recording,
    gaps: Sequence[Gap],
    function: FillFunction,
    params: Any,
    progress: Progress,
) -> FillResult:
    """Fill gaps, some of which cover measured samples: these are hidden from their own fill alone.

    What one gap hides the others still see, so that the order of repairs makes no difference.

    Parameters
    ----------
    recording : Recording
        Not changed.
    gaps : sequence of Gap
        What shall be filled.
    function : FillFunction
        A method.
    params : object
        Its parameters.
    progress : Progress
        Called often.

    Returns
    -------
    FillResult
        In the order of the gaps.
    """
    hiding = [gap for gap in gaps if covers_measured(recording, gap)]
    if not hiding:
        return function(recording, gaps, params, progress)
    plain = [gap for gap in gaps if gap not in set(hiding)]
    share = len(plain) / len(gaps)
    results = [function(recording, plain, params, part(progress, 0.0, share))]
    for number, gap in enumerate(hiding):
        points = recording.points.copy()
        points[gap.start : gap.stop, gap.marker] = np.nan
        begin, end = ((len(plain) + number + more) / len(gaps) for more in (0, 1))
        hidden = recording.with_points(points)
        results.append(function(hidden, [gap], params, part(progress, begin, end)))
    place = {gap: order for order, gap in enumerate(gaps)}
    return FillResult(
        tuple(sorted((p for r in results for p in r.patches), key=lambda p: place[p.gap])),
        tuple(sorted((u for r in results for u in r.unfilled), key=lambda u: place[u.gap])),
        {gap: note for result in results for gap, note in result.notes.items()},
    )
