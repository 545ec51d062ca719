"""The picture of the 3D view: painted by numpy and QPainter, so it needs no OpenGL."""

from collections.abc import Sequence
from typing import Literal

import numpy as np
from numpy.typing import NDArray
from pyqtgraph.functions import arrayToQPath
from PySide6.QtCore import QRectF, QSize, Qt
from PySide6.QtGui import QColor, QPainter, QPaintEvent
from PySide6.QtWidgets import QSizePolicy, QWidget

from mocapmend.document import Document
from mocapmend.suspects import markers_of
from mocapmend.theme import Theme
from mocapmend.views.body_path import BodyPath
from mocapmend.views.camera import Camera, upright
from mocapmend.views.floor import floor_grid
from mocapmend.views.painters.body import (
    paint_markers,
    paint_segment_names,
    paint_segments,
    paint_sticks,
)
from mocapmend.views.painters.candidates import paint_candidates, paint_donors
from mocapmend.views.painters.companion import paint_companion, paint_key
from mocapmend.views.painters.edits import edits_text, paint_edits
from mocapmend.views.painters.exchange import exchange_shown, paint_exchange
from mocapmend.views.painters.ground import (
    paint_axes,
    paint_force_plates,
    paint_ground,
    plate_outlines,
)
from mocapmend.views.painters.measure import measurement, paint_measure
from mocapmend.views.painters.shot import Shot
from mocapmend.views.painters.texts import paint_captions, paint_labels
from mocapmend.views.painters.trails import paint_trails
from mocapmend.viewstate import ViewState
from mocapmend_algorithms.problems import BadRun

Array = NDArray[np.float64]
Layer = Literal[
    "labels",
    "trails",
    "all_trails",
    "sticks",
    "segments",
    "ground",
    "plates",
    "before_after",
    "measure",
]
"""What can be switched on and off; also the ids of the actions that do it."""

FIT = 3.0
"""Distance of the camera in body sizes at which the body fills the view."""
TRAIL_SECONDS = (0.25, 0.5, 1.0, 2.0, 5.0)
"""The lengths of trails to choose from, each way."""


