"""A file that was repaired before, in the window: its repairs are repairs, to revert and redo."""

from collections.abc import Callable
from pathlib import Path

import numpy as np
import pytest
from PySide6.QtCore import Qt
from pytestqt.qtbot import QtBot

from mocapmend.files import check_files, read_c3d
from mocapmend.files.records import line
from mocapmend.files.sidecar import sidecar_path
from mocapmend.report import summarise
from mocapmend.settings import Settings
from mocapmend.state import SampleState
from mocapmend.views.main_window import MainWindow
from mocapmend.views.workspace import Workspace
from mocapmend_algorithms import Gap, no_progress
from mocapmend_algorithms.fill import registry
from mocapmend_algorithms.skeleton import Skeleton

Open = Callable[[Path], MainWindow]
CTRL = Qt.KeyboardModifier.ControlModifier


@pytest.fixture(params=["gait", "sprint"])
def pair(request: pytest.FixtureRequest) -> tuple[Path, Path]:
    """Return an original and its repaired copy, the record in the file and beside it."""
    name = request.param
    return request.getfixturevalue(name), request.getfixturevalue(f"repaired_{name}")


@pytest.fixture
def opened(open_in: Open, repaired_gait: Path, qtbot: QtBot) -> MainWindow:
    """Return the window with a repaired recording and the list of its repairs."""
    window = open_in(repaired_gait)
    show_repairs(window, qtbot)
    return window


def workspace_of(window: MainWindow) -> Workspace:
    assert window.workspace is not None
    return window.workspace


def show_repairs(window: MainWindow, qtbot: QtBot) -> None:
    qtbot.waitUntil(lambda: workspace_of(window).arranged)
    qtbot.keyClick(window, Qt.Key.Key_2, CTRL)
    table = workspace_of(window).repairs.table
    qtbot.waitUntil(table.hasFocus)


def rows(workspace: Workspace) -> list[tuple[str, ...]]:
    model = workspace.repairs.table.model()
    return [
        tuple(str(model.index(row, column).data()) for column in range(model.columnCount()))
        for row in range(model.rowCount())
    ]


def marked(workspace: Workspace) -> list[int]:
    return [index.row() for index in workspace.repairs.table.selectionModel().selectedRows()]


def frames_text(gap: Gap, first_frame: int) -> str:
    first, last = gap.start + first_frame, gap.stop - 1 + first_frame
    return str(first) if first == last else f"{first} – {last}"


def wait_for_preview(qtbot: QtBot, workspace: Workspace, method: str) -> None:
    qtbot.waitUntil(
        lambda: workspace.view.preview is not None and workspace.view.preview.method == method,
        timeout=20_000,
    )


def export(window: MainWindow, out: Path, qtbot: QtBot) -> Path:
    window.files.export(out)
    qtbot.waitUntil(lambda: not window.files.writing, timeout=20_000)
    return out


def records(path: Path) -> set[str]:
    return set(map(line, read_c3d(path).repairs))


def test_earlier_repairs_are_repairs(open_in: Open, pair: tuple[Path, Path], qtbot: QtBot) -> None:
    original, repaired = read_c3d(pair[0]), read_c3d(pair[1])
    window = open_in(pair[1])
    workspace = workspace_of(window)
    document = workspace.document
    assert len(repaired.repairs) == (780 if "sprint" in pair[1].name else 41)
    assert len(document.repairs) == len(rows(workspace)) == len(repaired.repairs)
    assert document.original.points.tobytes() == original.recording.points.tobytes()
    assert document.points.tobytes() == repaired.recording.points.tobytes()
    filled = document.state == SampleState.FILLED
    assert np.array_equal(filled, repaired.recording.present & ~original.recording.present)
    assert not window.isWindowModified()
    assert f"in which {len(repaired.repairs)} gaps" in window.statusBar().currentMessage()


def test_earlier_repairs_are_listed(open_in: Open, repaired_gait: Path) -> None:
    source = read_c3d(repaired_gait)
    workspace = workspace_of(open_in(repaired_gait))
    listed = sorted(rows(workspace))
    expected = sorted(
        (
            record.marker,
            frames_text(gap, source.recording.first_frame),
            str(gap.length),
            "Linear",
            f"{record.expected_error_mm:.1f} mm" if record.expected_error_mm >= 0 else "—",
            "before",
            "",
        )
        for gap, record in zip(source.repaired, source.repairs, strict=True)
    )
    assert listed == expected
    assert len({row[4] for row in listed}) > 5


