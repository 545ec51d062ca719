"""Bad samples in the window: found by themselves, listed, fixed, dismissed, corrected by hand."""

from collections.abc import Callable
from pathlib import Path

import numpy as np
import pytest
from PySide6.QtCore import QPoint, Qt
from pytestqt.qtbot import QtBot
from spoilt import HOLE, LEAP, OTHER, SPIKE, SWAP

from mocapmend.doubts import BY_HAND
from mocapmend.prospects import Way
from mocapmend.ranking import Status
from mocapmend.settings import RANKING, SEARCHING, Settings
from mocapmend.state import SampleState
from mocapmend.suspects import gap_to_be, place_of
from mocapmend.views.main_window import MainWindow
from mocapmend.views.queue_texts import GLYPHS, Column
from mocapmend.views.workspace import Workspace
from mocapmend_algorithms import Gap
from mocapmend_algorithms.corrections import Exchange
from mocapmend_algorithms.fill.limits import Limits
from mocapmend_algorithms.problems import BadRun

Open = Callable[[Path], MainWindow]
SHIFT, CTRL = Qt.KeyboardModifier.ShiftModifier, Qt.KeyboardModifier.ControlModifier


def workspace_of(window: MainWindow) -> Workspace:
    assert window.workspace is not None
    return window.workspace


@pytest.fixture
def plain(open_in: Open, spoilt_walk: Path) -> MainWindow:
    """Return the window with the spoilt walk, of which nothing is known."""
    return open_in(spoilt_walk)


@pytest.fixture
def searched(open_in: Open, spoilt_walk: Path, settings: Settings, qtbot: QtBot) -> MainWindow:
    """Return the window with the spoilt walk, its bad samples found by themselves."""
    settings.set(SEARCHING, True)
    window = open_in(spoilt_walk)
    at_rest(workspace_of(window), qtbot)
    return window


@pytest.fixture
def told(searched: MainWindow) -> list[str]:
    """Return what the window says in passing."""
    texts: list[str] = []
    workspace_of(searched).message.connect(texts.append)
    return texts


def at_rest(workspace: Workspace, qtbot: QtBot) -> None:
    """Wait until it is known what is bad now."""
    qtbot.waitUntil(lambda: workspace.search.suspects.known and not workspace.search.running)
    qtbot.waitUntil(lambda: workspace.filling.job is None)
    workspace.queue.model.refresh()


def listed(workspace: Workspace, column: Column) -> list[str]:
    model = workspace.queue.model
    model.refresh()
    return [model.index(row, column).data() for row in range(model.rowCount())]


def kinds_found(workspace: Workspace) -> list[tuple[str, Gap]]:
    return sorted((run.kind, place_of(run)) for run in workspace.search.suspects.found)


def go_to(workspace: Workspace, place: Gap) -> None:
    """Go to the bad run at a place as a click on its row does."""
    model = workspace.queue.model
    model.refresh()
    row = next(
        row
        for row, gap in enumerate(model.gaps)
        if gap == place and model.problem(row).bad is not None
    )
    table = workspace.queue.table
    table.clicked.emit(model.index(row, 1))


def choose(workspace: Workspace, status: Status) -> None:
    combo = workspace.queue.status
    wanted = [i for i in range(combo.count()) if status in combo.itemData(i)]
    combo.setCurrentIndex(wanted[0])


