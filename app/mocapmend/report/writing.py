"""Writing a report: what kind of file it becomes, by its name."""

from pathlib import Path

from mocapmend.errors import MocapmendError
from mocapmend.files.atomic import write_bytes
from mocapmend.report import page
from mocapmend.report.model import About, Report

ENDINGS = (".html", ".htm", ".pdf")


def check_report_ending(path: Path) -> None:
    """Make sure that a name says what a report shall be.

    Raises
    ------
    MocapmendError
        If it does not.
    """
    if path.suffix.lower() not in ENDINGS:
        raise MocapmendError(
            "A report is an HTML or a PDF file, and this name says neither.",
            str(path),
            "End the name in .html or .pdf.",
        )


def write_report(report: Report, about: About, path: Path) -> None:
    """Write a report; a file of that name is replaced when all is written.

    Parameters
    ----------
    report : Report
        The figures.
    about : About
        What else it says.
    path : Path
        Ends in one of `ENDINGS`.

    Raises
    ------
    MocapmendError
        If it cannot be written.
    """
    check_report_ending(path)
    if path.suffix.lower() == ".pdf":
        # Slow to import, and only needed here.
        from mocapmend.report import pdf

        data = pdf.render(report, about)
    else:
        data = page.render(report, about).encode("utf-8")
    write_bytes(path, data)
