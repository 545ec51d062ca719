"""What the queue's table says of a problem, column by column."""

import math
from enum import IntEnum

import numpy as np
from PySide6.QtCore import QObject

from mocapmend.document import Document
from mocapmend.problem_list import GAP
from mocapmend.ranking import Problem, Status
from mocapmend.views.engine_texts import method_name, shown
from mocapmend.views.suspect_texts import (
    kind_text,
    kinds_text,
    markers_text,
    reason_text,
    score_text,
)
from mocapmend.views.tables import frames_text
from mocapmend_algorithms import Gap


class Column(IntEnum):
    """Of the table, from left to right."""

    STATUS = 0
    MARKER = 1
    KIND = 2
    FRAMES = 3
    ERROR = 4
    HARM = 5
    MS = 6
    METHOD = 7
    CONTEXT = 8
    PLACE = 9


GLYPHS = {
    Status.OPEN: "○",
    Status.BEYOND: "◌",
    Status.LEFT: "◐",
    Status.REPAIRED: "●",
    Status.NEVER: "⊘",
    Status.FOUND: "✕",
    Status.FIXED: "✔",
    Status.DISMISSED: "–",
}


class QueueTexts(QObject):
    """Words for the problems of a document."""

    def __init__(self, document: Document, parent: QObject | None = None) -> None:
        super().__init__(parent)
        self._document = document

    def status_text(self, status: Status) -> str:
        """Return what a status is called."""
        return {
            Status.OPEN: self.tr("open"),
            Status.BEYOND: self.tr("beyond the limits"),
            Status.LEFT: self.tr("left open"),
            Status.REPAIRED: self.tr("repaired"),
            Status.NEVER: self.tr("never to be filled"),
            Status.FOUND: self.tr("found"),
            Status.FIXED: self.tr("fixed"),
            Status.DISMISSED: self.tr("no problem"),
        }[status]

    def text(self, problem: Problem, column: Column) -> str:
        """Return what a cell shows."""
        gap, mm = problem.gap, self._document.original.mm
        match column:
            case Column.STATUS:
                return GLYPHS[problem.status]
            case Column.MARKER:
                return self._markers_text(problem)
            case Column.KIND:
                return kind_text(GAP if problem.bad is None else problem.bad.kind)
            case Column.FRAMES:
                return str(gap.length)
            case Column.ERROR:
                return self._error_text(problem)
            case Column.HARM:
                return "" if math.isnan(problem.harm) else short_number(problem.harm * mm)
            case Column.MS:
                return f"{self._ms(gap):.0f}"
            case Column.METHOD:
                return "" if problem.best is None else method_name(problem.best.method)
            case Column.CONTEXT:
                return self._context(gap)
            case Column.PLACE:
                return frames_text(gap, self._document.original.first_frame)

    def _markers_text(self, problem: Problem) -> str:
        names, bad = self._document.names, problem.bad
        return names[problem.gap.marker] if bad is None else markers_text(bad, names)

    def _error_text(self, problem: Problem) -> str:
        if not problem.tried:
            return "…"
        error = problem.error * self._document.original.mm
        return "?" if math.isnan(error) else f"{error:.1f}"

    def _context(self, gap: Gap) -> str:
        middle = (gap.start + gap.stop - 1) // 2
        others = int(np.count_nonzero(~self._document.original.present[middle])) - 1
        match gap.kind(self._document.original.frames):
            case "leading":
                text = self.tr("start, {0} more missing")
            case "trailing":
                text = self.tr("end, {0} more missing")
            case _:
                text = self.tr("inside, {0} more missing")
        return text.format(max(0, others))

    def tip(self, problem: Problem) -> str:
        """Return what is told of a row under the mouse."""
        gap, best, bad = problem.gap, problem.best, problem.bad
        first = self._document.original.first_frame + gap.start
        last = first + gap.length - 1
        labels = self._document.labels
        lines = [
            self.tr("{0}, frames {1} to {2}: {3}").format(
                labels[gap.marker] if bad is None else markers_text(bad, labels),
                first,
                last,
                self.status_text(problem.status),
            )
        ]
        if bad is not None:
            about = (kinds_text(bad.kind), score_text(bad))
            lines.append(", ".join(filter(None, about)))
        if problem.reason:
            lines.append(shown(problem.reason) if bad is None else reason_text(bad))
        if best is not None:
            lines.append(method_name(best.method))
        elif problem.tried and problem.status < Status.REPAIRED:
            lines.append(self.tr("No repair that was tried could be tested here"))
        return "\n".join(lines)

    def _ms(self, gap: Gap) -> float:
        return 1000.0 * gap.length / self._document.original.rate


def short_number(value: float) -> str:
    """Write a number in five characters: what is cut off cannot be compared."""
    for size, sign in ((1e5, ""), (1e7, "k")):
        if value < size - 0.5:
            return f"{value / (1e3 if sign else 1.0):.0f}{sign}"
    return f"{value / 1e6:.0f}M"
