"""The queue: ranked in the background, filtered, stepped through, decided upon."""

from collections.abc import Callable
from pathlib import Path

import pytest
from holes import HOLES
from PySide6.QtCore import QPoint, Qt
from pytestqt.qtbot import QtBot

from mocapmend.ranking import Status
from mocapmend.settings import RANKING, Settings
from mocapmend.state import SampleState
from mocapmend.views.main_window import MainWindow
from mocapmend.views.queue_pane import QueuePane
from mocapmend.views.queue_table import QueueTable
from mocapmend.views.queue_texts import GLYPHS, Column, short_number
from mocapmend.views.workspace import Workspace
from mocapmend_algorithms import Gap

Open = Callable[[Path], MainWindow]
SHIFT = Qt.KeyboardModifier.ShiftModifier


def workspace_of(window: MainWindow) -> Workspace:
    assert window.workspace is not None
    return window.workspace


def worst(queue: QueuePane) -> Gap:
    problem = queue.worst()
    assert problem is not None
    return problem.gap


@pytest.fixture
def opened(open_in: Open, holed_walk: Path) -> MainWindow:
    """Return the window with the walk, not ranked."""
    return open_in(holed_walk)


@pytest.fixture
def ranked(open_in: Open, holed_walk: Path, settings: Settings, qtbot: QtBot) -> MainWindow:
    """Return the window with the walk, all repairs tried."""
    settings.set(RANKING, True)
    window = open_in(holed_walk)
    workspace = workspace_of(window)
    qtbot.waitUntil(lambda: workspace.survey.portions >= 4, timeout=60_000)
    qtbot.waitUntil(lambda: not workspace.survey.running, timeout=60_000)
    return window


def shown(workspace: Workspace, column: Column) -> list[str]:
    model = workspace.queue.model
    model.refresh()
    return [model.index(row, column).data() for row in range(model.rowCount())]


def test_the_worst_comes_first_and_the_user_is_there(ranked: MainWindow) -> None:
    workspace = workspace_of(ranked)
    harms = [float(text) for text in shown(workspace, Column.HARM)]
    assert len(harms) == 3
    assert harms == sorted(harms, reverse=True)
    errors = [float(text) for text in shown(workspace, Column.ERROR)]
    frames = [float(text) for text in shown(workspace, Column.FRAMES)]
    for harm, error, length in zip(harms, errors, frames, strict=True):
        assert harm == pytest.approx(error * length, abs=0.5 + 0.05 * length)
    assert workspace.view.gap == worst(workspace.queue)
    assert workspace.view.visible == (0.0, 343.0), "the user looks at the whole recording first"
    contexts = dict(zip(workspace.queue.model.gaps, shown(workspace, Column.CONTEXT), strict=True))
    assert contexts[HOLES["leading"]] == "start, 0 more missing"
    assert contexts[HOLES["trailing"]] == "end, 0 more missing"
    assert contexts[HOLES["interior"]] == "inside, 0 more missing"


def test_a_user_who_has_begun_is_not_taken_away(
    open_in: Open, holed_walk: Path, settings: Settings, qtbot: QtBot
) -> None:
    settings.set(RANKING, True)
    workspace = workspace_of(open_in(holed_walk))
    workspace.view.go_to(HOLES["trailing"])
    qtbot.waitUntil(lambda: workspace.survey.portions >= 2, timeout=60_000)
    assert workspace.view.gap == HOLES["trailing"]


def test_next_after_a_repair_is_the_worst_that_is_left(ranked: MainWindow, qtbot: QtBot) -> None:
    workspace = workspace_of(ranked)
    first, second, third = workspace.queue.model.gaps
    qtbot.waitUntil(lambda: workspace.view.preview is not None, timeout=20_000)
    qtbot.keyClick(ranked, Qt.Key.Key_Return, SHIFT)
    assert first in workspace.document.repairs
    assert workspace.view.gap == second
    qtbot.keyClick(ranked, Qt.Key.Key_N)
    assert workspace.view.gap == third
    qtbot.keyClick(ranked, Qt.Key.Key_N)
    assert workspace.view.gap == second, "around the end"
    qtbot.keyClick(ranked, Qt.Key.Key_P)
    assert workspace.view.gap == third


