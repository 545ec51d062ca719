"""What is painted: states in the timeline, gaps and fills in the plots, previews as ghosts."""

from collections import Counter

import numpy as np
import pytest
from PySide6.QtGui import QColor, QImage
from PySide6.QtWidgets import QWidget
from pytestqt.qtbot import QtBot

from mocapmend.commands import EditSamples
from mocapmend.document import Document
from mocapmend.edits import Edit
from mocapmend.state import SampleState
from mocapmend.theme import DARK, LIGHT, THEMES, Theme
from mocapmend.views.lane import alone_in
from mocapmend.views.scene import Scene
from mocapmend.views.timeline import Timeline
from mocapmend.views.trajectories import Trajectories
from mocapmend.viewstate import Preview, ViewState
from mocapmend_algorithms import Gap
from mocapmend_algorithms.fill.contract import Patch

SIZE = (800, 500)


@pytest.fixture
def view(document: Document) -> ViewState:
    return ViewState(document.original.frames)


@pytest.fixture
def gap(document: Document) -> Gap:
    """Return a gap of a few frames, with samples of the marker on both sides."""
    return next(g for g in document.gaps if g.length > 10 and g.kind(293) == "interior")


def picture(qtbot: QtBot, widget: QWidget) -> QImage:
    widget.resize(*SIZE)
    widget.show()
    qtbot.waitExposed(widget)
    return widget.grab().toImage()


def colours(image: QImage) -> Counter[int]:
    width, height = image.width(), image.height()
    return Counter(image.pixel(x, y) for x in range(width) for y in range(height))


def patch_of(document: Document, gap: Gap) -> Patch:
    start = document.points[gap.start - 1, gap.marker]
    stop = document.points[gap.stop, gap.marker]
    share = np.linspace(0, 1, gap.length + 2)[1:-1, None]
    sigma = np.full(gap.length, 20.0)
    return Patch(gap, start + share * (stop - start), sigma, 2.5 * sigma)


def fill(document: Document, gap: Gap) -> None:
    edit = Edit.fill(patch_of(document, gap), "linear", None)
    document.undo_stack.push(EditSamples(document, [edit], "fill"))


@pytest.mark.parametrize("theme", THEMES.values(), ids=THEMES)
def test_a_lane_shows_missing_and_filled(
    document: Document, view: ViewState, gap: Gap, theme: Theme, qtbot: QtBot
) -> None:
    timeline = Timeline(document, view, theme)
    qtbot.addWidget(timeline)
    image = picture(qtbot, timeline)
    x = round(timeline.axis.x_of((gap.start + gap.stop) / 2)) + timeline.viewport().x()
    y = timeline.lane_top(gap.marker) + timeline.viewport().y()
    assert image.pixelColor(x, y) == QColor(theme.state_colour(SampleState.MISSING))
    fill(document, gap)
    image = picture(qtbot, timeline)
    assert image.pixelColor(x, y) == QColor(theme.state_colour(SampleState.FILLED))
    document.undo_stack.undo()
    image = picture(qtbot, timeline)
    assert image.pixelColor(x, y) == QColor(theme.state_colour(SampleState.MISSING))


def test_a_lane_out_of_view_is_scrolled_to_and_painted_in_its_place(
    document: Document, view: ViewState, gap: Gap, qtbot: QtBot
) -> None:
    timeline = Timeline(document, view, DARK)
    qtbot.addWidget(timeline)
    timeline.resize(800, 120)
    timeline.show()
    qtbot.waitExposed(timeline)
    assert timeline.lane_top(gap.marker) > timeline.viewport().height()
    view.select((gap.marker,))
    image = timeline.grab().toImage()
    x = round(timeline.axis.x_of((gap.start + gap.stop) / 2)) + timeline.viewport().x()
    y = timeline.lane_top(gap.marker) + 1 + timeline.viewport().y()
    assert image.pixelColor(x, y) == QColor(DARK.state_colour(SampleState.MISSING))
    name = image.pixelColor(timeline.viewport().x() + 1, y)
    assert name == QColor(DARK.accent)


def test_the_current_gap_has_arrows_and_one_points_to_it_when_it_is_out_of_view(
    document: Document, view: ViewState, qtbot: QtBot
) -> None:
    gap = next(g for g in document.gaps if 60 < g.start and g.stop < 233)
    timeline = Timeline(document, view, DARK)
    qtbot.addWidget(timeline)
    view.set_gap(gap)

    def inked() -> list[int]:
        """Return the columns of the viewport that have the gap's colour."""
        picture(qtbot, timeline)
        image, ink = timeline.viewport().grab().toImage(), QColor(DARK.preview).rgba()
        inside = range(image.width()), range(image.height())
        return [x for x in inside[0] if any(image.pixel(x, y) == ink for y in inside[1])]

    columns = inked()
    left, right = timeline.axis.x_of(gap.start), timeline.axis.x_of(gap.stop)
    assert left - 8 <= min(columns) < left
    assert right < max(columns) <= right + 8
    view.set_visible(gap.stop + 10, gap.stop + 60)
    assert max(inked()) < timeline.axis.left + 14
    view.set_visible(gap.start - 60, gap.start - 10)
    assert min(inked()) > timeline.axis.left + timeline.axis.width - 14


