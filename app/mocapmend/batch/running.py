"""A batch from its folder to its rows: what is to be done, what is done already, and doing it."""

import hashlib
import logging
from dataclasses import dataclass, replace
from pathlib import Path

from mocapmend import __version__, training
from mocapmend.batch.crew import Crew, Watcher
from mocapmend.batch.folder import REPORT, Found, find
from mocapmend.batch.ledger import NAME as LEDGER
from mocapmend.batch.ledger import Entry, Ledger
from mocapmend.batch.results import Finished, Problem, Row
from mocapmend.batch.seeing import is_still, is_there, stamp_of
from mocapmend.batch.summary_files import SUMMARIES
from mocapmend.batch.work import Task, make_folder
from mocapmend.errors import MocapmendError
from mocapmend.plan import Plan
from mocapmend.repairing import Request

logger = logging.getLogger(__name__)


@dataclass(frozen=True, kw_only=True)
class Order:
    """What a batch is to do.

    Attributes
    ----------
    folder, out : Path
        Where the recordings are and where their copies go; absolute.
    plan : Plan
        How each is repaired.
    pattern : str
        What their names look like.
    recursive : bool
        Whether folders in the folder count.
    reports : bool
        Whether each copy gets a report beside it.
    accept_truncated : bool
        Whether recordings are repaired that end before they should.
    again : bool
        Whether all is done that was done before, and whatever is in the way replaced.
    """

    folder: Path
    out: Path
    plan: Plan
    pattern: str = "*.c3d"
    recursive: bool = False
    reports: bool = False
    accept_truncated: bool = False
    again: bool = False

    @property
    def key(self) -> str:
        """What differs where a copy would: by the plan, its training sets, or the program."""
        digests = training.digests(self.plan.way.params)
        said = repr((__version__, self.plan, sorted(digests.items()), self.accept_truncated))
        return hashlib.sha256(said.encode()).hexdigest()


class Batch:
    """A batch that is ready to be done.

    Parameters
    ----------
    order : Order
        What to do.

    Attributes
    ----------
    rows : dict of str to Row
        The files in their order, as far as is known.
    tasks : list of Task
        What is left to do, the largest files first: so all workers are busy to the end.

    Raises
    ------
    MocapmendError
        If there is nothing to do, or no place to write to.
    """

    def __init__(self, order: Order) -> None:
        self.order = order
        found = find(
            order.folder,
            order.out,
            order.pattern,
            recursive=order.recursive,
            reserved=frozenset((LEDGER, *SUMMARIES)),
        )
        if not found:
            raise MocapmendError(
                f"There is no recording like {order.pattern} in this folder.",
                str(order.folder),
                "Choose another folder, --pattern or --recursive.",
            )
        make_folder(order.out)
        self._ledger = Ledger(order.out)
        self.rows: dict[str, Row] = {}
        self.tasks: list[Task] = []
        self._key = order.key
        for item in found:
            self._sort_out(item)
        self.tasks.sort(key=lambda task: (-task.size, task.file))

    def run(self, crew: Crew, watcher: Watcher) -> None:
        """Have the tasks done; each end is in the ledger before the watcher hears of it."""
        crew.work(self.tasks, _Recorder(self, watcher))

    def close(self) -> None:
        """Give the ledger back."""
        self._ledger.close()

    def begin(self, task: Task) -> None:
        """Note that a copy is going to be written."""
        self._ledger.begin(task.file)

    def end(self, task: Task, finished: Finished) -> None:
        """Note what has become of a task."""
        if finished.trace:
            logger.error("%s: %s", task.request.file, finished.trace)
        if finished.input is not None:
            self._ledger.finish(finished, task.key)
        elif finished.untouched:
            self._ledger.fail(task.file)
        row = finished.row
        if row.problem is not None and is_there(task.out):
            row = replace(row, problem=_with_what_is_left(row.problem, finished))
        self.rows[task.file] = row

    def _sort_out(self, item: Found) -> None:
        """Find out whether a file is done, cannot be done, or is to be done."""
        task = self._task(item)
        entry = self._ledger.done.get(item.file)
        problem = item.problem
        if problem is None and not self.order.again:
            if entry is not None and self._is_current(task, entry):
                self.rows[item.file] = replace(entry.row, state="unchanged")
                return
            # What was begun may have been written, and not noted any more.
            begun = item.file in self._ledger.begun
            problem = None if begun else _in_the_way(task, entry)
        if problem is not None:
            self.rows[item.file] = task.failed(problem)
            return
        self.rows[item.file] = Row(file=item.file, state="waiting")
        self.tasks.append(task)

    def _is_current(self, task: Task, entry: Entry) -> bool:
        """Say whether a copy is what would be made now, with the report that is asked for."""
        if entry.key != task.key or entry.row.output != task.output:
            return False
        report = task.request.report
        if report is not None and not (entry.row.report == task.report and is_there(report)):
            return False
        return is_still(task.request.file, entry.input) and is_still(task.out, entry.output)

    def _task(self, item: Found) -> Task:
        order = self.order
        report = item.output + REPORT if order.reports else ""
        request = Request(
            file=item.path,
            plan=order.plan,
            out=order.out / item.output,
            report=order.out / report if report else None,
            accept_truncated=order.accept_truncated,
        )
        stamp = stamp_of(item.path)
        return Task(
            file=item.file,
            request=request,
            output=item.output,
            report=report,
            size=0 if stamp is None else stamp.size,
            key=self._key,
        )


class _Recorder:
    """Keeps the books, and passes on what the watcher is to hear."""

    def __init__(self, batch: Batch, watcher: Watcher) -> None:
        self._batch = batch
        self._watcher = watcher
        self.at = watcher.at
        self.tick = watcher.tick

    @property
    def stopping(self) -> bool:
        return self._watcher.stopping

    def began(self, task: Task) -> None:
        self._batch.begin(task)
        self._watcher.began(task)

    def finished(self, task: Task, finished: Finished) -> None:
        self._batch.end(task, finished)
        self._watcher.finished(task, finished)


def _with_what_is_left(problem: Problem, finished: Finished) -> Problem:
    """Let a failure say that there is a copy all the same: by another plan, for example."""
    left = (
        "The copy that an earlier run has made is still there."
        if finished.untouched
        else "What is there as its copy may be of this attempt; the next run replaces it."
    )
    return replace(problem, todo=f"{problem.todo} {left}".strip())


def _in_the_way(task: Task, entry: Entry | None) -> Problem | None:
    """Say what a task would replace that no batch has written."""
    out, report = task.out, task.request.report
    if entry is not None and is_there(out) and not is_still(out, entry.output):
        return Problem(
            "The repaired copy was changed since the batch wrote it, and is kept.",
            str(out),
            "Move it, or add --again to replace it.",
        )
    foreign = [out] if entry is None else []
    if report is not None and (entry is None or entry.row.report != task.report):
        foreign.append(report)
    for path in foreign:
        if is_there(path):
            return Problem(
                "There is already a file of this name, which no batch has written.",
                str(path),
                "Move it or choose another output folder, or add --again to replace it.",
            )
    return None
