"""The report: its figures against closed forms, its page against what a browser needs."""

import re
from html.parser import HTMLParser
from pathlib import Path

import numpy as np
import pytest
from hypothesis import given
from hypothesis import strategies as st
from hypothesis.extra.numpy import arrays

from mocapmend import engine, report
from mocapmend.errors import MocapmendError
from mocapmend.report import About, RepairRow, charts, summary
from mocapmend.report.page import render
from mocapmend_algorithms import Gap, Recording, find_gaps, no_progress
from mocapmend_algorithms.fill.contract import Patch, Unfilled
from mocapmend_algorithms.fill.limits import Limits
from mocapmend_algorithms.fill.registry import METHODS
from mocapmend_algorithms.skeleton import Skeleton

SKELETON = Skeleton("", ((0, 1), (1, 2), (2, 3)), "distances")
FILLED = Gap(0, 2, 5)
OPEN = Gap(3, 8, 10)


def make(labels: tuple[str, ...] = ("A", "B", "C", "D")) -> tuple[Recording, Recording]:
    """Return four markers 100 mm apart over 10 frames with a filled and an open gap."""
    points = np.zeros((10, 4, 3))
    points[:, :, 0] = 100 * np.arange(4)
    points[OPEN.start : OPEN.stop, 3] = np.nan
    after = points.copy()
    points[FILLED.start : FILLED.stop, 0] = np.nan
    after[3, 0, 0] = -30
    return (
        Recording(points, labels, 50.0, first_frame=101),
        Recording(after, labels, 50.0, first_frame=101),
    )


def summarised(labels: tuple[str, ...] = ("A", "B", "C", "D")) -> report.Report:
    before, after = make(labels)
    repairs = [RepairRow(FILLED, "cubic", 4.25, 7.5, ("B", "<C>"))]
    unfilled = [Unfilled(OPEN, "the marker is never seen again")]
    return report.summarise(before, after, SKELETON, repairs, unfilled, no_progress)


def test_figures_of_a_recording_that_can_be_counted_by_hand() -> None:
    made = summarised()
    assert made.bone_names == ("A – B", "B – C", "C – D")
    assert made.shown_bones == (0,)
    assert made.bone_repairs.tolist() == [3, 0, 0]
    assert made.changed[:, 0].nonzero()[0].tolist() == [2, 3, 4]
    assert made.spread_before.tolist() == [0, 0, 0]
    lengths = np.array([100.0] * 9 + [130])
    assert made.spread_after[0] == pytest.approx(100 * lengths.std() / lengths.mean())
    assert made.spread_after[1:].tolist() == [0, 0]
    first, *_, last = made.markers
    assert (first.missing_before, first.missing_after, first.filled) == (30, 0, 3)
    assert (first.gaps_before, first.gaps_after) == (1, 0)
    assert (first.longest_before, first.longest_after) == (3, 0)
    assert first.filled_by == (("cubic", 30.0),)
    assert first.worst_error_mm == 4.25
    assert (last.missing_before, last.missing_after, last.filled) == (20, 20, 0)
    assert np.isnan(last.worst_error_mm)
    assert made.open_gaps == (report.OpenGap(OPEN, "the marker is never seen again"),)


def test_success_counts_the_same_markers_before_and_after() -> None:
    before, after = make()
    never = np.full((10, 1, 3), np.nan)
    labels = (*before.labels, "E")
    before, after = (
        Recording(np.concatenate((made.points, never), axis=1), labels, 50.0)
        for made in (before, after)
    )
    made = report.summarise(before, after, SKELETON, (), (), no_progress)
    share = np.ones(10)
    share[8:] = 0.75
    assert made.success_after.instantaneous.tolist() == share.tolist()
    assert made.success_after.survival.tolist() == share.tolist()
    share[2:5] = 0.75
    assert made.success_before.instantaneous.tolist() == share.tolist()
    assert made.success_before.survival.tolist() == [1, 1, *[0.75] * 6, 0.5, 0.5]
    means = np.cumsum(share) / np.arange(1, 11)
    np.testing.assert_allclose(made.success_before.running_mean, means)


