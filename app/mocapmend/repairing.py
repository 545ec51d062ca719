"""One file repaired by a plan: the same for the command line, a batch and a cluster. No Qt.

The steps are functions of their own, in the order in which `repair` takes them. Nothing is printed.
"""

from collections.abc import Callable
from dataclasses import dataclass, replace
from pathlib import Path

from mocapmend import engine, fixing, marker_choice, recipe
from mocapmend.changes import Repaired, earlier, filled
from mocapmend.errors import MocapmendError, NothingToRepairError
from mocapmend.files import Source, check_ending, read_recording
from mocapmend.layers import Layers
from mocapmend.plan import Plan
from mocapmend.repair_outcome import Outcome
from mocapmend_algorithms import Gap, Progress
from mocapmend_algorithms.fill.contract import FillResult, Unfilled
from mocapmend_algorithms.fill.limits import Limits
from mocapmend_algorithms.problems import BadRun
from mocapmend_algorithms.skeleton import Skeleton
from mocapmend_algorithms.smooth.contract import SmoothResult

Began = Callable[[str], None]
"""Is told the title of each step; the progress after it, from 0 to 1, is that of the step."""


@dataclass(frozen=True, kw_only=True)
class Request:
    """What is asked for.

    Attributes
    ----------
    file : Path
        The recording.
    plan : Plan
        How it is repaired.
    limits : Limits, optional
        What holds in place of the plan's own limits, which are in milliseconds.
    out : Path or None
        Where the repaired copy goes; None for a dry run, which writes nothing.
    markers : tuple of str, optional
        Labels of the markers whose gaps are filled, see `marker_choice.choose`; all by default.
    report, recipe : Path, optional
        Where a report goes, and the edits to be replayed.
    replace_source, accept_truncated : bool
        Whether `out` may be the recording itself, and whether that may end before it should.
    """

    file: Path
    plan: Plan
    limits: Limits | None = None
    out: Path | None
    markers: tuple[str, ...] | None = None
    report: Path | None = None
    recipe: Path | None = None
    replace_source: bool = False
    accept_truncated: bool = False

    @property
    def wants_skeleton(self) -> bool:
        """Whether the bones have to be found, which may take long."""
        return self.report is not None or bool(self.plan.fix)

    def limits_at(self, rate: float) -> Limits:
        """Return the limits for a recording of `rate` frames per second (Hz)."""
        return self.plan.limits(rate) if self.limits is None else self.limits


def repair_file(request: Request, progress: Progress, began: Began) -> Outcome:
    """Read a file and repair it; see `repair`.

    Raises
    ------
    MocapmendError
        If it cannot be read too.
    """
    began("Reading")
    return repair(read(request), request, progress, began)


def read(request: Request) -> Source:
    """Read the file, and refuse a name for its copy that no copy of it can have.

    Raises
    ------
    MocapmendError
        If it cannot be read.
    """
    source = read_recording(request.file)
    if request.out is not None:
        check_ending(source, request.out)
    return source


def repair(source: Source, request: Request, progress: Progress, began: Began) -> Outcome:
    """Repair a file that was read, and write what is asked for.

    Parameters
    ----------
    source : Source
        Of `read`.
    request : Request
        What is asked for.
    progress : Progress
        Called often; may cancel.
    began : Began
        Told each step.

    Raises
    ------
    MocapmendError
        If the plan does not fit the file, or if something cannot be written.
    """
    require_repairable(source, request)
    skeleton = find_skeleton(source, request, progress, began)
    layers, fixed = fix(source, skeleton, request, progress, began)
    result = fill(layers, request, progress, began)
    smoothing = smooth(filled(earlier(layers), result, *request.plan.way), request, progress, began)
    limits = request.limits_at(source.recording.rate)
    done = Outcome(layers, tuple(fixed), request.plan.way, limits, result, smoothing, exported=None)
    if request.out is None:
        return done
    done = replace(done, exported=export(done, request, request.out, progress, began))
    if request.report is not None and skeleton is not None:
        write_report(done, skeleton, request.report, progress, began)
    return done


