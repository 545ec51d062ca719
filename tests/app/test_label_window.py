"""Labels in the window: proposed, reviewed, applied in one step; or given by hand."""

from collections.abc import Callable
from pathlib import Path

import numpy as np
import pytest
from PySide6.QtCore import Qt
from PySide6.QtWidgets import QComboBox, QFileDialog
from pytestqt.qtbot import QtBot
from scrambled import write_scrambled

from mocapmend import engine
from mocapmend.bench.labels.scrambling import GHOST, NOTHING, Scrambled
from mocapmend.files import read_c3d
from mocapmend.label_review import Decision, LabelReview
from mocapmend.ranking import Status
from mocapmend.settings import KEEP_NAMES, LABELLED_FILES, Settings
from mocapmend.unsure_labels import UNSURE
from mocapmend.views.label_chooser import LabelChooser
from mocapmend.views.label_dialog import LabelDialog
from mocapmend.views.label_table import Column
from mocapmend.views.main_window import MainWindow
from mocapmend.views.queue_model import TO_DO
from mocapmend.views.workspace import Workspace
from mocapmend_algorithms import no_progress
from mocapmend_algorithms.labelling import Labelling, LabelParams
from mocapmend_algorithms.names import without_subject

Open = Callable[[Path], MainWindow]


@pytest.fixture(scope="module")
def walk(samples: Path) -> Path:
    return samples / "walk_cmu_02_01.c3d"


@pytest.fixture(scope="module")
def file(tmp_path_factory: pytest.TempPathFactory) -> Path:
    return tmp_path_factory.mktemp("labels") / "scrambled.c3d"


@pytest.fixture(scope="module")
def scrambled(walk: Path, file: Path) -> Scrambled:
    return write_scrambled(walk, file)


@pytest.fixture(scope="module")
def labelling(scrambled: Scrambled, walk: Path, file: Path) -> Labelling:
    """Return what is proposed for it: computed once."""
    base = read_c3d(file).measured
    return engine.label_from(base, [walk], LabelParams(), no_progress)


@pytest.fixture
def workspace(scrambled: Scrambled, file: Path, open_in: Open) -> Workspace:
    window = open_in(file)
    assert window.workspace is not None
    return window.workspace


@pytest.fixture
def review(workspace: Workspace, labelling: Labelling, qtbot: QtBot) -> LabelReview:
    """Return the review of labels that were proposed."""
    workspace.show_pane(workspace.naming.pane)
    workspace.naming.search._take(labelling, workspace.naming.search._now())
    qtbot.waitUntil(lambda: workspace.naming.pane.table.currentIndex().row() == 0)
    qtbot.waitUntil(workspace.naming.pane.isEnabled)
    found = workspace.naming.search.review
    assert found is not None
    return found


def right_share(workspace: Workspace, truth: Scrambled) -> float:
    """Return the share of the markers' samples that are in the points of their labels."""
    document = workspace.document
    origins = document.layers.origins
    if origins is None:
        origins = np.tile(np.arange(truth.truth.shape[1]), (len(truth.truth), 1))
    marker = np.take_along_axis(truth.truth, origins, axis=1)
    names = [without_subject(label) for label in document.labels]
    label = np.array([truth.labels.index(n) if n in truth.labels else -9 for n in names])
    real = (marker != NOTHING) & (marker != GHOST)
    return float((marker == label)[real].mean())


def test_recordings_are_chosen_and_remembered(
    workspace: Workspace,
    window: MainWindow,
    settings: Settings,
    walk: Path,
    qtbot: QtBot,
    monkeypatch: pytest.MonkeyPatch,
) -> None:
    monkeypatch.setattr(QFileDialog, "getOpenFileNames", lambda *_: ([str(walk)], ""))
    window.actions_by_id["label_from"].trigger()
    dialog = workspace.findChild(LabelDialog)
    assert dialog is not None
    assert not dialog.go.isEnabled(), "there is nothing to learn from yet"
    dialog.adding.click()
    dialog.adding.click()
    assert dialog.paths == [walk]
    dialog.keep.setChecked(False)
    with qtbot.waitSignal(workspace.naming.search.started):
        dialog.go.click()
    workspace.naming.search.job.cancel()
    qtbot.waitUntil(lambda: workspace.naming.search.job is None)
    assert settings.get(LABELLED_FILES) == [str(walk)]
    assert settings.get(KEEP_NAMES) is False
    window.actions_by_id["label_from"].trigger()
    (again,) = [each for each in workspace.findChildren(LabelDialog) if each.isVisible()]
    assert again.paths == [walk]
    again.list.selectAll()
    again.removing.click()
    assert not again.paths
    again.reject()


