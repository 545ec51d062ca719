"""All detectors on one recording, and each wrong sample explained once."""

from collections.abc import Iterable, Mapping, Sequence
from dataclasses import replace
from typing import Any

import numpy as np

from mocapmend_algorithms.arrays import BoolArray
from mocapmend_algorithms.gaps import runs
from mocapmend_algorithms.problems.bad_run import BadRun
from mocapmend_algorithms.problems.registry import chosen
from mocapmend_algorithms.progress import Progress, part
from mocapmend_algorithms.recording import Recording
from mocapmend_algorithms.skeleton import Skeleton

BEST_FIRST = (
    "swaps",
    "fragments",
    "frozen",
    "reflections",
    "far",
    "spikes",
    "tails",
    "bone-breaks",
)
"""What explains more comes first: a swap explains the jumps at its ends and broken bones."""
BESIDE = 2
"""Frames beside a swap that its jumps disturb."""
MOSTLY = 0.5
"""Of a run: where so much is explained, the rest is as well."""


def detect(
    recording: Recording,
    skeleton: Skeleton,
    ids: Iterable[str] | None,
    progress: Progress,
    *,
    params: Mapping[str, Any] | None = None,
) -> list[BadRun]:
    """Look for bad samples of several kinds.

    Parameters
    ----------
    recording : Recording
        What to look at.
    skeleton : Skeleton
        Its bones.
    ids : iterable of str or None
        The detectors, by id; all by default.
    progress : Progress
        Called often; may cancel.
    params : mapping of str to object, optional
        Parameters by the id of the detector; those that are missing have their defaults.

    Returns
    -------
    list of BadRun
        Ordered by marker and start. What several detectors find is listed once, as what explains
        it best.

    Raises
    ------
    KeyError
        If there is no detector of an id; the message lists the ids.
    """
    detectors = chosen(ids)
    found = []
    for count, each in enumerate(detectors):
        share = part(progress, count / len(detectors), (count + 1) / len(detectors))
        own = each.params() if params is None or each.id not in params else params[each.id]
        found += each.function(recording, skeleton, own, share)
    progress(1.0)
    return explained_once(found, recording.present)


def explained_once(found: Sequence[BadRun], present: BoolArray) -> list[BadRun]:
    """Keep one run for each bad sample, of the kind that explains it best.

    Parameters
    ----------
    found : sequence of BadRun
        Of all detectors.
    present : ndarray of bool, shape (frames, markers)
        Which samples are there.

    Returns
    -------
    list of BadRun
        Ordered by marker and start. Of a run that is explained in part, the longest rest is kept.
    """
    taken = np.zeros_like(present)
    kept = []
    place = {kind: at for at, kind in enumerate(BEST_FIRST)}
    for run in sorted(found, key=lambda r: (place[r.kind], -r.score, r.marker, r.start)):
        rest = _rest(run, taken)
        if rest is None:
            continue
        kept.append(rest)
        markers = [run.marker]
        beside = 0
        if run.kind == "swaps" and run.other is not None:
            markers.append(run.other)
            beside = BESIDE
        taken[max(0, rest.start - beside) : rest.stop + beside, markers] = True
    return sorted(kept, key=lambda run: (run.marker, run.start, place[run.kind]))


def _rest(run: BadRun, taken: BoolArray) -> BadRun | None:
    """Return what of a run is not explained yet; None where most of it is."""
    free = ~taken[run.start : run.stop, run.marker]
    if run.kind == "swaps" and run.other is not None:
        free &= ~taken[run.start : run.stop, run.other]
    if free.all():
        return run
    if np.count_nonzero(free) <= MOSTLY * run.length or run.kind in ("swaps", "fragments"):
        return None
    start, stop = max(runs(free), key=lambda span: span[1] - span[0])
    reason = run.reason.removesuffix(".") + "; the rest is explained otherwise."
    return replace(run, start=run.start + start, stop=run.start + stop, reason=reason)