class TestFound:
    def test_they_are_in_the_queue_with_the_gap_the_worst_first(self, searched: MainWindow) -> None:
        workspace = workspace_of(searched)
        assert ("spikes", SPIKE) in kinds_found(workspace)
        assert ("swaps", SWAP) in kinds_found(workspace)
        model = workspace.queue.model
        workspace.queue.table.sortByColumn(Column.HARM, Qt.SortOrder.DescendingOrder)
        assert model.gaps[:2] == [SWAP, SPIKE]
        kinds = dict(zip(model.gaps, listed(workspace, Column.KIND), strict=True))
        assert (kinds[SWAP], kinds[SPIKE], kinds[HOLE]) == ("Swap", "Spike", "Gap")
        assert listed(workspace, Column.MARKER)[:2] == ["RELB ↔ LWRA", "RFWT"]
        assert listed(workspace, Column.FRAMES)[:2] == ["50", "2"]
        assert float(listed(workspace, Column.ERROR)[1]) == pytest.approx(LEAP, rel=0.1)
        assert listed(workspace, Column.STATUS)[0] == GLYPHS[Status.FOUND]
        tip = model.index(1, 1).data(Qt.ItemDataRole.ToolTipRole)
        assert "found" in tip
        assert "% sure" in tip
        assert "times the noise there" in tip

    def test_a_gap_that_is_ranked_has_its_place_among_them(
        self, searched: MainWindow, qtbot: QtBot
    ) -> None:
        workspace = workspace_of(searched)
        workspace.queue.rank.setChecked(True)
        qtbot.waitUntil(lambda: workspace.prospects.tried(HOLE))
        qtbot.waitUntil(lambda: not workspace.survey.running)
        workspace.queue.model.refresh()
        harms = [workspace.queue.model.problem(row).harm for row in range(4)]
        assert harms == sorted(harms, reverse=True)
        assert workspace.queue.model.gaps[0] == SWAP

    def test_without_the_setting_nothing_is_looked_for_until_it_is_asked_for(
        self, plain: MainWindow, qtbot: QtBot
    ) -> None:
        workspace = workspace_of(plain)
        qtbot.waitUntil(lambda: workspace.document.found_skeleton is not None)
        assert not workspace.search.running
        assert workspace.queue.table.isColumnHidden(Column.KIND)
        said: list[str] = []
        workspace.message.connect(said.append)
        with qtbot.waitSignal(workspace.search.done) as found:
            qtbot.keyClick(plain, Qt.Key.Key_F, CTRL)
        assert found.args == [3]
        assert said == ["Bad samples found: 3; they are in the queue."]
        workspace.queue._catch_up()
        assert not workspace.queue.table.isColumnHidden(Column.KIND)
        plain.actions_by_id["search_bad"].trigger()
        assert len(said) == 2, "what is known is not looked for again"

    def test_asked_for_before_the_bones_are_known_it_is_done_then(
        self, plain: MainWindow, qtbot: QtBot
    ) -> None:
        workspace = workspace_of(plain)
        document = workspace.document
        qtbot.waitUntil(lambda: document.found_skeleton is not None)
        skeleton, document.found_skeleton = document.found_skeleton, None
        workspace.search.search()
        assert not workspace.search.running
        assert skeleton is not None
        with qtbot.waitSignal(workspace.search.done):
            document.set_skeleton(skeleton)

    def test_it_is_switched_off_and_on(
        self, searched: MainWindow, settings: Settings, qtbot: QtBot
    ) -> None:
        workspace = workspace_of(searched)
        workspace.queue.look.setChecked(False)
        assert not settings.get(SEARCHING)
        go_to(workspace, SPIKE)
        workspace.bad_actions.fix()
        assert not workspace.search.running
        assert not workspace.search.suspects.known
        workspace.queue.look.setChecked(True)
        at_rest(workspace, qtbot)

    def test_a_point_is_a_ghost_or_none_by_its_name(
        self, searched: MainWindow, qtbot: QtBot
    ) -> None:
        workspace = workspace_of(searched)
        assert "fragments" not in dict(kinds_found(workspace))
        workspace.naming.renaming.rename(5, "*5")
        at_rest(workspace, qtbot)
        assert "fragments" in dict(kinds_found(workspace))
        workspace.document.undo_stack.undo()
        assert "fragments" not in dict(kinds_found(workspace)), "at once"
        assert "spikes" in dict(kinds_found(workspace))
        at_rest(workspace, qtbot)
        assert "fragments" not in dict(kinds_found(workspace))

    def test_filter_by_kind(self, searched: MainWindow) -> None:
        workspace = workspace_of(searched)
        queue = workspace.queue
        kinds = {queue.kind.itemText(i): i for i in range(queue.kind.count())}
        queue.kind.setCurrentIndex(kinds["Swapped labels"])
        assert queue.model.gaps == [SWAP]
        queue.kind.setCurrentIndex(kinds["Gaps"])
        assert queue.model.gaps == [HOLE]
        queue.kind.setCurrentIndex(kinds["Bad samples"])
        assert HOLE not in queue.model.gaps
        assert {SWAP, SPIKE} <= set(queue.model.gaps)
        queue.filter.setText("LWRA")
        assert queue.model.gaps == [SWAP], "by the second marker too"

    def test_where_there_is_no_gap_the_user_begins_at_the_worst_of_them(
        self, open_in: Open, samples: Path, settings: Settings, qtbot: QtBot
    ) -> None:
        settings.set(SEARCHING, True)
        workspace = workspace_of(open_in(samples / "walk_cmu_02_01.c3d"))
        qtbot.waitUntil(lambda: workspace.view.suspect is not None)
        assert workspace.view.suspect in workspace.search.suspects.found
        assert workspace.view.visible == (0.0, 343.0)