def test_what_cannot_be_learned_from_is_said(
    workspace: Workspace, walk: Path, tmp_path: Path, qtbot: QtBot
) -> None:
    with qtbot.waitSignal(workspace.failed) as heard:
        workspace.naming.look([tmp_path / "gone.c3d"], keep_names=True)
    assert "gone.c3d" in str(heard.args[0])
    qtbot.waitUntil(lambda: workspace.naming.search.job is None)
    assert workspace.naming.search.review is None


def test_proposals_are_reviewed_by_keyboard_and_applied_in_one_step(
    workspace: Workspace,
    window: MainWindow,
    scrambled: Scrambled,
    review: LabelReview,
    qtbot: QtBot,
) -> None:
    document, view, pane = workspace.document, workspace.view, workspace.naming.pane
    before = document.labels
    sure = [review.proposal(row).confidence for row in range(len(review))]
    assert sure == sorted(sure)
    assert document.labels == before
    assert not document.undo_stack.count(), "nothing changes before"

    # The views are where the marked piece is, and show what it would be called.
    piece = review.proposal(0).piece
    assert view.selection == (piece.point,)
    assert piece.start <= view.frame < piece.stop
    assert view.proposed[piece.point] == review.label(0)

    qtbot.keyClick(pane.table, Qt.Key.Key_Return)
    qtbot.keyClick(pane.table, Qt.Key.Key_Delete)
    assert review.decision(0) is Decision.ACCEPTED
    assert review.decision(1) is Decision.REJECTED
    assert pane.table.currentIndex().row() == 2
    assert view.selection == (review.proposal(2).piece.point,)
    assert not document.undo_stack.count(), "Enter and Delete are not those of the gaps"
    assert not review.used(1)
    pane.table.selectRow(1)
    qtbot.keyClick(pane.table, Qt.Key.Key_Return)

    window.actions_by_id["apply_labels"].trigger()
    assert document.undo_stack.count() == 1
    assert document.undo_stack.undoText() == f"label {review.counts()[0]} pieces"
    assert right_share(workspace, scrambled) > 0.99
    assert not view.proposed
    assert not pane.applying.isEnabled()
    assert "Applied" in pane.summary.text()

    document.undo_stack.undo()
    assert document.labels == before
    assert document.layers.origins is None or not document.doubts
    assert pane.applying.isEnabled(), "the proposals are there again"
    document.undo_stack.redo()
    assert right_share(workspace, scrambled) > 0.99


def choose(combo: QComboBox, value: object) -> None:
    """Choose what stands for a value in one of the queue's filters."""
    (row,) = [row for row in range(combo.count()) if combo.itemData(row) == value]
    combo.setCurrentIndex(row)


