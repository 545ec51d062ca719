"""Finds by itself what a glance may miss: clipped texts, English in Chinese, large dialogs."""

import re
from collections.abc import Iterator

from PySide6.QtCore import QRect, Qt
from PySide6.QtWidgets import (
    QAbstractButton,
    QComboBox,
    QGroupBox,
    QHeaderView,
    QLabel,
    QTabBar,
    QTableView,
    QWidget,
)

BORDERS = 8
"""Pixels of a button or a heading that its text does not get."""
ARROW = 24
"""Pixels of a list's arrow."""
_TAG = re.compile(r"<[^>]*>")
_ENGLISH = re.compile(r"[a-z]{3,} [a-z]{2,}")
_CHINESE = re.compile(r"[\u4e00-\u9fff]")


class Proofreader:
    """Collects complaints about windows.

    Parameters
    ----------
    chinese : bool
        Whether English sentences are a complaint.

    Attributes
    ----------
    found : dict of str to str
        The first picture of each complaint.
    """

    def __init__(self, *, chinese: bool) -> None:
        self._chinese = chinese
        self.found: dict[str, str] = {}

    def look(self, name: str, windows: list[QWidget]) -> None:
        """Note what is wrong in the windows of a picture."""
        room = windows[0].geometry()
        for window in windows:
            if not room.contains(window.geometry()):
                self._note(name, f"{type(window).__name__} {window.windowTitle()!r} is outside")
            for widget in (window, *window.findChildren(QWidget)):
                if widget.isVisible() and not widget.visibleRegion().isEmpty():
                    self._look_at(name, widget)

    def _look_at(self, name: str, widget: QWidget) -> None:
        kind = type(widget).__name__
        for text in _clipped(widget):
            self._note(name, f"{kind} clips {text!r}")
        if not self._chinese:
            return
        for text in _texts(widget):
            plain = _TAG.sub("", text)
            if _ENGLISH.search(plain) and not _CHINESE.search(plain):
                self._note(name, f"{kind} is English: {plain!r}")

    def _note(self, name: str, complaint: str) -> None:
        self.found.setdefault(complaint, name)


def _texts(widget: QWidget) -> Iterator[str]:
    """Return what is read in a widget and in its tool tip."""
    yield widget.toolTip()
    yield widget.windowTitle() if widget.isWindow() else ""
    yield widget.accessibleName()
    if isinstance(widget, QLabel | QAbstractButton):
        yield widget.text()
    elif isinstance(widget, QGroupBox):
        yield widget.title()
    elif isinstance(widget, QComboBox):
        yield from (widget.itemText(k) for k in range(widget.count()))
    elif isinstance(widget, QTabBar):
        yield from (widget.tabText(k) for k in range(widget.count()))
    elif isinstance(widget, QTableView) and widget.model() is not None:
        model = widget.model()
        yield from (
            str(model.index(row, column).data() or "")
            for row in range(min(model.rowCount(), 300))
            for column in range(model.columnCount())
        )


def _clipped(widget: QWidget) -> Iterator[str]:
    """Return the texts that have too little room."""
    advance = widget.fontMetrics().horizontalAdvance
    if isinstance(widget, QLabel) and widget.text() and not _fits(widget):
        yield widget.text()
    elif isinstance(widget, QAbstractButton) and widget.text():
        if widget.width() < min(widget.sizeHint().width(), advance(widget.text()) + BORDERS):
            yield widget.text()
    elif isinstance(widget, QComboBox):
        if widget.width() < advance(widget.currentText()) + ARROW:
            yield widget.currentText()
    elif isinstance(widget, QTabBar):
        yield from _clipped_tabs(widget)
    elif isinstance(widget, QHeaderView) and widget.orientation() == Qt.Orientation.Horizontal:
        yield from _clipped_titles(widget)


def _fits(label: QLabel) -> bool:
    if label.wordWrap():
        return label.heightForWidth(label.width()) <= label.height() + 1
    return label.sizeHint().width() <= label.width() + 1


def _clipped_tabs(bar: QTabBar) -> Iterator[str]:
    advance = bar.fontMetrics().horizontalAdvance
    for k in range(bar.count()):
        rect: QRect = bar.tabRect(k)
        if advance(bar.tabText(k)) > rect.width() or rect.right() > bar.width():
            yield bar.tabText(k)


def _clipped_titles(header: QHeaderView) -> Iterator[str]:
    model, advance = header.model(), header.fontMetrics().horizontalAdvance
    for k in range(header.count()):
        text = str(model.headerData(k, Qt.Orientation.Horizontal) or "")
        if not header.isSectionHidden(k) and advance(text) + BORDERS > header.sectionSize(k):
            yield text
