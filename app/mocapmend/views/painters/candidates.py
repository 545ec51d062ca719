"""Where other repairs of the current gap would put the marker, and what the repair leans on."""

from collections.abc import Sequence

import numpy as np
from PySide6.QtCore import QPointF, QRectF

from mocapmend.views.painters.shot import Array, Shot
from mocapmend.viewstate import Preview

SIZE = 5.0
DONOR = 6.0
"""Half the side of the square around a donor."""
APART = 11.0
"""Pixels between numbers."""


def paint_candidates(shot: Shot, candidates: Sequence[tuple[int, Preview]]) -> None:
    """Paint small diamonds with the numbers of the repairs that reach into the frame.

    A number that would lie on another one is left out.
    """
    numbered: list[Array] = []
    for number, candidate in candidates:
        gap, patch = candidate.gap, candidate.patch
        if patch is None or not gap.start <= shot.view.frame < gap.stop:
            continue
        place = shot.project(patch.values[shot.view.frame - gap.start][None])[0]
        if np.isfinite(place).all():
            shot.pen(shot.theme.candidate, 1.0)
            shot.diamond(place, SIZE)
            if all(np.abs(place - other).max() > APART for other in numbered):
                numbered.append(place)
                shot.painter.drawText(QPointF(place[0] + SIZE + 1, place[1] - 2), str(number))


def paint_donors(shot: Shot, preview: Preview | None) -> None:
    """Paint squares around the markers that the previewed repair is computed from."""
    if preview is None or not preview.donors:
        return
    donors = set(preview.donors)
    shot.pen(shot.theme.preview, 1.0)
    for marker, label in enumerate(shot.document.original.labels):
        x, y = shot.pixels[marker]
        if label in donors and np.isfinite(x):
            shot.painter.drawRect(QRectF(x - DONOR, y - DONOR, 2 * DONOR, 2 * DONOR))
