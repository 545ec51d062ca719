"""Bad samples are seen: on the timeline, in the plots and in 3D; set aside they stay in sight."""

from collections.abc import Iterator
from pathlib import Path

import numpy as np
import pytest
from PySide6.QtCore import QPoint, QPointF, Qt
from PySide6.QtGui import QColor, QImage
from PySide6.QtWidgets import QWidget
from pytestqt.qtbot import QtBot
from spoilt import LEAP, OTHER, SPIKE, SWAP

from mocapmend.commands import EditSamples
from mocapmend.correcting import step
from mocapmend.document import Document
from mocapmend.doubts import BY_HAND, Doubt
from mocapmend.engine import load
from mocapmend.state import SampleState
from mocapmend.suspects import by_marker
from mocapmend.theme import THEMES, Theme
from mocapmend.views.lane_picture import PERIOD, SUSPECT, shape_of
from mocapmend.views.painters.trails import DOTTED, SOLID, trails_around
from mocapmend.views.scene import Scene
from mocapmend.views.timeline import Timeline
from mocapmend.views.trajectories import Trajectories
from mocapmend.viewstate import ViewState
from mocapmend_algorithms import no_progress
from mocapmend_algorithms.problems import BadRun

LEFT = Qt.MouseButton.LeftButton
SPIKE_RUN = BadRun("spikes", *SPIKE, score=0.9, deviation=LEAP, reason="It leaps.")
SWAP_RUN = BadRun("swaps", *SWAP, score=0.9, deviation=600.0, reason="They swap.", other=OTHER)


@pytest.fixture
def walk(spoilt_walk: Path, qtbot: QtBot) -> Document:
    """Return the spoilt walk as a document."""
    return Document(*load(spoilt_walk, no_progress))


@pytest.fixture
def view(walk: Document) -> ViewState:
    return ViewState(walk.original.frames)


@pytest.fixture(params=THEMES.values(), ids=THEMES)
def theme(request: pytest.FixtureRequest) -> Iterator[Theme]:
    yield request.param


def shown(widget: QWidget, qtbot: QtBot, width: int = 900, height: int = 500) -> None:
    qtbot.addWidget(widget)
    widget.resize(width, height)
    widget.show()
    qtbot.waitExposed(widget)


def set_aside(document: Document) -> None:
    made = step(document, set_aside={SPIKE: Doubt(BY_HAND, "It leaps.")})
    document.undo_stack.push(EditSamples(document, made.edits, "set aside", made.correction))


def inked(image: QImage, colour: str, off: int = 0) -> np.ndarray:
    """Say which pixels have a colour, shape (height, width), but for smooth edges."""
    image = image.convertToFormat(QImage.Format.Format_RGB32)
    width, height = image.width(), image.height()
    pixels = np.frombuffer(image.constBits(), np.uint8).reshape(height, -1, 4)[:, :width, :3]
    wanted = QColor(colour)
    exact = np.array([wanted.blue(), wanted.green(), wanted.red()])
    return np.asarray((np.abs(pixels.astype(int) - exact) <= off).all(axis=2))


def bad(theme: Theme) -> str:
    return theme.state_colour(SampleState.BAD)