def test_the_timeline_shows_earlier_repairs(opened: MainWindow) -> None:
    workspace = workspace_of(opened)
    workspace.show_pane(workspace.timeline)
    gap = max(workspace.document.repairs, key=lambda gap: gap.length)
    workspace.view.go_to(gap)
    timeline = workspace.timeline
    image = timeline.viewport().grab().toImage()
    x = round(timeline.axis.x_of((gap.start + gap.stop) / 2)) + 3
    column = {image.pixelColor(x, timeline.lane_top(gap.marker) + y).name() for y in range(6)}
    assert opened.theme.state_colour(SampleState.FILLED) in column


def test_the_report_counts_earlier_repairs(
    open_in: Open, pair: tuple[Path, Path], qtbot: QtBot
) -> None:
    before, after = (read_c3d(path).recording for path in pair)
    workspace = workspace_of(open_in(pair[1]))
    qtbot.waitUntil(lambda: workspace.report.report is not None, timeout=20_000)
    shown = workspace.report.report
    assert shown is not None
    expected = summarise(before, after, Skeleton("", (), "none"), (), (), no_progress)
    for name in ("success_before", "success_after"):
        one, other = getattr(shown, name), getattr(expected, name)
        assert np.array_equal(one.instantaneous, other.instantaneous)
        assert np.array_equal(one.survival, other.survival)
    about = workspace.report_inputs()[-1]
    assert about.earlier == len(workspace.document.repairs)


def test_moving_in_the_list_goes_to_the_repair_that_del_reverts(
    opened: MainWindow, qtbot: QtBot
) -> None:
    workspace = workspace_of(opened)
    table, view, document = workspace.repairs.table, workspace.view, workspace.document
    assert (marked(workspace), view.gap) == ([], None), "the list alone goes nowhere"
    for _ in range(3):
        qtbot.keyClick(table, Qt.Key.Key_Down)
    assert marked(workspace) == [2]
    gap = view.gap
    assert gap is not None
    listed = rows(workspace)
    assert listed[2][1] == frames_text(gap, document.original.first_frame)
    assert gap.start <= view.frame < gap.stop
    assert view.visible[0] <= gap.start < gap.stop <= view.visible[1]
    assert document.names[gap.marker] == listed[2][0]

    qtbot.keyClick(table, Qt.Key.Key_Delete)
    assert rows(workspace) == [*listed[:2], *listed[3:]]
    assert marked(workspace) == []
    assert gap in document.gaps
    assert not np.isfinite(document.points[gap.start : gap.stop, gap.marker]).any()
    qtbot.keyClick(table, Qt.Key.Key_Delete)
    assert document.undo_stack.count() == 1, "a gap is no repair"
    qtbot.keyClick(table, Qt.Key.Key_Down)
    assert marked(workspace) == [2]
    assert rows(workspace)[2] == listed[3], "the next one, none is left out"

    qtbot.keyClick(opened, Qt.Key.Key_Z, CTRL)
    assert rows(workspace) == listed
    assert not opened.isWindowModified()


def test_a_click_goes_to_the_repair(opened: MainWindow, qtbot: QtBot) -> None:
    workspace = workspace_of(opened)
    table = workspace.repairs.table
    place = table.visualRect(table.model().index(4, 0)).center()
    qtbot.mouseClick(table.viewport(), Qt.MouseButton.LeftButton, pos=place)
    gap = workspace.view.gap
    assert gap is not None
    assert rows(workspace)[4][1] == frames_text(gap, workspace.document.original.first_frame)
    workspace.view.go_to(workspace.document.gaps[0])
    assert marked(workspace) == []
    qtbot.mouseClick(table.viewport(), Qt.MouseButton.LeftButton, pos=place)
    assert workspace.view.gap == gap


