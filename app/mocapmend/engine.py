"""What the program does to recordings: the same functions for the window and the command line.

Each is a pure function (files aside) that a worker process can import. No Qt.
"""

import os
from collections.abc import Callable, Collection, Sequence
from dataclasses import replace
from pathlib import Path
from typing import Any, NamedTuple

import numpy as np

from mocapmend import label_templates, report, training, user_templates
from mocapmend.bones import find_skeleton as find_skeleton
from mocapmend.bones import search_skeleton as search_skeleton
from mocapmend.bones import skeleton_of, stated_skeleton
from mocapmend.changes import Changes as Changes
from mocapmend.changes import changes_of as changes_of
from mocapmend.changes import kept_gap as kept_gap
from mocapmend.changes import record as record
from mocapmend.changes import repaired as repaired
from mocapmend.errors import MocapmendError
from mocapmend.exporting import Exported as Exported
from mocapmend.exporting import export as export
from mocapmend.files import CheckReport, Source, Way, check_files, read_recording
from mocapmend.shared_memory import shared_array
from mocapmend.states import States
from mocapmend_algorithms import Gap, Progress, Recording
from mocapmend_algorithms.fill import registry
from mocapmend_algorithms.fill.contract import FillResult, Unfilled
from mocapmend_algorithms.fill.hiding import fill_hiding
from mocapmend_algorithms.fill.limits import Limits, fill_within
from mocapmend_algorithms.labelling import Labelling, LabelParams
from mocapmend_algorithms.labelling import label as propose_labels
from mocapmend_algorithms.progress import part
from mocapmend_algorithms.skeleton import Skeleton
from mocapmend_algorithms.smooth import registry as smoothers
from mocapmend_algorithms.smooth.contract import SmoothResult
from mocapmend_algorithms.sparse.part_sets import going_on, train_parts
from mocapmend_algorithms.sparse.part_training import PartSettings
from mocapmend_algorithms.sparse.training_set import TrainingSet, TrainingSetError, gather

FOR_MANY = Way(shared_array, threads=min(4, os.cpu_count() or 1))
"""How a file is read that a user waits for, and that workers are to share."""


def load(path: Path, progress: Progress) -> tuple[Source, Skeleton]:
    """Read a file of any format and find its skeleton.

    The source's warnings also name the user's skeleton templates that are wrong.

    Raises
    ------
    MocapmendError
        If it cannot be read.
    """
    source = read_recording(path)
    progress(0.5)
    own, complaints = user_templates.load()
    skeleton = skeleton_of(source, own, part(progress, 0.5, 1.0))
    if complaints:
        source = replace(source, warnings=(*source.warnings, *complaints))
    progress(1.0)
    return source, skeleton


class ToShow(NamedTuple):
    """What a window needs of a file.

    Attributes
    ----------
    source : Source
        The recording.
    skeleton : Skeleton or None
        None where `search_skeleton` is to find it.
    states : States
        Of its samples.
    """

    source: Source
    skeleton: Skeleton | None
    states: States


def load_to_show(path: Path, progress: Progress) -> ToShow:
    """Read a file as `load` does, soon and for many: a search for its skeleton may come later.

    Its samples are in shared memory where the system has some.

    Raises
    ------
    MocapmendError
        If it cannot be read.
    """
    source = read_recording(path, FOR_MANY)
    progress(0.8)
    _, complaints = user_templates.load()
    if complaints:
        source = replace(source, warnings=(*source.warnings, *complaints))
    # Here and now, for the window would wait for it. numpy loads np.ma when it is first asked for
    # different values or a percentile, as the views do.
    _ = source.measured.present, np.ma
    read = ToShow(source, stated_skeleton(source), States(source))
    progress(1.0)
    return read


def fill(
    recording: Recording,
    gaps: Sequence[Gap],
    method_id: str,
    params: Any,
    limits: Limits,
    progress: Progress,
) -> FillResult:
    """Fill the gaps that a method can fill within the limits; see `fill_within`.

    Raises
    ------
    MocapmendError
        If a training set that the parameters name cannot be used.
    """
    with training.usable(params) as found:
        return fill_within(recording, gaps, registry.method(method_id), found, limits, progress)


def fill_anyway(
    recording: Recording, gaps: Sequence[Gap], method_id: str, params: Any, progress: Progress
) -> FillResult:
    """Fill gaps whatever their length and expected error.

    A gap may cover measured samples, which then are hidden from its own fill; see `fill_hiding`.

    Raises
    ------
    MocapmendError
        If a training set that the parameters name cannot be used.
    """
    with training.usable(params) as found:
        function = registry.method(method_id).function
        return fill_hiding(recording, gaps, function, found, progress)