class TestSteps:
    def test_n_and_p_go_through_gaps_and_bad_samples_alike(
        self, searched: MainWindow, qtbot: QtBot
    ) -> None:
        workspace = workspace_of(searched)
        view, gaps = workspace.view, workspace.queue.model.gaps
        seen = []
        for _ in gaps:
            qtbot.keyClick(searched, Qt.Key.Key_N)
            assert (view.gap is None) != (view.suspect is None)
            seen.append(view.gap if view.suspect is None else place_of(view.suspect))
        assert set(seen) == set(gaps)
        qtbot.keyClick(searched, Qt.Key.Key_P)
        assert (view.gap or place_of(view.suspect)) == seen[-2]

    def test_going_to_one_shows_it_and_what_is_known_of_it(self, searched: MainWindow) -> None:
        workspace = workspace_of(searched)
        go_to(workspace, SWAP)
        view, box = workspace.view, workspace.repair._suspect_box
        assert view.selection == (OTHER, SWAP.marker)
        assert SWAP.start <= view.frame < SWAP.stop
        assert view.visible[0] < SWAP.start < SWAP.stop < view.visible[1]
        assert box.isVisible()
        assert not workspace.repair._gap_box.isVisible()
        assert "Swapped labels: RELB ↔ LWRA" in box._title.text()
        assert "each continue the other" in box._about.text()
        view.go_to(HOLE)
        assert not box.isVisible()
        assert workspace.repair._gap_box.isVisible()

    def test_the_buttons_are_above_what_is_longer_or_shorter(
        self, searched: MainWindow, qtbot: QtBot
    ) -> None:
        workspace = workspace_of(searched)
        box = workspace.repair._suspect_box
        for place in (SPIKE, SWAP):
            go_to(workspace, place)
            qtbot.waitUntil(lambda: box.fix.geometry().bottom() < box._about.y())

    def test_it_is_zoomed_to(self, searched: MainWindow) -> None:
        workspace = workspace_of(searched)
        view = workspace.view
        go_to(workspace, SWAP)
        workspace.zoom_all()
        searched.actions_by_id["zoom_gap"].trigger()
        start, stop = view.visible
        assert start < SWAP.start < SWAP.stop < stop
        assert stop - start < 4 * SWAP.length

    def test_the_arrow_keys_of_the_table_go_to_them(
        self, searched: MainWindow, qtbot: QtBot
    ) -> None:
        workspace = workspace_of(searched)
        table, model = workspace.queue.table, workspace.queue.model
        place = table.visualRect(model.index(1, 1)).center()
        qtbot.mouseClick(table.viewport(), Qt.MouseButton.LeftButton, pos=QPoint(place))
        qtbot.keyClick(table, Qt.Key.Key_Up)
        assert workspace.view.suspect == model.bad(0)


