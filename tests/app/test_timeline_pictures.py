"""What lanes and overview are painted from: exact for every column, told apart without colour."""

from itertools import combinations

import numpy as np
import pytest
from hypothesis import given
from hypothesis import strategies as st
from PySide6.QtCore import QPoint, Qt
from pytestqt.qtbot import QtBot

from mocapmend.commands import EditSamples
from mocapmend.document import Document
from mocapmend.edits import Edit
from mocapmend.state import SampleState
from mocapmend.theme import DARK
from mocapmend.views.columns import column_edges, columns_with
from mocapmend.views.lane_picture import PERIOD, LanePicture, shape_of
from mocapmend.views.overview import Overview
from mocapmend.views.run_index import RunIndex, missing_share
from mocapmend.viewstate import ViewState
from mocapmend_algorithms.gaps import runs as find_runs

LEFT = Qt.MouseButton.LeftButton


def runs_of(mask: np.ndarray) -> list[np.ndarray]:
    """Return the runs of each marker of a mask, shape (frames, markers)."""
    return [np.array(find_runs(column), np.int64).reshape(-1, 2) for column in mask.T]


@given(
    frames=st.integers(1, 300),
    markers=st.integers(1, 6),
    width=st.integers(1, 200),
    seed=st.integers(0, 99),
    data=st.data(),
)
def test_the_cells_of_all_lanes_are_those_of_each(
    frames: int, markers: int, width: int, seed: int, data: st.DataObject
) -> None:
    rng = np.random.default_rng(seed)
    runs = runs_of(rng.random((frames, markers)) < rng.random())
    start = data.draw(st.floats(0, frames - 1))
    edges = column_edges(start, data.draw(st.floats(start + 0.5, frames)), width)
    shown = rng.permutation(markers)[: rng.integers(1, markers + 1)]
    row_of = np.full(markers, -1)
    row_of[shown] = np.arange(len(shown))
    picture = np.zeros((len(shown), width), bool)
    picture.reshape(-1)[RunIndex(runs).cells(row_of, edges)] = True
    expected = [columns_with(runs[marker], edges) for marker in shown]
    assert (picture == np.array(expected)).all()


@given(
    frames=st.integers(1, 300),
    markers=st.integers(1, 5),
    width=st.integers(1, 200),
    seed=st.integers(0, 99),
)
def test_the_share_of_missing_samples_is_that_of_the_frames(
    frames: int, markers: int, width: int, seed: int
) -> None:
    rng = np.random.default_rng(seed)
    missing = rng.random((frames, markers)) < rng.random()
    missing[:, 0] = False
    seen = ~missing.all(axis=0)
    edges = np.linspace(0.0, frames, width + 1)
    sums = np.concatenate(([0.0], np.cumsum(missing[:, seen].mean(axis=1))))
    expected = np.diff(np.interp(edges, np.arange(frames + 1), sums)) / np.diff(edges)
    assert missing_share(runs_of(missing), frames, edges) == pytest.approx(expected, abs=1e-9)


def test_nothing_is_missing_where_no_marker_is_ever_seen() -> None:
    assert missing_share([np.array([[0, 50]])], 50, np.linspace(0, 50, 9)).tolist() == [0.0] * 8


@pytest.mark.parametrize("height", [4, 5, 9, 15])
def test_states_differ_in_shape_and_lose_no_column(height: int) -> None:
    shapes = [shape_of(state, height) for state in SampleState]
    for one, other in combinations(shapes, 2):
        assert (one != other).any()
    for shape in shapes:
        assert shape.shape == (height, PERIOD)
        assert shape.any(axis=0).all()


def test_the_colours_of_lanes_of_any_height_fit_into_an_indexed_picture(document: Document) -> None:
    lanes = LanePicture(document, DARK)
    for height in range(5, 60):
        table = lanes._colours(height)
        assert len(np.unique(table, axis=0)) * table.shape[1] <= 256


def test_lanes_are_painted_anew_only_when_something_in_them_changes(document: Document) -> None:
    lanes = LanePicture(document, DARK)
    markers = np.arange(document.original.markers)
    first = lanes.image(markers, (0.0, 293.0), 300, 5).copy()
    kept = lanes._image
    assert lanes.image(markers, (0.0, 293.0), 300, 5) is kept
    assert lanes.image(markers[::-1], (0.0, 293.0), 300, 5) != first
    gap = max(document.gaps, key=lambda g: g.kind(293) == "interior" and g.length)
    points = np.zeros((gap.length, 3))
    edit = Edit(gap, points, np.full(gap.length, SampleState.MEASURED, np.uint8))
    document.undo_stack.push(EditSamples(document, [edit], "edit"))
    lanes.forget()
    assert lanes.image(markers, (0.0, 293.0), 300, 5) != first
    document.undo_stack.undo()
    lanes.forget()
    assert lanes.image(markers, (0.0, 293.0), 300, 5) == first


@pytest.fixture
def view(document: Document) -> ViewState:
    return ViewState(document.original.frames)


@pytest.fixture
def overview(document: Document, view: ViewState, qtbot: QtBot) -> Overview:
    made = Overview(document, view, DARK)
    qtbot.addWidget(made)
    made.set_gutter(60)
    made.resize(660, 20)
    made.show()
    qtbot.waitExposed(made)
    return made


def drag(qtbot: QtBot, overview: Overview, start: float, stop: float) -> None:
    """Drag on the overview from one frame to another."""
    places = [QPoint(round(overview.x_of(frame)), 10) for frame in (start, stop)]
    qtbot.mousePress(overview, LEFT, pos=places[0])
    qtbot.mouseMove(overview, places[1])
    qtbot.mouseRelease(overview, LEFT, pos=places[1])


def test_the_window_is_moved_and_its_ends_are_pulled(
    overview: Overview, view: ViewState, qtbot: QtBot
) -> None:
    view.set_visible(100, 160)
    drag(qtbot, overview, 130, 180)
    assert view.visible == pytest.approx((150, 210), abs=1)
    drag(qtbot, overview, view.visible[0], 120)
    assert view.visible == pytest.approx((120, 210), abs=1)
    drag(qtbot, overview, view.visible[1], 140)
    assert view.visible == pytest.approx((120, 140), abs=1)
    drag(qtbot, overview, view.visible[1], 50)
    assert view.visible == pytest.approx((120, 130), abs=1)


def test_a_click_goes_there(overview: Overview, view: ViewState, qtbot: QtBot) -> None:
    view.set_visible(0, 40)
    qtbot.mouseClick(overview, LEFT, pos=QPoint(round(overview.x_of(200)), 10))
    assert view.visible == pytest.approx((180, 220), abs=1)
    assert view.frame == pytest.approx(200, abs=1)


def test_the_ends_of_the_recording_hold_the_window(
    overview: Overview, view: ViewState, qtbot: QtBot
) -> None:
    view.set_visible(200, 240)
    drag(qtbot, overview, 220, 600)
    assert view.visible == (253.0, 293.0)


def test_the_heat_follows_the_samples(overview: Overview, document: Document) -> None:
    before = overview.heat()
    gap = max(document.gaps, key=lambda g: g.kind(293) == "interior" and g.length)
    column = int(overview.x_of((gap.start + gap.stop) / 2)) - 60
    points = np.zeros((gap.length, 3))
    edit = Edit(gap, points, np.full(gap.length, SampleState.FILLED, np.uint8))
    document.undo_stack.push(EditSamples(document, [edit], "edit"))
    assert overview.heat()[column] < before[column]
    document.undo_stack.undo()
    assert (overview.heat() == before).all()