def test_unsure_labels_are_reviewed_in_the_queue(
    workspace: Workspace, window: MainWindow, review: LabelReview, qtbot: QtBot
) -> None:
    queue, view, document = workspace.queue, workspace.view, workspace.document
    workspace.naming.pane.least.setValue(100)
    every = [row for row in range(len(review)) if review.proposal(row).confidence < 1.0]
    choose(queue.kind, (UNSURE,))
    qtbot.waitUntil(lambda: queue.model.rowCount() == len(every))
    harm = [queue.model.problem(row).harm for row in range(len(every))]
    assert harm == sorted(harm, reverse=True)
    assert harm[0] > 0.0

    # The next one is where its piece is, in all views; the pane of labels marks it too.
    window.actions_by_id["next_gap"].trigger()
    run = view.suspect
    assert run is not None
    row = workspace.naming.pane.table.currentIndex().row()
    proposal = review.proposal(row)
    assert (run.marker, run.start, run.stop) == tuple(proposal.piece)
    assert run.score == proposal.confidence
    assert view.selection == (proposal.piece.point,)
    assert view.preview is None

    # Enter accepts it, Shift+D rejects the one after it; nothing changes in the recording.
    workspace.apply(go_on=True)
    assert review.decision(row) is Decision.ACCEPTED
    assert view.suspect is not None
    second = workspace.naming.pane.table.currentIndex().row()
    assert second != row
    window.actions_by_id["dismiss_problem"].trigger()
    assert review.decision(second) is Decision.REJECTED
    qtbot.waitUntil(lambda: queue.model.rowCount() == len(every) - 2)
    assert not document.undo_stack.count()
    choose(queue.status, frozenset({Status.DISMISSED}))
    qtbot.waitUntil(lambda: queue.model.rowCount() == 1)
    choose(queue.status, TO_DO)

    # Fixing a kind or all of them accepts none: that is for somebody to decide.
    window.actions_by_id["next_gap"].trigger()
    window.actions_by_id["fix_kind"].trigger()
    assert not document.undo_stack.count()
    assert [review.decision(k) for k in every].count(Decision.NONE) == len(every) - 2

    # They are listed as long as they are for the recording as it is.
    window.actions_by_id["apply_labels"].trigger()
    assert document.undo_stack.count() == 1
    qtbot.waitUntil(lambda: not queue.model.rowCount())
    assert view.suspect is None
    document.undo_stack.undo()
    qtbot.waitUntil(lambda: queue.model.rowCount() == len(every) - 2)


def test_when_all_unsure_labels_are_looked_at_it_is_said(
    workspace: Workspace, review: LabelReview, qtbot: QtBot
) -> None:
    workspace.naming.pane.least.setValue(100)
    queue = workspace.queue
    choose(queue.kind, (UNSURE,))
    told: list[str] = []
    workspace.message.connect(told.append)
    left = workspace.search.suspects.labels.left
    assert left
    assert queue.step(1)
    for _ in range(left):
        workspace.apply(go_on=True)
    assert not workspace.search.suspects.labels.left
    assert "apply them" in told[-1]
    assert not queue.step(1)


def test_a_row_of_the_pane_is_the_current_problem(
    workspace: Workspace, review: LabelReview, qtbot: QtBot
) -> None:
    workspace.naming.pane.least.setValue(100)
    unsure = workspace.search.suspects.labels
    row = next(row for row in range(1, len(review)) if unsure.run(row) is not None)
    workspace.naming.pane.table.selectRow(row)
    assert workspace.view.suspect == unsure.run(row)


def test_another_label_is_chosen(workspace: Workspace, review: LabelReview) -> None:
    pane = workspace.naming.pane
    free, taken = review.choices(0)
    assert pane.choice.count() == len(free) + len(taken) + 1
    other = next(label for label in taken if label != review.proposal(0).label)
    pane.choice.setCurrentIndex(pane.choice.findData(other))
    pane.choice.activated.emit(pane.choice.currentIndex())
    assert review.label(0) == review.labels[other]
    assert review.decision(0) is Decision.ACCEPTED
    model = pane.table.model()
    assert model.index(0, Column.LABEL).data().strip() == review.labels[other]
    pane.choice.activated.emit(pane.choice.count() - 1)
    assert review.label(0) is None


def test_the_least_confidence_says_how_many(workspace: Workspace, review: LabelReview) -> None:
    pane = workspace.naming.pane
    pane.least.setValue(0)
    all_of_them, every = review.counts()
    pane.least.setValue(100)
    assert review.counts()[0] < all_of_them
    assert f"{review.counts()[0]} of {every} pieces" in pane.summary.text()


