"""Marker labels where there is not enough room for them."""

from PySide6.QtCore import QModelIndex, QPersistentModelIndex, Qt
from PySide6.QtGui import QFontMetrics
from PySide6.QtWidgets import QStyle, QStyledItemDelegate, QStyleOptionViewItem

MIDDLE = Qt.TextElideMode.ElideMiddle


def elided(label: str, metrics: QFontMetrics, width: int) -> str:
    """Shorten a label to a width.

    Of "WheelchairL:Marker3" the middle of the subject goes first: subjects differ at their ends,
    and the marker's own name is what people look for.
    """
    subject, colon, marker = label.rpartition(":")
    name = colon + marker
    room = width - metrics.horizontalAdvance(name)
    if not subject or room < metrics.horizontalAdvance("M…M"):
        return metrics.elidedText(label, MIDDLE, width)
    return metrics.elidedText(subject, MIDDLE, room) + name


class LabelDelegate(QStyledItemDelegate):
    """Shows the labels of a table's column as `elided` shortens them."""

    def initStyleOption(
        self, option: QStyleOptionViewItem, index: QModelIndex | QPersistentModelIndex
    ) -> None:
        super().initStyleOption(option, index)
        widget = option.widget
        margin = widget.style().pixelMetric(QStyle.PixelMetric.PM_FocusFrameHMargin) + 1
        width = option.rect.width() - 2 * margin
        option.text = elided(option.text, option.fontMetrics, width)
