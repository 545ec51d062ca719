"""The pages of the report pane: by keyboard, after edits, and with the rest of the window."""

from collections.abc import Callable
from pathlib import Path

import pytest
from PySide6.QtCore import Qt
from PySide6.QtGui import QGuiApplication
from PySide6.QtWidgets import QFileDialog, QTableWidget
from pytestqt.qtbot import QtBot

from mocapmend import engine
from mocapmend.edits import Edit
from mocapmend.views.main_window import MainWindow
from mocapmend.views.report_pane import ReportPane
from mocapmend.views.tables import in_sight
from mocapmend.views.workspace import Workspace
from mocapmend_algorithms import no_progress
from mocapmend_algorithms.fill.registry import METHODS

Open = Callable[[Path], MainWindow]
CTRL = Qt.KeyboardModifier.ControlModifier
TRACKING, BONES, MARKERS, METHODS_PAGE, HISTORY = range(5)


@pytest.fixture
def workspace(open_in: Open, gait: Path, qtbot: QtBot) -> Workspace:
    """Return the workspace of the gait recording, with the report in front."""
    window = open_in(gait)
    assert window.workspace is not None
    qtbot.keyClick(window, Qt.Key.Key_3, CTRL)
    pane = window.workspace.report
    qtbot.waitUntil(pane.tabs.hasFocus)
    qtbot.waitUntil(lambda: pane.report is not None and pane.up_to_date, timeout=20_000)
    return window.workspace


def fill(workspace: Workspace, qtbot: QtBot, count: int) -> None:
    """Fill the first gaps linearly and wait for the report."""
    document, pane = workspace.document, workspace.report
    before = pane.report
    gaps = [gap for gap in document.gaps if gap.length < document.original.frames][:count]
    params = METHODS["linear"].params()
    result = engine.fill_anyway(document.original, gaps, "linear", params, no_progress)
    workspace.push(Edit.fills(result, "linear", params), f"fill {count}")
    qtbot.waitUntil(lambda: pane.report is not before and pane.up_to_date, timeout=20_000)


def cells(table: QTableWidget) -> list[list[str]]:
    return [
        [table.item(row, column).text() for column in range(table.columnCount())]
        for row in range(table.rowCount())
    ]


def test_the_pages_are_reached_by_keyboard(workspace: Workspace, qtbot: QtBot) -> None:
    pane = workspace.report
    seen = [pane.pages.currentIndex()]
    for _ in range(4):
        qtbot.keyClick(pane.tabs, Qt.Key.Key_Right)
        seen.append(pane.pages.currentIndex())
    assert seen == [TRACKING, BONES, MARKERS, METHODS_PAGE, HISTORY]
    assert [pane.tabs.tabText(i) for i in seen] == [
        "Tracking", "Bones", "Markers", "Methods", "History",
    ]  # fmt: skip
    pane.tabs.setCurrentIndex(MARKERS)
    qtbot.keyClick(pane.tabs, Qt.Key.Key_Tab)
    qtbot.waitUntil(pane.pages.markers.table.hasFocus)


def test_the_marker_table_has_the_figures_and_leads(workspace: Workspace, qtbot: QtBot) -> None:
    pane = workspace.report
    fill(workspace, qtbot, 3)
    assert pane.report is not None
    pane.tabs.setCurrentIndex(MARKERS)
    table = pane.pages.markers.table
    model = table.model()
    rows = pane.report.markers
    assert model.rowCount() == len(rows)
    marker = next(i for i, row in enumerate(rows) if row.filled)
    texts = [model.index(marker, column).data() for column in range(model.columnCount())]
    row = rows[marker]
    assert texts[0] == workspace.document.names[marker]
    assert texts[3:5] == [str(row.gaps_before), str(row.gaps_after)]
    assert texts[5] == str(row.longest_before)
    assert texts[8:10] == [str(row.filled), str(row.unfilled)]
    assert texts[10] == "—", "nothing is smoothed"
    assert texts[11].startswith("Linear ")
    table.selectRow(marker)
    assert workspace.view.selection == (marker,)
    table.sortByColumn(1, Qt.SortOrder.DescendingOrder)
    first = table.model().index(0, 0).data()
    most = max(rows, key=lambda row: row.missing_before)
    names = dict(zip(workspace.document.original.labels, workspace.document.names, strict=True))
    assert first == names[most.label]
    table.selectRow(0)
    assert workspace.view.marker == workspace.document.original.labels.index(most.label)
    workspace.view.select((marker,))
    chosen = table.selectionModel().selectedRows()
    assert [index.data() for index in chosen] == [workspace.document.names[marker]]


def test_the_paragraph_is_copied(workspace: Workspace, qtbot: QtBot) -> None:
    pane = workspace.report
    assert "No gap was filled." in pane.pages.methods.text.toPlainText()
    fill(workspace, qtbot, 2)
    text = pane.pages.methods.text.toPlainText()
    assert "2 by linear interpolation (method “linear”)." in text
    pane.tabs.setCurrentIndex(METHODS_PAGE)
    qtbot.mouseClick(pane.pages.methods.copy, Qt.MouseButton.LeftButton)
    assert QGuiApplication.clipboard().text() == text


