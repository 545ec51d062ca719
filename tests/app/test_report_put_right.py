"""What reports say of samples that were set aside, exchanged and smoothed."""

from pathlib import Path

import numpy as np
import pytest

from mocapmend import report
from mocapmend.cli import main
from mocapmend.doubts import BY_HAND, Doubt
from mocapmend.files import Renamed
from mocapmend.report import About, RepairRow, SmoothRow, describe, put_right
from mocapmend.report.content import Text, contents
from mocapmend.report.sources import SMOOTHING
from mocapmend.report.tables import Table
from mocapmend_algorithms import Gap, Recording, no_progress
from mocapmend_algorithms.corrections import Move
from mocapmend_algorithms.skeleton import Skeleton
from mocapmend_algorithms.smooth.registry import SMOOTHERS

NO_BONES = Skeleton("", (), "none")
ASIDE = {
    Gap(0, 3, 7): Doubt("spikes", "It jumps."),
    Gap(1, 3, 4): Doubt("spikes", "It jumps."),
    Gap(2, 0, 2): Doubt(BY_HAND, "It was knocked."),
}
MOVES = [Move(0, 10, 30, 1), Move(1, 10, 30, 0)]


def row(marker: int, cutoffs: tuple[float, ...], rms: float, **params: object) -> SmoothRow:
    given = {"cutoff_hz": None, "cutoff_for": "axis", "rule": "least-error", "order": 4, **params}
    return SmoothRow.of(Gap(marker, 0, 50), "butterworth", given, {"cutoff_hz": cutoffs}, rms)


def figures(*, hole: bool = False) -> report.Report:
    """Return the report of 3 markers over 50 frames, of which 5 samples are others now."""
    points = np.zeros((50, 3, 3))
    after = points.copy()
    after[:5, 0] = 1.0
    if hole:
        points[20:25, 2] = after[20:25, 2] = np.nan
    one, other = (Recording(values, ("A", "B", "C"), 100.0) for values in (points, after))
    return report.summarise(one, other, NO_BONES, [], [], no_progress)


def test_counts_by_detector() -> None:
    done = put_right(ASIDE, MOVES, [], {"swaps": 1})
    made = describe(figures(), About("w.c3d", put_right=done)).paragraph
    for part in (
        "was repaired with",
        (
            "40 samples of 2 markers were exchanged between markers, in 2 runs (found now: "
            "1 case of “swaps”)."
        ),
        (
            "7 measured samples in 3 runs were set aside as bad and treated as missing: 5 by the "
            "detector “spikes” (2 runs); 2 by hand (1 run)."
        ),
        "By all of this, 5 measured samples were changed.",
    ):
        assert part in made, part
    assert "smoothed" not in made


def test_smoothing_names_method_cutoffs_markers_and_change() -> None:
    done = put_right({}, [], [row(1, (6.0, 9.0, 12.0), 0.5), row(0, (7.5, 7.5, 7.5), 0.25)])
    made = describe(figures(), About("w.c3d", put_right=done))
    for part in (
        (
            "2 markers (A, B) were smoothed over the whole recording by a zero-lag Butterworth "
            "low-pass filter (method “butterworth”) [1, 2]."
        ),
        (
            "The cut-off frequencies were 6.0 to 12.0 Hz, with a median of 7.5 Hz, chosen by "
            "residual analysis."
        ),
        (
            "It moved samples by 0.38 mm (root mean square, median of the trajectories), by "
            "0.5 mm at most."
        ),
    ):
        assert part in made.paragraph, part
    assert made.references == SMOOTHING["butterworth"].references


def test_what_was_given_is_not_said_to_be_chosen() -> None:
    done = put_right({}, [], [row(0, (6.0, 6.0, 6.0), 0.5, cutoff_hz=6.0, order=2)])
    made = describe(figures(hole=True), About("w.c3d", put_right=done)).paragraph
    assert "with cutoff_hz=6.0, order=2." in made
    assert "The cut-off frequency was 6.0 Hz. It moved samples by 0.5 mm" in made
    assert "except for stretches" not in made, "that marker has no gap"
    gaps = put_right({}, [], [row(2, (6.0, 6.0, 6.0), 0.5)])
    made = describe(figures(hole=True), About("w.c3d", put_right=gaps)).paragraph
    assert "except for stretches of too few samples between gaps" in made


def test_a_method_of_another_version_is_named_as_it_is() -> None:
    nan = float("nan")
    done = put_right({}, [], [SmoothRow.of(Gap(0, 2, 9), "wavelets", {"depth": 3}, {}, nan)])
    made = describe(figures(), About("w.c3d", put_right=done))
    assert "1 marker (A) was smoothed in 1 stretch by the method “wavelets” with depth=3." in (
        made.paragraph
    )
    assert made.references == ()


def test_samples_that_were_exchanged_into_gaps_are_no_unknown_fills() -> None:
    points = np.zeros((50, 2, 3))
    after = points.copy()
    points[10:30, 0] = np.nan
    after[10:30, 1] = np.nan
    one, other = (Recording(values, ("A", "B"), 100.0) for values in (points, after))
    figures = report.summarise(one, other, NO_BONES, [], [], no_progress)
    done = put_right({}, MOVES, [])
    assert "not known" not in describe(figures, About("w.c3d", put_right=done)).paragraph
    assert "not known" in describe(figures, About("w.c3d")).paragraph


