"""What is wrong with the names of the files of a refinement, in the user's language."""

from pathlib import Path

from PySide6.QtCore import QCoreApplication

from mocapmend.files import WRITTEN, same_file

translate = QCoreApplication.translate


def file_problem(recording: Path, reference: Path | None, out: Path | None) -> str:
    """Say what is in the way of writing the outcome, "" where nothing is.

    Parameters
    ----------
    recording : Path
        What is refined.
    reference : Path, optional
        What the outcome is measured against.
    out : Path, optional
        Where it goes.
    """
    if reference is not None and not reference.is_file():
        return translate("RefineChecks", "There is no reference of this name.")
    if out is None:
        return translate("RefineChecks", "Say where the outcome goes.")
    if not out.name.lower().endswith(WRITTEN):
        ends = ", ".join(end for end in WRITTEN if end.count(".") == 1)
        text = translate("RefineChecks", "The name of the outcome must end in one of {0}.")
        return text.format(ends)
    if out.is_dir() or not out.absolute().parent.is_dir():
        return translate("RefineChecks", "There is no folder for the outcome.")
    taken = (recording, *(() if reference is None else (reference,)))
    if any(same_file(out, path) for path in taken):
        return translate(
            "RefineChecks", "The outcome must not replace the recording or its reference."
        )
    return ""
