"""The timeline: one lane per marker, what is missing or repaired, and the playhead."""

from collections.abc import Mapping, Sequence

import numpy as np
from PySide6.QtCore import QEvent, QPoint, QPointF, QRect, QSize, Qt, QTimer
from PySide6.QtGui import (
    QColor,
    QHelpEvent,
    QMouseEvent,
    QPainter,
    QPaintEvent,
    QPixmap,
    QResizeEvent,
    QWheelEvent,
)
from PySide6.QtWidgets import QAbstractScrollArea, QToolTip, QWidget

from mocapmend.document import Document
from mocapmend.suspects import by_marker, markers_of
from mocapmend.theme import Theme
from mocapmend.views.event_lane import EventLane, whole_frame
from mocapmend.views.lane_layout import LaneLayout
from mocapmend.views.lane_picture import LanePicture
from mocapmend.views.overview import Overview
from mocapmend.views.time_axis import TimeAxis
from mocapmend.views.timeline_marks import TimelineMarks
from mocapmend.views.timeline_texts import description, event_tip, lane_tip, suspect_tip
from mocapmend.viewstate import ViewState
from mocapmend_algorithms import Gap
from mocapmend_algorithms.problems import BadRun

MOST_LANES = 24
"""That the timeline would like to show."""
LANE, GOOD_LANE = 6, 11
"""Heights of a lane: one that can be read and hit, and one with room for a name."""
DESCRIBE_MS = 200
"""A screen reader is told at most so often what is under the playhead."""


