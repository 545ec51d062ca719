"""Refining the joints of a Kinect, and looking at another recording beside the open one."""

from pathlib import Path

from PySide6.QtWidgets import QWidget

from mocapmend.refine.apart import Order
from mocapmend.refine.models import DEFAULT
from mocapmend.views.refine_dialog import RefineDialog
from mocapmend.views.workspace import Workspace
from mocapmend_algorithms.refine.refining import RefineParams
from screens.stage import Stage, settle, wait_until

MIDDLE = 40


def refining(stage: Stage) -> None:
    """Refine the bundled squat, compare, and see the report; then what does not fit."""
    workspace = stage.open_sample("squat_kinect")
    truth = workspace.document.source.path.with_name("squat_vicon.c3d")
    stage.shoot("kinect")
    stage.dialog("refine", lambda: stage.do("refine"))
    stage.dialog("refine_reference", lambda: stage.do("refine"), lambda d: _fill(d, truth))
    stage.dialog("refine_half_calibrated", lambda: stage.do("refine"), _half)
    refined = refine_squat(stage)
    stage.shoot("refined")
    stage.show_pane(refined.report)
    refined.report.tabs.setCurrentIndex(refined.report.tabs.count() - 1)
    settle()
    stage.shoot("refined_report")
    refined.comparing.look(truth)
    wait_until(lambda: refined.comparing.companion is not None)
    stage.wait()
    stage.shoot("compared")
    stage.close_all()
    stage.open_sample("walk_cmu_02_01")
    stage.dialog("refine_misfit", lambda: stage.do("refine"))
    stage.close_all()


def refine_squat(stage: Stage) -> Workspace:
    """Refine the squat that is open; return the outcome with its original beside it."""
    source = stage.workspace.document.source
    truth = source.path.with_name("squat_vicon.c3d")
    out = stage.home / "squat_refined.c3d"
    order = Order(source.path, source.stamp, DEFAULT, RefineParams("60", 6.0), out, truth)
    before = stage.window.documents.count()
    stage.window.files.refining.prepare(order)
    wait_until(lambda: stage.window.documents.count() > before)
    wait_until(lambda: stage.workspace.comparing.companion is not None)
    stage.wait()
    refined = stage.workspace
    refined.view.select((refined.document.labels.index("LWRA"),))
    refined.view.set_frame(MIDDLE)
    settle()
    return refined


def _fill(dialog: QWidget, truth: Path) -> None:
    assert isinstance(dialog, RefineDialog)
    dialog.reference.set_path(truth)
    dialog.calibration.set_path(truth.with_name("squat_kinect.c3d"))
    dialog.truth.set_path(truth)


def _half(dialog: QWidget) -> None:
    assert isinstance(dialog, RefineDialog)
    dialog.truth.set_path(Path("nowhere.c3d"))
