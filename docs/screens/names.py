"""Names and labels, and what is corrected by hand."""

from PySide6.QtWidgets import QWidget

from mocapmend.settings import LABELLED_FILES
from mocapmend.views.palette import Palette
from mocapmend.views.samples import sample_recordings
from mocapmend.views.workspace import Workspace
from screens.stage import Stage, settle, wait_until

NAMELESS = (4, 9, 12, 30)
"""Points of the walk that lose their names."""


def names(stage: Stage) -> None:
    """Rename markers, and give points without a label theirs, by hand and from a recording."""
    workspace = stage.open_sample("walk_cmu_02_01")
    walk = workspace.document.source.path
    stage.show_pane(workspace.naming.pane)
    stage.shoot("labels_none")
    workspace.view.select((NAMELESS[0],))
    stage.do("rename")
    stage.shoot("rename")
    stage.show_pane(workspace.queue)
    stage.dialog("this_is", workspace.naming.ask_label)
    stage.dialog("this_is_refused", workspace.naming.ask_label, lambda d: _type(d, "nobody"))
    for marker in NAMELESS:
        workspace.naming.renaming.rename(marker, f"*{marker}")
    stage.dialog("this_is_new", workspace.naming.ask_label, lambda d: _type(d, "LF"))
    stage.settings.set(LABELLED_FILES, [])
    stage.dialog("label_from_none", workspace.naming.ask_recordings)
    stage.settings.set(LABELLED_FILES, [str(path) for path, _ in sample_recordings()])
    stage.dialog("label_from", workspace.naming.ask_recordings)
    workspace.naming.search.start([walk], keep_names=True)
    stage.show_pane(workspace.naming.pane)
    wait_until(lambda: workspace.naming.search.job is None)
    settle()
    stage.shoot("labels")
    workspace.naming.pane.accept()
    stage.shoot("labels_accepted")
    workspace.naming.pane.apply()
    stage.shoot("labels_applied")
    by_hand(stage, workspace)
    stage.close_all()


def by_hand(stage: Stage, workspace: Workspace) -> None:
    """Exchange two markers, and set samples of another aside."""
    stage.show_pane(workspace.timeline)
    workspace.view.select((5, 6))
    workspace.view.set_span((100, 140))
    stage.do("zoom_span")
    stage.do("exchange")
    stage.shoot("to exchange")
    stage.do("exchange")
    stage.shoot("exchanged")
    workspace.view.select((7,))
    workspace.view.set_span((150, 170))
    stage.do("set_aside")
    stage.do("zoom_span")
    stage.shoot("set_aside")
    stage.show_pane(workspace.report)
    wait_until(lambda: workspace.report.up_to_date)
    workspace.report.tabs.setCurrentIndex(workspace.report.tabs.count() - 1)
    stage.shoot("report_of_corrections")
    workspace.report.tabs.setCurrentIndex(0)
    workspace.view.set_span(None)


def _type(dialog: QWidget, text: str) -> None:
    assert isinstance(dialog, Palette)
    dialog.field.setText(text)