def require_repairable(source: Source, request: Request) -> None:
    """Refuse a file that holds nothing to repair, or less than it says, or not what is asked for.

    Raises
    ------
    MocapmendError
        If it is one.
    """
    if source.truncated and not (request.accept_truncated or request.out is None):
        raise MocapmendError(
            f"The file is truncated: {source.recording.frames} of "
            f"{source.frames_promised} frames are there.",
            str(source.path),
            "To repair what is there, add --accept-truncated.",
        )
    if not source.recording.points.size:
        raise NothingToRepairError(
            "The file holds no marker data: there is nothing to repair.",
            str(source.path),
            "Choose another file.",
        )
    marker_choice.require(source, getattr(request.plan.way.params, "donors", ()))


def find_skeleton(
    source: Source, request: Request, progress: Progress, began: Began
) -> Skeleton | None:
    """Find the bones where a later step needs them."""
    if not request.wants_skeleton:
        return None
    began("Looking for bones")
    return engine.find_skeleton(source, progress)


def fix(
    source: Source, skeleton: Skeleton | None, request: Request, progress: Progress, began: Began
) -> tuple[Layers, list[BadRun]]:
    """Put right what the detectors of the plan find; all markers are looked at."""
    layers = Layers.of(source)
    if not request.plan.fix or skeleton is None:
        return layers, []
    began("Looking for bad samples")
    return fixing.fix(layers, skeleton, request.plan.fix, progress)


def fill(layers: Layers, request: Request, progress: Progress, began: Began) -> FillResult:
    """Fill the gaps of the markers that were asked for; account for all others too.

    Raises
    ------
    MocapmendError
        If there is no such marker, or if the method's training set cannot be used.
    """
    source = layers.source
    never = {gap: kept.reason for gap, kept in layers.kept_open.items() if kept.never}
    gaps = [gap for gap in layers.open_gaps() if gap not in never]
    wanted = marker_choice.choose(source, request.markers)
    began("Filling")
    result = engine.fill(
        layers.recording,
        [gap for gap in gaps if gap.marker in wanted],
        *request.plan.way,
        request.limits_at(source.recording.rate),
        progress,
    )
    result = marker_choice.with_the_others(result, gaps, wanted)
    protected = [Unfilled(gap, reason) for gap, reason in never.items()]
    unfilled = sorted([*result.unfilled, *protected], key=lambda entry: entry.gap)
    return replace(result, unfilled=tuple(unfilled))


def smooth(
    made: Repaired, request: Request, progress: Progress, began: Began
) -> SmoothResult | None:
    """Smooth the markers that were asked for, where the plan says so.

    Raises
    ------
    MocapmendError
        If the parameters do not fit the recording.
    """
    if request.plan.smooth is None:
        return None
    began("Smoothing")
    wanted = marker_choice.choose(made.layers.source, request.markers)
    recording = made.recording
    runs = [Gap(marker, 0, recording.frames) for marker in sorted(wanted)]
    return engine.smooth(recording, runs, *request.plan.smooth, progress)


def export(
    done: Outcome, request: Request, out: Path, progress: Progress, began: Began
) -> engine.Exported:
    """Write the repaired copy and prove that only the repairs differ.

    Raises
    ------
    MocapmendError
        If it cannot be written, or if a proof fails.
    """
    began("Writing")
    changes = done.made.changes()
    if request.recipe is not None:
        # Before the recording, which may be replaced by its repaired copy.
        recipe.write_recipe(
            done.source,
            changes.repairs,
            request.recipe,
            kept_open=changes.kept_open,
            corrections=changes.corrections,
        )
    return engine.export(
        done.source, changes, out, request.replace_source, request.accept_truncated, progress
    )


def write_report(
    done: Outcome, skeleton: Skeleton, path: Path, progress: Progress, began: Began
) -> None:
    """Write the report of what was done.

    Raises
    ------
    MocapmendError
        If it cannot be written.
    """
    began("Report")
    engine.write_report(
        done.source.measured,
        done.after,
        skeleton,
        done.all_repairs,
        done.result.unfilled,
        done.about,
        path,
        progress,
    )