def test_every_open_gap_is_listed_even_if_nobody_gave_a_reason() -> None:
    before, _ = make()
    made = report.summarise(before, before, SKELETON, (), (), no_progress)
    assert [row.gap for row in made.open_gaps] == find_gaps(before.present)
    assert {row.reason for row in made.open_gaps} == {summary.NOT_ASKED}
    assert made.shown_bones == ()


def test_a_repaired_end_does_not_count_where_the_other_end_is_missing() -> None:
    before, after = make()
    points = after.points.copy()
    points[2:4, 1] = np.nan
    hidden = Recording(points, after.labels, 50.0)
    made = report.summarise(before, hidden, SKELETON, (), (), no_progress)
    assert made.bone_repairs.tolist() == [1, 0, 0]


@pytest.mark.parametrize("shape", [(0, 0), (0, 3), (5, 0), (1, 1), (5, 3)])
def test_recordings_with_nothing_in_them(shape: tuple[int, int]) -> None:
    empty = Recording(np.full((*shape, 3), np.nan), tuple("ABC"[: shape[1]]), 100.0)
    made = report.summarise(empty, empty, Skeleton("", (), "none"), (), (), no_progress)
    page = render(made, About("nothing.c3d"))
    assert "No pair of markers keeps its distance" in page


def test_row_of_a_patch_is_in_millimetres_and_knows_what_is_unknown() -> None:
    recording = Recording(np.zeros((9, 1, 3)), ("A",), 100.0, unit="m")
    values, nan = np.zeros((3, 3)), np.full(3, np.nan)
    patch = Patch(Gap(0, 2, 5), values, np.full(3, 0.001), np.array([0.002, 0.003, 0.009]))
    row = RepairRow.of(patch, "kalman", recording)
    assert row.expected_error_mm == pytest.approx(np.sqrt(3))
    assert row.r90_mm == pytest.approx(3)
    assert row.donors == ()
    assert RepairRow.of(patch, "auto", recording, ("B", "C")).donors == ("B", "C")
    unknown = RepairRow.of(Patch(Gap(0, 2, 5), values, nan, nan), "kalman", recording)
    assert np.isnan([unknown.expected_error_mm, unknown.r90_mm]).all()


# --- curves --------------------------------------------------------------------------------------


def drawn(values: np.ndarray, across: float = 1.0) -> str:
    return charts.Line("after", tuple(charts._pieces(0.0, across, values))).path


def points_of(path: str) -> list[list[tuple[float, float]]]:
    """Read path data back: one list of points per piece."""
    return [
        [(float(x), float(y)) for x, y in re.findall(r"(-?[\d.]+) (-?[\d.]+)", piece)]
        for piece in path.split("M")[1:]
    ]


@given(
    arrays(
        np.float64,
        st.integers(1, 5000),
        elements=st.one_of(st.just(np.nan), st.integers(0, 200).map(float)),
        fill=st.just(50.0),
    )
)
def test_a_path_keeps_extremes_and_invents_nothing(values: np.ndarray) -> None:
    pieces = points_of(drawn(values))
    known = values[~np.isnan(values)]
    flat = [point for piece in pieces for point in piece]
    assert bool(flat) == bool(known.size)
    for x, y in flat:
        assert values[int(x)] == y
    if known.size:
        heights = [y for _, y in flat]
        assert (min(heights), max(heights)) == (known.min(), known.max())
    assert [x for x, _ in flat] == sorted(x for x, _ in flat)


def test_a_path_breaks_at_gaps_and_shows_lone_samples() -> None:
    values = np.array([1, 2, np.nan, 7, np.nan, np.nan, 4, 4, 4, 4])
    assert drawn(values) == ("M0.0 1.0L1.0 2.0M3.0 7.0L3.0 7.0M6.0 4.0L9.0 4.0")


def test_a_long_recording_stays_a_short_path() -> None:
    values = np.random.default_rng(0).normal(100, 10, 100_000)
    assert len(drawn(values, 0.003)) < 40_000


@given(st.floats(-1e4, 1e4), st.floats(1e-3, 1e4))
def test_ticks_enclose_the_values_and_are_few(low: float, span: float) -> None:
    ticks = charts._nice(low, low + span, 5)
    assert 2 <= len(ticks) <= 8
    assert ticks[0] <= low + 1e-6 * span
    assert ticks[-1] >= (low + span) - 1e-6 * span
    labels = [text for _, text in charts._labelled(ticks)]
    assert len(set(labels)) == len(labels)


