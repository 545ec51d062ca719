"""Where the parts of the timeline are; all sizes follow from the font."""

from collections.abc import Sequence

import numpy as np
from numpy.typing import NDArray
from PySide6.QtGui import QFontMetrics

from mocapmend.views.labels import elided

LANE_MIN = 5
MOST_NAME = 22
"""Characters of a marker's name that have room, at most."""
NAME_PADDING = 14


class LaneLayout:
    """Ruler on top, events below it, then the lanes of all markers, scrolled.

    Parameters
    ----------
    names : sequence of str
        Of the markers.
    events : bool
        Whether there is a lane for events.
    """

    def __init__(self, names: Sequence[str], *, events: bool) -> None:
        self._names = names
        self.names: list[str] = []
        self._events = events
        self._order = np.arange(len(names))
        self._rows = self._order
        self.height = 0
        self.scroll = 0
        self.gutter = self.text = self.ruler = self.events = self.name_margin = 0

    def set_names(self, names: Sequence[str]) -> None:
        """Call the markers otherwise; `use_font` makes room for it."""
        self._names = names

    def use_font(self, metrics: QFontMetrics, titles: Sequence[str]) -> None:
        """Take all sizes from a font; titles are what else stands left of the axis."""
        self.text = metrics.height()
        # One more: at fractional scales a text is wider than the pixels that it is said to be.
        widest = max(map(metrics.horizontalAdvance, self._names), default=0) + 1
        titles_room = max(map(metrics.horizontalAdvance, titles))
        room = max(titles_room, min(widest, MOST_NAME * metrics.averageCharWidth()))
        self.names = [elided(name, metrics, room) for name in self._names]
        self.gutter = room + NAME_PADDING
        self.ruler = self.text + 6
        self.events = self.text + 4 if self._events else 0
        self.name_margin = (self.text - LANE_MIN + 1) // 2 + 1

    def set_order(self, order: NDArray[np.intp]) -> None:
        """Show the lanes in another order: markers from top to bottom."""
        self._order = order
        self._rows = np.argsort(order)

    @property
    def lanes_top(self) -> int:
        """Where the first lane begins when nothing is scrolled."""
        return self.lanes_area + self.name_margin

    @property
    def lanes_area(self) -> int:
        """Where the part that scrolls begins."""
        return self.ruler + self.events

    @property
    def page(self) -> int:
        """Pixels that the lanes can take."""
        return self.height - self.lanes_area

    @property
    def lane_height(self) -> int:
        """Lanes share the height, within what can be read and hit."""
        room = self.page - 2 * self.name_margin
        return max(LANE_MIN, min(self.text + 2, room // max(1, len(self._order))))

    @property
    def content(self) -> int:
        """Pixels that all lanes take, with room for names at both ends."""
        return len(self._order) * self.lane_height + 2 * self.name_margin

    def marker_at(self, y: float) -> int | None:
        """Return the marker whose lane is at a height."""
        row = int((y - self.lanes_top + self.scroll) // self.lane_height)
        if y < self.lanes_area or not 0 <= row < len(self._order):
            return None
        return int(self._order[row])

    def lane_top(self, marker: int) -> int:
        """Return where a marker's lane begins."""
        return self.lanes_top + int(self._rows[marker]) * self.lane_height - self.scroll

    def in_view(self) -> NDArray[np.intp]:
        """Return the markers whose lanes or names can be seen, in part at least."""
        end = (self.scroll + self.page + 2 * self.name_margin) // self.lane_height + 1
        return self._order[self._first_in_view : end]

    @property
    def _first_in_view(self) -> int:
        return max(0, (self.scroll - 2 * self.name_margin) // self.lane_height)

    def first_named(self, every: int) -> int:
        """Return the first of the lanes in view that has its name, if one of several has it.

        The same lanes have theirs however far the lanes are scrolled.
        """
        return -self._first_in_view % every

    def scroll_to(self, marker: int) -> int:
        """Return how far to scroll so that a marker's lane is in view, no further than needed."""
        top = int(self._rows[marker]) * self.lane_height
        bottom = top + self.lane_height + 2 * self.name_margin
        return max(bottom - self.page, min(self.scroll, top))
