"""Where the panes of a workspace are at first, and how large."""

from typing import TYPE_CHECKING

from PySide6.QtCore import QCoreApplication, Qt
from PySide6.QtWidgets import QLabel, QSizePolicy, QSplitter, QWidget

from mocapmend.document import Document
from mocapmend.views.text_scale import scaled
from mocapmend.views.timeline import GOOD_LANE, LANE

if TYPE_CHECKING:
    from mocapmend.views.workspace import Workspace

translate = QCoreApplication.translate

TAB_HEIGHT = 36
MARKERS_WIDTH, REPAIR_WIDTH = (352, 470), (280, 400)
"""Of the panes at the sides, from where they can be read to where all of it can."""
GOOD_BOTTOM = 0.22
"""Share of the window's height that the timeline takes where its lanes are still low."""
SIDE, MOST_SIDE = 0.2, 0.3
"""Shares of the window that they take, and that they take at most when texts are large."""
LEFT, RIGHT, BOTTOM = (
    Qt.DockWidgetArea.LeftDockWidgetArea,
    Qt.DockWidgetArea.RightDockWidgetArea,
    Qt.DockWidgetArea.BottomDockWidgetArea,
)


def arrange(workspace: "Workspace") -> None:
    """Put what a workspace has into its middle and into panes around it."""
    bottom = []
    if workspace.document.repairable:
        workspace.setCentralWidget(_middle(workspace))
        markers = workspace.dock("markers", translate("Panes", "Markers"), workspace.markers, LEFT)
        queue = workspace.dock("queue", translate("Panes", "Queue"), workspace.queue, LEFT)
        repair = workspace.dock("repair", translate("Panes", "Repair"), workspace.repair, RIGHT)
        for name, title, content in (
            ("timeline", translate("Panes", "Timeline"), workspace.timeline),
            ("plan", translate("Panes", "Plan"), workspace.plan),
            ("repairs", translate("Panes", "Repairs"), workspace.repairs),
            ("report", translate("Panes", "Report"), workspace.report),
            ("history", translate("Panes", "History"), workspace.history),
            ("labels", translate("Panes", "Labels"), workspace.naming.pane),
        ):
            bottom.append(workspace.dock(name, title, content, BOTTOM))
        smooth = workspace.dock("smooth", translate("Panes", "Smooth"), workspace.smooth, RIGHT)
        workspace.share_place([queue, markers])
        workspace.share_place([repair, smooth])
    else:
        workspace.setCentralWidget(
            _nothing_to_repair(workspace.document, alone=workspace.analog is None)
        )
    if workspace.analog is not None:
        title = translate("Panes", "Analog")
        bottom.append(workspace.dock("analog", title, workspace.analog, BOTTOM))
    if workspace.document.repairable:
        workspace.share_place(bottom)


def size_panes(workspace: "Workspace") -> None:
    """Give the panes the sizes that they have at first; the window must have its own."""
    markers, repair, timeline = (
        next(pane for pane in workspace.panes() if pane.objectName() == name)
        for name in ("markers", "repair", "timeline")
    )
    widths = [_width_of(workspace, *limits) for limits in (MARKERS_WIDTH, REPAIR_WIDTH)]
    workspace.resizeDocks([markers, repair], widths, Qt.Orientation.Horizontal)
    least = min(workspace.timeline.height_of(LANE), workspace.height() // 4)
    # In a high window lanes grow, but the plots have most of what there is more.
    good = min(workspace.timeline.height_of(GOOD_LANE), round(GOOD_BOTTOM * workspace.height()))
    workspace.resizeDocks([timeline], [max(least, good) + TAB_HEIGHT], Qt.Orientation.Vertical)


def _width_of(workspace: QWidget, least: int, most: int) -> int:
    """Return the width of a side pane: a share of the window, within what its text needs."""
    wanted = min(scaled(workspace, most), round(SIDE * workspace.width()))
    share = max(scaled(workspace, least), wanted)
    return min(share, round(MOST_SIDE * workspace.width()))


def _middle(workspace: "Workspace") -> QSplitter:
    middle = QSplitter(Qt.Orientation.Horizontal)
    middle.addWidget(workspace.scene)
    middle.addWidget(workspace.plots)
    middle.setSizes([400, 490])
    middle.setChildrenCollapsible(False)
    return middle


def _nothing_to_repair(document: Document, *, alone: bool) -> QLabel:
    source = document.source
    held = []
    if source.events:
        held.append(translate("Panes", "{0} events").format(len(source.events)))
    # Without frames there are only the names of channels and outputs.
    if source.analog_labels and document.original.frames:
        held.append(translate("Panes", "{0} analog channels").format(len(source.analog_labels)))
    if source.model_outputs and document.original.frames:
        held.append(translate("Panes", "{0} model outputs").format(len(source.model_outputs)))
    label = QLabel(
        translate(
            "Panes",
            "This file has no marker samples: there is nothing to repair.\n\nIt holds {0}.",
        ).format(", ".join(held) or translate("Panes", "nothing that can be shown"))
    )
    label.setAlignment(Qt.AlignmentFlag.AlignCenter)
    label.setWordWrap(True)
    label.setMargin(16)
    if not alone:
        # The channels take the rest of the window.
        label.setSizePolicy(QSizePolicy.Policy.Preferred, QSizePolicy.Policy.Maximum)
    return label
