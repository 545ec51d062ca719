"""Repair many recordings by one plan: on all cores, or with --scheduler on a Dask cluster.

The copies go into OUT, in the folders that they have in FOLDER, with a summary of all of them:
summary.html to read, summary.csv to compute with. A file that cannot be repaired never stops the
others. The same command goes on where it was stopped: what is done, and whose recording and plan
are as they were, is not done again.

With --scheduler, the workers read and write the files themselves: FOLDER and OUT are on a file
system that all of them see under the same path.
"""

import argparse
import os
import time
from collections.abc import Sequence
from dataclasses import asdict
from pathlib import Path
from typing import Any

from mocapmend.batch import cluster
from mocapmend.batch.crew import Crew
from mocapmend.batch.local import Local
from mocapmend.batch.results import Finished, Row
from mocapmend.batch.running import Batch, Order
from mocapmend.batch.show import Tracker, duration, end_text, result_text
from mocapmend.batch.summary_files import write_summaries
from mocapmend.batch.summary_page import Facts
from mocapmend.batch.totals import Totals, by_need
from mocapmend.batch.work import Task
from mocapmend.cli import common
from mocapmend.cli.console import Console
from mocapmend.cli.usage import UsageError
from mocapmend.errors import MocapmendError
from mocapmend.interrupts import Wish, wish_to_stop
from mocapmend.plan import Plan, read_plan
from mocapmend.report import method_text

DONE, FAILED, INTERRUPTED = 0, 1, 130


def add_arguments(parser: argparse.ArgumentParser) -> None:
    """Say what the command takes."""
    parser.add_argument("folder", type=Path, metavar="FOLDER", help="the recordings")
    parser.add_argument(
        "--plan",
        type=Path,
        metavar="FILE",
        required=True,
        help="method, parameters and limits: a plan that was saved in the window",
    )
    parser.add_argument(
        "-o",
        "--output",
        type=Path,
        metavar="OUT",
        required=True,
        help="the folder of the repaired copies; it is made where it is missing",
    )
    parser.add_argument(
        "--pattern",
        default="*.c3d",
        metavar="GLOB",
        help="what the names of the recordings look like, in upper or lower case (default: *.c3d)",
    )
    parser.add_argument(
        "--recursive",
        action="store_true",
        help="repair what is in the folders of FOLDER too; links to folders are not followed",
    )
    parser.add_argument(
        "--report", action="store_true", help="write a report beside each copy: NAME.html"
    )
    parser.add_argument(
        "--jobs", type=_jobs, metavar="N", help="how many at once (default: one per core)"
    )
    parser.add_argument(
        "--scheduler",
        metavar="ADDRESS",
        help="have a Dask cluster do it, as tcp://HOST:8786; all its workers see FOLDER and OUT "
        "under the same path, and have this version of mocapmend",
    )
    parser.add_argument(
        "--again",
        action="store_true",
        help="do again what is done, and replace what is in OUT of the names needed",
    )
    parser.add_argument(
        "--accept-truncated",
        action="store_true",
        help="repair recordings that end before they should too",
    )


def run(arguments: argparse.Namespace, console: Console) -> int:
    """Do the batch, say what was done, and return the exit code."""
    if arguments.scheduler is not None and arguments.jobs is not None:
        raise UsageError("--jobs is about this machine: leave it out with --scheduler")
    plan = read_plan(arguments.plan)
    order = Order(
        folder=Path(os.path.abspath(arguments.folder)),  # noqa: PTH100 - a link stays a link
        out=Path(os.path.abspath(arguments.output)),  # noqa: PTH100
        plan=plan if arguments.scheduler is None else cluster.with_whole_paths(plan),
        pattern=arguments.pattern,
        recursive=arguments.recursive,
        reports=arguments.report,
        accept_truncated=arguments.accept_truncated,
        again=arguments.again,
    )
    start = time.monotonic()
    batch = Batch(order)
    try:
        with wish_to_stop() as wish:
            workers = _work(batch, arguments, wish, console)
    finally:
        batch.close()
    facts = Facts(
        folder=arguments.folder,
        out=arguments.output,
        plan=arguments.plan,
        method=method_text(*plan.way),
        limits=_limits_text(plan),
        fix=", ".join(plan.fix),
        smoothing="" if plan.smooth is None else method_text(*plan.smooth),
        seconds=time.monotonic() - start,
        workers=workers,
    )
    return _tell(batch, facts, console)


def _work(batch: Batch, arguments: argparse.Namespace, wish: Wish, console: Console) -> str:
    """Do what is to be done, and say who did it."""
    if not batch.tasks:
        return "no worker"
    watcher = _Watcher(batch, wish, console)
    if arguments.scheduler is None:
        local = Local(min(arguments.jobs or cores(), len(batch.tasks)))
        watcher.run(local)
        return f"{local.size} process{'' if local.size == 1 else 'es'}"
    with cluster.connected(arguments.scheduler, batch.order) as crew:
        for warning in crew.warnings:
            console.warn(warning)
        workers = f"{common.count(crew.size, 'worker')} of {arguments.scheduler}"
        watcher.run(crew)
        return workers