def test_an_edit_meanwhile_is_told_and_labels_are_looked_for_again(
    workspace: Workspace, walk: Path, qtbot: QtBot
) -> None:
    workspace.naming.look([walk], keep_names=True)
    qtbot.waitUntil(lambda: workspace.naming.search.review is not None)
    pane, document = workspace.naming.pane, workspace.document
    assert pane.applying.isEnabled()
    workspace.naming.renaming.rename(0, "Something")
    assert not pane.applying.isEnabled()
    assert "edited since" in pane.summary.text()
    pane.apply()
    assert document.undo_stack.count() == 1
    first = workspace.naming.search.review
    pane.again.click()
    qtbot.waitUntil(lambda: workspace.naming.search.review is not first)
    assert pane.applying.isEnabled()


def test_proposed_names_are_seen_only_with_the_pane(
    workspace: Workspace, review: LabelReview, qtbot: QtBot
) -> None:
    assert workspace.view.proposed
    workspace.show_pane(workspace.timeline)
    qtbot.waitUntil(lambda: not workspace.view.proposed)
    workspace.show_pane(workspace.naming.pane)
    qtbot.waitUntil(lambda: bool(workspace.view.proposed))


def test_a_recording_may_be_closed_meanwhile(
    workspace: Workspace, window: MainWindow, walk: Path, qtbot: QtBot
) -> None:
    workspace.naming.look([walk], keep_names=True)
    job = workspace.naming.search.job
    assert job is not None
    with qtbot.waitSignal(job.ended):
        window.files.close()
    assert window.workspace is None


# --- by hand -----------------------------------------------------------------------------


def place_of_piece(truth: Scrambled, label: int) -> tuple[int, int]:
    """Return a point without a label and a frame in which it holds a marker."""
    nameless = [k for k, name in enumerate(truth.recording.labels) if name.startswith("*")]
    found = np.argwhere(truth.truth[:, nameless] == label)
    frame, at = found[0].tolist()
    return nameless[at], frame


def test_this_is_and_on_to_the_next(
    workspace: Workspace, window: MainWindow, scrambled: Scrambled, qtbot: QtBot
) -> None:
    document, view = workspace.document, workspace.view
    nameless = [k for k, name in enumerate(document.labels) if name.startswith("*")]
    missing = next(
        k for k, label in enumerate(scrambled.labels) if (scrambled.truth[:, nameless] == k).any()
    )
    point, frame = place_of_piece(scrambled, missing)
    name = scrambled.labels[missing]
    view.select((point,))
    view.set_frame(frame)
    window.actions_by_id["this_is"].trigger()
    (chooser,) = [each for each in workspace.findChildren(LabelChooser) if each.isVisible()]
    qtbot.keyClicks(chooser.field, name)
    qtbot.keyClick(chooser.field, Qt.Key.Key_Return)
    assert without_subject(document.labels[point]) == name
    assert view.marker != point, "the next point without a label"
    assert document.labels[view.marker or 0].startswith("*")
    document.undo_stack.undo()
    assert document.labels[point].startswith("*")


def test_labels_that_were_learned_can_be_chosen(
    workspace: Workspace, review: LabelReview, window: MainWindow
) -> None:
    unused = set(review.labels) - set(workspace.document.names)
    assert unused
    window.actions_by_id["this_is"].trigger()
    (chooser,) = [each for each in workspace.findChildren(LabelChooser) if each.isVisible()]
    assert unused < set(chooser.texts())
    chooser.reject()


def chooser_of(workspace: Workspace) -> LabelChooser:
    workspace.naming.ask_label()
    (chooser,) = [each for each in workspace.findChildren(LabelChooser) if each.isVisible()]
    return chooser


def test_a_new_label_is_offered_after_those_that_it_is_a_part_of(
    workspace: Workspace, scrambled: Scrambled, qtbot: QtBot
) -> None:
    document, view = workspace.document, workspace.view
    nameless = next(k for k, label in enumerate(document.labels) if label.startswith("*"))
    view.select((nameless,))
    view.set_frame(int(np.flatnonzero(document.base.present[:, nameless])[0]))
    chooser = chooser_of(workspace)
    part = next(name for name in document.names if not name.startswith("*"))[:2]
    qtbot.keyClicks(chooser.field, part)
    assert len(chooser.texts()) > 1
    assert chooser.texts()[-1] == part
    chooser.table.setCurrentCell(len(chooser.texts()) - 1, 0)
    qtbot.keyClick(chooser.field, Qt.Key.Key_Return)
    assert document.names[nameless] == part