class TestTimeline:
    def test_lanes_and_overview_are_marked_where_samples_are_held_for_bad(
        self, walk: Document, view: ViewState, theme: Theme, qtbot: QtBot
    ) -> None:
        timeline = Timeline(walk, view, theme)
        shown(timeline, qtbot)
        assert not inked(timeline.grab().toImage(), bad(theme)).any()
        timeline.set_suspects([SPIKE_RUN, SWAP_RUN])
        ink = inked(timeline.viewport().grab().toImage(), bad(theme))
        for run, marker in ((SPIKE_RUN, SPIKE.marker), (SWAP_RUN, SWAP.marker), (SWAP_RUN, OTHER)):
            top = timeline.lane_top(marker)
            lane = ink[top : top + timeline._layout.lane_height].any(axis=0)
            left, right = (round(timeline.axis.x_of(frame)) for frame in (run.start, run.stop))
            assert lane[left + 1 : right].all()
        strip = inked(timeline.overview.grab().toImage(), bad(theme))[1]
        for run in (SPIKE_RUN, SWAP_RUN):
            # What is out of the window on the visible frames is dimmed: here all is in view.
            assert strip[round(timeline.overview.x_of((run.start + run.stop) / 2))]

    @pytest.mark.parametrize("height", [4, 5, 9, 15])
    def test_their_shape_is_another_than_that_of_any_state(self, height: int) -> None:
        shape = shape_of(SUSPECT, height)
        assert shape.shape == (height, PERIOD)
        assert shape.any(axis=0).all()
        assert all((shape != shape_of(state, height)).any() for state in SampleState)

    def test_a_click_takes_them_and_a_double_click_goes_there(
        self, walk: Document, view: ViewState, qtbot: QtBot
    ) -> None:
        timeline = Timeline(walk, view, THEMES["dark"])
        shown(timeline, qtbot)
        timeline.set_suspects([SPIKE_RUN, SWAP_RUN])
        middle = timeline.axis.x_of((SWAP.start + SWAP.stop) / 2)
        place = QPoint(round(middle), timeline.lane_top(OTHER) + 2)
        assert timeline.suspect_at(QPointF(place)) == SWAP_RUN
        assert "They swap." in timeline.tip_at(QPointF(place))
        place = QPoint(round(middle), timeline.lane_top(SWAP.marker) + 2)
        qtbot.mousePress(timeline.viewport(), LEFT, pos=place)
        assert view.suspect == SWAP_RUN
        assert view.gap is None
        assert "Swapped labels" in timeline.tip_at(QPointF(place))
        timeline._describe()
        assert "Current problem" in timeline.accessibleDescription()
        place = QPoint(
            round(timeline.axis.x_of(SPIKE.start + 1)), timeline.lane_top(SPIKE.marker) + 2
        )
        qtbot.mouseDClick(timeline.viewport(), LEFT, pos=place)
        assert view.suspect == SPIKE_RUN
        assert view.selection == (SPIKE.marker,)
        assert view.visible[1] - view.visible[0] < 60

    def test_what_is_set_aside_counts_as_missing(
        self, walk: Document, view: ViewState, qtbot: QtBot
    ) -> None:
        timeline = Timeline(walk, view, THEMES["dark"])
        shown(timeline, qtbot)
        before = timeline.overview.heat().sum()
        view.set_frame(SPIKE.start)
        timeline._describe()
        assert "0 of 41" in timeline.accessibleDescription()
        set_aside(walk)
        assert timeline.overview.heat().sum() > before
        timeline._describe()
        assert "1 of 41" in timeline.accessibleDescription()