def test_the_plots_shade_gaps_and_show_the_preview_with_its_band(
    document: Document, view: ViewState, gap: Gap, qtbot: QtBot
) -> None:
    plots = Trajectories(document, view, DARK)
    qtbot.addWidget(plots)
    empty = picture(qtbot, plots)
    view.select((gap.marker,))
    view.frame_span(gap.start, gap.stop)
    shaded = picture(qtbot, plots)
    assert shaded != empty
    ink = QColor(DARK.preview).rgba()
    assert colours(shaded)[ink] == 0
    view.set_gap(gap)
    view.set_preview(Preview(gap, "linear", None, patch_of(document, gap)))
    previewed = picture(qtbot, plots)
    assert colours(previewed)[ink] > 50
    assert document.points[gap.start, gap.marker, 0] != document.points[gap.start, gap.marker, 0]
    view.set_gap(None)
    assert picture(qtbot, plots) == shaded


@pytest.mark.parametrize("theme", THEMES.values(), ids=THEMES)
def test_the_plots_have_arrows_on_the_ends_of_the_current_gap(
    document: Document, view: ViewState, theme: Theme, qtbot: QtBot
) -> None:
    gap = next(g for g in document.gaps if 60 < g.start and g.stop < 233)
    plots = Trajectories(document, view, theme)
    qtbot.addWidget(plots)
    other = next(m for m in range(document.original.markers) if m != gap.marker)
    view.select((other, gap.marker))
    view.frame_span(gap.start, gap.stop)
    picture(qtbot, plots)
    kept = plots._picture

    def inked() -> list[int]:
        """Return the columns that have the gap's colour, which no curve has."""
        image, ink = picture(qtbot, plots), QColor(theme.preview).rgba()
        inside = range(image.width()), range(image.height())
        return [x for x in inside[0] if any(image.pixel(x, y) == ink for y in inside[1])]

    assert inked() == []
    view.set_gap(gap)
    columns = inked()
    assert plots._picture is kept, "only laid over the plots"
    left, right = plots._axis.x_of(gap.start), plots._axis.x_of(gap.stop)
    assert left - 10 <= min(columns) < left
    assert right < max(columns) <= right + 10
    assert all(x <= left or x >= right for x in columns)
    view.set_visible(gap.stop + 10, gap.stop + 60)
    assert max(inked()) < plots._axis.left + 14
    view.set_visible(gap.start - 60, gap.start - 10)
    assert min(inked()) > plots._axis.left + plots._axis.width - 14
    view.select((gap.marker, other))
    assert inked() == [], "the plots shade the gaps of the other marker"


def test_moving_the_playhead_paints_no_plot_again(
    document: Document, view: ViewState, gap: Gap, qtbot: QtBot
) -> None:
    plots = Trajectories(document, view, DARK)
    qtbot.addWidget(plots)
    view.select((gap.marker,))
    picture(qtbot, plots)
    kept = plots._picture
    view.set_frame(view.frame + 5)
    picture(qtbot, plots)
    assert plots._picture is kept
    view.zoom(0.5, 100.0)
    assert plots._stale


def test_the_scene_shows_the_preview_in_its_frames_alone(
    document: Document, view: ViewState, gap: Gap, qtbot: QtBot
) -> None:
    scene = Scene(document, view, DARK)
    scene.set_layer("trails", on=False)
    qtbot.addWidget(scene)
    view.set_gap(gap)
    view.set_frame(gap.start)
    before = picture(qtbot, scene)
    view.set_preview(Preview(gap, "linear", None, patch_of(document, gap)))
    assert picture(qtbot, scene) != before
    view.set_frame(gap.start - 2)
    outside = picture(qtbot, scene)
    view.set_preview(None)
    assert picture(qtbot, scene) == outside


@pytest.mark.parametrize("name", ["front", "back", "left", "right", "top", "oblique"])
def test_every_fixed_view_shows_the_body(
    document: Document, view: ViewState, qtbot: QtBot, name: str
) -> None:
    scene = Scene(document, view, DARK)
    qtbot.addWidget(scene)
    scene.look(name)
    picture(qtbot, scene)
    pixels = scene._project(scene._current_points())
    seen = pixels[np.isfinite(pixels[:, 0])]
    inside = (seen >= 0).all(axis=1) & (seen[:, 0] < SIZE[0]) & (seen[:, 1] < SIZE[1])
    assert inside.mean() > 0.9


def test_a_sample_alone_between_gaps_is_marked() -> None:
    nan = np.nan
    values = np.array([1.0, nan, 2.0, 3.0, nan, nan, 4.0])
    assert alone_in(values).tolist() == [True, False, False, False, False, False, True]


def luminance(colour: str) -> float:
    channels = QColor(colour).getRgbF()[:3]
    linear = [c / 12.92 if c <= 0.04045 else ((c + 0.055) / 1.055) ** 2.4 for c in channels]
    return 0.2126 * linear[0] + 0.7152 * linear[1] + 0.0722 * linear[2]


def contrast(one: str, other: str) -> float:
    light, dark = sorted((luminance(one), luminance(other)), reverse=True)
    return (light + 0.05) / (dark + 0.05)


@pytest.mark.parametrize("theme", [DARK, LIGHT], ids=["dark", "light"])
def test_text_and_curves_can_be_read(theme: Theme) -> None:
    for ink in (theme.text, theme.dim):
        for ground in (theme.window, theme.base):
            assert contrast(ink, ground) >= 4.5
    for ink in (*theme.curves, theme.preview):
        assert contrast(ink, theme.base) >= 3.0
    assert contrast(theme.on_accent, theme.accent) >= 3.0
