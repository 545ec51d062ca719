"""The plots of trajectories: what is chosen, what the mouse reads, what the fonts need."""

from collections.abc import Callable
from pathlib import Path

import pytest
from PySide6.QtCore import QCoreApplication, QEvent, QPoint, Qt
from PySide6.QtGui import QColor, QImage
from PySide6.QtTest import QTest
from PySide6.QtWidgets import QComboBox
from pytestqt.qtbot import QtBot
from text_samples import TRC

from mocapmend.commands import EditSamples
from mocapmend.document import Document, Edit
from mocapmend.engine import load
from mocapmend.settings import PLOTS, SAME_SCALE, Settings
from mocapmend.theme import DARK
from mocapmend.views import quantities
from mocapmend.views.lane_painter import Lane, LanePainter
from mocapmend.views.main_window import MainWindow
from mocapmend.views.quantities import Curve, Quantity
from mocapmend.views.readout import Readout, Row
from mocapmend.views.trajectories import POSITION, Trajectories
from mocapmend.viewstate import ViewState
from mocapmend_algorithms import Gap, no_progress

Open = Callable[[Path], MainWindow]


@pytest.fixture
def view(document: Document) -> ViewState:
    return ViewState(document.original.frames)


@pytest.fixture
def plots(document: Document, view: ViewState, qtbot: QtBot) -> Trajectories:
    made = Trajectories(document, view, DARK)
    qtbot.addWidget(made)
    made.resize(800, 500)
    made.show()
    qtbot.waitExposed(made)
    view.select((3, 8))
    return made


def image(plots: Trajectories) -> QImage:
    return plots.grab().toImage()


def test_every_choice_of_quantities_has_its_plots(plots: Trajectories) -> None:
    plots.set_quantities((*POSITION, Quantity.ACCELERATION, Quantity.BONE))
    plots.set_bone((3, 8))
    kinds = [(lane.quantity, len(lane.curves)) for lane in plots.lanes()]
    assert kinds == [*((axis, 2) for axis in POSITION), (Quantity.ACCELERATION, 2),
                     (Quantity.BONE, 1)]  # fmt: skip
    plots.set_separate(on=True)
    plots.resize(800, 1200)
    owners = [lane.curves[0].markers for lane in plots.lanes()]
    assert owners == [(3,)] * 4 + [(8,)] * 4 + [(3, 8)]
    image(plots)
    assert plots._left_out == 0
    plots.resize(800, 350)
    image(plots)
    assert plots._left_out == 4
    assert plots.lanes()[0].curves[0].marker == 8


def test_without_any_plot_it_is_said_how_to_get_some(plots: Trajectories) -> None:
    plots.set_quantities(())
    image(plots)
    assert plots.lanes() == []
    assert "V" in plots._hint()
    plots._view.select(())
    assert "marker" in plots._hint()


def test_the_crosshair_reads_the_frame_under_the_mouse_and_leaves_no_trace(
    plots: Trajectories, view: ViewState, document: Document
) -> None:
    before, picture = image(plots), plots._picture
    x = round(float(plots._frames[1].x(100)))
    place = QPoint(x, round(plots._frames[1].rect.center().y()))
    QTest.mouseMove(plots, place + QPoint(1, 1))
    QTest.mouseMove(plots, place)
    assert image(plots) != before
    assert plots._picture is picture
    readout = plots._readout(plots._axis.frame_at(x), 1)
    assert readout.columns == ("X", "Y", "Z")
    assert str(100 + document.original.first_frame) in readout.title
    assert [row.name for row in readout.rows] == [document.names[8], document.names[3]]
    assert readout.rows[0].values == tuple(f"{v:.1f}" for v in document.points[100, 8])
    QTest.mousePress(plots, Qt.MouseButton.LeftButton, pos=place)
    assert plots._mouse is None
    QTest.mouseRelease(plots, Qt.MouseButton.LeftButton, pos=place)
    view.set_frame(0)
    plots.leaveEvent(QEvent(QEvent.Type.Leave))
    assert image(plots) == before


def test_the_readout_is_about_the_plot_under_the_mouse(plots: Trajectories) -> None:
    plots.set_quantities((Quantity.X, Quantity.SPEED, Quantity.RESIDUAL, Quantity.BONE))
    plots.set_bone((3, 8))
    image(plots)
    columns = [plots._readout(50.0, row).columns for row in range(4)]
    assert len({*columns}) == 4
    bone = plots._readout(50.0, 3)
    (row,) = bone.rows
    assert row.name.count("–") == 1
    assert float(row.values[0]) > 0