def test_a_click_and_the_arrow_keys_go_to_a_gap(opened: MainWindow, qtbot: QtBot) -> None:
    workspace = workspace_of(opened)
    table, model = workspace.queue.table, workspace.queue.model
    place = table.visualRect(model.index(2, 1)).center()
    qtbot.mouseClick(table.viewport(), Qt.MouseButton.LeftButton, pos=QPoint(place))
    assert workspace.view.gap == model.gaps[2]
    qtbot.keyClick(table, Qt.Key.Key_Up)
    assert workspace.view.gap == model.gaps[1]
    assert workspace.view.frame == (model.gaps[1].start + model.gaps[1].stop - 1) // 2


def test_gaps_are_left_open_and_taken_up_again(opened: MainWindow, qtbot: QtBot) -> None:
    workspace = workspace_of(opened)
    gap = HOLES["interior"]
    workspace.view.go_to(gap)
    qtbot.keyClick(opened, Qt.Key.Key_X)
    assert workspace.document.set_aside == {gap: "left open by hand"}
    assert workspace.view.gap != gap, "on to the next"
    workspace.queue.model.refresh()
    assert gap not in workspace.queue.model.gaps
    choose(workspace, Status.LEFT)
    assert workspace.queue.model.gaps == [gap]
    assert "left open by hand" in workspace.queue.model.index(0, 0).data(
        Qt.ItemDataRole.ToolTipRole
    )
    assert workspace.report_inputs()[4][0].gap == gap
    workspace.view.go_to(gap)
    qtbot.keyClick(opened, Qt.Key.Key_X)
    assert not workspace.document.set_aside


def test_a_protected_gap_is_never_filled_until_it_is_freed(
    opened: MainWindow, qtbot: QtBot
) -> None:
    workspace = workspace_of(opened)
    document, gap = workspace.document, HOLES["interior"]
    before = document.points.tobytes()
    workspace.view.go_to(gap)
    qtbot.keyClick(opened, Qt.Key.Key_X, SHIFT)
    assert document.never == [gap]
    assert gap not in document.gaps
    assert (document.state[gap.start : gap.stop, gap.marker] == SampleState.NEVER).all()
    assert "Never to be filled" in workspace.repair._promise.text()
    workspace.repair.limits._limit_error.setChecked(False)
    workspace.fill_all()
    qtbot.waitUntil(lambda: document.undo_stack.count() == 2, timeout=60_000)
    assert set(document.repairs) == {HOLES["leading"], HOLES["trailing"]}
    assert any(entry.gap == gap for entry in workspace.report_inputs()[4])
    choose(workspace, Status.NEVER)
    assert workspace.queue.model.gaps == [gap]
    assert workspace.queue.model.index(0, 0).data() == GLYPHS[Status.NEVER]
    workspace.view.go_to(gap)
    qtbot.keyClick(opened, Qt.Key.Key_X, SHIFT)
    assert gap in document.gaps
    document.undo_stack.setIndex(0)
    assert document.points.tobytes() == before


def choose(workspace: Workspace, status: Status) -> None:
    combo = workspace.queue.status
    wanted = [i for i in range(combo.count()) if combo.itemData(i) == frozenset({status})]
    combo.setCurrentIndex(wanted[0])


def test_filters_by_marker_length_and_status(open_in: Open, sprint: Path, qtbot: QtBot) -> None:
    workspace = workspace_of(open_in(sprint))
    queue, document = workspace.queue, workspace.document
    every = queue.model.gaps
    rate = document.original.rate
    queue.length.setCurrentIndex(1)
    assert queue.model.gaps == [gap for gap in every if gap.length <= 0.2 * rate]
    queue.length.setCurrentIndex(3)
    assert queue.model.gaps == [gap for gap in every if gap.length > rate]
    queue.length.setCurrentIndex(0)
    queue.filter.setText("forearml")
    named = [i for i, name in enumerate(document.names) if "ForearmL" in name]
    assert queue.model.gaps == [gap for gap in every if gap.marker in named]
    queue.filter.setText("no such marker")
    assert queue.model.rowCount() == 0
    assert queue._empty.isVisible()
    assert queue._empty.text() == "No problem passes the filter."
    told: list[str] = []
    workspace.message.connect(told.append)
    workspace.gap_actions.step(1)
    assert told == ["No problem is left in the queue."]


