"""The report: what the repairs changed, as figures for the window and as one HTML file. No Qt."""

from mocapmend.report.model import MarkerRow, OpenGap, RepairRow, Report
from mocapmend.report.page import About, write_html
from mocapmend.report.summary import summarise

__all__ = [
    "About",
    "MarkerRow",
    "OpenGap",
    "RepairRow",
    "Report",
    "summarise",
    "write_html",
]