@pytest.mark.parametrize(("count", "names"), [(5, "abcd"), (4, "abcd"), (3, "ab+2"), (1, "+4")])
def test_rows_that_do_not_fit_are_counted(count: int, names: str) -> None:
    rows = tuple(Row(name, "", ("1",)) for name in "abcd")
    fitted = Readout("", ("X",), rows).fitting(count)
    assert "".join(row.name for row in fitted.rows) == names


def test_a_selected_span_is_shaded_and_forgotten(plots: Trajectories) -> None:
    before = image(plots)
    plots.set_span((50, 90))
    shaded = image(plots)
    frame = plots._frames[0]
    y = round(frame.rect.top() + 3)
    for where, differs in ((70, True), (20, False), (120, False)):
        x = round(float(frame.x(where)))
        assert (shaded.pixel(x, y) != before.pixel(x, y)) == differs
    plots.set_span(None)
    assert image(plots) == before


def test_the_same_scale_makes_a_unit_equally_high(plots: Trajectories, view: ViewState) -> None:
    view.select((3,))
    image(plots)
    assert len({round(frame.high - frame.low, 6) for frame in plots._frames}) == 3
    own = [(frame.low + frame.high) / 2 for frame in plots._frames]
    plots.set_quantities((*POSITION, Quantity.SPEED))
    plots.set_same_scale(on=True)
    image(plots)
    heights = [frame.high - frame.low for frame in plots._frames]
    assert heights[:3] == pytest.approx([max(heights[:3])] * 3)
    assert heights[3] != pytest.approx(heights[0])
    middles = [(frame.low + frame.high) / 2 for frame in plots._frames]
    assert middles[:3] == pytest.approx(own)


def test_a_larger_font_has_more_room(plots: Trajectories) -> None:
    image(plots)
    before = plots._frames[0].rect
    font = plots.font()
    font.setPointSizeF(2 * font.pointSizeF())
    plots.setFont(font)
    image(plots)
    after = plots._frames[0].rect
    metrics = plots.fontMetrics()
    assert after.left() > before.left() + metrics.horizontalAdvance("00")
    assert after.top() >= metrics.height()
    assert plots.height() - plots._frames[-1].rect.bottom() >= metrics.height()
    # The time axis has moved too: what is clicked is what is under the mouse.
    assert plots._axis.frame_at(float(plots._frames[0].x(40))) == pytest.approx(40.5)


@pytest.fixture
def slow(document: Document, monkeypatch: pytest.MonkeyPatch) -> None:
    """Let no more than three curves be computed at a time, as those of a long recording."""
    monkeypatch.setattr(quantities, "PORTION", 3 * document.original.frames)


def fresh(document: Document, plots: Trajectories, qtbot: QtBot) -> QImage:
    """Return how plots look in which everything is computed already."""
    other = Trajectories(document, plots._view, DARK)
    qtbot.addWidget(other)
    other.resize(plots.size())
    other.show()
    qtbot.waitUntil(lambda: not other._stale)
    return image(other)


@pytest.mark.usefixtures("slow")
def test_the_plots_of_many_markers_come_all_at_once(
    plots: Trajectories, view: ViewState, document: Document, qtbot: QtBot
) -> None:
    before, seen = image(plots), []
    view.select(tuple(range(document.original.markers)))
    while plots._stale:
        picture = image(plots)
        if plots._stale:
            seen.append(picture)
        QCoreApplication.processEvents()
    assert len(seen) > 3
    assert all(picture == before for picture in seen)
    assert image(plots) == fresh(document, plots, qtbot) != before


@pytest.mark.usefixtures("slow")
def test_what_is_laid_over_the_plots_is_about_what_they_show(
    plots: Trajectories, view: ViewState, document: Document, qtbot: QtBot
) -> None:
    image(plots)
    view.select(tuple(range(20)))
    plots.set_quantities((Quantity.SPEED,))
    QTest.mouseMove(plots, plots.rect().center())
    image(plots)
    assert plots._stale
    readout = plots._readout(100.0, 1)
    assert readout.columns == ("X", "Y", "Z")
    assert [row.name for row in readout.rows] == [document.names[8], document.names[3]]
    assert len(plots._painter.series._envelopes) < 20
    qtbot.waitUntil(lambda: not plots._stale)
    assert len(plots._readout(100.0, 0).rows) == 20