class ScenePicture(QWidget):
    """Markers, sticks, floor and the previewed repair of one document, seen from a camera."""

    def __init__(
        self, document: Document, view: ViewState, theme: Theme, parent: QWidget | None = None
    ) -> None:
        super().__init__(parent)
        self._document = document
        self._view = view
        self._theme = theme
        self._suspects: Sequence[BadRun] = ()
        self.layers: set[Layer] = {"sticks", "trails", "ground", "plates"}
        self.trail_seconds = 0.5
        self.follow = True
        original = document.original
        self._turn = upright(original.up).T
        self._path = BodyPath(original.points, original.rate)
        self._size = self._path.size()
        grid = floor_grid(original, self._turn, self._path.overview @ self._turn, self._size)
        self._grid = grid @ self._turn.T
        self._plates = plate_outlines(document.source.force_plates)
        self._take_bones()
        document.skeleton_changed.connect(self._take_bones)
        self.camera = Camera(distance=FIT * self._size)
        self._offset = np.zeros(3)
        self._box: QRectF | None = None
        self.setMinimumSize(QSize(200, 160))
        self.setSizePolicy(QSizePolicy.Policy.Expanding, QSizePolicy.Policy.Expanding)
        self.setAttribute(Qt.WidgetAttribute.WA_OpaquePaintEvent)
        self.setAccessibleName(self.tr("3D marker view"))
        for signal in (
            view.frame_changed,
            view.selection_changed,
            view.preview_changed,
            view.suspect_changed,
            view.exchange_changed,
            view.candidates_changed,
            view.companion_changed,
            view.picking_changed,
            document.samples_changed,
            document.names_changed,
            view.proposed_changed,
        ):
            signal.connect(self.update)

    def set_theme(self, theme: Theme) -> None:
        """Paint with other colours from now on."""
        self._theme = theme
        self.update()

    def set_suspects(self, found: Sequence[BadRun]) -> None:
        """Mark measured samples that are held for bad."""
        self._suspects = found
        self.update()

    def look(self, name: str) -> None:
        """Turn to a fixed view and bring the body back to the middle."""
        self.camera.look(name)
        self.camera.distance = FIT * self._size
        self._offset = np.zeros(3)
        self.update()

    def set_follow(self, on: bool) -> None:  # noqa: FBT001 - a slot of toggled(bool)
        """Keep the body in the middle, or let it walk through the picture."""
        if on != self.follow:
            self._offset = np.zeros(3) if on else self._offset + self._centre()
            self.follow = on
            self.update()

    def set_layer(self, layer: Layer, on: bool) -> None:  # noqa: FBT001 - a slot of toggled(bool)
        """Show something, or no longer."""
        if on:
            self.layers.add(layer)
        else:
            self.layers.discard(layer)
        self.update()

    def set_trail_seconds(self, seconds: float) -> None:
        """Choose how far trails reach, in seconds each way."""
        self.trail_seconds = float(np.clip(seconds, TRAIL_SECONDS[0], TRAIL_SECONDS[-1]))
        self.update()

    def step_trails(self, step: int) -> None:
        """Make trails longer (1) or shorter (-1)."""
        near = int(np.argmin(np.abs(np.array(TRAIL_SECONDS) - self.trail_seconds)))
        last = len(TRAIL_SECONDS) - 1
        self.set_trail_seconds(TRAIL_SECONDS[min(max(near + step, 0), last)])

    # --- painting ----------------------------------------------------------------------------

    def paintEvent(self, event: QPaintEvent) -> None:
        painter = QPainter(self)
        painter.fillRect(self.rect(), QColor(self._theme.base))
        painter.setRenderHint(QPainter.RenderHint.Antialiasing)
        self._aim()
        shot = Shot(
            painter=painter,
            theme=self._theme,
            document=self._document,
            view=self._view,
            camera=self.camera,
            turn=self._turn,
            width=self.width(),
            height=self.height(),
            pixels=self._project(self._current_points()),
        )
        ghost = self._ghost_pixels(shot)
        self._paint_surroundings(shot)
        self._paint_body(shot)
        self._paint_ghost(shot, ghost)
        self._paint_texts(shot, ghost)
        if self._box is not None:
            self._paint_box(shot, self._box)
        painter.end()

    def _centre(self) -> Array:
        """Return where the body is in the current frame, upright."""
        centre: Array = self._path.at(self._view.frame) @ self._turn
        return centre

    def _aim(self) -> None:
        self.camera.target = self._offset + (self._centre() if self.follow else 0.0)

    def _take_bones(self) -> None:
        self._bones = np.array(self._document.skeleton.bones, dtype=np.intp).reshape(-1, 2)
        self.update()

    def _project(self, points: Array) -> Array:
        return self.camera.project(points, self.width(), self.height())[0]

    def _current_points(self) -> Array:
        return np.asarray(self._document.points[self._view.frame] @ self._turn)

    def _paint_surroundings(self, shot: Shot) -> None:
        if "ground" in self.layers:
            paint_ground(shot, self._grid)
        if "plates" in self.layers:
            paint_force_plates(shot, self._plates)
        if self._view.companion is not None:
            paint_companion(shot, self._view.companion, sticks="sticks" in self.layers)

    def _paint_body(self, shot: Shot) -> None:
        layers = self.layers
        if "segments" in layers:
            paint_segments(shot, self._document.skeleton.segments)
        if layers & {"trails", "all_trails"}:
            paint_trails(shot, self.trail_seconds, all_markers="all_trails" in layers)
        if "sticks" in layers:
            paint_sticks(shot, self._bones)
        paint_markers(shot, self._suspects_now())
        if "before_after" in layers:
            paint_edits(shot)
        if "measure" in layers:
            paint_measure(shot)

    def _suspects_now(self) -> set[int]:
        """Return the markers that are held for bad in this frame."""
        frame = self._view.frame
        now = (run for run in self._suspects if run.start <= frame < run.stop)
        return {marker for run in now for marker in markers_of(run)}

    def _ghost_pixels(self, shot: Shot) -> tuple[int, Array] | None:
        """Return the marker that a preview would put into this frame, and where."""
        preview, frame = self._view.preview, self._view.frame
        if preview is None or preview.patch is None:
            return None
        gap = preview.gap
        if not gap.start <= frame < gap.stop:
            return None
        pixel = shot.project(preview.patch.values[frame - gap.start][None])[0]
        return (gap.marker, pixel) if np.isfinite(pixel).all() else None

    def _paint_ghost(self, shot: Shot, ghost: tuple[int, Array] | None) -> None:
        """Paint the previewed repair: its trail, its sticks and the marker as a diamond."""
        preview = self._view.preview
        patch = None if preview is None else preview.patch
        if patch is not None and self.layers & {"trails", "all_trails"}:
            pixels = shot.project(patch.values)
            shot.pen(self._theme.preview, 1.5)
            shot.painter.drawPath(arrayToQPath(pixels[:, 0], pixels[:, 1], connect="finite"))
        exchange = exchange_shown(self._view, self._suspects)
        if exchange is not None:
            paint_exchange(shot, exchange, self._bones)
        paint_candidates(shot, self._view.others)
        paint_donors(shot, preview)
        if ghost is None:
            return
        marker, place = ghost
        if "sticks" in self.layers:
            touching = self._bones[(self._bones == marker).any(axis=1)]
            ends = shot.pixels[touching]
            ends[touching == marker] = place
            shot.pen(self._theme.preview, 1.2, Qt.PenStyle.DashLine)
            shot.pairs(ends.reshape(-1, 2))
        shot.pen(self._theme.preview, 2)
        shot.diamond(place, 8.0)

    def _paint_texts(self, shot: Shot, ghost: tuple[int, Array] | None) -> None:
        layers, skeleton = self.layers, self._document.skeleton
        places = shot.pixels.copy()
        if ghost is not None:
            places[ghost[0]] = ghost[1]
        names = []
        if "segments" in layers:
            names = paint_segment_names(shot, skeleton.segments)
        # What is proposed is seen without asking for it.
        some = (*self._view.proposed, *self._view.selection)
        labelled = range(len(places)) if "labels" in layers else some
        paint_labels(shot, places, labelled, names)
        paint_axes(shot)
        captions = []
        if self._view.picking:
            captions.append(self.tr("Picking donors: click markers; D ends it"))
        if "measure" in layers:
            captions.append(measurement(self._document, self._view.selection, self._view.frame))
        if "before_after" in layers:
            captions.append(edits_text(self._document, self._view.frame))
        if "segments" in layers and not skeleton.segments:
            captions.append(self.tr("Segments: none are known for this recording"))
        top = paint_key(shot, self._view.companion)
        paint_captions(shot, captions, top)

    def _paint_box(self, shot: Shot, box: QRectF) -> None:
        """Paint the box that selects."""
        fill = QColor(self._theme.accent)
        fill.setAlpha(40)
        shot.painter.fillRect(box, fill)
        shot.pen(self._theme.accent, 1.0, Qt.PenStyle.DashLine)
        shot.painter.drawRect(box)