def test_reasons_of_a_fill_that_filled_nothing_are_told(workspace: Workspace, qtbot: QtBot) -> None:
    gap = workspace.document.gaps[0]
    workspace.document.leave_open({gap: "it is too far away"})
    text = workspace.report.pages.methods.text
    qtbot.waitUntil(lambda: "it is too far away (1 gap)" in text.toPlainText(), timeout=20_000)


def test_the_history_lists_steps_and_what_was_undone(workspace: Workspace, qtbot: QtBot) -> None:
    pane, stack = workspace.report, workspace.document.undo_stack
    assert pane.pages.history.table.rowCount() == 0
    fill(workspace, qtbot, 2)
    fill(workspace, qtbot, 1)
    gap = min(workspace.document.repairs)
    workspace.push([Edit.clear(gap)], "clear it")
    table = pane.pages.history.table
    qtbot.waitUntil(lambda: table.rowCount() == 3)
    listed = cells(table)
    assert [row[0] for row in listed] == ["1", "2", "3"]
    assert [row[1] for row in listed] == ["fill 2", "fill 1", "clear it"]
    assert listed[0][3] == "2"
    assert listed[2][2:] == ["1", "1", "0", str(gap.length), "done"]
    stack.undo()
    stack.undo()
    qtbot.waitUntil(lambda: [row[6] for row in cells(table)] == ["done", "undone", "undone"])
    assert [row.text for row in workspace.report_inputs()[-1].edits] == ["fill 2"]


def test_repairs_of_before_open_the_history(
    open_in: Open, repaired_gait: Path, qtbot: QtBot
) -> None:
    workspace = open_in(repaired_gait).workspace
    assert workspace is not None
    count = len(workspace.document.repairs)
    (row,) = cells(workspace.report.pages.history.table)
    assert row[0] == "0"
    assert row[1] == f"{count} repairs that the file had when it was opened"
    assert row[6] == "before"


def test_segments_can_be_counted(workspace: Workspace, qtbot: QtBot) -> None:
    page, pane = workspace.report.pages.tracking, workspace.report
    assert pane.report is not None
    assert pane.report.segment_success is not None
    assert page.unit.isEnabled()

    def drawn(plot: int) -> list[float]:
        curve = page.plots[plot].getPlotItem().listDataItems()[0]
        return list(curve.yData)

    assert drawn(0) == (100 * pane.report.success_after.instantaneous).tolist()
    qtbot.keyClick(page.unit, Qt.Key.Key_Down)
    assert drawn(0) == (100 * pane.report.segment_success[1].instantaneous).tolist()
    for plot in page.plots:
        styles = [item.opts["pen"].style() for item in plot.getPlotItem().listDataItems()]
        assert styles == [Qt.PenStyle.SolidLine, Qt.PenStyle.DashLine]


def test_what_was_there_but_wrong_is_counted(workspace: Workspace, qtbot: QtBot) -> None:
    document, pane = workspace.document, workspace.report
    page, before = pane.pages.tracking, pane.report
    assert before is not None
    assert "wrong" not in page._key.text()
    seen = int(document.original.present.all(axis=0).argmax())
    workspace.view.select((seen,))
    workspace.view.set_span((10, 17))
    workspace.bad_actions.set_aside()
    qtbot.waitUntil(lambda: pane.report is not before and pane.up_to_date, timeout=20_000)
    assert "Samples that were there but wrong: 7" in page._key.text()


def test_a_stale_report_is_dropped(workspace: Workspace, qtbot: QtBot) -> None:
    pane: ReportPane = workspace.report
    before = pane.report
    pane._compute()
    stale = pane._job
    assert stale is not None
    pane._compute()
    qtbot.waitUntil(lambda: pane.report is not before, timeout=20_000)
    assert pane._job is not stale


def test_the_report_is_saved_as_pdf(
    workspace: Workspace, qtbot: QtBot, tmp_path: Path, monkeypatch: pytest.MonkeyPatch
) -> None:
    path = tmp_path / "walk.pdf"
    kinds: list[str] = []

    def answer(*args: str) -> tuple[str, str]:
        kinds.append(args[3])
        return str(path), ""

    monkeypatch.setattr(QFileDialog, "getSaveFileName", answer)
    window = workspace.window()
    assert isinstance(window, MainWindow)
    fill(workspace, qtbot, 1)
    window.files.ask_and_save_report()
    qtbot.waitUntil(lambda: not window.files.writing, timeout=20_000)
    assert path.read_bytes().startswith(b"%PDF-")
    assert "*.pdf" in kinds[0]
    assert "*.html" in kinds[0]


def test_out_of_sight_nothing_is_drawn_until_it_is_looked_at(
    open_in: Open, gait: Path, qtbot: QtBot
) -> None:
    window = open_in(gait)
    assert window.workspace is not None
    pane = window.workspace.report
    window.workspace.show_pane(window.workspace.timeline)
    qtbot.waitUntil(lambda: not in_sight(pane))
    before = pane.report
    pane.refresh()
    qtbot.waitUntil(lambda: pane.report is not None and pane.report is not before, timeout=20_000)
    assert not pane.up_to_date
    window.workspace.show_pane(pane)
    qtbot.waitUntil(lambda: pane.up_to_date)
    assert pane.pages.bones.table.rowCount() == len(pane.report.bone_names)
