"""What is painted around the lanes of the timeline: names, ruler, gap, selection, playhead."""

from PySide6.QtCore import QCoreApplication, QPointF, QRect, QRectF, Qt
from PySide6.QtGui import QColor, QFontMetrics, QPainter, QPen

from mocapmend.theme import Theme
from mocapmend.views.gap_arrows import ARROW, HINT, paint_arrow
from mocapmend.views.lane import ticks
from mocapmend.views.lane_layout import LaneLayout
from mocapmend.views.time_axis import TimeAxis
from mocapmend_algorithms import Gap, Recording


class TimelineMarks:
    """Paints marks over the lanes of a recording.

    Parameters
    ----------
    recording : Recording
        Its rate and its first frame are shown.
    axis : TimeAxis
        Where frames are.
    layout : LaneLayout
        Where lanes are.
    """

    def __init__(self, recording: Recording, axis: TimeAxis, layout: LaneLayout) -> None:
        self._recording = recording
        self._axis = axis
        self._layout = layout

    @property
    def _right(self) -> int:
        return self._axis.left + self._axis.width

    def names(self, painter: QPainter, theme: Theme, selection: tuple[int, ...]) -> None:
        """Write the names of the selected lanes, and of as many others as keep apart."""
        layout, height = self._layout, self._layout.lane_height
        seen = layout.in_view().tolist()
        chosen = set(selection)
        # The current marker first, then the other selected ones, then as many as have room.
        selected = [marker for marker in reversed(selection) if marker in seen]
        every = max(1, -(-(layout.text - 3) // height))
        taken: list[int] = []
        for marker in (*selected, *seen[layout.first_named(every) :: every]):
            top = layout.lane_top(marker) + (height - layout.text) // 2
            clipped = top < layout.lanes_area - 2 and marker not in chosen
            if clipped or any(abs(top - other) < every * height for other in taken):
                continue
            taken.append(top)
            place = QRectF(0, top, self._axis.left - 4, layout.text)
            if marker in chosen:
                painter.fillRect(place, QColor(theme.accent))
            painter.setPen(QColor(theme.on_accent if marker in chosen else theme.dim))
            place.adjust(6, 0, 0, 0)
            painter.drawText(place, Qt.AlignmentFlag.AlignVCenter, layout.names[marker])

    def ruler(self, painter: QPainter, theme: Theme, visible: tuple[float, float]) -> None:
        """Write the seconds since the first frame."""
        metrics, bottom, rate = painter.fontMetrics(), self._layout.ruler, self._recording.rate
        widest = metrics.horizontalAdvance("0000.00 s") + 24
        count = max(2, self._axis.width // widest)
        seconds, decimals = ticks(visible[0] / rate, visible[1] / rate, count)
        painter.setPen(QColor(theme.dim))
        for second in seconds.tolist():
            x = self._axis.x_of(second * rate)
            painter.drawLine(QPointF(x, bottom - 5), QPointF(x, bottom - 1))
            text = QCoreApplication.translate("TimelineMarks", "{0} s").format(
                f"{second:.{decimals}f}"
            )
            if x + 3 + metrics.horizontalAdvance(text) < self._right:
                place = QRectF(x + 3, 0, widest, bottom - 3)
                painter.drawText(place, Qt.AlignmentFlag.AlignVCenter, text)

    def span(self, painter: QPainter, theme: Theme, span: tuple[int, int], height: int) -> None:
        """Paint the selected frames as a band, and their length where there is room."""
        left, right = (
            min(max(self._axis.x_of(frame), self._axis.left), self._right) for frame in span
        )
        if left >= right:
            return
        veil = QColor(theme.accent)
        veil.setAlpha(50)
        painter.fillRect(QRectF(left, 0, right - left, height), veil)
        painter.setPen(QPen(QColor(theme.accent), 1, Qt.PenStyle.DashLine))
        for frame, x in zip(span, (left, right), strict=True):
            if x == self._axis.x_of(frame):
                painter.drawLine(QPointF(x, 0), QPointF(x, height))
        frames = span[1] - span[0]
        text = QCoreApplication.translate("TimelineMarks", "{0} frames, {1} s").format(
            frames, f"{frames / self._recording.rate:.2f}"
        )
        if painter.fontMetrics().horizontalAdvance(text) + 12 < right - left:
            place = QRectF(left + 1, 0, right - left - 2, self._layout.ruler - 1)
            painter.fillRect(place, QColor(theme.raised))
            painter.setPen(QColor(theme.text))
            # At the left: the flag of the playhead is rather in the middle or at the right end.
            place.adjust(6, 0, 0, 0)
            painter.drawText(place, Qt.AlignmentFlag.AlignVCenter, text)

    def gap(self, painter: QPainter, theme: Theme, gap: Gap) -> None:
        """Frame the current gap and put arrows on its ends; point to it when it is out of view."""
        left, right = self._axis.x_of(gap.start), self._axis.x_of(gap.stop)
        top, height = self._layout.lane_top(gap.marker), self._layout.lane_height - 1
        painter.save()
        painter.setRenderHint(QPainter.RenderHint.Antialiasing)
        painter.setClipRect(
            QRectF(self._axis.left - ARROW, 0, self._axis.width + 2 * ARROW, self._layout.height),
            Qt.ClipOperation.IntersectClip,
        )
        if right < self._axis.left or left > self._right:
            self._hint(painter, theme, top + height / 2, before=right < self._axis.left)
        else:
            painter.setPen(QPen(QColor(theme.preview), 1.5))
            painter.setBrush(Qt.BrushStyle.NoBrush)
            begin, end = max(left, self._axis.left - 2.0), min(right, self._right + 2.0)
            painter.drawRect(QRectF(begin - 1, top - 1, max(1.0, end - begin) + 2, height + 2))
            for y in (top - 1 - ARROW / 2, top + height + 1 + ARROW / 2):
                if left >= self._axis.left:
                    paint_arrow(painter, theme, QPointF(left - 0.5, y), -ARROW)
                if right <= self._right:
                    paint_arrow(painter, theme, QPointF(right + 0.5, y), ARROW)
        painter.restore()

    def _hint(self, painter: QPainter, theme: Theme, y: float, *, before: bool) -> None:
        area = self._layout.lanes_area
        y = min(max(y, area + HINT), self._layout.height - HINT)
        if before:
            paint_arrow(painter, theme, QPointF(self._axis.left + 2, y), HINT)
        else:
            paint_arrow(painter, theme, QPointF(self._right - 2, y), -HINT)

    def playhead_area(self, metrics: QFontMetrics, frame: int) -> QRect:
        """Return a part of the timeline that holds all of a frame's playhead."""
        reach = metrics.horizontalAdvance("0") * len(str(frame + self._recording.first_frame)) + 14
        x = int(self._axis.x_of(frame + 0.5))
        return QRect(x - reach, 0, 2 * reach + 1, self._layout.height)

    def playhead(self, painter: QPainter, theme: Theme, frame: int, height: int) -> None:
        """Draw a line through the middle of a frame's time, with the frame's number."""
        x = self._axis.x_of(frame + 0.5)
        if not self._axis.left <= x <= self._right:
            return
        painter.setPen(QPen(QColor(theme.playhead), 1))
        painter.drawLine(QPointF(x, 0), QPointF(x, height))
        text = str(frame + self._recording.first_frame)
        width = painter.fontMetrics().horizontalAdvance(text) + 10
        left = max(self._axis.left, min(x - width / 2, self._right - width))
        flag = QRectF(left, 0, width, self._layout.ruler - 3)
        painter.setPen(Qt.PenStyle.NoPen)
        painter.setBrush(QColor(theme.accent))
        painter.drawRoundedRect(flag, 3, 3)
        painter.setPen(QColor(theme.on_accent))
        painter.drawText(flag, Qt.AlignmentFlag.AlignCenter, text)
