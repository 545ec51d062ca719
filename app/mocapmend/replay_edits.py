"""The edits of a recipe in an open recording, which may have been edited before."""

from collections.abc import Sequence

from mocapmend.document import Document, Edit
from mocapmend.replaying import Plan
from mocapmend.state import SampleState
from mocapmend_algorithms import Gap
from mocapmend_algorithms.fill.contract import FillResult


def replayed(document: Document, planned: Plan, results: Sequence[FillResult]) -> list[Edit]:
    """Return the edits that a recipe makes of samples.

    Gaps that the user has marked as never to be filled stay so, unless the recipe frees them.

    Parameters
    ----------
    document : Document
        The recording.
    planned : Plan
        The recipe.
    results : sequence of FillResult
        One for each of its jobs.
    """
    gaps, never = _Gaps(document), set(document.never)
    freed = never.intersection(map(gaps.now, planned.freed))
    protected = document.state == SampleState.NEVER
    for gap in freed:
        protected[gap.start : gap.stop, gap.marker] = False
    fills = [
        edit
        for job, result in zip(planned.jobs, results, strict=True)
        for edit in Edit.fills(result, job.method, job.params)
        if not protected[edit.gap.start : edit.gap.stop, edit.gap.marker].any()
    ]
    cleared = [*sorted(freed), *(gap for gap in planned.reopened if gap in document.repairs)]
    kept = [gaps.now(gap) for gap, entry in planned.kept_open.items() if entry.never]
    of_gap = {gap: Edit.clear(gap) for gap in cleared}
    of_gap |= {gap: Edit.clear(gap, SampleState.NEVER) for gap in kept if gap not in never}
    return [*of_gap.values(), *fills]


def keep_open(document: Document, planned: Plan) -> int:
    """Leave gaps open as a recipe does, or take them up; return how many they are."""
    gaps = _Gaps(document)
    taken = document.set_aside.intersection(map(gaps.now, planned.freed))
    for gap in taken:
        document.take_up(gap)
    left = 0
    for gap, entry in planned.kept_open.items():
        now = gaps.now(gap)
        if entry.never:
            document.never_reasons[now] = entry.reason
        elif now not in document.set_aside:
            document.put_aside(now, entry.reason)
            left += 1
    return len(taken) + left


class _Gaps:
    """The gaps of a document, open or not."""

    def __init__(self, document: Document) -> None:
        self._document = document
        self._known = {*document.gaps, *document.repairs, *document.never}

    def now(self, gap: Gap) -> Gap:
        """Return a gap of the file with the ends that it has now."""
        if gap in self._known:
            return gap
        return self._document.gap_near(gap.marker, gap.start) or gap