# --- page ----------------------------------------------------------------------------------------


class Reader(HTMLParser):
    """Checks that elements are nested and closed, and collects text and addresses."""

    VOID = ("meta", "br", "rect")

    def __init__(self) -> None:
        super().__init__()
        self.open: list[str] = []
        self.texts: list[str] = []
        self.addresses: list[str] = []
        self.tags: list[str] = []

    def handle_starttag(self, tag: str, attrs: list[tuple[str, str | None]]) -> None:
        self.tags.append(tag)
        self.addresses += [v or "" for k, v in attrs if k in ("href", "src", "xlink:href")]
        if tag not in self.VOID:
            self.open.append(tag)

    def handle_startendtag(self, tag: str, attrs: list[tuple[str, str | None]]) -> None:
        self.tags.append(tag)

    def handle_endtag(self, tag: str) -> None:
        assert self.open.pop() == tag

    def handle_data(self, data: str) -> None:
        self.texts.append(data)


def read(page: str) -> Reader:
    reader = Reader()
    reader.feed(page)
    reader.close()
    assert reader.open == []
    return reader


def test_the_page_is_whole_and_needs_nothing_else() -> None:
    about = About("walk.c3d", ("cubic",), "none", ("It is odd.",), proof=("All is well.",))
    page = render(summarised(), about)
    reader = read(page)
    assert all(address.startswith("#") for address in reader.addresses)
    assert not re.search(r"https?:|url\(|@import|<script|<link|<img", page)
    assert "prefers-color-scheme: dark" in page
    assert reader.tags.count("figure") == 4
    text = " ".join(reader.texts)
    for part in (
        "walk.c3d", "It is odd.", "All is well.", "103 – 105", "109 – 110", "4.2", "7.5",
        "the marker is never seen again", "A – B", "time (s)", "length (mm)",
        "2 further markers are", "cubic (B, <C>)",
    ):  # fmt: skip
        assert part in text or part in page, part


def test_the_table_of_contents_leads_to_every_heading() -> None:
    page = render(summarised(), About("walk.c3d"))
    links = re.findall(r'<a href="#([a-z]+)">', page)
    assert links == re.findall(r'<h2 id="([a-z]+)">', page)
    assert {"methods", "markers", "repairs", "open", "history", "check"} <= set(links)
    assert "@media print" in page


def test_before_and_after_differ_by_more_than_colour() -> None:
    page = render(summarised(), About("walk.c3d"))
    assert "stroke-dasharray" in re.search(r"\.before \{[^}]*\}", page).group()
    assert "stroke-dasharray" not in re.search(r"\.after \{[^}]*\}", page).group()


def test_labels_cannot_break_the_page() -> None:
    wild = ('<script>alert("x")</script>', "B & C", "'", "</svg>")
    reader = read(render(summarised(wild), About("<b>.c3d", warnings=("<i>",))))
    assert "script" not in reader.tags
    assert "b" not in reader.tags
    assert any("<script>" in text for text in reader.texts)


def test_the_same_input_makes_the_same_bytes(samples: Path, tmp_path: Path) -> None:
    source, skeleton = engine.load(samples / "sprint_basketball.c3d", no_progress)
    recording = source.recording
    gaps = find_gaps(recording.present)
    params = METHODS["linear"].params()
    result = engine.fill(recording, gaps, "linear", params, Limits(), no_progress)
    rows = [RepairRow.of(patch, "linear", recording) for patch in result.patches]
    after = engine.repaired(recording, result)
    about = About(source.path.name, ("linear",), "", source.warnings)
    pages = [tmp_path / "a.html", tmp_path / "b.html"]
    for path in pages:
        engine.write_report(
            recording, after, skeleton, rows, result.unfilled, about, path, no_progress
        )
    page = pages[0].read_text("utf-8")
    assert pages[0].read_bytes() == pages[1].read_bytes()
    assert str(samples) not in page
    assert page.count("<tr>") >= len(gaps)
    read(page)


def test_a_report_that_cannot_be_written_says_so(tmp_path: Path) -> None:
    path = tmp_path / "no such folder" / "report.html"
    with pytest.raises(MocapmendError):
        report.write_report(summarised(), About("walk.c3d"), path)
    assert list(tmp_path.iterdir()) == []