def test_bad_samples_were_not_tracked_and_have_their_own_number() -> None:
    points = np.zeros((50, 2, 3))
    points[40:45, 1] = np.nan
    after = points.copy()
    after[3:7, 0] = 1.0
    after[10:30] = after[10:30, ::-1] + 1.0
    one, other = (Recording(values, ("A", "B"), 100.0) for values in (points, after))
    done = put_right({Gap(0, 3, 7): Doubt("spikes", "It jumps.")}, MOVES, [])
    made = report.summarise(one, other, NO_BONES, [], [], no_progress, done)
    share = np.ones(50)
    share[3:7] = share[40:45] = 0.5
    share[10:30] = 0.0
    assert made.success_before.instantaneous.tolist() == share.tolist()
    assert (made.missing_before, made.wrong_before) == (5, 44)
    text = next(
        part.text
        for section in contents(made, About("w.c3d", put_right=done)).sections
        for part in section.parts
        if isinstance(part, Text) and "wrong:" in part.text
    )
    assert "5.00 % of all samples were missing, and 44.00 % were there but wrong" in text


def test_what_was_exchanged_before_is_not_wrong_in_the_recording_before() -> None:
    points = np.zeros((50, 2, 3))
    one = Recording(points, ("A", "B"), 100.0)
    done = put_right({}, MOVES, [], moved_before=MOVES)
    assert done.moved_samples == 40
    assert not done.wrong_in(one).any()


def test_a_bone_is_not_repaired_by_smoothing() -> None:
    points = np.zeros((50, 3, 3))
    points[:, :, 0] = 100.0 * np.arange(3)
    points[20:25, 0] = np.nan
    after = np.nan_to_num(points) + 1.0
    one, other = (Recording(values, ("A", "B", "C"), 100.0) for values in (points, after))
    bones = Skeleton("", ((0, 1), (1, 2)), "distances")
    smooth = [row(marker, (6.0,) * 3, 0.5) for marker in range(3)]
    aside = {Gap(2, 3, 7): Doubt("spikes", "It jumps.")}
    done = put_right(aside, [], smooth)
    repairs = [RepairRow(Gap(0, 20, 25), "linear"), RepairRow(Gap(2, 3, 7), "linear")]
    made = report.summarise(one, other, bones, repairs, [], no_progress, done)
    assert made.bone_repairs.tolist() == [5, 4]
    assert made.changed.sum(axis=0).tolist() == [5, 4]
    plain = report.summarise(one, other, bones, repairs, [], no_progress)
    assert plain.bone_repairs.tolist() == [50, 50]


def test_renamed_markers_are_named() -> None:
    renamed = [Renamed(n + 1, f"old {n}", f"new {n}") for n in range(8)]
    done = put_right({}, [], [], renamed=renamed)
    made = contents(figures(), About("w.c3d", put_right=done))
    assert dict(made.head[0].rows)["Renamed"] == "8 markers"
    (table,) = next(section.parts for section in made.sections if section.anchor == "names")
    assert table.rows == tuple((f"old {n}", f"new {n}") for n in range(8))
    paragraph = describe(figures(), About("w.c3d", put_right=done)).paragraph
    assert "8 markers were renamed: old 0 to new 0, " in paragraph
    assert "old 5 to new 5 and 2 more." in paragraph
    assert "was examined with" in paragraph, "no sample is repaired by it"


def test_every_smoothing_method_has_a_phrase_and_a_source() -> None:
    assert set(SMOOTHING) == set(SMOOTHERS)
    assert all(source.references and source.choice for source in SMOOTHING.values())


def test_sections_and_facts() -> None:
    done = put_right(ASIDE, MOVES, [row(1, (6.0, 9.0, 12.0), 0.5), row(0, (7.5,) * 3, 0.25)])
    made = contents(figures(), About("w.c3d", put_right=done))
    facts = dict(made.head[0].rows)
    assert facts["Set aside"] == "7 samples (spikes: 5, by hand: 2)"
    assert facts["Exchanged"] == "40 samples of 2 markers"
    assert facts["Smoothed"] == "2 markers (butterworth)"
    tables = {
        section.anchor: part.rows
        for section in made.sections
        for part in section.parts
        if isinstance(part, Table)
    }
    assert tables["bad"] == (("spikes", "2", "5"), ("by hand", "1", "2"))
    assert [cells[-2:] for cells in tables["smoothing"]] == [
        ("7.5", "0.25"),
        ("6.0 9.0 12.0", "0.50"),
    ]
    plain = contents(figures(), About("w.c3d"))
    assert {"bad", "smoothing"}.isdisjoint(section.anchor for section in plain.sections)


def test_samples_that_were_set_aside_and_filled_count_as_repaired() -> None:
    points = np.zeros((50, 1, 3))
    after = points.copy()
    after[3:7] = 1.0
    one, other = (Recording(values, ("A",), 100.0) for values in (points, after))
    rows = [RepairRow(Gap(0, 3, 7), "linear", 0.5)]
    made = report.summarise(one, other, NO_BONES, rows, [], no_progress)
    done = put_right({Gap(0, 3, 7): Doubt("spikes", "It jumps.")}, [], [])
    facts = dict(contents(made, About("w.c3d", put_right=done)).head[0].rows)
    assert facts["Repaired"] == "1 gap, 4 samples"


@pytest.mark.parametrize("ending", ["html", "pdf"])
def test_the_command_line_tells_it_too(holed_walk: Path, tmp_path: Path, ending: str) -> None:
    out, page = tmp_path / "out.c3d", tmp_path / f"report.{ending}"
    arguments = ["repair", str(holed_walk), "-o", str(out), "--method", "linear"]
    assert main([*arguments, "--smooth", "butterworth", "--report", str(page)]) == 0
    again = tmp_path / "again.html"
    assert main(["report", str(holed_walk), str(out), "-o", str(again)]) == 0
    pages = [again, page] if ending == "html" else [again]
    for each in pages:
        text = each.read_text(encoding="utf-8")
        assert "41 markers were smoothed over the whole recording" in text
        assert "RMS change (mm)" in text
    assert page.stat().st_size > 10_000