class TestFix:
    def test_a_spike_is_set_aside_and_the_queue_goes_on(
        self, searched: MainWindow, qtbot: QtBot
    ) -> None:
        workspace = workspace_of(searched)
        document = workspace.document
        before, stored = document.points.tobytes(), document.stored(SPIKE)
        go_to(workspace, SPIKE)
        qtbot.keyClick(searched, Qt.Key.Key_H)
        assert (document.state[SPIKE.start : SPIKE.stop, SPIKE.marker] == SampleState.BAD).all()
        assert np.isnan(document.points[SPIKE.start : SPIKE.stop, SPIKE.marker]).all()
        np.testing.assert_array_equal(document.stored(SPIKE), stored)
        assert SPIKE in document.gaps
        assert document.doubts[SPIKE].problem == "spikes"
        assert workspace.view.suspect is None or place_of(workspace.view.suspect) != SPIKE
        assert workspace.view.suspect is not None or workspace.view.gap is not None
        at_rest(workspace, qtbot)
        assert ("spikes", SPIKE) not in kinds_found(workspace)
        assert ("swaps", SWAP) in kinds_found(workspace)
        choose(workspace, Status.FIXED)
        assert workspace.queue.model.gaps == [SPIKE]
        assert listed(workspace, Column.STATUS) == [GLYPHS[Status.FIXED]]
        document.undo_stack.undo()
        assert document.points.tobytes() == before
        assert ("spikes", SPIKE) in kinds_found(workspace), "known already"

    def test_a_swap_is_exchanged_back(
        self, searched: MainWindow, samples: Path, qtbot: QtBot
    ) -> None:
        workspace = workspace_of(searched)
        document = workspace.document
        before = document.points.copy()
        go_to(workspace, SWAP)
        qtbot.keyClick(searched, Qt.Key.Key_Return)
        rows, pair = slice(SWAP.start, SWAP.stop), [SWAP.marker, OTHER]
        np.testing.assert_array_equal(document.points[rows, pair], before[rows, pair[::-1]])
        at_rest(workspace, qtbot)
        assert ("swaps", SWAP) not in kinds_found(workspace)
        assert workspace.facts.about().put_right.found_as == (("swaps", 1),)
        assert ("spikes", SPIKE) in kinds_found(workspace)
        choose(workspace, Status.FIXED)
        assert listed(workspace, Column.MARKER) == ["RELB ↔ LWRA"]
        assert float(listed(workspace, Column.ERROR)[0]) > 100.0, "as it was found"

    def test_all_of_a_kind_and_all_are_one_step_each(
        self, searched: MainWindow, told: list[str], qtbot: QtBot
    ) -> None:
        workspace = workspace_of(searched)
        document, found = workspace.document, workspace.search.suspects.found
        before = document.points.tobytes()
        spikes = [run for run in found if run.kind == "spikes"]
        go_to(workspace, SPIKE)
        qtbot.keyClick(searched, Qt.Key.Key_H, SHIFT)
        assert document.undo_stack.count() == 1
        assert set(map(place_of, spikes)) == set(document.doubts)
        assert document.undo_stack.text(0) == f"fix {len(spikes)} problems (spikes)"
        document.undo_stack.undo()
        qtbot.keyClick(searched, Qt.Key.Key_H, CTRL)
        assert document.undo_stack.count() == 1
        assert document.undo_stack.text(0) == f"fix {len(found)} problems"
        assert len(document.layers.moves) == 2
        assert told[-1].startswith(f"Problems fixed: {len(found)}.")
        at_rest(workspace, qtbot)
        assert not workspace.search.suspects.found
        qtbot.keyClick(searched, Qt.Key.Key_H, CTRL)
        assert told[-1] == "There is nothing that could be fixed."
        document.undo_stack.undo()
        assert document.points.tobytes() == before

    def test_after_all_of_a_kind_the_next_is_the_worst_that_is_left(
        self, searched: MainWindow, qtbot: QtBot
    ) -> None:
        workspace = workspace_of(searched)
        go_to(workspace, SPIKE)
        qtbot.keyClick(searched, Qt.Key.Key_H, SHIFT)
        at_rest(workspace, qtbot)
        qtbot.keyClick(searched, Qt.Key.Key_N)
        worst, view = workspace.queue.worst(), workspace.view
        assert worst is not None
        assert (view.gap if view.suspect is None else place_of(view.suspect)) == worst.gap

    def test_undo_and_redo_say_what_they_do(
        self, searched: MainWindow, told: list[str], qtbot: QtBot
    ) -> None:
        workspace = workspace_of(searched)
        go_to(workspace, SPIKE)
        workspace.bad_actions.fix()
        searched.actions_by_id["undo"].trigger()
        assert told[-1] == "Taken back: fix RFWT (Spikes)."
        searched.actions_by_id["redo"].trigger()
        assert told[-1] == "Made again: fix RFWT (Spikes)."
        at_rest(workspace, qtbot)

    def test_what_was_fixed_before_the_file_was_saved_is_listed(
        self, searched: MainWindow, open_in: Open, tmp_path: Path, qtbot: QtBot
    ) -> None:
        workspace = workspace_of(searched)
        workspace.bad_actions.fix_all()
        fixed = sorted(map(place_of, workspace.search.suspects.fixed()))
        assert {SPIKE, SWAP} <= set(fixed)
        at_rest(workspace, qtbot)
        out = tmp_path / "mended.c3d"
        searched.files.export(out)
        qtbot.waitUntil(lambda: not searched.isWindowModified() and not searched.files.writing)
        again = workspace_of(open_in(out))
        assert sorted(map(place_of, again.search.suspects.fixed())) == fixed

    def test_fills_that_lean_on_what_is_corrected_are_made_anew(
        self, searched: MainWindow, qtbot: QtBot
    ) -> None:
        workspace = workspace_of(searched)
        document = workspace.document
        workspace.filling.fill_all(Way.default("local-frame"), Limits())
        qtbot.waitUntil(lambda: HOLE in document.repairs)
        qtbot.waitUntil(lambda: workspace.filling.job is None)
        go_to(workspace, SWAP)
        workspace.bad_actions.fix()
        assert document.stale == [HOLE]
        qtbot.waitUntil(lambda: document.stale == [])
        assert HOLE in document.repairs
        at_rest(workspace, qtbot)


