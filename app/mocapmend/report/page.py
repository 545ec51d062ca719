"""The report as one HTML file that needs nothing else, with SVG curves."""

from importlib.resources import files

from mocapmend.report import charts
from mocapmend.report.content import contents
from mocapmend.report.model import About, Report

TEMPLATE = "templates/report.html.j2"


def render(report: Report, about: About) -> str:
    """Return the report as HTML; the same for the same input."""
    # Slow to import, and only needed here.
    from jinja2 import Environment, StrictUndefined

    environment = Environment(
        autoescape=True, undefined=StrictUndefined, trim_blocks=True, lstrip_blocks=True
    )
    source = files("mocapmend_resources").joinpath(TEMPLATE).read_text("utf-8")
    content = contents(report, about)
    return environment.from_string(source).render(content=content, frame=charts)
