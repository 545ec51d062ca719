"""What the painters of the 3D view find out before they paint, against closed forms."""

from dataclasses import replace

import numpy as np
import pytest
from PySide6.QtCore import Qt
from PySide6.QtGui import QColor, QImage, QPainter
from pytestqt.qtbot import QtBot

from mocapmend.commands import EditSamples
from mocapmend.document import Document
from mocapmend.edits import Edit
from mocapmend.files import ForcePlate
from mocapmend.state import SampleState
from mocapmend.theme import DARK
from mocapmend.views.body_path import BodyPath
from mocapmend.views.camera import Camera
from mocapmend.views.painters.edits import edits_in, edits_text, measured_edges
from mocapmend.views.painters.ground import plate_outlines
from mocapmend.views.painters.hull import hull
from mocapmend.views.painters.measure import angle, distance, measurement
from mocapmend.views.painters.shot import Shot
from mocapmend.views.painters.texts import place_labels
from mocapmend.views.painters.trails import (
    BROKEN,
    DASHED,
    DOTTED,
    MOST_VERTICES,
    SOLID,
    paint_trails,
    trails_around,
)
from mocapmend.views.scene import Scene
from mocapmend.viewstate import ViewState
from mocapmend_algorithms import Gap
from mocapmend_algorithms.fill.contract import Patch


@pytest.fixture
def gap(document: Document) -> Gap:
    """Return a gap of a few frames, with samples of the marker on both sides."""
    return next(g for g in document.gaps if g.length > 10 and g.kind(293) == "interior")


def write(document: Document, edit: Edit) -> None:
    document.undo_stack.push(EditSamples(document, [edit], "edit"))


def fill(document: Document, gap: Gap) -> None:
    sigma = np.ones(gap.length)
    patch = Patch(gap, np.ones((gap.length, 3)) * np.arange(gap.length)[:, None], sigma, sigma)
    write(document, Edit.fill(patch, "linear", None))


# --- trails ----------------------------------------------------------------------------------


def test_a_trail_breaks_at_a_gap_and_is_dashed_where_it_is_filled(
    document: Document, gap: Gap
) -> None:
    marker = np.array([gap.marker])
    reach = gap.length + 3
    styles = trails_around(document, gap.start, reach, marker).styles[:, 0]
    first = gap.start - reach
    measured = np.isfinite(document.points[first : gap.start + reach + 1, gap.marker, 0])
    joined = measured[:-1] & measured[1:]
    assert np.array_equal(styles == BROKEN, ~joined)
    assert (styles[joined] == SOLID).all()
    fill(document, gap)
    styles = trails_around(document, gap.start, reach, marker).styles[:, 0]
    lines = np.arange(first, gap.start + reach)
    filled = (lines + 1 >= gap.start) & (lines < gap.stop)
    assert (styles[filled] == DASHED).all()
    assert np.array_equal(styles[~filled] == SOLID, joined[~filled])


def test_bad_samples_are_dotted(document: Document) -> None:
    present = np.isfinite(document.points[:, :, 0]).all(axis=0)
    marker = int(np.flatnonzero(present)[0])
    run = Gap(marker, 50, 53)
    now = document.read(run)
    write(document, replace(now, states=np.full(3, SampleState.BAD, np.uint8)))
    styles = trails_around(document, 51, 10, np.array([marker])).styles[:, 0]
    assert styles.tolist() == [SOLID] * 8 + [DOTTED] * 4 + [SOLID] * 8


@pytest.mark.parametrize("frame", [0, 5, 292])
def test_trails_end_with_the_recording(document: Document, frame: int) -> None:
    trails = trails_around(document, frame, 100, np.array([0, 1]))
    first, last = max(0, frame - 100), min(292, frame + 100)
    expected = document.points[first : last + 1, :2]
    assert np.array_equal(trails.points, expected, equal_nan=True)
    assert trails.styles.shape == (last - first, 2)