class TestPreview:
    def test_what_is_to_be_set_aside_is_shown_as_it_would_be_filled(
        self, searched: MainWindow, qtbot: QtBot
    ) -> None:
        workspace = workspace_of(searched)
        document, view = workspace.document, workspace.view
        go_to(workspace, SPIKE)
        qtbot.waitUntil(lambda: view.preview is not None and view.preview.patch is not None)
        assert view.preview.gap == SPIKE
        assert "expected error" in workspace.repair._suspect_box._about.text()
        # Nearer to the trajectory than what is measured: the spike itself is not leaned on.
        inside = document.points[SPIKE.start : SPIKE.stop, SPIKE.marker]
        off = np.linalg.norm(view.preview.patch.values - inside, axis=1)
        assert off == pytest.approx(LEAP, rel=0.1)
        go_to(workspace, SWAP)
        assert view.preview is None

    def test_after_fixing_the_same_fill_can_be_applied(
        self, searched: MainWindow, qtbot: QtBot
    ) -> None:
        workspace = workspace_of(searched)
        document, view = workspace.document, workspace.view
        go_to(workspace, SPIKE)
        qtbot.keyClick(searched, Qt.Key.Key_Return)
        choose(workspace, Status.FIXED)
        go_to(workspace, SPIKE)
        qtbot.waitUntil(lambda: view.preview is not None)
        qtbot.keyClick(searched, Qt.Key.Key_Return)
        assert SPIKE in document.repairs
        assert SPIKE in document.doubts
        at_rest(workspace, qtbot)

    def test_a_ragged_end_becomes_one_gap_with_that_beside_it(self, searched: MainWindow) -> None:
        document = workspace_of(searched).document
        tail = BadRun("tails", HOLE.marker, HOLE.start - 3, HOLE.start, 0.9, 5.0, "It bends.")
        assert gap_to_be(document, tail) == Gap(HOLE.marker, HOLE.start - 3, HOLE.stop)
        both = BadRun("swaps", 1, 5, 9, 0.9, 5.0, "They swap.", other=2)
        assert gap_to_be(document, both) is None


