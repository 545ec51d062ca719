"""A box that points at a widget of its window."""

from PySide6.QtCore import QEvent, QObject, QPoint, QPointF, QRect, Qt
from PySide6.QtGui import QColor, QPainter, QPainterPath, QPaintEvent, QPen, QPolygonF
from PySide6.QtWidgets import QHBoxLayout, QLabel, QPushButton, QVBoxLayout, QWidget

from mocapmend.theme import Theme
from mocapmend.views.tables import in_sight
from mocapmend.views.text_scale import scaled

ARROW = 12
WIDTH = 340
MARGIN = 14


class Callout(QWidget):
    """Says something about a widget, with a tip towards it; the window works meanwhile."""

    def __init__(self, window: QWidget, theme: Theme) -> None:
        super().__init__(window)
        self._window = window
        self._theme = theme
        self._tip: QPoint | None = None
        self.setAccessibleName(self.tr("Tour"))
        self._text = QLabel()
        self._text.setWordWrap(True)
        self._text.setTextFormat(Qt.TextFormat.PlainText)
        self._count = QLabel()
        self.skip_button = QPushButton(self.tr("Skip the tour"))
        self.skip_button.setToolTip(self.tr("Esc; Help > Tour shows it again"))
        self.next_button = QPushButton()
        for button in (self.skip_button, self.next_button):
            # The keys go on working for what the tour is about.
            button.setFocusPolicy(Qt.FocusPolicy.TabFocus)
        row = QHBoxLayout()
        row.addWidget(self._count, 1)
        row.addWidget(self.skip_button)
        row.addWidget(self.next_button)
        layout = QVBoxLayout(self)
        layout.setContentsMargins(*[ARROW + MARGIN] * 4)
        layout.addWidget(self._text)
        layout.addSpacing(6)
        layout.addLayout(row)
        self._target: QWidget | None = None
        window.installEventFilter(self)

    def set_theme(self, theme: Theme) -> None:
        """Paint in other colours from now on."""
        self._theme = theme
        self.update()

    def show_step(self, text: str, count: str, go_on: str) -> None:
        """Say something else."""
        self._text.setText(text)
        self.setAccessibleDescription(text)
        self._count.setText(count)
        self.next_button.setText(go_on)

    def point_at(self, target: QWidget | None) -> None:
        """Move beside a widget and point at it; into the middle of the window without one."""
        self._target = target
        window = self._window
        self.setFixedWidth(min(scaled(self, WIDTH) + 2 * (ARROW + MARGIN), window.width()))
        self.setFixedHeight(self.heightForWidth(self.width()))
        if target is None or not in_sight(target):
            self._tip = None
            self.move(window.rect().center() - self.rect().center())
        else:
            rect = QRect(target.mapTo(window, QPoint(0, 0)), target.size())
            place, tip = placed(rect, self.size().width(), self.height(), window.rect())
            self.move(place)
            self._tip = tip - place
        self.show()
        self.raise_()
        self.update()

    @property
    def points(self) -> bool:
        """Whether it points at something that is seen."""
        return self._tip is not None

    def eventFilter(self, watched: QObject, event: QEvent) -> bool:
        if event.type() in (QEvent.Type.Resize, QEvent.Type.FontChange) and self.isVisible():
            self.point_at(self._target)
        return False

    def paintEvent(self, event: QPaintEvent) -> None:
        painter = QPainter(self)
        painter.setRenderHint(QPainter.RenderHint.Antialiasing)
        path = QPainterPath()
        box = self.rect().adjusted(ARROW, ARROW, -ARROW, -ARROW)
        path.addRoundedRect(box, 6, 6)
        if self._tip is not None:
            path = path.united(_arrow(box, self._tip))
        painter.setPen(QPen(QColor(self._theme.accent), 2))
        painter.setBrush(QColor(self._theme.raised))
        painter.drawPath(path)
        painter.end()


def placed(target: QRect, width: int, height: int, room: QRect) -> tuple[QPoint, QPoint]:
    """Return where a box goes and where its tip points: beside the target, else inside it."""
    middle = target.center()
    x = min(max(middle.x() - width // 2, room.left()), room.right() - width)
    y = min(max(middle.y() - height // 2, room.top()), room.bottom() - height)
    if target.bottom() + height <= room.bottom():
        return QPoint(x, target.bottom()), QPoint(middle.x(), target.bottom() + 2)
    if target.top() - height >= room.top():
        return QPoint(x, target.top() - height), QPoint(middle.x(), target.top() - 2)
    if target.left() - width >= room.left():
        return QPoint(target.left() - width, y), QPoint(target.left() - 2, middle.y())
    if target.right() + width <= room.right():
        return QPoint(target.right(), y), QPoint(target.right() + 2, middle.y())
    return QPoint(x, y), QPoint(middle.x(), y)


def _arrow(box: QRect, tip: QPoint) -> QPainterPath:
    """Return the triangle from the nearest edge of a box to its tip."""
    x = float(min(max(tip.x(), box.left() + 2 * ARROW), box.right() - 2 * ARROW))
    y = float(min(max(tip.y(), box.top() + 2 * ARROW), box.bottom() - 2 * ARROW))
    if tip.y() <= box.top():
        base = [QPointF(x - ARROW, box.top() + 1), QPointF(x + ARROW, box.top() + 1)]
    elif tip.y() >= box.bottom():
        base = [QPointF(x - ARROW, box.bottom() - 1), QPointF(x + ARROW, box.bottom() - 1)]
    else:
        edge = box.right() - 1 if tip.x() >= box.right() else box.left() + 1
        base = [QPointF(edge, y - ARROW), QPointF(edge, y + ARROW)]
    end = QPointF(tip)
    end.setX(min(max(end.x(), 1.0), box.right() + ARROW - 1.0))
    end.setY(min(max(end.y(), 1.0), box.bottom() + ARROW - 1.0))
    path = QPainterPath()
    path.addPolygon(QPolygonF([base[0], end, base[1]]))
    path.closeSubpath()
    return path