class TestPlots:
    def plots(self, walk: Document, view: ViewState, theme: Theme, qtbot: QtBot) -> Trajectories:
        made = Trajectories(walk, view, theme)
        shown(made, qtbot)
        view.set_visible(80, 120)
        view.select((SPIKE.marker,))
        return made

    def test_their_points_have_the_colour_of_bad_samples(
        self, walk: Document, view: ViewState, theme: Theme, qtbot: QtBot
    ) -> None:
        plots = self.plots(walk, view, theme, qtbot)
        assert not inked(plots.grab().toImage(), bad(theme)).any()
        plots.set_suspects([SPIKE_RUN])
        ink = inked(plots.grab().toImage(), bad(theme))
        frame = plots._frames[0]
        x = round(float(frame.x(SPIKE.start)))
        y = round(float(frame.y(walk.points[SPIKE.start, SPIKE.marker, 0])))
        assert ink[y - 2 : y + 3, x - 2 : x + 3].any()
        assert not ink[:, : x - 6].any()

    def test_set_aside_they_are_crosses_that_do_not_stretch_the_axis(
        self, walk: Document, view: ViewState, theme: Theme, qtbot: QtBot
    ) -> None:
        plots = self.plots(walk, view, theme, qtbot)
        plots.grab()
        wide = [frame.high - frame.low for frame in plots._frames]
        set_aside(walk)
        plots.grab()
        narrow = [frame.high - frame.low for frame in plots._frames]
        assert min(narrow) < 0.8 * min(wide)
        view.set_suspect(SPIKE_RUN)
        ink = inked(plots.grab().toImage(), bad(theme))
        assert [frame.high - frame.low for frame in plots._frames] == pytest.approx(wide, rel=0.2)
        frame = plots._frames[1]
        x, y = float(frame.x(SPIKE.start)), float(frame.y(walk.stored(SPIKE)[0, 1]))
        assert ink[round(y) - 3 : round(y) + 4, round(x) - 3 : round(x) + 4].any()

    def test_a_swap_is_drawn_as_it_would_be(
        self, walk: Document, view: ViewState, qtbot: QtBot
    ) -> None:
        theme = THEMES["dark"]
        plots = Trajectories(walk, view, theme)
        shown(plots, qtbot)
        plots.set_suspects([SWAP_RUN])
        view.go_to_suspect(SWAP_RUN)
        frame_of = view.selection
        assert frame_of == (OTHER, SWAP.marker)
        view.set_suspect(None)
        without = plots.grab().toImage()
        view.set_suspect(SWAP_RUN)
        image = plots.grab().toImage()
        # The first marker's colour where the second one is measured, and the other way round.
        frame, middle = plots._frames[1], (SWAP.start + SWAP.stop) // 2
        for order, other in ((0, SWAP.marker), (1, OTHER)):
            colour = theme.curves[order]
            rows = slice(middle - 8, middle + 8)
            x = np.round(frame.x(np.arange(rows.start, rows.stop))).astype(int)
            y = np.round(frame.y(walk.points[rows, other, 1])).astype(int)
            assert not inked(without, colour)[y, x].any()
            drawn = inked(image, colour)[y, x]
            assert drawn.any()
            assert not drawn.all(), "dashed"


class TestScene:
    def test_markers_that_are_held_for_bad_and_those_set_aside_are_red(
        self, walk: Document, view: ViewState, theme: Theme, qtbot: QtBot
    ) -> None:
        scene = Scene(walk, view, theme)
        shown(scene, qtbot)
        view.set_frame(SPIKE.start)
        assert not inked(scene.grab().toImage(), bad(theme)).any()
        scene.set_suspects([SPIKE_RUN])
        assert inked(scene.grab().toImage(), bad(theme)).any()
        view.set_frame(SPIKE.stop)
        assert not inked(scene.grab().toImage(), bad(theme)).any()
        scene.set_suspects([])
        set_aside(walk)
        view.set_frame(SPIKE.start)
        assert inked(scene.grab().toImage(), bad(theme)).any(), "a cross where it was measured"

    def test_a_swap_is_drawn_as_it_would_be(
        self, walk: Document, view: ViewState, theme: Theme, qtbot: QtBot
    ) -> None:
        scene = Scene(walk, view, theme)
        shown(scene, qtbot)
        scene.set_suspects([SWAP_RUN])
        view.select((OTHER, SWAP.marker))
        view.set_frame((SWAP.start + SWAP.stop) // 2)
        before = inked(scene.grab().toImage(), theme.preview, 40).sum()
        view.set_suspect(SWAP_RUN)
        assert inked(scene.grab().toImage(), theme.preview, 40).sum() > before + 10

    def test_trails_go_dotted_through_what_is_set_aside(self, walk: Document) -> None:
        markers = np.array([SPIKE.marker])
        frame = SPIKE.start
        before = trails_around(walk, frame, 5, markers)
        assert set(before.styles.ravel().tolist()) == {SOLID}
        set_aside(walk)
        after = trails_around(walk, frame, 5, markers)
        np.testing.assert_array_equal(after.points, before.points)
        dotted = np.flatnonzero(after.styles[:, 0] == DOTTED)
        assert dotted.tolist() == [4, 5, 6]


def test_what_is_to_be_exchanged_is_wrong_in_both_markers() -> None:
    near = BadRun("reflections", 4, 1, 3, score=0.5, deviation=1.0, reason="", other=7)
    assert by_marker([SPIKE_RUN, SWAP_RUN, near]) == {
        SPIKE.marker: [SPIKE_RUN],
        SWAP.marker: [SWAP_RUN],
        OTHER: [SWAP_RUN],
        4: [near],
    }