def test_long_trails_of_many_markers_leave_frames_out_but_no_gap(
    document: Document, gap: Gap
) -> None:
    markers = np.arange(document.original.markers)
    frame = min(gap.stop + 3, 292)
    trails = trails_around(document, frame, 200, markers)
    assert trails.points.shape[0] * trails.points.shape[1] <= MOST_VERTICES + len(markers)
    here = (trails.points == document.points[frame]).all(axis=2)
    assert (here.any(axis=0) == np.isfinite(document.points[frame, :, 0])).all()
    missing = np.isnan(document.points[:, :, 0])
    broken = (trails.styles == BROKEN).any(axis=0)
    assert broken[gap.marker]
    assert not broken[~missing.any(axis=0)].any()


# --- before and after ------------------------------------------------------------------------


def test_the_edits_of_a_frame_are_told_apart(document: Document, gap: Gap) -> None:
    frame = gap.start + 2
    assert not any(map(len, vars(edits_in(document, frame)).values()))
    assert edits_text(document, frame) == "Before and after: no edits in this frame"
    measured = np.flatnonzero(np.isfinite(document.points[frame, :, 0]))
    moved, removed = (int(marker) for marker in measured[:2])
    fill(document, gap)
    run = Gap(moved, frame, frame + 1)
    write(document, replace(document.read(run), values=document.points[frame, [moved]] + 5.0))
    write(document, Edit.clear(Gap(removed, frame, frame + 1)))
    edits = edits_in(document, frame)
    assert edits.filled.tolist() == [gap.marker]
    assert edits.moved.tolist() == [moved]
    assert edits.removed.tolist() == [removed]
    assert edits_text(document, frame) == "Before and after: 1 filled, 1 moved, 1 removed"
    document.undo_stack.setIndex(0)
    assert not any(map(len, vars(edits_in(document, frame)).values()))


def test_a_fill_lies_between_measured_samples(document: Document, gap: Gap) -> None:
    fill(document, gap)
    for frame in (gap.start, gap.stop - 1):
        before, after = measured_edges(document, gap.marker, frame)
        assert np.array_equal(before, document.original.points[gap.start - 1, gap.marker])
        assert np.array_equal(after, document.original.points[gap.stop, gap.marker])


def test_a_fill_at_the_end_has_one_edge(document: Document) -> None:
    gap = next(g for g in document.gaps if g.kind(293) == "trailing" and g.length < 293)
    fill(document, gap)
    before, after = measured_edges(document, gap.marker, gap.stop - 1)
    assert np.isfinite(before).all()
    assert np.isnan(after).all()


def test_a_sample_that_no_fill_holds_has_no_edges(document: Document, gap: Gap) -> None:
    run = Gap(gap.marker, gap.start + 1, gap.start + 2)
    write(document, Edit(run, np.ones((1, 3)), np.array([SampleState.BAD], np.uint8)))
    assert edits_in(document, run.start).filled.tolist() == [gap.marker]
    assert np.isnan(measured_edges(document, gap.marker, run.start)).all()


# --- measuring -------------------------------------------------------------------------------


def test_distances_and_angles() -> None:
    origin, x, y = np.zeros(3), np.array([3.0, 0, 0]), np.array([0, 4.0, 0])
    assert distance(x, y) == pytest.approx(5.0)
    assert angle(x, origin, y) == pytest.approx(90.0)
    assert angle(x, origin, x + y) == pytest.approx(np.degrees(np.arctan2(4, 3)))
    assert angle(x, origin, -x) == pytest.approx(180.0)
    assert angle(x, origin, 2 * x) == pytest.approx(0.0)
    # The cosine alone would lose half of the digits here.
    assert angle(x, origin, x + 1e-9 * y) == pytest.approx(np.degrees(4e-9 / 3))
    assert np.isnan(angle(x, origin, origin))
    assert np.isnan(angle(x, np.full(3, np.nan), y))
    assert np.isnan(distance(x, np.full(3, np.nan)))