@pytest.mark.usefixtures("slow")
def test_what_changes_while_many_curves_are_computed_is_seen(
    plots: Trajectories, view: ViewState, document: Document, qtbot: QtBot
) -> None:
    image(plots)
    view.select(tuple(range(20)))
    image(plots)
    assert plots._stale
    plots.resize(900, 700)
    corner = image(plots).pixelColor(895, 695)
    assert plots._stale
    assert corner == QColor(DARK.window)
    gap = document.gaps[0]
    view.select((gap.marker, *view.selection))
    push = document.undo_stack.push
    push(EditSamples(document, [Edit.clear(Gap(3, 40, 90))], "clear"))
    qtbot.waitUntil(lambda: not plots._stale)
    assert image(plots) == fresh(document, plots, qtbot)
    view.select((3,))
    assert image(plots) == fresh(document, plots, qtbot)


def test_an_empty_plot_says_why(tmp_path: Path, qtbot: QtBot) -> None:
    path = tmp_path / "walk.trc"
    path.write_text(TRC)
    document = Document(*load(path, no_progress))
    painter = LanePainter(document, DARK)
    curve = Curve(0, "#ffffff")
    assert "no residuals" in painter._message(Lane(Quantity.RESIDUAL, (curve,)))
    assert "two markers" in painter._message(Lane(Quantity.BONE, ()))
    assert painter._message(Lane(Quantity.X, (curve,))) == ""


def test_choices_are_remembered(
    open_in: Open, gait: Path, sprint: Path, settings: Settings
) -> None:
    window = open_in(gait)
    actions = window.actions_by_id
    assert actions["plot_position"].isChecked()
    actions["plot_speed"].trigger()
    actions["same_scale"].trigger()
    assert settings.get(PLOTS) == ["plot_position", "plot_speed"]
    assert settings.get(SAME_SCALE)
    for action in ("plot_speed", "same_scale"):
        actions[action].blockSignals(True)
        actions[action].setChecked(False)
        actions[action].blockSignals(False)
    window = open_in(sprint)
    assert window.workspace is not None
    lanes = window.workspace.trajectories.lanes()
    assert [lane.quantity for lane in lanes] == [*POSITION, Quantity.SPEED]
    assert actions["plot_speed"].isChecked()
    assert actions["same_scale"].isChecked()


def test_a_key_goes_through_the_sets_of_plots(open_in: Open, gait: Path, qtbot: QtBot) -> None:
    window = open_in(gait)
    assert window.workspace is not None

    def shown() -> list[Quantity]:
        assert window.workspace is not None
        return [lane.quantity for lane in window.workspace.trajectories.lanes()]

    steps = []
    for _ in range(4):
        qtbot.keyClick(window.workspace, Qt.Key.Key_V)
        steps.append(shown())
    motion = [Quantity.SPEED, Quantity.ACCELERATION]
    assert steps == [motion, [Quantity.RESIDUAL], [Quantity.BONE], list(POSITION)]
    qtbot.keyClick(window.workspace, Qt.Key.Key_V, Qt.KeyboardModifier.ShiftModifier)
    assert shown() == [Quantity.BONE]
    window.actions_by_id["plot_speed"].trigger()
    qtbot.keyClick(window.workspace, Qt.Key.Key_V)
    assert shown() == list(POSITION)


def test_the_bone_is_one_of_the_marker_or_the_last_two_selected(
    open_in: Open, gait: Path, qtbot: QtBot
) -> None:
    window = open_in(gait)
    workspace = window.workspace
    assert workspace is not None
    qtbot.waitUntil(lambda: bool(workspace.document.skeleton.bones), timeout=20_000)
    marker = workspace.document.skeleton.bones[0][0]
    workspace.view.select((marker,))
    qtbot.keyClick(workspace, Qt.Key.Key_B)
    bones = workspace.plots.findChild(QComboBox)
    assert bones is not None
    touching = [bone for bone in workspace.document.skeleton.bones if marker in bone]
    assert bones.count() == len(touching)
    (lane,) = [lane for lane in workspace.trajectories.lanes() if lane.quantity is Quantity.BONE]
    assert lane.curves[0].markers == touching[bones.currentIndex()]
    others = [other for other in range(56) if other != marker][-2:]
    workspace.view.select((marker, *others))
    assert workspace.trajectories.lanes()[-1].curves[0].markers == tuple(others)
    workspace.view.select(())
    assert bones.count() == 0
    assert workspace.trajectories.lanes() == []