class TestShown:
    def test_the_marker_list_and_the_plots_tell_what_is_set_aside(
        self, searched: MainWindow
    ) -> None:
        workspace = workspace_of(searched)
        go_to(workspace, SPIKE)
        workspace.bad_actions.fix()
        model = workspace.markers._model
        tip = model.index(SPIKE.marker, 0).data(Qt.ItemDataRole.ToolTipRole)
        assert "2 samples set aside" in tip
        workspace.view.select((SPIKE.marker,))
        workspace.view.set_frame(SPIKE.start)
        (curve,) = workspace.trajectories._curves()
        assert workspace.trajectories._place_now(curve) == "set aside"
        row = workspace.facts.edits()[0]
        assert (row.markers, row.runs, row.cleared) == (1, 1, 2)
        assert "RFWT" in workspace.history.row_text(1)


class TestDismiss:
    def test_what_is_no_problem_is_out_of_sight_until_it_is_asked_for(
        self, searched: MainWindow, qtbot: QtBot
    ) -> None:
        workspace = workspace_of(searched)
        go_to(workspace, SPIKE)
        qtbot.keyClick(searched, Qt.Key.Key_D, SHIFT)
        workspace.queue._catch_up()
        assert SPIKE not in workspace.queue.model.gaps
        assert workspace.document.undo_stack.count() == 0
        choose(workspace, Status.DISMISSED)
        assert workspace.queue.model.gaps == [SPIKE]
        go_to(workspace, SPIKE)
        assert "no problem" in workspace.repair._suspect_box._about.text()
        qtbot.keyClick(searched, Qt.Key.Key_D, SHIFT)
        workspace.queue._catch_up()
        assert workspace.queue.model.gaps == []
        choose(workspace, Status.FOUND)
        assert SPIKE in workspace.queue.model.gaps

    def test_it_stays_so_after_corrections_and_is_not_fixed_with_all(
        self, searched: MainWindow, qtbot: QtBot
    ) -> None:
        workspace = workspace_of(searched)
        go_to(workspace, SPIKE)
        workspace.bad_actions.dismiss()
        workspace.bad_actions.fix_all()
        assert SPIKE not in workspace.document.doubts
        at_rest(workspace, qtbot)
        assert workspace.search.suspects.found == []
        assert [place_of(run) for run in workspace.search.suspects.dismissed] == [SPIKE]