@pytest.mark.parametrize("column", list(Column))
def test_every_column_can_be_sorted_by(open_in: Open, sprint: Path, column: Column) -> None:
    workspace = workspace_of(open_in(sprint))
    model = workspace.queue.model
    gaps = set(model.gaps)
    for order in Qt.SortOrder:
        workspace.queue.table.sortByColumn(column, order)
        assert set(model.gaps) == gaps
        if column in (Column.FRAMES, Column.MS):
            lengths = [gap.length for gap in model.gaps]
            falling = order == Qt.SortOrder.DescendingOrder
            assert lengths == sorted(lengths, reverse=falling)


def test_ranking_is_switched_off_and_on(ranked: MainWindow, settings: Settings) -> None:
    workspace = workspace_of(ranked)
    workspace.queue.rank.setChecked(False)
    assert not settings.get(RANKING)
    assert not workspace.survey.on
    assert workspace.queue.model.index(0, Column.ERROR).data() != "…", "what is known is kept"
    workspace.queue.rank.setChecked(True)
    assert workspace.survey.on


def test_a_gap_with_other_ends_is_ranked_anew(ranked: MainWindow, qtbot: QtBot) -> None:
    workspace = workspace_of(ranked)
    workspace.view.go_to(HOLES["interior"])
    workspace.gap_actions.widen(1)
    wide = workspace.view.gap
    assert wide is not None
    qtbot.waitUntil(lambda: workspace.prospects.best(wide) is not None, timeout=60_000)


@pytest.mark.parametrize(
    ("value", "text"),
    [
        (0.0, "0"),
        (99_999.4, "99999"),
        (99_999.6, "100k"),
        (1_731_488.0, "1731k"),
        (9_999_999.6, "10M"),
        (31_000_000.0, "31M"),
    ],
)
def test_harm_is_short_enough_to_be_compared(value: float, text: str) -> None:
    assert short_number(value) == text


def test_a_complete_recording_says_so(open_in: Open, samples: Path) -> None:
    workspace = workspace_of(open_in(samples / "walk_cmu_02_01.c3d"))
    assert workspace.queue.worst() is None
    assert "nothing to fill" in workspace.queue._empty.text()
    assert "were not looked for" in workspace.queue._empty.text()
    workspace.queue.look.setChecked(True)
    assert "are being looked for" in workspace.queue._empty.text()
    workspace.queue.look.setChecked(False)
    assert "were not looked for" in workspace.queue._empty.text()
    assert workspace.queue.model.gaps == []
    assert not workspace.queue.step(1)


def test_names_take_the_room_that_the_numbers_leave_them(opened: MainWindow, qtbot: QtBot) -> None:
    name = "AnExcessivelyLongSubject:AnExcessivelyLongMarker"
    table = QueueTable(workspace_of(opened).queue.model, name)
    qtbot.addWidget(table)
    header, metrics = table.horizontalHeader(), table.fontMetrics()
    table.resize(450, 300)
    table.grab()
    first = (Column.STATUS, Column.MARKER, Column.FRAMES, Column.ERROR, Column.HARM)
    assert sum(map(header.sectionSize, first)) == table.viewport().width()
    assert header.sectionSize(Column.ERROR) > metrics.horizontalAdvance("0000.0")
    table.resize(1400, 300)
    table.grab()
    assert header.sectionSize(Column.MARKER) > metrics.horizontalAdvance(name)
    assert sum(map(header.sectionSize, first)) < table.viewport().width()
