"""Refining in a process of its own: given and returned is only what is quickly passed."""

from collections.abc import Mapping
from dataclasses import dataclass
from pathlib import Path

from mocapmend.files import Stamp, read_recording
from mocapmend.files.opening import changed_on_disk
from mocapmend.refine.judging import Judged
from mocapmend.refine.running import refine_file
from mocapmend_algorithms.progress import Progress, part
from mocapmend_algorithms.refine.refining import RefineParams


@dataclass(frozen=True)
class Order:
    """What is to be refined, and how.

    Attributes
    ----------
    recording : Path
        The file of the joints.
    stamp : Stamp
        As it was when the user saw it.
    network : str
        Name of one that ships, or a path.
    params : RefineParams
        Of the refinement.
    out : Path
        Where the outcome goes; what is there is replaced.
    reference : Path or None
        What the outcome is held against.
    calibration : tuple of (Path, Path)
        Other recordings of the same person, each with its reference.
    """

    recording: Path
    stamp: Stamp
    network: str
    params: RefineParams
    out: Path
    reference: Path | None = None
    calibration: tuple[tuple[Path, Path], ...] = ()


@dataclass(frozen=True)
class Outcome:
    """What became of it.

    Attributes
    ----------
    markers, frames : int
        How much was computed.
    bridged : mapping of str to int
        Frames in which joints were missing.
    notes : tuple of str
        What the file does not hold.
    judged : Judged or None
        Where there was a reference.
    """

    markers: int
    frames: int
    bridged: Mapping[str, int]
    notes: tuple[str, ...]
    judged: Judged | None


def carry_out(order: Order, progress: Progress) -> Outcome:
    """Refine a recording and write the outcome; a truncated one as far as it is there.

    Raises
    ------
    MocapmendError
        As `refine_file`; and if the recording is another one by now.
    """
    source = read_recording(order.recording)
    if source.stamp != order.stamp:
        raise changed_on_disk(order.recording)
    progress(0.05)
    done = refine_file(
        source,
        order.network,
        order.params,
        order.out,
        order.reference,
        order.calibration,
        accept_truncated=True,
        progress=part(progress, 0.05, 1.0),
    )
    judged = None
    if done.comparison is not None and order.reference is not None:
        judged = Judged.of(done.comparison, done.model.profile, order.reference.name)
    made = done.refined.recording
    return Outcome(made.markers, made.frames, dict(done.bridged), done.saved.notes, judged)