class TestByHand:
    def test_the_sample_at_the_playhead_and_those_in_the_selected_time(
        self, searched: MainWindow, told: list[str], qtbot: QtBot
    ) -> None:
        workspace = workspace_of(searched)
        document, view = workspace.document, workspace.view
        before = document.points.tobytes()
        view.select((30,))
        view.set_frame(50)
        qtbot.keyClick(searched, Qt.Key.Key_U)
        assert set(document.doubts) == {Gap(30, 50, 51)}
        assert document.doubts[Gap(30, 50, 51)].problem == BY_HAND
        view.select((HOLE.marker, 31))
        view.set_span((HOLE.start - 2, HOLE.start + 3))
        qtbot.keyClick(searched, Qt.Key.Key_U)
        assert Gap(HOLE.marker, HOLE.start - 2, HOLE.start) in document.doubts
        assert Gap(31, HOLE.start - 2, HOLE.start + 3) in document.doubts
        assert told[-1] == "Samples set aside: 7."
        assert Gap(HOLE.marker, HOLE.start - 2, HOLE.stop) in document.gaps
        qtbot.keyClick(searched, Qt.Key.Key_U)
        assert told[-1] == "No measured sample is selected here."
        assert document.undo_stack.count() == 2
        document.undo_stack.setIndex(0)
        assert document.points.tobytes() == before

    def test_samples_are_believed_again(
        self, searched: MainWindow, told: list[str], qtbot: QtBot
    ) -> None:
        workspace = workspace_of(searched)
        document, view = workspace.document, workspace.view
        before = document.points.tobytes()
        view.select((30,))
        view.set_span((50, 60))
        workspace.bad_actions.set_aside()
        view.set_span((52, 54))
        qtbot.keyClick(searched, Qt.Key.Key_U, SHIFT)
        assert set(document.doubts) == {Gap(30, 50, 52), Gap(30, 54, 60)}
        assert told[-1] == "Samples believed again: 2."
        view.set_span(None)
        view.set_frame(57)
        qtbot.keyClick(searched, Qt.Key.Key_U, SHIFT)
        assert set(document.doubts) == {Gap(30, 50, 52)}, "the whole run at the playhead"
        choose(workspace, Status.FIXED)
        go_to(workspace, Gap(30, 50, 52))
        view.set_frame(100)
        qtbot.keyClick(searched, Qt.Key.Key_U, SHIFT)
        assert not document.doubts
        assert document.points.tobytes() == before
        qtbot.keyClick(searched, Qt.Key.Key_U, SHIFT)
        assert told[-1] == "No sample is set aside here."

    def test_two_markers_are_exchanged_in_the_selected_time(
        self, searched: MainWindow, told: list[str], qtbot: QtBot
    ) -> None:
        workspace = workspace_of(searched)
        document, view = workspace.document, workspace.view
        before = document.points.copy()
        view.select((5, 6, 7))
        qtbot.keyClick(searched, Qt.Key.Key_E, CTRL)
        assert told[-1] == "Select the two markers to be exchanged (Ctrl+click adds one)."
        view.select((5, HOLE.marker))
        view.set_span((HOLE.start - 5, HOLE.stop + 5))
        qtbot.keyClick(searched, Qt.Key.Key_E, CTRL)
        assert view.exchange == Exchange(5, HOLE.marker, HOLE.start - 5, HOLE.stop + 5)
        assert told[-1].startswith("Dashed lines show how it would be")
        assert not document.undo_stack.count(), "it is shown first"
        qtbot.keyClick(searched, Qt.Key.Key_E, CTRL)
        assert view.exchange is None
        rows, pair = slice(HOLE.start - 5, HOLE.stop + 5), [5, HOLE.marker]
        np.testing.assert_array_equal(document.points[rows, pair], before[rows, pair[::-1]])
        assert Gap(5, HOLE.start, HOLE.stop) in document.gaps, "the gap goes with it"
        assert document.gaps_of(HOLE.marker) == []
        document.undo_stack.undo()
        np.testing.assert_array_equal(document.points, before)

    def test_what_is_shown_of_an_exchange_goes_with_what_it_was_for(
        self, searched: MainWindow, qtbot: QtBot
    ) -> None:
        workspace = workspace_of(searched)
        document, view = workspace.document, workspace.view
        plots, scene = workspace.trajectories, workspace.scene
        view.select((5, 6))
        view.set_span((300, 320))
        view.frame_span(300, 320)
        view.set_frame(310)
        seen = plots.grab().toImage(), scene.grab().toImage()
        qtbot.keyClick(searched, Qt.Key.Key_E, CTRL)
        assert plots.grab().toImage() != seen[0]
        assert scene.grab().toImage() != seen[1]
        # For other frames it is shown anew, not done.
        view.set_span((300, 330))
        qtbot.keyClick(searched, Qt.Key.Key_E, CTRL)
        assert view.exchange == Exchange(5, 6, 300, 330)
        view.select((6,))
        assert view.exchange is None
        view.select((5, 6))
        qtbot.keyClick(searched, Qt.Key.Key_E, CTRL)
        assert view.exchange is not None
        workspace.bad_actions.set_aside()
        assert view.exchange is None
        assert document.layers.origins is None

    def test_without_one_it_is_from_the_playhead_to_the_next_end(
        self, searched: MainWindow, told: list[str], qtbot: QtBot
    ) -> None:
        workspace = workspace_of(searched)
        document, view = workspace.document, workspace.view
        before = document.points.copy()
        view.select((5, HOLE.marker))
        view.set_frame(HOLE.start - 30)
        qtbot.keyClick(searched, Qt.Key.Key_E, CTRL)
        qtbot.keyClick(searched, Qt.Key.Key_E, CTRL)
        changed = np.flatnonzero((document.points[:, 5] != before[:, 5]).any(axis=1))
        assert (changed[0], changed[-1]) == (HOLE.start - 30, HOLE.start - 1)
        assert told[-1] == f"Exchanged in 30 frames, from frame {HOLE.start - 29} on."
        document.undo_stack.undo()
        view.select((5, 6))
        view.set_frame(300)
        qtbot.keyClick(searched, Qt.Key.Key_E, CTRL)
        qtbot.keyClick(searched, Qt.Key.Key_E, CTRL)
        np.testing.assert_array_equal(document.points[300:, 5], before[300:, 6])
        np.testing.assert_array_equal(document.points[:300], before[:300])


