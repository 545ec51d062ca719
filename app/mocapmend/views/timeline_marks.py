"""What is painted around the lanes of the timeline: names, ruler, gap, selection, playhead."""

from PySide6.QtCore import QCoreApplication, QPointF, QRect, QRectF, Qt
from PySide6.QtGui import QColor, QFontMetrics, QPainter, QPen

from mocapmend.theme import Theme
from mocapmend.views.gap_arrows import ARROW, HINT, paint_arrow
from mocapmend.views.lane import thin, ticks
from mocapmend.views.lane_layout import LaneLayout
from mocapmend.views.time_axis import TimeAxis
from mocapmend_algorithms import Gap, Recording

WIDEST_TIME = "0000.00 s"


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
        """Draw a mark at round seconds since the first frame."""
        bottom = self._layout.ruler
        painter.setPen(thin(painter, theme.dim))
        for place, _ in self._seconds(painter.fontMetrics(), visible):
            x = place.left() - 3
            painter.drawLine(QPointF(x, bottom - 5), QPointF(x, bottom - 1))

    def seconds(
        self,
        painter: QPainter,
        theme: Theme,
        visible: tuple[float, float],
        frame: int,
        span: tuple[int, int] | None,
    ) -> None:
        """Write the seconds at the marks of the ruler, but for what other texts would cover."""
        metrics = painter.fontMetrics()
        others = [self._flag(metrics, frame)]
        if span is not None:
            others.append(self._caption(metrics, span)[0])
        painter.setPen(QColor(theme.dim))
        for place, text in self._seconds(metrics, visible):
            if place.right() < self._right and not any(map(place.intersects, others)):
                painter.drawText(place, Qt.AlignmentFlag.AlignVCenter, text)

    def _seconds(
        self, metrics: QFontMetrics, visible: tuple[float, float]
    ) -> list[tuple[QRectF, str]]:
        """Return the round seconds with the places of their texts, right of their marks."""
        rate = self._recording.rate
        count = max(2, self._axis.width // (metrics.horizontalAdvance(WIDEST_TIME) + 24))
        seconds, decimals = ticks(visible[0] / rate, visible[1] / rate, count)
        found = []
        for second in seconds.tolist():
            text = QCoreApplication.translate("TimelineMarks", "{0} s").format(
                f"{second:.{decimals}f}"
            )
            x = self._axis.x_of(second * rate) + 3
            width = metrics.horizontalAdvance(text) + 1
            found.append((QRectF(x, 0, width, self._layout.ruler - 3), text))
        return found

    def span(self, painter: QPainter, theme: Theme, span: tuple[int, int], height: int) -> None:
        """Paint the selected frames as a band, and their length where there is room."""
        left, right = self._ends(span)
        if left >= right:
            return
        veil = QColor(theme.accent)
        veil.setAlpha(50)
        painter.fillRect(QRectF(left, 0, right - left, height), veil)
        painter.setPen(thin(painter, theme.accent, Qt.PenStyle.DashLine))
        for frame, x in zip(span, (left, right), strict=True):
            if x == self._axis.x_of(frame):
                painter.drawLine(QPointF(x, 0), QPointF(x, height))
        place, text = self._caption(painter.fontMetrics(), span)
        if not place.isEmpty():
            painter.fillRect(place, QColor(theme.raised))
            painter.setPen(QColor(theme.text))
            # At the left: the flag of the playhead is rather in the middle or at the right end.
            place.adjust(6, 0, 0, 0)
            painter.drawText(place, Qt.AlignmentFlag.AlignVCenter, text)

    def _ends(self, span: tuple[int, int]) -> tuple[float, float]:
        """Return where a run of frames begins and ends, as far as it is in view."""
        left, right = (
            min(max(self._axis.x_of(frame), self._axis.left), self._right) for frame in span
        )
        return left, right

    def _caption(self, metrics: QFontMetrics, span: tuple[int, int]) -> tuple[QRectF, str]:
        """Return what is said of the selected frames, and where; an empty place if nowhere."""
        left, right = self._ends(span)
        frames = span[1] - span[0]
        text = QCoreApplication.translate("TimelineMarks", "{0} frames, {1} s").format(
            frames, f"{frames / self._recording.rate:.2f}"
        )
        fits = metrics.horizontalAdvance(text) + 12 < right - left
        place = QRectF(left + 1, 0, right - left - 2, self._layout.ruler - 1)
        return place if fits else QRectF(), text

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
        """Return a part of the timeline that holds a frame's playhead, and all that it covers."""
        flag, covered = self._flag(metrics, frame), metrics.horizontalAdvance(WIDEST_TIME)
        if flag.isEmpty():
            return QRect()
        flag.setHeight(self._layout.height)
        return flag.adjusted(-covered, 0, covered, 0).toAlignedRect()

    def _flag(self, metrics: QFontMetrics, frame: int) -> QRectF:
        """Return where the number of the playhead's frame stands; empty out of view."""
        x = self._axis.x_of(frame + 0.5)
        if not self._axis.left <= x <= self._right:
            return QRectF()
        width = metrics.horizontalAdvance(str(frame + self._recording.first_frame)) + 10
        left = max(self._axis.left, min(x - width / 2, self._right - width))
        return QRectF(left, 0, width, self._layout.ruler - 3)

    def playhead(self, painter: QPainter, theme: Theme, frame: int, height: int) -> None:
        """Draw a line through the middle of a frame's time, with the frame's number."""
        flag = self._flag(painter.fontMetrics(), frame)
        if flag.isEmpty():
            return
        x = self._axis.x_of(frame + 0.5)
        painter.setPen(thin(painter, theme.playhead))
        painter.drawLine(QPointF(x, 0), QPointF(x, height))
        painter.setPen(Qt.PenStyle.NoPen)
        painter.setBrush(QColor(theme.accent))
        painter.drawRoundedRect(flag, 3, 3)
        painter.setPen(QColor(theme.on_accent))
        text = str(frame + self._recording.first_frame)
        painter.drawText(flag, Qt.AlignmentFlag.AlignCenter, text)
