"""The methods paragraph: every number in it against figures that can be counted by hand."""

import dataclasses

import numpy as np
import pytest

from mocapmend import __version__, report
from mocapmend.report import About, RepairRow, describe, method_text
from mocapmend.report.sources import SOURCES
from mocapmend_algorithms import Gap, Recording, no_progress
from mocapmend_algorithms.fill.contract import Patch, Unfilled
from mocapmend_algorithms.fill.registry import METHODS
from mocapmend_algorithms.skeleton import Segment, Skeleton

GAPS = (Gap(0, 2, 5), Gap(1, 10, 20), Gap(2, 30, 31), Gap(2, 40, 42))
NO_BONES = Skeleton("", (), "none")
NAN = float("nan")


def figures(
    rows: list[RepairRow], unfilled: list[Unfilled], *, filled: int, altered: int = 0
) -> report.Report:
    """Return the report of 3 markers over 50 frames at 100 Hz; the first gaps are filled."""
    points = np.zeros((50, 3, 3))
    before, after = points.copy(), points.copy()
    for gap in GAPS:
        before[gap.start : gap.stop, gap.marker] = np.nan
    for gap in GAPS[filled:]:
        after[gap.start : gap.stop, gap.marker] = np.nan
    after[45 : 45 + altered, 0] = 7.0
    labels = ("A", "B", "C")
    one, other = (Recording(values, labels, 100.0) for values in (before, after))
    return report.summarise(one, other, NO_BONES, rows, unfilled, no_progress)


ROWS = [
    RepairRow(GAPS[0], "auto", 2.0),
    RepairRow(GAPS[1], "auto", 12.34),
    RepairRow(GAPS[2], "cubic", NAN),
]
OPEN = [Unfilled(GAPS[3], "2 frames (20 ms) is longer than the limit of 1 frame (10 ms)")]


def test_the_numbers_of_the_paragraph() -> None:
    about = About("walk.c3d", ("auto (donors=2)", "cubic"), "no gap longer than 1 frame (10 ms)")
    made = describe(figures(ROWS, OPEN, filled=3), about)
    for part in (
        "walk.c3d (3 markers, 50 frames at 100 Hz, 0.50 s)",
        f"was repaired with mocapmend {__version__}.",
        "16 samples (10.7 % of all) were missing, in 4 gaps.",
        "3 gaps (14 samples) were filled: 2 by a blend of Gaussian-process regressions",
        "(method “auto”) [1, 2]; 1 by cubic spline interpolation (method “cubic”).",
        "Parameters other than the defaults: auto (donors=2).",
        "1 to 10 frames long (10 to 100 ms), with a median of 3 frames (30 ms).",
        "was 7.2 mm in the median of the gaps and 12.3 mm at most.",
        "stretches of the same recording that were hidden",
        "For 1 gap, it could not be estimated.",
        "Limits: no gap longer than 1 frame (10 ms).",
        "1 gap (2 samples) was left open: the gap is longer than the limit (1 gap).",
        "No measured sample was changed.",
    ):
        assert part in made.paragraph, part
    assert "Check of" not in made.paragraph
    assert "before this session" not in made.paragraph
    assert len(made.references) == 2
    assert made.text.endswith(
        "[2] Breiman L (1996). Stacked regressions. Machine Learning 24:49–64."
    )


def test_nothing_is_claimed_that_is_not_known() -> None:
    rows = [RepairRow(GAPS[0], "of-tomorrow", 2.0)]
    text = describe(figures(rows, [], filled=1), About("walk.c3d")).paragraph
    assert "1 by the method “of-tomorrow”." in text
    assert "hidden" not in text
    assert "All filled gaps were 3 frames (30 ms) long." in text
    assert "no repair was asked for (3 gaps)" in text
    assert "Limits" not in text


def test_fills_without_a_record_are_of_an_unknown_method() -> None:
    text = describe(figures([], [], filled=4), About("walk.c3d")).paragraph
    assert "16 samples were filled by a method that is not known." in text
    assert "was examined with" in text
    assert "No gap was left open." in text
    mixed = describe(figures(ROWS[:1], [], filled=4), About("walk.c3d")).paragraph
    assert "1 gap (3 samples) was filled" in mixed
    assert "13 samples were filled by a method that is not known." in mixed


