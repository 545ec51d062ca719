"""The report: what the repairs changed, as figures for the window and as HTML or PDF. No Qt."""

from mocapmend.report.methods import Methods, describe, method_text
from mocapmend.report.model import About, EditRow, MarkerRow, OpenGap, RepairRow, Report
from mocapmend.report.put_right import PutRight, SmoothRow, put_right
from mocapmend.report.refining import Refining, refining
from mocapmend.report.rows import repair_rows
from mocapmend.report.summary import summarise
from mocapmend.report.writing import ENDINGS, check_report_ending, write_report

__all__ = [
    "ENDINGS",
    "About",
    "EditRow",
    "MarkerRow",
    "Methods",
    "OpenGap",
    "PutRight",
    "Refining",
    "RepairRow",
    "Report",
    "SmoothRow",
    "check_report_ending",
    "describe",
    "method_text",
    "put_right",
    "refining",
    "repair_rows",
    "summarise",
    "write_report",
]
