"""Writing the repaired copy of a recording, and proving that only the repairs differ. No Qt."""

from collections.abc import Callable
from dataclasses import dataclass, replace
from pathlib import Path
from typing import Any

from mocapmend.changes import Changes, with_new_labels
from mocapmend.errors import MocapmendError
from mocapmend.files import (
    CheckReport,
    Claim,
    Provenance,
    Saved,
    Source,
    check_files,
    patches,
    save_patched,
    write_recording,
)
from mocapmend_algorithms import Progress
from mocapmend_algorithms.progress import part

Apart = Callable[..., Any]
"""Calls a function with some arguments and a progress elsewhere, and waits for what it returns."""
READ_BACK = "The file was read back: all samples are as they should be."


@dataclass(frozen=True)
class Exported:
    """A file that was written, and the proofs that it is right.

    Attributes
    ----------
    saved : Saved
        What was written.
    second_reader : str
        What an independent C3D library makes of the file, or how it was read back, as a sentence.
    check : CheckReport or None
        The comparison with the original, passed; None where the new file is no copy of it.
    """

    saved: Saved
    second_reader: str
    check: CheckReport | None

    @property
    def sentences(self) -> tuple[str, ...]:
        """The proofs and what else there is to know, for reports."""
        checked = () if self.check is None else (self.check.sentence, *self.check.allowed)
        return (
            *checked,
            self.second_reader,
            *self.saved.sentences,
        )


def export(
    source: Source,
    changes: Changes,
    out: Path,
    replace_source: bool,  # noqa: FBT001 - a job passes its arguments by position
    accept_truncated: bool,  # noqa: FBT001
    progress: Progress,
    apart: Apart | None = None,
) -> Exported:
    """Write the repaired copy of a file and prove that only the repairs differ.

    A C3D file is copied and patched. What comes from another format, or goes into one, is written
    as a new file.

    The proofs come before the copy gets its name: what was there stays until they have passed.

    Parameters
    ----------
    source : Source
        The file as it was read.
    changes : Changes
        The repairs.
    out : Path
        Where the copy goes; a file of that name is replaced.
    replace_source, accept_truncated : bool
        See `save_patched`.
    progress : Progress
        Called often; may cancel.
    apart : Apart, optional
        Where the second reading goes on, which takes most of the time; here by default.

    Raises
    ------
    MocapmendError
        If it cannot be written, or if a proof fails. Then nothing has changed.
    """
    changes = with_new_labels(source, changes)
    if not patches(source, out):
        points = source.recording.points.copy()
        for run in changes.runs:
            points[run.start : run.start + len(run.values), run.marker] = run.values
        saved = write_recording(
            source,
            replace(source.recording, points=points, labels=_labels(source, changes)),
            changes.repairs,
            out,
            kept_open=changes.kept_open,
            corrections=changes.corrections,
            replace_source=replace_source,
            accept_truncated=accept_truncated,
            progress=progress,
        )
        return Exported(saved, READ_BACK, None)
    proofs: list[tuple[str, CheckReport]] = []

    def prove(copy: Path, record: Provenance | None) -> None:
        claim = Claim.of(source, copy, changes.runs)
        sentence = (
            second_opinion(claim, progress) if apart is None else apart(second_opinion, claim)
        )
        check = check_files(source.path, copy, record)
        if not check.passed:
            raise MocapmendError(
                f"The written file is wrong and was removed: {check.other_differences[0]}",
                str(out),
                "Please report this.",
            )
        proofs.append((sentence, check))
        progress(1.0)

    saved = save_patched(
        source,
        changes.runs,
        out,
        repairs=changes.repairs,
        kept_open=changes.kept_open,
        corrections=changes.corrections,
        replace_source=replace_source,
        accept_truncated=accept_truncated,
        progress=part(progress, 0.0, 0.3),
        confirm=prove,
    )
    return Exported(saved, *proofs[0])


def _labels(source: Source, changes: Changes) -> tuple[str, ...]:
    """Return what the markers of a copy are called."""
    labels = list(source.recording.labels)
    for point, label in changes.labels(source).items():
        labels[source.markers_by_point[point + 1]] = label
    return tuple(labels)


def second_opinion(claim: Claim, progress: Progress) -> str:
    """Confirm what an export has written; see `Claim.confirm`."""
    return claim.confirm(part(progress, 0.3, 0.9))
