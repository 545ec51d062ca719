"""Two markers as they would be if their samples were exchanged."""

from collections.abc import Container

import numpy as np
from numpy.typing import NDArray
from pyqtgraph.functions import arrayToQPath
from PySide6.QtCore import Qt

from mocapmend.suspects import exchange_of
from mocapmend.views.painters.shot import Shot
from mocapmend.viewstate import ViewState
from mocapmend_algorithms.corrections import Exchange
from mocapmend_algorithms.problems import BadRun

MOST_CORNERS = 2000
"""Of a trail: with more, frames are left out."""


def exchange_shown(view: ViewState, found: Container[BadRun]) -> Exchange | None:
    """Return what is shown as it would be: what the user is about to do, or would put right.

    Parameters
    ----------
    view : ViewState
        What the user looks at.
    found : container of BadRun
        The problems that are still there: what was exchanged already is shown as it is.
    """
    run = view.suspect
    return view.exchange or (None if run is None or run not in found else exchange_of(run))


def paint_exchange(shot: Shot, exchange: Exchange, bones: NDArray[np.intp]) -> None:
    """Paint the trails of both markers and, where the frame is inside, their sticks: dashed.

    Parameters
    ----------
    shot : Shot
        The frame.
    exchange : Exchange
        What would be done.
    bones : ndarray, shape (bones, 2)
        Markers that sticks join.
    """
    pair = exchange.first, exchange.second
    points, style = shot.document.points, Qt.PenStyle.DashLine
    first, last = max(0, exchange.start - 1), min(len(points), exchange.stop + 1)
    frames = np.arange(first, last, max(1, (last - first) // MOST_CORNERS))
    inside = (frames >= exchange.start) & (frames < exchange.stop)
    for marker, other in (pair, pair[::-1]):
        trail = np.where(inside[:, None], points[frames, other], points[frames, marker])
        x, y = shot.project(trail).T
        selection = shot.view.selection
        order = selection.index(marker) if marker in selection else 0
        shot.pen(shot.curve_colour(order), 1.5, style)
        shot.painter.drawPath(arrayToQPath(x, y, connect="finite"))
    if exchange.start <= shot.view.frame < exchange.stop:
        exchanged = shot.pixels.copy()
        exchanged[list(pair)] = shot.pixels[list(pair[::-1])]
        touching = bones[np.isin(bones, pair).any(axis=1)]
        shot.pen(shot.theme.preview, 1.2, style)
        shot.pairs(exchanged[touching].reshape(-1, 2))