def test_reverting_far_down_the_list_keeps_its_place(
    open_in: Open, repaired_sprint: Path, qtbot: QtBot
) -> None:
    window = open_in(repaired_sprint)
    show_repairs(window, qtbot)
    workspace = workspace_of(window)
    table = workspace.repairs.table
    table.sortByColumn(4, Qt.SortOrder.DescendingOrder)
    errors = [float(row[4].removesuffix(" mm")) for row in rows(workspace) if row[4] != "—"]
    assert len(errors) > 700
    assert errors == sorted(errors, reverse=True)
    table.selectRow(400)
    listed, scrolled = rows(workspace), table.verticalScrollBar().value()
    assert scrolled > 0
    assert workspace.view.gap in workspace.document.repairs
    qtbot.keyClick(table, Qt.Key.Key_Delete)
    assert rows(workspace) == [*listed[:400], *listed[401:]]
    assert table.verticalScrollBar().value() == scrolled
    workspace.document.undo_stack.undo()
    assert marked(workspace) == [400]


def test_a_reverted_repair_is_missing_in_the_copy(
    open_in: Open, pair: tuple[Path, Path], qtbot: QtBot, tmp_path: Path
) -> None:
    window = open_in(pair[1])
    workspace = workspace_of(window)
    before = read_c3d(pair[1])
    at = len(before.repaired) // 2
    gap, record = before.repaired[at], before.repairs[at]
    workspace.view.go_to(gap)
    qtbot.keyClick(window, Qt.Key.Key_Delete)
    assert window.isWindowModified()
    out = export(window, tmp_path / "out.c3d", qtbot)
    assert not window.isWindowModified()
    after = read_c3d(out)
    assert records(pair[1]) - records(out) == {line(record)}
    assert records(out) < records(pair[1])
    expected = before.recording.points.copy()
    expected[gap.start : gap.stop, gap.marker] = np.nan
    assert after.recording.points.tobytes() == expected.tobytes()
    for original in pair:
        check = check_files(original, out)
        assert check.passed, check.other_differences
    assert check.changed_samples == gap.length


def test_a_repair_can_be_made_again_by_another_method(
    opened: MainWindow, qtbot: QtBot, gait: Path, repaired_gait: Path, tmp_path: Path
) -> None:
    workspace = workspace_of(opened)
    document, table = workspace.document, workspace.repairs.table
    original = read_c3d(gait)
    # One that is close to another repair: a fill that leant on that one would differ.
    gap = next(
        one
        for one in document.repairs
        for other in document.repairs
        if one.marker == other.marker and 0 < other.start - one.stop < 5
    )
    workspace.view.go_to(gap)
    (row,) = marked(workspace)
    qtbot.keyClick(table, Qt.Key.Key_Delete)
    workspace.repair._method.setCurrentIndex(workspace.repair._method.findData("pchip"))
    wait_for_preview(qtbot, workspace, "pchip")
    preview = workspace.view.preview
    assert preview is not None
    assert preview.patch is not None
    method = registry.method("pchip")
    alone = method.function(original.recording, [gap], method.params(), no_progress).patches[0]
    assert preview.patch.values.tobytes() == alone.values.tobytes()
    assert preview.patch.sigma.tobytes() == alone.sigma.tobytes()
    qtbot.keyClick(table, Qt.Key.Key_Return)
    assert marked(workspace) == [row]
    assert rows(workspace)[row][3:6] == (method.label, rows(workspace)[row][4], "now")
    out = export(opened, tmp_path / "out.c3d", qtbot)
    assert check_files(gait, out).passed
    assert check_files(repaired_gait, out).passed
    again = read_c3d(out)
    assert {item.method for item in again.repairs} == {"linear", "pchip"}
    assert again.repairs[again.repaired.index(gap)].method == "pchip"
    assert len(again.repairs) == len(document.repairs)
    document.undo_stack.undo()
    document.undo_stack.undo()
    assert {row[5] for row in rows(workspace)} == {"before"}
    assert opened.isWindowModified(), "the exported file has another repair"


def test_fill_all_leaves_earlier_repairs_alone(
    opened: MainWindow, qtbot: QtBot, repaired_gait: Path
) -> None:
    workspace = workspace_of(opened)
    document = workspace.document
    before = read_c3d(repaired_gait)
    document.undo_stack.setClean()
    workspace.repair.limits._limit_error.setChecked(False)
    workspace.fill_all()
    qtbot.waitUntil(lambda: document.undo_stack.count() == 1, timeout=20_000)
    assert len(document.repairs) > len(before.repairs)
    assert all(document.is_earlier(gap) for gap in before.repaired)
    for gap in before.repaired:
        rows_of = slice(gap.start, gap.stop), gap.marker
        assert np.array_equal(document.points[rows_of], before.recording.points[rows_of])
    made = {row[5] for row in rows(workspace)}
    assert made == {"before", "now"}