def test_nothing_done_is_said_so() -> None:
    text = describe(figures([], [], filled=0), About("walk.c3d")).paragraph
    assert "No gap was filled." in text
    assert "expected error" not in text
    assert "frames long" not in text


def test_changed_measured_samples_earlier_repairs_and_proofs_are_told() -> None:
    about = About("w.c3d", earlier=1, earlier_program="mocapmend 0.0.9", proof=("All is well.",))
    text = describe(figures(ROWS, OPEN, filled=3, altered=2), about).paragraph
    assert "Besides, 2 measured samples were changed." in text
    assert "1 of these gaps had been filled before this session" in text
    assert "(mocapmend 0.0.9)" in text
    assert text.endswith("Check of the written file: All is well.")


def test_reasons_that_differ_in_numbers_are_counted_together() -> None:
    unfilled = [
        Unfilled(GAPS[0], "the expected error of 23 mm is above the default limit of 20 mm"),
        Unfilled(GAPS[1], "the expected error of 99.5 mm is above the limit of 20 mm"),
        Unfilled(GAPS[2], "the marker is never seen before frame 31: this method needs both sides"),
    ]
    text = describe(figures([], unfilled, filled=0), About("w.c3d")).paragraph
    assert "the expected error is above the limit (2 gaps); the marker is not seen on both" in text


def test_every_method_has_a_phrase_for_papers() -> None:
    assert set(SOURCES) == set(METHODS)


def test_a_method_is_named_with_what_differs_from_its_defaults() -> None:
    params = METHODS["rigid"].params()
    assert method_text("rigid", params) == "rigid"
    given = dataclasses.replace(params, donors=("LASI", "RASI", "SACR"))
    assert method_text("rigid", given) == "rigid (donors=LASI, RASI, SACR)"
    assert method_text("rigid", {"donors": ("LASI",)}) == "rigid"


def test_segments_are_tracked_when_all_their_markers_are() -> None:
    points = np.zeros((4, 3, 3))
    after = points.copy()
    points[1, 0] = np.nan
    points[2, 1] = np.nan
    one, other = (Recording(values, ("A", "B", "C"), 100.0) for values in (points, after))
    segments = (Segment((0, 1)), Segment((2,)))
    made = report.summarise(one, other, Skeleton("", (), "none", segments), (), (), no_progress)
    assert made.segments == 2
    assert made.segment_success is not None
    old, new = made.segment_success
    assert old.instantaneous.tolist() == [1, 0.5, 0.5, 1]
    assert old.survival.tolist() == [1, 0.5, 0.5, 0.5]
    assert new.instantaneous.tolist() == [1, 1, 1, 1]


@pytest.mark.parametrize("seed", range(5))
def test_many_repairs_are_described_as_one_by_one(seed: int) -> None:
    random = np.random.default_rng(seed)
    recording = Recording(np.zeros((200, 2, 3)), ("A", "B"), 100.0, unit="m")
    made = []
    for start in range(0, 150, 20):
        length = int(random.integers(1, 9))
        sigma, r90 = random.random((2, length))
        r90[random.random(length) < 0.4] = np.nan
        sigma[random.random(length) < 0.1] = np.nan
        patch = Patch(Gap(0, start, start + length), np.zeros((length, 3)), sigma, r90)
        made.append((patch, "auto", ("B",)))
    rows = report.repair_rows(made, recording)
    for row, (patch, method, donors) in zip(rows, made, strict=True):
        alone = RepairRow.of(patch, method, recording, donors)
        assert (row.gap, row.method, row.donors) == (alone.gap, alone.method, alone.donors)
        np.testing.assert_allclose(
            (row.expected_error_mm, row.r90_mm), (alone.expected_error_mm, alone.r90_mm)
        )
    assert report.repair_rows([], recording) == []