def test_what_is_measured_is_said_with_its_unit(document: Document, gap: Gap) -> None:
    frame = gap.start
    one, middle, other = np.flatnonzero(np.isfinite(document.points[frame, :, 0]))[:3].tolist()
    names = document.names
    points = document.points[frame]
    length = f"{np.linalg.norm(points[one] - points[other]):.1f} mm"
    text = measurement(document, (one, other), frame)
    assert text == f"{names[one]} – {names[other]}: {length}"
    text = measurement(document, (one, middle, other), frame)
    expected = angle(points[one], points[middle], points[other])
    assert text == f"{names[one]} – {names[middle]} – {names[other]}: {expected:.1f}°"
    missing = measurement(document, (gap.marker, other), frame)
    mine = names[gap.marker]
    assert missing == f"{mine} – {names[other]}: missing here ({mine})"
    fill(document, gap)
    assert measurement(document, (gap.marker, other), frame).endswith(f" mm (not measured: {mine})")


@pytest.mark.parametrize("count", [0, 1, 4])
def test_without_two_or_three_markers_it_says_what_to_select(
    document: Document, count: int
) -> None:
    assert "select two markers" in measurement(document, tuple(range(count)), 0)


def test_markers_at_one_place_have_no_angle(document: Document) -> None:
    present = np.isfinite(document.points[0, :, 0])
    one, other = np.flatnonzero(present)[:2].tolist()
    run = Gap(other, 0, 1)
    write(document, replace(document.read(run), values=document.points[0, [one]].copy()))
    assert "no angle" in measurement(document, (one, other, int(np.flatnonzero(present)[2])), 0)


# --- shapes ----------------------------------------------------------------------------------


def test_a_hull_holds_all_points_and_turns_one_way() -> None:
    points = np.random.default_rng(3).normal(size=(40, 2))
    corners = hull(points)
    edges = np.roll(corners, -1, axis=0) - corners
    to_points = points[None] - corners[:, None]
    sides = edges[:, None, 0] * to_points[..., 1] - edges[:, None, 1] * to_points[..., 0]
    assert (sides > -1e-9).all()
    assert {tuple(corner) for corner in corners} <= {tuple(point) for point in points}


@pytest.mark.parametrize(
    ("points", "corners"),
    [
        ([], []),
        ([(1, 2)], [(1, 2)]),
        ([(1, 2), (1, 2)], [(1, 2)]),
        ([(3, 3), (1, 1), (2, 2)], [(1, 1), (3, 3)]),
        ([(0, 0), (2, 0), (2, 2), (0, 2), (1, 1)], [(0, 0), (2, 0), (2, 2), (0, 2)]),
    ],
)
def test_hulls_of_few_points(points: list, corners: list) -> None:
    found = hull(np.array(points, float).reshape(-1, 2))
    assert found.tolist() == np.array(corners, float).reshape(-1, 2).tolist()


def test_plates_keep_the_numbers_of_the_file() -> None:
    square = np.array([[0, 0, 0], [4.0, 0, 0], [4, 6, 0], [0, 6, 0]])
    none = np.full((4, 3), np.nan)
    plates = [ForcePlate(2, corners, np.zeros(3), ()) for corners in (none, square, square * 0)]
    outlines = plate_outlines(plates)
    assert list(outlines) == [2]
    outline = outlines[2]
    assert np.array_equal(outline[0], outline[-1])
    around = np.linalg.norm(np.diff(outline, axis=0), axis=1).sum()
    assert around == pytest.approx(20.0)
    for corner in square:
        assert (outline == corner).all(axis=1).any()


def test_a_recording_without_plates_and_segments_is_painted(
    document: Document, qtbot: QtBot
) -> None:
    bare = Document(
        replace(document.source, force_plates=()),
        replace(document.skeleton, segments=(), bones=()),
    )
    view = ViewState(bare.original.frames)
    scene = Scene(bare, view, DARK)
    qtbot.addWidget(scene)
    scene.layers.clear()
    empty = scene.grab().toImage()
    scene.set_layer("plates", on=True)
    assert scene.grab().toImage() == empty
    scene.set_layer("segments", on=True)
    # It says that there are none.
    assert scene.grab().toImage() != empty