class Timeline(QAbstractScrollArea):
    """Lanes of all markers over the visible frames; a click scrubs, a wheel zooms."""

    def __init__(
        self, document: Document, view: ViewState, theme: Theme, parent: QWidget | None = None
    ) -> None:
        super().__init__(parent)
        self._document = document
        self._view = view
        self._theme = theme
        self._picture: QPixmap | None = None
        self._shown = view.frame
        self._suspects: Mapping[int, Sequence[BadRun]] = {}
        self.axis = TimeAxis(view)
        original = document.original
        self._events = EventLane(document.source.events, original.frames, self.axis)
        self._layout = LaneLayout(document.names, events=bool(self._events.events))
        self._lanes = LanePicture(document, theme)
        self._marks = TimelineMarks(original, self.axis, self._layout)
        self.overview = Overview(document, view, theme, self)
        self._describe_later = QTimer(self)
        self._describe_later.setSingleShot(True)
        self._describe_later.setInterval(DESCRIBE_MS)
        self._describe_later.timeout.connect(self._describe)
        self.setHorizontalScrollBarPolicy(Qt.ScrollBarPolicy.ScrollBarAlwaysOff)
        self.setFocusPolicy(Qt.FocusPolicy.ClickFocus)
        self.setAccessibleName(self.tr("Timeline"))
        self.viewport().setMouseTracking(True)
        self.verticalScrollBar().valueChanged.connect(self._scroll)
        view.frame_changed.connect(self._show_frame)
        for signal in (
            view.range_changed,
            view.selection_changed,
            view.gap_changed,
            view.suspect_changed,
            view.span_changed,
        ):
            signal.connect(self._repaint)
        document.samples_changed.connect(self._forget)
        document.names_changed.connect(self._rename)
        view.selection_changed.connect(self._show_lane)
        self._use_font()

    def sizeHint(self) -> QSize:
        return QSize(800, self.height_of(LANE))

    def height_of(self, lane: int) -> int:
        """Return the height for lanes of a height."""
        lanes = min(MOST_LANES, self._document.original.markers) * lane
        return self._layout.lanes_top + lanes + 16 + self.overview.height()

    def set_theme(self, theme: Theme) -> None:
        """Paint with other colours from now on."""
        self._theme = theme
        self._lanes.set_theme(theme)
        self.overview.set_theme(theme)
        self._repaint()

    def set_suspects(self, found: Sequence[BadRun]) -> None:
        """Mark measured samples that are held for bad."""
        self._suspects = by_marker(found)
        self._lanes.set_suspects(self._suspects)
        self.overview.set_suspects(found)
        self._repaint()

    def set_most_missing_first(self, on: bool) -> None:  # noqa: FBT001 - a slot of toggled(bool)
        """Order the lanes by what is missing now, or as the file has them.

        The order stays while gaps are filled: a lane that is worked on does not move.
        """
        markers = range(self._document.original.markers)
        order = np.arange(len(markers))
        if on:
            missing = [sum(gap.length for gap in self._document.gaps_of(m)) for m in markers]
            order = np.argsort(-np.array(missing, np.int64), kind="stable")
        self._layout.set_order(order)
        self._repaint()
        self._show_lane()

    # --- where things are --------------------------------------------------------------------

    def marker_at(self, y: float) -> int | None:
        """Return the marker whose lane is at a vertical place of the viewport."""
        return self._layout.marker_at(y)

    def lane_top(self, marker: int) -> int:
        """Return the vertical place of a marker's lane in the viewport."""
        return self._layout.lane_top(marker)

    def gap_at(self, position: QPointF) -> Gap | None:
        """Return the gap under a place of the viewport; two pixels of tolerance."""
        marker = self.marker_at(position.y())
        if marker is None or position.x() < self.axis.left:
            return None
        reach = 2.0 * self.axis.frames_per_pixel
        return self._document.gap_near(marker, self.axis.frame_at(position.x()), reach)

    def suspect_at(self, position: QPointF) -> BadRun | None:
        """Return the bad run under a place of the viewport; two pixels of tolerance."""
        marker = self.marker_at(position.y())
        if marker is None or position.x() < self.axis.left:
            return None
        frame, reach = self.axis.frame_at(position.x()), 2.0 * self.axis.frames_per_pixel
        near = (
            run
            for run in self._suspects.get(marker, ())
            if run.start - reach <= frame < run.stop + reach
        )
        return min(near, key=lambda run: abs((run.start + run.stop) / 2.0 - frame), default=None)

    def _event_at(self, position: QPointF) -> int | None:
        """Return the frame of the event under a place of the viewport."""
        if not self._layout.ruler <= position.y() < self._layout.lanes_area:
            return None
        event = self._events.event_at(position.x())
        return None if event is None else whole_frame(event)

    def _show_lane(self) -> None:
        if self._view.marker is not None:
            self.verticalScrollBar().setValue(self._layout.scroll_to(self._view.marker))

    # --- what the user does ------------------------------------------------------------------

    def mousePressEvent(self, event: QMouseEvent) -> None:
        shift = event.modifiers() & Qt.KeyboardModifier.ShiftModifier
        if event.button() == Qt.MouseButton.LeftButton and not shift:
            frame = self._event_at(event.position())
            if frame is not None:
                self._view.set_frame(frame)
                return
            self._select_at(event)
        self.axis.press(event)

    def mouseMoveEvent(self, event: QMouseEvent) -> None:
        self.axis.drag(event)

    def mouseDoubleClickEvent(self, event: QMouseEvent) -> None:
        run, gap = self.suspect_at(event.position()), self.gap_at(event.position())
        if run is not None:
            self._view.go_to_suspect(run)
        elif gap is not None:
            self._view.go_to(gap)

    def wheelEvent(self, event: QWheelEvent) -> None:
        control = event.modifiers() & Qt.KeyboardModifier.ControlModifier
        if control or event.position().x() < self.axis.left:
            super().wheelEvent(event)
        else:
            self.axis.wheel(event)

    def viewportEvent(self, event: QEvent) -> bool:
        if isinstance(event, QHelpEvent) and event.type() == QEvent.Type.ToolTip:
            self._show_tip(event.pos(), event.globalPos())
            return True
        return super().viewportEvent(event)

    def resizeEvent(self, event: QResizeEvent) -> None:
        self._place_axis()
        self._place_overview()
        self._repaint()
        self._show_lane()
        super().resizeEvent(event)

    def changeEvent(self, event: QEvent) -> None:
        if event.type() == QEvent.Type.FontChange:
            self._use_font()
        elif event.type() == QEvent.Type.PaletteChange:
            self._picture = None
        super().changeEvent(event)

    def _select_at(self, event: QMouseEvent) -> None:
        marker = self.marker_at(event.position().y())
        if marker is None:
            return
        add = bool(event.modifiers() & Qt.KeyboardModifier.ControlModifier)
        if add or self._view.picking or marker != self._view.marker:
            self._view.click(marker, add=add)
        run, gap = self.suspect_at(event.position()), self.gap_at(event.position())
        if run is not None and run.marker in self._view.selection:
            self._view.set_suspect(run)
        elif gap is not None and marker in self._view.selection:
            self._view.set_gap(gap)

    def _show_tip(self, place: QPoint, on_screen: QPoint) -> None:
        QToolTip.showText(on_screen, self.tip_at(QPointF(place)), self)

    def tip_at(self, place: QPointF) -> str:
        """Return the tooltip of a place of the viewport; empty where there is nothing to say."""
        if self._layout.ruler <= place.y() < self._layout.lanes_area:
            event = self._events.event_at(place.x())
            return "" if event is None else event_tip(self._document, event)
        marker = self.marker_at(place.y())
        if marker is None:
            return ""
        on_lane = place.x() >= self.axis.left
        run = self.suspect_at(place)
        if run is not None:
            return suspect_tip(self._document, run)
        frame = self.axis.frame_at(place.x()) if on_lane else -1.0
        return lane_tip(self._document, marker, self.gap_at(place), on_lane=on_lane, frame=frame)

    def _describe(self) -> None:
        self.setAccessibleDescription(description(self._document, self._view))

    # --- painting ----------------------------------------------------------------------------

    def _use_font(self) -> None:
        metrics = self.fontMetrics()
        self._layout.use_font(metrics, (self._events.title, self.overview.title))
        self._place_axis()
        self.overview.set_gutter(self._layout.gutter)
        height = metrics.height() + 6
        self.overview.setFixedHeight(height)
        self.setViewportMargins(0, 0, 0, height)
        self.setMinimumHeight(self._layout.lanes_top + height + 3 * metrics.height())
        self._place_overview()
        self.updateGeometry()
        self._repaint()

    def _place_axis(self) -> None:
        gutter = self._layout.gutter
        self.axis.place(gutter, self.viewport().width() - gutter - 1)

    def _place_overview(self) -> None:
        area = self.viewport().geometry()
        self.overview.setGeometry(
            area.left(), area.bottom() + 1, area.width(), self.overview.height()
        )

    def _forget(self) -> None:
        self._lanes.forget()
        self._repaint()

    def _rename(self) -> None:
        self._layout.set_names(self._document.names)
        self._use_font()

    def _scroll(self, value: int) -> None:
        self._layout.scroll = value
        self._repaint()

    def _show_frame(self, frame: int) -> None:
        """Paint again where the playhead was and where it is."""
        for place in (self._shown, frame):
            self.viewport().update(self._marks.playhead_area(self.fontMetrics(), place))
        self._shown = frame
        self._describe_soon()

    def _describe_soon(self) -> None:
        if not self._describe_later.isActive():
            self._describe_later.start()

    def _repaint(self) -> None:
        self._picture = None
        self._layout.height = self.viewport().height()
        page = self._layout.page
        self.verticalScrollBar().setRange(0, max(0, self._layout.content - page))
        self.verticalScrollBar().setPageStep(page)
        self.verticalScrollBar().setSingleStep(self._layout.lane_height)
        self.viewport().update()
        self._describe_soon()

    def paintEvent(self, event: QPaintEvent) -> None:
        if self._picture is None or self._picture.devicePixelRatioF() != self.devicePixelRatioF():
            self._picture = self._paint_picture()
        painter = QPainter(self.viewport())
        painter.drawPixmap(0, 0, self._picture)
        view = self._view
        self._marks.seconds(painter, self._theme, view.visible, view.frame, view.span)
        self._marks.playhead(painter, self._theme, view.frame, self.viewport().height())
        painter.end()

    def _paint_picture(self) -> QPixmap:
        ratio, layout, view = self.devicePixelRatioF(), self._layout, self._view
        picture = QPixmap(self.viewport().size() * ratio)
        picture.setDevicePixelRatio(ratio)
        picture.fill(QColor(self._theme.window))
        painter = QPainter(picture)
        painter.setFont(self.font())
        width, height = self.viewport().width(), self.viewport().height()
        painter.setClipRect(QRect(0, layout.lanes_area, width, max(0, layout.page)))
        markers = layout.in_view()
        if len(markers):
            image = self._lanes.image(markers, view.visible, self.axis.width, layout.lane_height)
            painter.drawImage(layout.gutter, layout.lane_top(int(markers[0])), image)
        self._marks.names(painter, self._theme, view.selection)
        if view.gap is not None:
            self._marks.gap(painter, self._theme, view.gap)
        if view.suspect is not None:
            for marker in markers_of(view.suspect):
                place = Gap(marker, view.suspect.start, view.suspect.stop)
                self._marks.gap(painter, self._theme, place)
        painter.setClipping(False)
        self._marks.ruler(painter, self._theme, view.visible)
        if layout.events:
            self._events.paint(painter, self._theme, layout.ruler, layout.events)
        if view.span is not None:
            self._marks.span(painter, self._theme, view.span, height)
        painter.end()
        return picture
