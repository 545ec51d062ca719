"""The edits of a recipe, made again in a file."""

from collections.abc import Sequence
from dataclasses import replace

from mocapmend import engine
from mocapmend.changes import earlier, filled, smoothed
from mocapmend.engine import Changes, FillJob, fill_each
from mocapmend.errors import MocapmendError
from mocapmend.files import Source
from mocapmend.recipe import Recipe
from mocapmend.recipe_plan import Planned, SmoothJob, overlapping, plan
from mocapmend_algorithms import Progress, Recording
from mocapmend_algorithms.fill.contract import FillResult
from mocapmend_algorithms.progress import part
from mocapmend_algorithms.smooth.contract import SmoothResult


def fill(recording: Recording, jobs: Sequence[FillJob], progress: Progress) -> list[FillResult]:
    """Fill the gaps of a plan, all of them.

    Parameters
    ----------
    recording : Recording
        The measured samples.
    jobs : sequence of FillJob
        What to fill.
    progress : Progress
        Called often; may cancel.

    Returns
    -------
    list of FillResult
        One per job.

    Raises
    ------
    MocapmendError
        If a method leaves one of its gaps open.
    """
    results = fill_each(recording, jobs, progress)
    for left in (entry for result in results for entry in result.unfilled):
        raise MocapmendError(
            f"A gap of {recording.labels[left.gap.marker]} cannot be filled: {left.reason}.",
            todo="The recipe was made for another recording, or by another version.",
        )
    return results


def smooth(
    recording: Recording, jobs: Sequence[SmoothJob], progress: Progress
) -> list[SmoothResult]:
    """Smooth the runs of a plan, each from what lies beneath all smoothing.

    Parameters
    ----------
    recording : Recording
        The recording with its fills.
    jobs : sequence of SmoothJob
        What to smooth.
    progress : Progress
        Called often; may cancel.

    Raises
    ------
    MocapmendError
        If the parameters do not fit the recording.
    """
    return [
        engine.smooth(
            recording,
            job.runs,
            job.method,
            job.params,
            part(progress, number / len(jobs), (number + 1) / len(jobs)),
        )
        for number, job in enumerate(jobs)
    ]


def replay(source: Source, recipe: Recipe, progress: Progress) -> Changes:
    """Make the edits of a recipe in a file.

    Parameters
    ----------
    source : Source
        The file.
    recipe : Recipe
        What to do.
    progress : Progress
        Called often; may cancel.

    Returns
    -------
    Changes
        What the file becomes by it.

    Raises
    ------
    MocapmendError
        If an edit does not fit the file, or cannot be made.
    """
    planned = plan(source, recipe)
    results = fill(_called(planned, source), planned.jobs, progress)
    made = earlier(planned.layers, without=planned.reopened)
    for job, result in zip(planned.jobs, results, strict=True):
        made = filled(made, result, job.method, job.params)
    for curves in smooth(made.recording, planned.smoothing, progress):
        made = smoothed(made, curves)
    kept_open = {**made.kept_open, **planned.kept_open}
    gaps = [gap for job in planned.jobs for gap in job.gaps]
    for gap in (*planned.freed, *overlapping(source, gaps, source.kept_open)):
        kept_open.pop(gap, None)
    return replace(made, kept_open=kept_open, renamed=planned.renamed).changes()


def _called(planned: Planned, source: Source) -> Recording:
    """Return what gaps are filled from, with the labels that the donors of a recipe go by."""
    recording, new = planned.layers.recording, planned.labels(source)
    labels = tuple(new.get(marker, label) for marker, label in enumerate(recording.labels))
    return replace(recording, labels=labels, seen=recording.present)
