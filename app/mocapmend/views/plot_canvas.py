"""A widget of plots over the shared time axis: painted once, with what moves laid over it."""

from PySide6.QtCore import QEvent, QLineF, QPointF, QRectF, QSize, Qt, QTimer
from PySide6.QtGui import (
    QColor,
    QMouseEvent,
    QPainter,
    QPaintEvent,
    QPixmap,
    QResizeEvent,
    QWheelEvent,
)
from PySide6.QtWidgets import QSizePolicy, QWidget

from mocapmend.theme import Theme
from mocapmend.views.lane import Frame, Margins, paint_message, paint_span, thin, ticks
from mocapmend.views.readout import Readout, paint_readout
from mocapmend.views.time_axis import TimeAxis
from mocapmend.viewstate import ViewState


class PlotCanvas(QWidget):
    """Plots that are kept as a picture: playhead, crosshair and selected span are drawn over it.

    Subclasses say what is painted. Where that has to be computed first, and takes long, the picture
    stays as it was meanwhile.

    Parameters
    ----------
    view : ViewState
        Whose playhead and visible frames are shown and moved.
    rate : float
        Frames per second (Hz).
    first_frame : int
        Number of the first frame as the file counts it.
    theme : Theme
        The colours.
    """

    def __init__(
        self,
        view: ViewState,
        rate: float,
        first_frame: int,
        theme: Theme,
        parent: QWidget | None = None,
    ) -> None:
        super().__init__(parent)
        self._view = view
        self._rate = rate
        self._first_frame = first_frame
        self._theme = theme
        self._picture: QPixmap | None = None
        self._stale = True
        """Whether there is something else to see than in the picture."""
        self._later = QTimer(self)
        self._later.setSingleShot(True)
        self._later.setInterval(0)
        self._later.timeout.connect(self._go_on)
        self._frames: list[Frame] = []
        self._axis = TimeAxis(view)
        self._mouse: QPointF | None = None
        self._span: tuple[int, int] | None = None
        self._left_out = 0
        """Plots that there is no room for."""
        self._fit_texts()
        self.setSizePolicy(QSizePolicy.Policy.Expanding, QSizePolicy.Policy.Expanding)
        self.setFocusPolicy(Qt.FocusPolicy.ClickFocus)
        self.setMouseTracking(True)
        self.setAttribute(Qt.WidgetAttribute.WA_OpaquePaintEvent)
        view.frame_changed.connect(self.update)
        view.range_changed.connect(self.repaint_plots)

    def set_theme(self, theme: Theme) -> None:
        """Paint with other colours from now on."""
        self._theme = theme
        self.repaint_plots()

    def set_span(self, span: tuple[int, int] | None) -> None:
        """Shade a selected run of frames: the first, and the one after the last."""
        self._span = span
        self.update()

    def repaint_plots(self) -> None:
        """Paint the picture again: what it shows has changed."""
        self._stale = True
        self.update()

    # --- what subclasses say -----------------------------------------------------------------

    def _get_ready(self) -> bool:
        """Compute some of what the plots need; say whether they can be painted now."""
        return True

    def _paint_plots(self, painter: QPainter, area: QRectF) -> list[Frame]:
        """Paint all plots into an area, and return their frames from top to bottom."""
        raise NotImplementedError

    def _hint(self) -> str:
        """Return what is written where there are no plots."""
        raise NotImplementedError

    def _paint_header(self, painter: QPainter) -> None:
        """Write above the plots what changes with the playhead."""
        raise NotImplementedError

    def _paint_marks(self, painter: QPainter) -> None:
        """Draw over the plots what is drawn quickly; nothing by itself."""

    def _readout(self, frame: float, row: int) -> Readout:
        """Return the values at a place on the time axis, for a plot counted from the top."""
        raise NotImplementedError

    # --- what the user does ------------------------------------------------------------------

    def mousePressEvent(self, event: QMouseEvent) -> None:
        self._point_at(None)
        self._axis.press(event)

    def mouseMoveEvent(self, event: QMouseEvent) -> None:
        # While a button is held the playhead or the range moves: its values stand above the plots.
        self._point_at(None if event.buttons() else event.position())
        self._axis.drag(event)

    def mouseReleaseEvent(self, event: QMouseEvent) -> None:
        if not event.buttons() and self.rect().contains(event.position().toPoint()):
            self._point_at(event.position())

    def leaveEvent(self, event: QEvent) -> None:
        self._point_at(None)
        super().leaveEvent(event)

    def wheelEvent(self, event: QWheelEvent) -> None:
        self._axis.wheel(event)

    def resizeEvent(self, event: QResizeEvent) -> None:
        self._place_axis()
        self._stale = True
        super().resizeEvent(event)

    def changeEvent(self, event: QEvent) -> None:
        if event.type() in (QEvent.Type.FontChange, QEvent.Type.PaletteChange):
            self._fit_texts()
            self.repaint_plots()
        super().changeEvent(event)

    def _point_at(self, place: QPointF | None) -> None:
        if place != self._mouse:
            self._mouse = place
            self.update()

    def _fit_texts(self) -> None:
        """Make room for the texts in the present font."""
        self._margins = margins = Margins.of(self.fontMetrics())
        self._place_axis()
        self.setMinimumSize(QSize(2 * margins.left, margins.top + margins.least + margins.bottom))

    def _place_axis(self) -> None:
        margins = self._margins
        self._axis.place(margins.left, self.width() - margins.left - margins.right)

    # --- painting ----------------------------------------------------------------------------

    @property
    def _bottom(self) -> int:
        """Where the lowest plot ends."""
        return self.height() - self._margins.bottom

    def _area(self) -> QRectF:
        """Return where the plots are."""
        margins = self._margins
        return QRectF(margins.left, margins.top, self._axis.width, self._bottom - margins.top)

    def paintEvent(self, event: QPaintEvent) -> None:
        picture = self._picture
        if picture is None or picture.devicePixelRatioF() != self.devicePixelRatioF():
            self._stale = True
        if self._stale and not self._later.isActive():
            if self._get_ready():
                picture = self._picture = self._paint_picture()
                self._stale = False
            else:
                self._later.start()
        painter = QPainter(self)
        if self._stale:
            # The picture may be too small by now.
            painter.fillRect(self.rect(), QColor(self._theme.window))
        if picture is not None:
            painter.drawPixmap(0, 0, picture)
        if self._frames:
            if self._span is not None:
                paint_span(painter, self._frames[0], self._span, self._bottom, self._theme)
            self._paint_marks(painter)
            self._paint_header(painter)
            self._paint_playhead(painter)
            self._paint_crosshair(painter)
        painter.end()

    def _go_on(self) -> None:
        """Compute more, after other events. All at once is painted in an event of its own."""
        if self._get_ready():
            self.update()
        else:
            self._later.start()

    def _paint_picture(self) -> QPixmap:
        ratio = self.devicePixelRatioF()
        picture = QPixmap(self.size() * ratio)
        picture.setDevicePixelRatio(ratio)
        picture.fill(QColor(self._theme.window))
        painter = QPainter(picture)
        painter.setFont(self.font())
        self._frames = self._paint_plots(painter, self._area())
        if self._frames:
            self._paint_time_axis(painter)
            if self._left_out:
                place = QPointF(4, self._bottom + 2 + painter.fontMetrics().ascent())
                painter.drawText(place, self.tr("+{0} more").format(self._left_out))
        else:
            paint_message(painter, QRectF(self.rect()), self._hint(), self._theme)
        painter.end()
        return picture

    def _rows(self, area: QRectF, count: int) -> list[QRectF]:
        """Share an area among plots."""
        space = self._margins.space
        height = (area.height() + space) / max(1, count)
        return [
            QRectF(
                area.left(),
                round(area.top() + row * height),
                area.width(),
                max(8, round(height - space)),
            )
            for row in range(count)
        ]

    def _room(self, area: QRectF) -> int:
        """Return how many plots can be read in an area."""
        margins = self._margins
        return max(1, int((area.height() + margins.space) / (margins.least + margins.space)))

    def _paint_time_axis(self, painter: QPainter) -> None:
        frame, first, metrics = self._frames[-1], self._first_frame, painter.fontMetrics()
        widest = metrics.horizontalAdvance("0" * (len(str(self._view.frames + first)) + 3))
        about = max(2, self._axis.width // widest)
        marks, decimals = ticks(frame.start + first, frame.stop + first, about)
        painter.setPen(QColor(self._theme.dim))
        for mark in marks.tolist() if decimals == 0 else ():
            x, text = float(frame.x(mark - first)), f"{mark:.0f}"
            half = metrics.horizontalAdvance(text) / 2
            if frame.rect.left() <= x and x + half <= self.width():
                painter.drawText(QPointF(x - half, self._bottom + 2 + metrics.ascent()), text)

    def _paint_playhead(self, painter: QPainter) -> None:
        frame = self._frames[0]
        x = float(frame.x(self._view.frame))
        if frame.rect.left() <= x <= frame.rect.right():
            painter.setPen(thin(painter, self._theme.playhead))
            painter.drawLine(QLineF(x, self._margins.top - 4, x, self._bottom))

    def _paint_crosshair(self, painter: QPainter) -> None:
        """Draw a line at the mouse and write the values there beside it."""
        area = QRectF(self._frames[0].rect.topLeft(), self._frames[-1].rect.bottomRight())
        if self._mouse is None or not area.contains(self._mouse):
            return
        painter.setPen(thin(painter, self._theme.dim, Qt.PenStyle.DotLine))
        painter.drawLine(QLineF(self._mouse.x(), area.top(), self._mouse.x(), area.bottom()))
        painter.setFont(self.font())
        # Between two plots the upper one is meant.
        row = sum(frame.rect.top() <= self._mouse.y() for frame in self._frames) - 1
        readout = self._readout(self._axis.frame_at(self._mouse.x()), row)
        paint_readout(painter, readout, self._mouse, QRectF(self.rect()), self._theme)
