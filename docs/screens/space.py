"""The 3D view with each of its layers."""

from PySide6.QtCore import QEvent, QPointF, Qt
from PySide6.QtGui import QMouseEvent
from PySide6.QtWidgets import QApplication, QSplitter

from screens.stage import Stage

LAYERS = (
    "labels", "trails", "all_trails", "sticks", "segments", "ground", "plates", "before_after",
    "measure",
)  # fmt: skip
FIRST = {"trails", "sticks", "ground", "plates"}


def space(stage: Stage) -> None:
    """Show each layer of the 3D view beside those that are on at first, all and none."""
    workspace = stage.workspace
    workspace.view.select(tuple(range(3)))
    workspace.go_to_frame(150)
    splitter = workspace.centralWidget()
    assert isinstance(splitter, QSplitter)
    sizes = splitter.sizes()
    splitter.setSizes([3 * sum(sizes) // 4, sum(sizes) // 4])
    for layer in (name for name in LAYERS if name not in FIRST):
        stage.switch(**{name: name in {*FIRST, layer} for name in LAYERS})
        stage.shoot(f"space_{layer}")
    workspace.view.select((0, 1))
    stage.shoot("space_distance")
    stage.switch(**dict.fromkeys(LAYERS, True))
    stage.shoot("space_all")
    stage.switch(**dict.fromkeys(LAYERS, False))
    stage.shoot("space_none")
    stage.switch(**{name: name in FIRST for name in LAYERS})
    for place in ("front", "top"):
        workspace.scene.look(place)
        stage.shoot(f"space_from_{place}")
    workspace.scene.look("oblique")
    _draw_box(stage)
    splitter.setSizes(sizes)


def _draw_box(stage: Stage) -> None:
    """Take a picture while a box is drawn with the right button."""
    scene = stage.workspace.scene
    start, end = QPointF(60, 60), QPointF(scene.width() / 2, scene.height() * 0.7)
    right = Qt.MouseButton.RightButton

    def send(kind: QEvent.Type, place: QPointF) -> None:
        there = scene.mapToGlobal(place)
        event = QMouseEvent(kind, place, there, right, right, Qt.KeyboardModifier.NoModifier)
        QApplication.sendEvent(scene, event)

    send(QEvent.Type.MouseButtonPress, start)
    send(QEvent.Type.MouseMove, QPointF(start.x() + 20, start.y() + 20))
    send(QEvent.Type.MouseMove, end)
    stage.shoot("space_box")
    send(QEvent.Type.MouseButtonRelease, end)
    stage.shoot("space_box_selected")
