"""The report as one HTML file that needs nothing else, with SVG curves."""

from collections.abc import Iterable
from dataclasses import dataclass
from importlib.resources import files
from math import isnan
from pathlib import Path

from mocapmend import __version__
from mocapmend.files.atomic import write_bytes
from mocapmend.report import charts
from mocapmend.report.model import Report

TEMPLATE = "templates/report.html.j2"
KINDS = (
    ("instantaneous", "Tracked now"),
    ("running_mean", "Tracked so far (running mean)"),
    ("survival", "Never lost since the first frame"),
)


@dataclass(frozen=True)
class About:
    """What the report says about its making.

    Attributes
    ----------
    file : str
        Name of the recording, without its folder.
    methods : tuple of str
        The methods used, with their parameters.
    limits : str
        The limits that held, as a sentence.
    warnings : tuple of str
        What was odd about the file.
    earlier : int
        How many of the repairs the file had when it was opened.
    proof : tuple of str
        What the checks of the written file found; empty where none was written.
    """

    file: str
    methods: tuple[str, ...] = ()
    limits: str = ""
    warnings: tuple[str, ...] = ()
    earlier: int = 0
    proof: tuple[str, ...] = ()


def write_html(report: Report, about: About, path: Path) -> None:
    """Write the report; a file of that name is replaced when all is written.

    Raises
    ------
    MocapmendError
        If it cannot be written.
    """
    data = render(report, about).encode("utf-8")
    write_bytes(path, data)


def render(report: Report, about: About) -> str:
    """Return the report as HTML; the same for the same input."""
    # Slow to import, and only needed here.
    from jinja2 import Environment, StrictUndefined

    environment = Environment(
        autoescape=True, undefined=StrictUndefined, trim_blocks=True, lstrip_blocks=True
    )
    environment.filters |= {"number": _number, "percent": _percent}
    source = files("mocapmend_resources").joinpath(TEMPLATE).read_text("utf-8")
    return environment.from_string(source).render(
        report=report,
        about=about,
        version=__version__,
        frame=charts,
        success=tuple(_success_charts(report)),
        bones=tuple(_bone_charts(report)),
        touched=[row for row in report.markers if row.gaps_before or row.gaps_after],
        repaired_bones=sorted(
            (i for i in range(len(report.bones)) if report.bone_repairs[i]),
            key=lambda i: -report.bone_repairs[i],
        ),
    )


def _success_charts(report: Report) -> Iterable[charts.Chart]:
    for attribute, title in KINDS:
        before = 100 * getattr(report.success_before, attribute)
        after = 100 * getattr(report.success_after, attribute)
        yield charts.draw(title, "markers (%)", report.rate, before, after, top=100.0)


def _bone_charts(report: Report) -> Iterable[charts.Chart]:
    for column, bone in enumerate(report.shown_bones):
        yield charts.draw(
            report.bone_names[bone],
            f"length ({report.unit})",
            report.rate,
            report.lengths_before[:, column],
            report.lengths_after[:, column],
            changed=report.changed[:, column],
        )


def _number(value: float, decimals: int = 1) -> str:
    return "—" if isnan(value) else f"{value:.{decimals}f}"


def _percent(value: float) -> str:
    """Write a share so that little does not look like nothing, nor almost all like all."""
    if isnan(value):
        return "—"
    if 0 < value < 0.01:
        return "<0.01"
    return ">99.99" if 99.99 < value < 100 else f"{value:.2f}"
