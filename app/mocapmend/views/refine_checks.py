"""What is wrong with the names of the files of a refinement, in the user's language."""

from pathlib import Path

from PySide6.QtCore import QCoreApplication

from mocapmend.files import WRITTEN, same_file

translate = QCoreApplication.translate


Given = tuple[Path | None, Path | None, Path | None]
"""Reference, calibration recording, and reference of that."""


def file_problem(recording: Path, given: Given, out: Path | None) -> str:
    """Say what is in the way of writing the outcome, "" where nothing is.

    Parameters
    ----------
    recording : Path
        What is refined.
    given : tuple of Path or None
        The reference, and what the outcome is calibrated with.
    out : Path, optional
        Where it goes.
    """
    reference, calibration, truth = given
    if reference is not None and not reference.is_file():
        return translate("RefineChecks", "There is no reference of this name.")
    if (calibration is None) != (truth is None):
        return translate("RefineChecks", "To calibrate, give a recording and its reference.")
    if any(path is not None and not path.is_file() for path in (calibration, truth)):
        return translate("RefineChecks", "There is no recording of this name to calibrate with.")
    if calibration is not None and same_file(calibration, recording):
        return translate("RefineChecks", "A recording cannot calibrate itself.")
    if out is None:
        return translate("RefineChecks", "Say where the outcome goes.")
    if not out.name.lower().endswith(WRITTEN):
        ends = ", ".join(end for end in WRITTEN if end.count(".") == 1)
        text = translate("RefineChecks", "The name of the outcome must end in one of {0}.")
        return text.format(ends)
    if out.is_dir() or not out.absolute().parent.is_dir():
        return translate("RefineChecks", "There is no folder for the outcome.")
    taken = (recording, *(path for path in given if path is not None))
    if any(same_file(out, path) for path in taken):
        return translate(
            "RefineChecks", "The outcome must not replace one of the other recordings."
        )
    return ""
