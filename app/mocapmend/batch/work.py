"""One file of a batch: what a worker does, wherever it runs."""

import time
import traceback
from collections.abc import Sequence
from dataclasses import dataclass
from pathlib import Path

import numpy as np

from mocapmend import repairing
from mocapmend.batch.results import (
    NUMBER,
    Figures,
    Finished,
    Fixed,
    Problem,
    Reason,
    Row,
    Smoothed,
)
from mocapmend.batch.seeing import see, stamp_of
from mocapmend.errors import MocapmendError, NothingToRepairError
from mocapmend.files.opening import changed_on_disk
from mocapmend.repair_outcome import Outcome
from mocapmend_algorithms import Cancelled, Progress
from mocapmend_algorithms.arrays import BoolArray
from mocapmend_algorithms.fill.contract import Unfilled
from mocapmend_algorithms.metrics import success_curves, tracked
from mocapmend_algorithms.problems import BadRun
from mocapmend_algorithms.smooth.contract import SmoothResult

MOST_REASONS = 10


@dataclass(frozen=True, kw_only=True)
class Task:
    """A file to repair.

    Attributes
    ----------
    file : str
        Its path within the folder, with "/" between folders.
    request : Request
        What to do; `out` is given, and all paths are absolute.
    output, report : str
        The copy and its report within the output folder; `report` may be "".
    size : int
        Of the file in bytes, to estimate how long it takes.
    key : str
        Differs where the plan or the program does.
    """

    file: str
    request: repairing.Request
    output: str
    report: str
    size: int
    key: str

    @property
    def out(self) -> Path:
        """Where the repaired copy goes."""
        assert self.request.out is not None
        return self.request.out

    def failed(self, problem: Problem, seconds: float = 0.0) -> Row:
        """Say that it could not be repaired."""
        return Row(file=self.file, state="failed", problem=problem, seconds=seconds)


def do(task: Task, progress: Progress, began: repairing.Began) -> Finished:
    """Repair a file; whatever goes wrong with it is in what is returned.

    Raises
    ------
    Cancelled
        From `progress` alone.
    """
    start = time.perf_counter()
    trace = ""
    before = stamp_of(task.out)
    try:
        return _repaired(task, start, progress, began)
    except Cancelled:
        raise
    except NothingToRepairError as error:
        seconds = time.perf_counter() - start
        row = Row(file=task.file, state="nothing", problem=Problem.of(error), seconds=seconds)
        return Finished(row, untouched=True)
    except MocapmendError as error:
        problem = Problem.of(error)
    except MemoryError:
        problem = Problem(
            "There is not enough memory for this file.",
            str(task.request.file),
            "Repair fewer files at once (--jobs), or close other programs.",
        )
    except Exception as error:  # noqa: BLE001 - one file never stops the run, whatever it holds
        trace = traceback.format_exc()
        problem = Problem(
            f"Something went wrong inside the program ({type(error).__name__}: {error}).",
            str(task.request.file),
            "The log file has the details: please report it.",
        )
    row = task.failed(problem, time.perf_counter() - start)
    return Finished(row, untouched=stamp_of(task.out) == before, trace=trace)


def _repaired(task: Task, start: float, progress: Progress, began: repairing.Began) -> Finished:
    request = task.request
    make_folder(task.out.parent)
    done = repairing.repair_file(request, progress, began)
    seen = see(request.file)
    if stamp_of(request.file) != done.source.stamp:
        raise changed_on_disk(request.file)
    row = Row(
        file=task.file,
        state="repaired",
        figures=figures_of(done),
        output=task.output,
        report=task.report or None,
        seconds=time.perf_counter() - start,
    )
    return Finished(row, seen, see(task.out))


def make_folder(folder: Path) -> None:
    """Make a folder and those above it, where they are missing.

    Raises
    ------
    MocapmendError
        If that is not possible.
    """
    try:
        folder.mkdir(parents=True, exist_ok=True)
    except (FileExistsError, NotADirectoryError):
        raise MocapmendError(
            "There is a file where a folder is needed.", str(folder), "Choose another folder."
        ) from None
    except OSError as error:
        raise MocapmendError(
            f"The folder cannot be made: {error.strerror}.", str(folder), "Choose another one."
        ) from error


def figures_of(done: Outcome) -> Figures:
    """Return the figures of a repaired file."""
    recording, repairs, unfilled = done.source.recording, done.repairs, done.result.unfilled
    known = [row for row in repairs if not np.isnan(row.expected_error_mm)]
    worst = max(known, key=lambda row: row.expected_error_mm, default=None)
    measured = done.source.measured
    there, after = tracked(measured), tracked(done.after)
    counted = np.logical_or.reduce(there | after, axis=0)
    wrong = done.put_right.wrong_in(measured)
    return Figures(
        frames=recording.frames,
        markers=recording.markers,
        rate_hz=recording.rate,
        gaps=len(repairs) + len(unfilled),
        filled=len(repairs),
        left_open=len(unfilled),
        samples_missing=done.samples_missing,
        samples_filled=done.samples_filled,
        reasons=reasons_of(unfilled),
        expected_median_mm=(
            float(np.median([row.expected_error_mm for row in known])) if known else None
        ),
        expected_worst_mm=None if worst is None else worst.expected_error_mm,
        worst_place="" if worst is None else done.place(worst.gap),
        no_estimate=len(repairs) - len(known),
        tracked_before=_mean_success(there & ~wrong, counted),
        wrong_before=_mean_success(wrong, counted),
        tracked_after=_mean_success(after, counted),
        fixed=fixed_of(done.fixed),
        smoothed=None if done.smoothing is None else smoothed_of(done.smoothing, recording.mm),
        warnings=done.source.warnings,
    )


def fixed_of(runs: Sequence[BadRun]) -> tuple[Fixed, ...]:
    """Count bad samples by kind."""
    kinds: dict[str, list[int]] = {}
    for run in runs:
        kinds.setdefault(run.kind, []).append(run.length)
    return tuple(Fixed(kind, len(kinds[kind]), sum(kinds[kind])) for kind in sorted(kinds))


def smoothed_of(result: SmoothResult, mm: float) -> Smoothed:
    """Say how far smoothing has moved samples; `mm` is the recording's unit in mm."""
    runs = result.runs
    if not runs:
        return Smoothed(0, None, None)
    rms = float(np.median([one.rms for one in runs])) * mm
    return Smoothed(len({one.run.marker for one in runs}), rms, max(o.largest for o in runs) * mm)


def reasons_of(unfilled: Sequence[Unfilled]) -> tuple[Reason, ...]:
    """Count the reasons that differ in their numbers alone, the most frequent first."""
    alike: dict[str, list[Unfilled]] = {}
    for entry in unfilled:
        alike.setdefault(NUMBER.sub("#", entry.reason), []).append(entry)
    reasons = [
        Reason(
            len(entries),
            sum(entry.gap.length for entry in entries),
            max(entries, key=lambda entry: entry.gap.length).reason,
        )
        for entries in alike.values()
    ]
    reasons.sort(key=lambda reason: (-reason.gaps, reason.example))
    return tuple(reasons[:MOST_REASONS])


def _mean_success(samples: BoolArray, counted: BoolArray) -> float | None:
    """Return the share of such samples, mean over the frames, in %; None where no marker counts."""
    if not counted.any():
        return None
    return 100 * float(success_curves(samples, counted=counted).instantaneous.mean())