def test_an_export_without_edits_is_the_same_file(
    open_in: Open, pair: tuple[Path, Path], qtbot: QtBot, tmp_path: Path
) -> None:
    window = open_in(pair[1])
    out = export(window, tmp_path / "copy.c3d", qtbot)
    assert out.read_bytes() == pair[1].read_bytes()
    assert "byte for byte" in window.statusBar().currentMessage()
    beside = sidecar_path(pair[1])
    assert sidecar_path(out).exists() == beside.exists() == ("sprint" in pair[1].name)
    if beside.exists():
        assert sidecar_path(out).read_bytes() == beside.read_bytes()
    assert records(out) == records(pair[1])


def test_edits_of_earlier_repairs_are_recovered(
    open_in: Open, qtbot: QtBot, repaired_gait: Path, gait: Path, settings: Settings, tmp_path: Path
) -> None:
    window = open_in(repaired_gait)
    workspace = workspace_of(window)
    first, second, *_ = workspace.document.repairs
    for gap in (first, second):
        workspace.view.go_to(gap)
        qtbot.keyClick(window, Qt.Key.Key_Delete)
    wait_for_preview(qtbot, workspace, workspace.repair.method()[0])
    qtbot.keyClick(window, Qt.Key.Key_Return)
    points, listed = workspace.document.points.copy(), rows(workspace)
    (journal,) = settings.journal_folder.glob("*")
    left = tmp_path / journal.name
    left.write_bytes(journal.read_bytes())
    workspace.document.undo_stack.setClean()
    open_in(gait)
    window.files.open(repaired_gait, left)
    qtbot.waitUntil(lambda: window.isWindowModified(), timeout=20_000)
    document = workspace_of(window).document
    assert document.points.tobytes() == points.tobytes()
    assert rows(workspace_of(window)) == listed
    assert not document.is_earlier(second)
    for _ in range(3):
        document.undo_stack.undo()
    assert document.is_earlier(first)
    assert document.is_earlier(second)
    assert document.points.tobytes() == read_c3d(repaired_gait).recording.points.tobytes()
    assert not window.isWindowModified()


def test_hidden_panes_do_not_take_the_keyboard(opened: MainWindow, qtbot: QtBot) -> None:
    workspace = workspace_of(opened)
    assert workspace.repairs.isEnabled()
    assert not workspace.report.isEnabled()
    qtbot.keyClick(opened, Qt.Key.Key_3, CTRL)
    qtbot.waitUntil(workspace.report.tabs.hasFocus)
    assert not workspace.repairs.isEnabled()
    qtbot.keyClick(opened, Qt.Key.Key_1, CTRL)
    qtbot.waitUntil(lambda: not workspace.report.isEnabled())
    assert workspace.timeline.isEnabled()
    pane = next(pane for pane in workspace.panes() if pane.widget() is workspace.repairs)
    pane.close()
    show_repairs(opened, qtbot)
    assert pane.isVisible()


def test_without_repairs_the_list_says_so(open_in: Open, gait: Path, qtbot: QtBot) -> None:
    window = open_in(gait)
    workspace = workspace_of(window)
    qtbot.waitUntil(lambda: workspace.arranged)
    assert workspace.repairs._pages.currentWidget() is workspace.repairs._empty
    gap = next(
        gap for gap in workspace.document.gaps if gap.kind(workspace.view.frames) == "interior"
    )
    workspace.view.go_to(gap)
    wait_for_preview(qtbot, workspace, workspace.repair.method()[0])
    workspace.gap_actions.apply()
    assert workspace.repairs._pages.currentWidget() is workspace.repairs.table
    assert marked(workspace) == [0]
    assert rows(workspace)[0][5] == "now"
    workspace.document.undo_stack.undo()
    assert workspace.repairs._pages.currentWidget() is workspace.repairs._empty