class TestRefusals:
    def test_what_was_not_looked_for_cannot_be_fixed(self, plain: MainWindow) -> None:
        told: list[str] = []
        workspace_of(plain).message.connect(told.append)
        workspace_of(plain).bad_actions.fix_all()
        assert told == ["Bad samples are not known yet: look for them first (Ctrl+F)."]

    def test_without_bad_samples_at_hand_the_user_is_told(
        self, searched: MainWindow, told: list[str]
    ) -> None:
        workspace = workspace_of(searched)
        workspace.view.go_to(HOLE)
        for do in (
            workspace.bad_actions.fix,
            workspace.bad_actions.fix_kind,
            workspace.bad_actions.dismiss,
        ):
            do()
            assert told.pop() == "There is no bad sample here: choose a problem first (N)."

    def test_what_is_fixed_is_not_fixed_again(
        self, searched: MainWindow, told: list[str], qtbot: QtBot
    ) -> None:
        workspace = workspace_of(searched)
        workspace.bad_actions.fix_all()
        choose(workspace, Status.FIXED)
        go_to(workspace, SPIKE)
        workspace.bad_actions.fix()
        assert told[-1] == "This problem is fixed already; undo takes it back."
        workspace.bad_actions.dismiss()
        assert told[-1] == "This problem is fixed already; undo takes it back."
        at_rest(workspace, qtbot)

    def test_a_piece_that_fits_no_marker_cannot_be_fixed(
        self, open_in: Open, gait: Path, settings: Settings, qtbot: QtBot
    ) -> None:
        settings.set(SEARCHING, True)
        workspace = workspace_of(open_in(gait))
        at_rest(workspace, qtbot)
        ghosts = [run for run in workspace.search.suspects.found if run.other is None]
        assert ghosts
        told: list[str] = []
        workspace.message.connect(told.append)
        workspace.view.go_to_suspect(ghosts[0])
        workspace.bad_actions.fix()
        assert "fits no marker" in told[-1]
        assert not workspace.repair._suspect_box.fix.isEnabled()
        assert workspace.document.undo_stack.count() == 0


def test_a_search_is_over_when_the_recording_is_closed(
    open_in: Open, spoilt_walk: Path, settings: Settings, qtbot: QtBot
) -> None:
    settings.set(SEARCHING, True)
    settings.set(RANKING, True)
    window = open_in(spoilt_walk)
    workspace = workspace_of(window)
    qtbot.waitUntil(lambda: workspace.search.running)
    window.files.close()
    assert window.workspace is None
    qtbot.waitUntil(lambda: window.jobs.running == 0)