class _Watcher:
    """Shows how far the batch is: a line that changes on a terminal, else a line per file."""

    def __init__(self, batch: Batch, wish: Wish, console: Console) -> None:
        self._batch = batch
        self._wish = wish
        self._console = console
        self._tracker = Tracker(batch.tasks)
        self._size = 1
        self.began = self._tracker.began
        self.at = self._tracker.at

    def run(self, crew: Crew) -> None:
        """Have a crew do the batch."""
        self._size = crew.size
        self._batch.run(crew, self)

    @property
    def stopping(self) -> bool:
        """Whether the user has interrupted it."""
        return self._wish.stop

    def finished(self, task: Task, finished: Finished) -> None:
        """Say what has become of a file, where a line stays or something is wrong."""
        self._tracker.finished(task, finished.row)
        if finished.row.problem is not None or not self._console.changes_lines:
            files = len(self._batch.tasks)
            self._console.note(end_text(finished, self._tracker.done, files))

    def tick(self) -> None:
        """Show what goes on."""
        self._console.status(self._tracker.line(self._size))


def _tell(batch: Batch, facts: Facts, console: Console) -> int:
    """Write the summaries, print the result, and return the exit code."""
    rows = by_need(batch.rows.values())
    totals = Totals.of(rows)
    page = table = None
    try:
        page, table = write_summaries(rows, facts, batch.order.out)
    except MocapmendError as error:
        # What was done is to be told all the same.
        console.warn(str(error))
    console.result(
        folder=str(facts.folder),
        output=str(facts.out),
        plan=str(facts.plan),
        method=facts.method,
        limits=facts.limits,
        fix=list(batch.order.plan.fix),
        smoothing=facts.smoothing or None,
        workers=facts.workers,
        interrupted=totals.waiting > 0,
        seconds=facts.seconds,
        totals=asdict(totals),
        files=[row.as_json() for row in rows],
        summary_html=None if page is None else str(page),
        summary_csv=None if table is None else str(table),
    )
    _say(totals, facts, console)
    if page is not None:
        console.say(f"Summary:  {page}")
        console.say(f"Table:    {table}")
    _say_failures([row for row in rows if row.state == "failed"], console)
    if totals.waiting:
        console.warn(
            f"Interrupted; {common.count(totals.waiting, 'file')} not done yet. "
            "The same command goes on where this one has stopped."
        )
        return INTERRUPTED
    return FAILED if totals.failed or page is None else DONE


def _say(totals: Totals, facts: Facts, console: Console) -> None:
    files, gaps = common.count(totals.files, "file"), common.count(totals.gaps, "gap")
    console.say(f"Repaired: {totals.done} of {files}{_of_those(totals)}")
    if facts.fix:
        console.say(f"Fixed:    {common.count(totals.samples_fixed, 'bad sample')} ({facts.fix})")
    samples = common.count(totals.samples_filled, "sample")
    console.say(f"Filled:   {totals.filled} of {gaps}, {samples}")
    if facts.smoothing:
        console.say(f"Smoothed: {common.count(totals.files_smoothed, 'file')} ({facts.smoothing})")
    console.say(f"Time:     {duration(facts.seconds)} with {facts.workers}")


def _say_failures(rows: Sequence[Row], console: Console) -> None:
    if not rows:
        return
    console.say(f"\n{common.count(len(rows), 'file')} failed:")
    for row in rows[: common.MOST_ROWS]:
        console.say(result_text(row))
    if len(rows) > common.MOST_ROWS:
        console.say(f"and {len(rows) - common.MOST_ROWS} more: the summary lists them all.")


def _of_those(totals: Totals) -> str:
    parts = (
        (totals.unchanged, "by an earlier run"),
        (totals.nothing, "without markers"),
        (totals.failed, "failed"),
        (totals.waiting, "not done yet"),
    )
    listed = ", ".join(f"{n} {text}" for n, text in parts if n)
    return f" ({listed})" if listed else ""


def _limits_text(plan: Plan) -> str:
    parts = []
    if plan.max_gap_ms is not None:
        parts.append(f"no gap longer than {plan.max_gap_ms:g} ms")
    if plan.max_error_mm != float("inf"):
        parts.append(f"no expected error above {plan.max_error_mm:g} mm")
    return ", ".join(parts) or "none"


def cores() -> int:
    """Return how many cores this process may use."""
    allowed: Any = getattr(os, "sched_getaffinity", None)
    return len(allowed(0)) if allowed is not None else os.cpu_count() or 1


def _jobs(text: str) -> int:
    try:
        number = int(text)
    except ValueError:
        number = 0
    if number < 1:
        raise argparse.ArgumentTypeError(f"{text!r} is not a number of processes")
    return number
