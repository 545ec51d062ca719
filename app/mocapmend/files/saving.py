"""What all ways to save a recording have in common."""

from dataclasses import dataclass
from pathlib import Path

from mocapmend.errors import MocapmendError
from mocapmend.files.atomic import same_file
from mocapmend.files.c3d_group import NAME
from mocapmend.files.sidecar import sidecar_path
from mocapmend.files.source import Source


@dataclass(frozen=True)
class Saved:
    """What was written.

    Attributes
    ----------
    path : Path
        The new file.
    samples : int
        Number of samples that were replaced.
    notes : tuple of str
        What the user should know about it.
    converted : bool
        Whether integers became floats.
    record : str
        Where the repair record is: "group" (in the file), "sidecar", or "" without one.
    """

    path: Path
    samples: int
    notes: tuple[str, ...] = ()
    converted: bool = False
    record: str = ""

    @property
    def sentences(self) -> tuple[str, ...]:
        """What the user should know, the place of the repair record included."""
        places = {
            "group": f"The repair record is in the file, as parameter group {NAME}.",
            "sidecar": f"The repair record is beside the file: {sidecar_path(self.path).name}.",
        }
        return (*(places[key] for key in places if key == self.record), *self.notes)


def check_place(source: Source, out: Path, *, replace_source: bool, accept_truncated: bool) -> None:
    """Refuse to save where the user would have to say first that it is meant.

    Raises
    ------
    MocapmendError
        If the source is truncated, or would be replaced.
    """
    if source.truncated and not accept_truncated:
        raise MocapmendError(
            f"The file is truncated: {source.recording.frames} of {source.frames_promised} frames "
            "are there.",
            str(source.path),
            "Confirm that you want to save it all the same (--accept-truncated).",
        )
    if not replace_source and same_file(out, source.path):
        raise MocapmendError(
            "This is the file that the data come from.", str(out), "Choose another name."
        )