def smooth(
    recording: Recording, runs: Sequence[Gap], method_id: str, params: Any, progress: Progress
) -> SmoothResult:
    """Smooth runs of a recording as it is shown, fills included.

    Raises
    ------
    MocapmendError
        If the parameters do not fit the recording.
    """
    try:
        return smoothers.smoother(method_id).function(recording, runs, params, progress)
    except ValueError as error:
        raise MocapmendError(
            f"This cannot be smoothed: {error}.".replace("..", "."),
            todo="Choose other parameters, or another method.",
        ) from error


class FillJob(NamedTuple):
    """Gaps that one method fills with the same parameters."""

    method: str
    params: Any
    gaps: tuple[Gap, ...]


def fill_each(
    recording: Recording, jobs: Sequence[FillJob], progress: Progress
) -> list[FillResult]:
    """Fill gaps by several methods as `fill_anyway` does, and return a result for each job.

    Raises
    ------
    MocapmendError
        If a training set that the parameters name cannot be used.
    """
    results = []
    for number, job in enumerate(jobs):
        share = part(progress, number / len(jobs), (number + 1) / len(jobs))
        results.append(fill_anyway(recording, job.gaps, job.method, job.params, share))
    return results


def fill_gap(
    recording: Recording, gap: Gap, method_id: str, params: Any, progress: Progress
) -> FillResult:
    """Fill one gap as `fill_anyway` does, to be looked at."""
    return fill_anyway(recording, [gap], method_id, params, progress)


def train_sparse(
    recordings: Sequence[Recording],
    about: str,
    markers: Collection[str],
    rate: float | None,
    parts: PartSettings | None,
    progress: Progress,
    earlier: TrainingSet | None = None,
    keep: Callable[[TrainingSet], None] = lambda _: None,
) -> TrainingSet:
    """Make a training set for the sparse methods.

    Parameters
    ----------
    recordings : sequence of Recording
        What to learn from.
    about : str
        What they are, for people.
    markers : collection of str
        The markers to learn; see `gather`.
    rate : float, optional
        Frames per second (Hz) of the set; by default the lowest of the recordings.
    parts : PartSettings, optional
        How the dictionaries of a skeleton's parts are trained; none by default.
    progress : Progress
        Called often; may cancel.
    earlier : TrainingSet, optional
        Of a training that was broken off: what it has of the same motion is kept.
    keep : callable, optional
        Gets what is done after each part.

    Raises
    ------
    MocapmendError
        If nothing can be learned from the recordings.
    """
    common_rate = rate or min((recording.rate for recording in recordings), default=None)
    try:
        made = gather(recordings, about, common_rate, markers)
        if parts is not None:
            made = train_parts(going_on(made, earlier), parts, progress, keep)
    except TrainingSetError as error:
        todo = "Choose other recordings, or name the markers to learn."
        raise training.complaint(error, "", todo) from error
    progress(1.0)
    return made


def label_from(
    recording: Recording, paths: Sequence[Path], params: LabelParams, progress: Progress
) -> Labelling:
    """Propose labels for a recording's points, learned from labelled recordings or by a template.

    Raises
    ------
    MocapmendError
        If one of them cannot be read, or nothing can be learned from them.
    """
    model = label_templates.model_of(paths, part(progress, 0.0, 0.1))
    return propose_labels(recording, model, params, part(progress, 0.1, 1.0))


def check(original: Path, repaired: Path, progress: Progress) -> CheckReport:
    """Compare two files; see `check_files`.

    Raises
    ------
    MocapmendError
        If one of them cannot be read or the original is not a C3D file.
    """
    found = check_files(original, repaired)
    progress(1.0)
    return found


def write_report(
    before: Recording,
    after: Recording,
    skeleton: Skeleton,
    repairs: Sequence[report.RepairRow],
    unfilled: Sequence[Unfilled],
    about: report.About,
    path: Path,
    progress: Progress,
) -> None:
    """Write the report of a recording before and after its repairs: HTML or PDF, by its name.

    Raises
    ------
    MocapmendError
        If the name says neither, or if it cannot be written.
    """
    report.check_report_ending(path)
    done = about.put_right
    summary = report.summarise(before, after, skeleton, repairs, unfilled, progress, done)
    report.write_report(summary, about, path)


def report_figures(
    before: Recording,
    after: Recording,
    skeleton: Skeleton,
    repairs: Sequence[report.RepairRow],
    unfilled: Sequence[Unfilled],
    about: report.About,
    progress: Progress,
) -> tuple[report.Report, report.Methods]:
    """Return the figures of a report, and its methods paragraph, for the window.

    The lists of repairs and open gaps, which the window has, are left out: they may be long.
    """
    done = about.put_right
    summary = report.summarise(before, after, skeleton, repairs, unfilled, progress, done)
    return replace(summary, repairs=(), open_gaps=()), report.describe(summary, about)
