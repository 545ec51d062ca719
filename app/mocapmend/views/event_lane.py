"""The lane of the file's events: marks of three shapes, with as many labels as keep apart."""

from collections.abc import Callable, Sequence
from itertools import pairwise

from PySide6.QtCore import QCoreApplication, QPointF, QRectF, Qt
from PySide6.QtGui import QColor, QPainter, QPolygonF

from mocapmend.files import Event
from mocapmend.theme import Theme
from mocapmend.views.time_axis import TimeAxis

MARK = 4.0
"""Half the size of a mark in pixels, and the space between a mark and what is beside it."""
REACH = 7.0
"""Pixels around a mark in which a click finds it."""


def whole_frame(event: Event) -> int:
    """Return the frame that is nearest to an event."""
    return round(event.frame)


def name_of(event: Event) -> str:
    """Return what the user reads: side and label, as far as the file has them."""
    if not event.context:
        return event.label or QCoreApplication.translate("EventLane", "Event without a name")
    text = QCoreApplication.translate("EventLane", "{0} {1}", "side, event")
    return text.format(event.context, event.label).strip()


def thinned(
    places: Sequence[float], names: Sequence[str], width_of: Callable[[str], float], end: float
) -> list[str]:
    """Return what can be written beside each mark without touching the next one.

    Parameters
    ----------
    places : sequence of float
        Of the marks, ascending.
    names : sequence of str
        Their full names.
    width_of : callable
        Returns the pixels that a text takes.
    end : float
        Where the lane ends.

    Returns
    -------
    list of str
        The name, or its first letter where there is no room for more, or nothing.
    """
    texts = []
    for (place, after), name in zip(pairwise([*places, end + MARK]), names, strict=True):
        room = after - place - 4 * MARK
        fitting = (text for text in (name, name[:1]) if width_of(text) <= room)
        texts.append(next(fitting, ""))
    return texts


class EventLane:
    """Paints the events of a recording that lie inside it.

    Parameters
    ----------
    events : sequence of Event
        Ordered by time.
    frames : int
        Length of the recording.
    axis : TimeAxis
        Where frames are.
    """

    def __init__(self, events: Sequence[Event], frames: int, axis: TimeAxis) -> None:
        self.title = QCoreApplication.translate("EventLane", "Events")
        self.events = [event for event in events if 0 <= whole_frame(event) < frames]
        self._names = [name_of(event) for event in self.events]
        self._axis = axis

    def x_of(self, event: Event) -> float:
        """Return the horizontal place of an event: the middle of its frame's time."""
        return self._axis.x_of(event.frame + 0.5)

    def event_at(self, x: float) -> Event | None:
        """Return the event whose mark is at a place."""
        near = (event for event in self.events if abs(self.x_of(event) - x) <= REACH)
        return min(near, key=lambda event: abs(self.x_of(event) - x), default=None)

    def paint(self, painter: QPainter, theme: Theme, top: int, height: int) -> None:
        """Paint the lane; left of the axis stands its name."""
        left, width = self._axis.left, self._axis.width
        painter.setPen(QColor(theme.dim))
        place = QRectF(6, top, left - 8, height)
        painter.drawText(place, Qt.AlignmentFlag.AlignVCenter, self.title)
        painter.save()
        painter.setClipRect(QRectF(left, top, width, height))
        painter.fillRect(QRectF(left, top + 1, width, height - 2), QColor(theme.raised))
        seen = [
            (x, event, name)
            for event, name in zip(self.events, self._names, strict=True)
            if left - 2 * MARK <= (x := self.x_of(event)) <= left + width + 2 * MARK
        ]
        places = [x for x, _, _ in seen]
        advance = painter.fontMetrics().horizontalAdvance
        texts = thinned(places, [name for _, _, name in seen], advance, float(left + width))
        painter.setRenderHint(QPainter.RenderHint.Antialiasing)
        for (x, event, _), text in zip(seen, texts, strict=True):
            painter.setPen(Qt.PenStyle.NoPen)
            painter.setBrush(QColor(theme.text))
            painter.drawPolygon(_shape(event, x, top + height / 2))
            painter.setPen(QColor(theme.text))
            at = QRectF(x + 2 * MARK, top, advance(text) + 1, height)
            painter.drawText(at, Qt.AlignmentFlag.AlignVCenter, text)
        painter.restore()


def _shape(event: Event, x: float, y: float) -> QPolygonF:
    """Return a mark: down for a strike, up for an off, a diamond for anything else."""
    label = event.label.lower()
    corners: tuple[tuple[float, float], ...]
    if "strike" in label or label in {"lhs", "rhs", "lic", "ric"}:
        corners = ((-MARK, -MARK), (MARK, -MARK), (0.0, MARK))
    elif "off" in label or label in {"lto", "rto"}:
        corners = ((-MARK, MARK), (MARK, MARK), (0.0, -MARK))
    else:
        corners = ((-MARK, 0.0), (0.0, -MARK), (MARK, 0.0), (0.0, MARK))
    return QPolygonF([QPointF(x + dx, y + dy) for dx, dy in corners])