def test_a_new_label_is_not_offered_where_it_would_be_refused(
    workspace: Workspace, qtbot: QtBot
) -> None:
    document, view = workspace.document, workspace.view
    labelled = next(k for k, label in enumerate(document.labels) if not label.startswith("*"))
    view.select((labelled,))
    view.set_frame(int(np.flatnonzero(document.base.present[:, labelled])[0]))
    chooser = chooser_of(workspace)
    qtbot.keyClicks(chooser.field, "Nobody")
    assert chooser.texts() == []
    assert "F2" in chooser.hint.text()
    qtbot.keyClick(chooser.field, Qt.Key.Key_Return)
    assert chooser.isVisible()
    assert not document.undo_stack.count()
    chooser.reject()


def test_the_proposals_have_the_keyboard_when_they_come(
    workspace: Workspace, window: MainWindow, labelling: Labelling, qtbot: QtBot
) -> None:
    pane = workspace.naming.pane
    workspace.show_pane(pane)
    qtbot.waitUntil(lambda: pane.isAncestorOf(window.focusWidget()))
    workspace.naming.search._take(labelling, workspace.naming.search._now())
    assert window.focusWidget() is pane.table


def test_a_stretch_goes_to_the_point_of_its_label(
    workspace: Workspace, scrambled: Scrambled
) -> None:
    document, view = workspace.document, workspace.view
    home = next(k for k, name in enumerate(document.names) if not name.startswith("*"))
    nameless = [k for k, name in enumerate(document.labels) if name.startswith("*")]
    frame = 100
    point = next(k for k in nameless if document.base.present[frame, k])
    before = document.base.points[:, [point, home]].copy()
    view.select((point,))
    view.set_frame(frame)
    view.set_span((frame, frame + 5))
    workspace.naming.by_hand.this_is(document.names[home])
    after = document.base.points[:, [point, home]]
    inside = slice(frame, frame + 5)
    assert np.array_equal(after[inside], before[inside, ::-1], equal_nan=True)
    assert np.array_equal(after[:frame], before[:frame], equal_nan=True)
    assert np.array_equal(after[frame + 5 :], before[frame + 5 :], equal_nan=True)
    document.undo_stack.undo()
    assert np.array_equal(document.base.points[:, [point, home]], before, equal_nan=True)


def test_what_cannot_be_labelled_by_hand_is_said(workspace: Workspace, qtbot: QtBot) -> None:
    document, view = workspace.document, workspace.view
    home = next(k for k, name in enumerate(document.names) if not name.startswith("*"))
    view.select(())
    with qtbot.waitSignal(workspace.message):
        workspace.naming.ask_label()
    view.select((home,))
    view.set_frame(int(np.flatnonzero(document.base.present[:, home])[0]))
    for wrong in (document.names[home], "Nobody", " "):
        with qtbot.waitSignal(workspace.message):
            workspace.naming.by_hand.this_is(wrong)
    assert not document.undo_stack.count()


def test_the_next_point_without_a_label_is_gone_to(
    workspace: Workspace, window: MainWindow
) -> None:
    document, view = workspace.document, workspace.view
    view.select(())
    window.actions_by_id["next_nameless"].trigger()
    first = view.marker
    assert first is not None
    assert document.base.present[view.frame, first]
    window.actions_by_id["next_nameless"].trigger()
    assert view.marker != first


def test_an_applied_labelling_is_exported(
    workspace: Workspace, window: MainWindow, review: LabelReview, tmp_path: Path, qtbot: QtBot
) -> None:
    workspace.naming.pane.apply()
    out = tmp_path / "labelled.c3d"
    window.files.export(out)
    qtbot.waitUntil(lambda: workspace.saved)
    again = read_c3d(out)
    assert again.recording.labels == workspace.document.labels
    assert np.allclose(
        again.measured.points, workspace.document.base.points, atol=1e-3, equal_nan=True
    )
