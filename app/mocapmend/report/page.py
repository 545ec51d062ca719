"""The report as one HTML file that needs nothing else, with SVG curves."""

from importlib.resources import files

from mocapmend.report import charts
from mocapmend.report.content import Content, contents
from mocapmend.report.model import About, Report

TEMPLATE = "templates/report.html.j2"


def render(report: Report, about: About) -> str:
    """Return the report as HTML; the same for the same input."""
    return lay_out(contents(report, about))


def lay_out(content: Content) -> str:
    """Return contents of any kind as HTML."""
    # Slow to import, and only needed here.
    from jinja2 import Environment, StrictUndefined

    environment = Environment(
        autoescape=True, undefined=StrictUndefined, trim_blocks=True, lstrip_blocks=True
    )
    source = files("mocapmend_resources").joinpath(TEMPLATE).read_text("utf-8")
    return environment.from_string(source).render(content=content, frame=charts)
