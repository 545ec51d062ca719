"""Refining a recording and writing the outcome as a file of its own."""

from collections.abc import Mapping, Sequence
from dataclasses import asdict, dataclass, replace
from pathlib import Path
from typing import Any

from mocapmend.errors import MocapmendError
from mocapmend.files import Saved, Source, read_recording, same_file, write_recording
from mocapmend.files.refinement import Refinement
from mocapmend.files.sidecar import hash_file
from mocapmend.refine.models import load_model, path_of
from mocapmend.refine.profiles import profiles
from mocapmend_algorithms.arrays import FloatArray
from mocapmend_algorithms.progress import Progress, part
from mocapmend_algorithms.refine.calibrating import mean_error
from mocapmend_algorithms.refine.comparing import Comparison, compare
from mocapmend_algorithms.refine.model import Model
from mocapmend_algorithms.refine.preparing import RefineError, labels_places
from mocapmend_algorithms.refine.profile import Profile
from mocapmend_algorithms.refine.refining import Refined, RefineParams, refine, refined_poses
from mocapmend_algorithms.refine.train.pairs import make_pair

OUTCOME = "_refined.c3d"
"""What is put behind the name of a recording for the name of the outcome."""


@dataclass(frozen=True, eq=False)
class RefinedFile:
    """What became of a recording.

    Attributes
    ----------
    refined : Refined
        The outcome.
    model : Model
        What made it.
    saved : Saved
        The file.
    comparison : Comparison or None
        With the reference, where one was given.
    """

    refined: Refined
    model: Model
    saved: Saved
    comparison: Comparison | None

    @property
    def bridged(self) -> Mapping[str, int]:
        """Frames in which joints were missing, and were bridged, by their labels."""
        counts = self.refined.bridged.sum(axis=0).tolist()
        pairs = zip(self.model.profile.inputs, counts, strict=True)
        return {label: count for label, count in pairs if count}


def refine_file(
    source: Source,
    name: str,
    params: RefineParams,
    out: Path,
    reference: Path | None,
    calibration: Sequence[tuple[Path, Path]],
    accept_truncated: bool,  # noqa: FBT001 - a job passes its arguments by position
    progress: Progress,
) -> RefinedFile:
    """Refine a recording, write the outcome, and hold it against a reference.

    Parameters
    ----------
    source : Source
        The recording of the joints.
    name : str
        Of a network that ships with the program, or the path of one.
    params : RefineParams
        How.
    out : Path
        Where the outcome goes, of the format that its name says; what is there is replaced.
    reference : Path, optional
        A recording of the outputs, made beside the joints.
    calibration : sequence of (Path, Path)
        Other recordings of the same performer, each with a reference: the mean error there is
        subtracted; see `calibrating`.
    accept_truncated : bool
        Whether the joints may be of a truncated file.
    progress : Progress
        Called often; may cancel.

    Raises
    ------
    MocapmendError
        If the network, the recording or the reference cannot be used, or the file not be written.
    """
    model = load_model(name)
    truth = None if reference is None else read_recording(reference)
    if any(same_file(recording, source.path) for recording, _ in calibration):
        raise MocapmendError(
            "A recording cannot calibrate itself.",
            str(source.path),
            "Choose another recording of the same person.",
        )
    offset = _offset(model, params, calibration, part(progress, 0.0, 0.3))
    try:
        refined = refine(source.measured, model, params, part(progress, 0.3, 0.8), offset)
    except RefineError as error:
        raise _complaint(
            error, source.path, _advice(source.recording.labels, model.profile)
        ) from error
    comparison = None
    if truth is not None:
        try:
            comparison = compare(refined.poses, truth.measured, model.profile)
        except RefineError as error:
            raise _complaint(error, truth.path, "Choose another reference.") from error
    made = replace(source, recording=refined.recording, bones=(), repaired=(), provenance=None)
    saved = write_recording(
        made,
        refined.recording,
        (),
        out,
        refined=_record(name, model, params, calibration),
        accept_truncated=accept_truncated,
        progress=part(progress, 0.8, 1.0),
    )
    return RefinedFile(refined, model, saved, comparison)


def default_name(source: Path) -> str:
    """Return how the outcome is called if the user does not care."""
    return f"{source.stem}{OUTCOME}"


def _offset(
    model: Model,
    params: RefineParams,
    calibration: Sequence[tuple[Path, Path]],
    progress: Progress,
) -> FloatArray | None:
    """Return the mean error of calibration recordings, None without any."""
    if not calibration:
        return None
    pairs = []
    for recording, reference in calibration:
        given, truth = (read_recording(path).measured for path in (recording, reference))
        try:
            pairs.append(make_pair(given, truth, model.profile))
        except RefineError as error:
            raise _complaint(error, recording, "Leave this calibration out.") from error
    steps = [part(progress, at / len(pairs), (at + 1) / len(pairs)) for at in range(len(pairs))]
    made = [
        refined_poses(pair.joints, model, int(params.stride), step)
        for pair, step in zip(pairs, steps, strict=True)
    ]
    joints, markers = [pair.joints for pair in pairs], [pair.markers for pair in pairs]
    return mean_error(joints, made, markers, model.profile)


def _record(
    name: str,
    model: Model,
    params: RefineParams,
    calibration: Sequence[tuple[Path, Path]],
) -> Refinement:
    path = path_of(name)
    given: dict[str, Any] = asdict(params)
    if calibration:
        # The files' contents, in pairs: names may lead elsewhere tomorrow.
        given["calibration_sha256"] = tuple(hash_file(one) for pair in calibration for one in pair)
    return Refinement(path.stem, hash_file(path), model.profile.id, given)


def _advice(labels: Sequence[str], wanted: Profile) -> str:
    """Say what can be done about a recording that a network cannot take."""
    if _fits(labels, wanted):
        return "Put the recording right first, or choose another one."
    for profile in profiles().values():
        if _fits(labels, profile):
            return (
                f"Its joints are those of the profile {profile.id}: train a network for it with "
                "“mocapmend train refine”, or choose one."
            )
    return "Choose another network or recording."


def _fits(labels: Sequence[str], profile: Profile) -> bool:
    try:
        labels_places(labels, profile.inputs, profile.name)
    except RefineError:
        return False
    return True


def _complaint(error: RefineError, path: Path, todo: str) -> MocapmendError:
    what = str(error)
    return MocapmendError(f"{what[:1].upper()}{what[1:]}.", str(path), todo)
