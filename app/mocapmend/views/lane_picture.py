"""The picture of all lanes: the state of every marker in every column, told by colour and shape."""

from collections.abc import Mapping, Sequence

import numpy as np
from numpy.typing import NDArray
from PySide6.QtGui import QColor, QImage

from mocapmend.document import Document
from mocapmend.state import SampleState
from mocapmend.theme import Theme
from mocapmend.views.columns import column_edges
from mocapmend.views.run_index import RunIndex
from mocapmend_algorithms.problems import BadRun

SUSPECT = len(SampleState)
"""Stands for measured samples that are held for bad; it is no state of them."""
PERIOD = 4
"""Columns after which a pattern repeats."""
# Missing last: a gap must show even where it shares its column with others.
PAINTED = sorted(set(SampleState) - {SampleState.MEASURED}, key=lambda s: s is SampleState.MISSING)


def shape_of(state: int, height: int) -> NDArray[np.bool_]:
    """Return which pixels of a lane have a state's colour, so that shapes tell the states apart.

    Every column of every state but the measured has some, or a single frame could be lost.

    Parameters
    ----------
    state : int
        Measured samples are a thin line, missing ones a full bar, bad ones a chequered bar and
        fills are two rails. Smoothed samples are a line that reaches the top, and a `SUSPECT` is
        one with teeth. Any further state is a ladder.
    height : int
        Pixels of the lane.

    Returns
    -------
    ndarray of bool, shape (height, PERIOD)
    """
    y, x = np.mgrid[:height, :PERIOD]
    rail = max(1, height // 4)
    rails = (y < rail) | (y >= height - rail)
    shapes = {
        SampleState.MEASURED: ~rails,
        SampleState.MISSING: np.ones_like(rails),
        SampleState.BAD: (2 * x // PERIOD + y) % 2 == 0,
        SampleState.FILLED: rails,
        SampleState.SMOOTHED: y < height - rail,
        SUSPECT: ~rails | (x % 2 == 0),
    }
    return np.asarray(shapes.get(state, rails | (x < PERIOD // 2)))


class LanePicture:
    """Makes the picture of the lanes in view, and keeps it while nothing in it has changed.

    Parameters
    ----------
    document : Document
        Whose states are shown.
    theme : Theme
        The colours.
    """

    def __init__(self, document: Document, theme: Theme) -> None:
        self._document = document
        self._theme = theme
        self._indices: dict[SampleState, RunIndex] = {}
        self._suspects: RunIndex | None = None
        self._image: QImage | None = None
        self._key: object = None
        self._pixels: NDArray[np.uint8] | None = None

    def set_theme(self, theme: Theme) -> None:
        """Paint with other colours from now on."""
        self._theme = theme
        self._image = None

    def set_suspects(self, runs: Mapping[int, Sequence[BadRun]]) -> None:
        """Mark measured samples of markers that are held for bad."""
        markers = range(self._document.original.markers)
        spans = [sorted((run.start, run.stop) for run in runs.get(m, ())) for m in markers]
        self._suspects = RunIndex([np.array(of, np.int64).reshape(-1, 2) for of in spans])
        self._image = None

    def forget(self) -> None:
        """Drop what was computed: samples have changed."""
        self._indices.clear()
        self._image = None

    def image(
        self, markers: NDArray[np.intp], visible: tuple[float, float], width: int, height: int
    ) -> QImage:
        """Return the picture of some lanes.

        Parameters
        ----------
        markers : ndarray
            Whose lanes they are, from top to bottom.
        visible : tuple of float
            The frames that the width shows.
        width, height : int
            Pixels of the picture, and of each lane with the space below it.
        """
        key = (markers.tobytes(), visible, width, height)
        if self._image is None or key != self._key:
            self._key = key
            self._image = self._paint(self._states(markers, visible, width), height)
        return self._image

    def _states(
        self, markers: NDArray[np.intp], visible: tuple[float, float], width: int
    ) -> NDArray[np.uint8]:
        row_of = np.full(self._document.original.markers, -1)
        row_of[markers] = np.arange(len(markers))
        edges = column_edges(*visible, width)
        states = np.full((max(1, len(markers)), width), SampleState.MEASURED, np.uint8)
        for state in PAINTED:
            if state not in self._indices:
                runs = [self._document.runs(m, state) for m in range(len(row_of))]
                self._indices[state] = RunIndex(runs)
            states.reshape(-1)[self._indices[state].cells(row_of, edges)] = state
        if self._suspects is not None:
            states.reshape(-1)[self._suspects.cells(row_of, edges)] = SUSPECT
        return states

    def _paint(self, states: NDArray[np.uint8], height: int) -> QImage:
        rows, width = states.shape
        colours = self._colours(height)
        # Few rows of a lane differ: each of these has its own part of the image's colour table.
        kinds, kind_of_row = np.unique(colours, axis=0, return_inverse=True)
        cells = states * np.uint8(PERIOD) + (np.arange(width) % PERIOD).astype(np.uint8)
        first = (kind_of_row * colours.shape[1]).astype(np.uint8)
        # Rows of an image begin at multiples of four bytes.
        pixels = np.zeros((rows, height, width + -width % 4), np.uint8)
        np.add(cells[:, None], first[:, None], out=pixels[:, :, :width])
        # The image borrows the pixels.
        self._pixels = pixels
        image = QImage(
            pixels.data, width, rows * height, pixels.shape[2], QImage.Format.Format_Indexed8
        )
        image.setColorTable(kinds.ravel().tolist())
        return image

    def _colours(self, height: int) -> NDArray[np.uint32]:
        """Return the colour of every state and column of the pattern, by row of a lane."""
        ground = QColor(self._theme.window).rgb()
        table = np.full((height, len(SampleState) + 1, PERIOD), ground, np.uint32)
        for state in (*SampleState, SUSPECT):
            shown = SampleState.BAD if state == SUSPECT else SampleState(state)
            colour = QColor(self._theme.state_colour(shown)).rgb()
            table[:-1, state][shape_of(state, height - 1)] = colour
        return table.reshape(height, -1)
