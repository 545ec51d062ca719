"""The edits of a recipe in an open recording, which may have been edited before."""

from collections.abc import Sequence

from mocapmend.document import Document
from mocapmend.edits import Edit
from mocapmend.recipe_plan import Planned
from mocapmend.state import SampleState
from mocapmend_algorithms import Gap
from mocapmend_algorithms.fill.contract import FillResult


def replayed(document: Document, planned: Planned, results: Sequence[FillResult]) -> list[Edit]:
    """Return the edits that a recipe makes.

    Gaps that the user has marked as never to be filled stay so, unless the recipe says otherwise.

    Parameters
    ----------
    document : Document
        The recording.
    planned : Plan
        The recipe.
    results : sequence of FillResult
        One for each of its jobs.
    """
    gaps, aside = _Gaps(document), document.set_aside
    never = {gap: document.never_reason(gap) for gap in document.never}
    freed = {*never, *aside}.intersection(map(gaps.now, planned.freed))
    protected = document.state == SampleState.NEVER
    for gap in freed:
        protected[gap.start : gap.stop, gap.marker] = False
    fills = [
        edit
        for job, result in zip(planned.jobs, results, strict=True)
        for edit in Edit.fills(result, job.method, job.params, document.base_revision)
        if not protected[edit.gap.start : edit.gap.stop, edit.gap.marker].any()
    ]
    cleared = [*sorted(freed), *(gap for gap in planned.reopened if gap in document.repairs)]
    of_gap = {gap: Edit.clear(gap) for gap in cleared}
    for gap, entry in planned.kept_open.items():
        now = gaps.now(gap)
        before, state = (never, SampleState.NEVER) if entry.never else (aside, SampleState.MISSING)
        if before.get(now) != entry.reason:
            of_gap[now] = Edit.clear(now, state, entry.reason)
    return [*of_gap.values(), *fills]


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