# --- where the body is -----------------------------------------------------------------------


def test_the_path_follows_a_walk_through_gaps() -> None:
    frames = 500
    walk = np.zeros((frames, 6, 3))
    walk[:, :, 0] = np.linspace(0, 4000, frames)[:, None]
    walk[:, :, 2] = np.arange(6) * 300.0
    walk[200:260] = np.nan
    path = BodyPath(walk, 100.0)
    places = np.array([path.at(frame) for frame in range(frames)])
    assert np.isfinite(places).all()
    assert np.abs(places[60:-60, 0] - np.linspace(0, 4000, frames)[60:-60]).max() < 100
    # No jump that the eye would see: a walk makes 8 mm per frame.
    assert np.abs(np.diff(places[:, 0])).max() < 30
    assert path.size() < 1500


def test_a_long_recording_is_followed_as_closely_as_a_short_one() -> None:
    frames = 20_000
    walk = np.zeros((frames, 4, 3))
    walk[:, :, 0] = 1000 * np.sin(np.arange(frames) / 400)[:, None]
    path = BodyPath(walk, 100.0)
    assert len(path.overview) < 700
    for frame in (777, 9_999, 15_003):
        assert path.at(frame)[0] == pytest.approx(walk[frame, 0, 0], abs=20)


def test_a_ghost_far_away_does_not_move_the_picture() -> None:
    points = np.random.default_rng(1).uniform(-500, 500, (100, 40, 3))
    alone = BodyPath(points, 100.0).at(50)
    points[:, 0] = 1e6
    assert np.abs(BodyPath(points, 100.0).at(50) - alone).max() < 100


@pytest.mark.parametrize("shape", [(10, 2, 3), (0, 2, 3), (10, 0, 3)])
def test_an_empty_recording_has_a_place_and_a_size(shape: tuple[int, int, int]) -> None:
    path = BodyPath(np.full(shape, np.nan), 100.0)
    assert (path.at(0) == 0).all()
    assert (path.overview == 0).all()
    assert path.size() == 1.0


# --- labels ----------------------------------------------------------------------------------


def test_no_label_lies_over_another_and_selected_ones_come_first(document: Document) -> None:
    view = ViewState(document.original.frames)
    view.select((5, 7))
    image = QImage(400, 300, QImage.Format.Format_RGB32)
    painter = QPainter(image)
    # Two far apart, the others in a heap.
    places = np.full((document.original.markers, 2), 200.0)
    places[0], places[1] = (20.0, 20.0), (20.0, 280.0)
    places[2] = np.nan
    shot = Shot(painter, DARK, document, view, Camera(), np.eye(3), 400, 300, places)
    found = place_labels(shot, places, range(len(places)))
    painter.end()
    assert list(found)[:2] == [7, 5], "the current marker, then the other selected one"
    assert {0, 1} <= set(found)
    assert 2 not in found
    boxes = list(found.values())
    assert not any(a.intersects(b) for i, a in enumerate(boxes) for b in boxes[:i])


def test_trails_are_not_filled_with_what_was_painted_before_them(document: Document) -> None:
    view = ViewState(document.original.frames)
    view.set_frame(100)
    image = QImage(400, 300, QImage.Format.Format_RGB32)
    painter = QPainter(image)
    painter.setBrush(QColor("red"))
    places = np.full((document.original.markers, 2), 200.0)
    camera = Camera(distance=5000.0)
    shot = Shot(painter, DARK, document, view, camera, np.eye(3), 400, 300, places)
    for all_markers in (False, True):
        view.select((0, 1, 2))
        painter.setBrush(QColor("red"))
        paint_trails(shot, 0.5, all_markers=all_markers)
        assert painter.brush().style() == Qt.BrushStyle.NoBrush
    painter.end()
