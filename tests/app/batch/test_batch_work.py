"""What a worker makes of one file, and what people are told of many."""

import math
import os
from dataclasses import replace
from pathlib import Path

import numpy as np
import pytest
from batch_trials import write_trial
from c3d_synthetic import Synthetic, encode

from mocapmend import repairing
from mocapmend.batch.results import Figures, Problem, Reason, Row
from mocapmend.batch.show import Tracker, duration, result_text
from mocapmend.batch.time_left import SMALLEST, TimeLeft
from mocapmend.batch.totals import Totals, by_need
from mocapmend.batch.work import Task, do, reasons_of
from mocapmend.plan import Plan
from mocapmend.prospects import Way
from mocapmend.repairing import Request
from mocapmend_algorithms import Cancelled, Gap, no_progress
from mocapmend_algorithms.fill.contract import Unfilled

PLAN = Plan(Way.default("linear"), 200.0)
NOTHING = Figures(
    frames=10, markers=2, rate_hz=100.0, gaps=0, filled=0, left_open=0, samples_missing=0,
    samples_filled=0,
)  # fmt: skip


def ignore(step: str) -> None:
    """Be told a step."""


def task_of(path: Path, out: Path) -> Task:
    return Task(
        file=path.name,
        request=Request(file=path, plan=PLAN, out=out),
        output=out.name,
        report="",
        size=path.stat().st_size if path.exists() else 0,
        key="",
    )


class TestWork:
    def test_figures_are_those_of_the_file(self, tmp_path: Path) -> None:
        task = task_of(write_trial(tmp_path / "a.c3d"), tmp_path / "new" / "deep" / "a.c3d")
        finished = do(task, no_progress, ignore)
        figures = finished.row.figures
        assert finished.row.state == "repaired"
        assert figures is not None
        assert (figures.frames, figures.markers, figures.rate_hz) == (120, 5, 100)
        assert (figures.gaps, figures.filled, figures.left_open) == (3, 1, 2)
        assert (figures.samples_missing, figures.samples_filled) == (39, 5)
        assert figures.tracked_before == pytest.approx(100 * (1 - 39 / 600))
        assert figures.tracked_after == pytest.approx(100 * (1 - 34 / 600))
        assert sorted((reason.gaps, reason.samples) for reason in figures.reasons) == [
            (1, 4), (1, 30),
        ]  # fmt: skip
        assert finished.output is not None
        assert finished.output.size == task.out.stat().st_size
        assert finished.input is not None
        assert Row.from_json(finished.row.as_json()) == finished.row

    def test_what_was_wrong_was_not_tracked(self, tmp_path: Path) -> None:
        points = np.full((120, 5, 3), 900.0) + np.arange(5).reshape(1, 5, 1) * 100.0
        points += 100.0 * np.sin(np.arange(120) / 20.0)[:, None, None]
        points[60, 1] += 300.0
        path = tmp_path / "a.c3d"
        path.write_bytes(encode(Synthetic(points)))
        task = task_of(path, tmp_path / "out.c3d")
        plan = replace(PLAN, fix=("spikes",))
        figures = do(
            replace(task, request=replace(task.request, plan=plan)), no_progress, ignore
        ).row.figures
        assert figures is not None
        assert figures.samples_fixed == figures.samples_missing >= 1
        share = 100 * figures.samples_fixed / 600
        assert figures.wrong_before == pytest.approx(share)
        assert figures.tracked_before == pytest.approx(100 - share)

    def test_what_goes_wrong_is_in_the_row(
        self, tmp_path: Path, monkeypatch: pytest.MonkeyPatch
    ) -> None:
        missing = do(task_of(tmp_path / "no.c3d", tmp_path / "out.c3d"), no_progress, ignore)
        assert missing.row.problem == Problem(
            "There is no such file.", str(tmp_path / "no.c3d"), "Check the name and the folder."
        )
        task = task_of(write_trial(tmp_path / "a.c3d"), tmp_path / "out.c3d")
        for error, text in ((MemoryError(), "memory"), (ZeroDivisionError("oh"), "oh")):

            def fail(*_: object, error: BaseException = error) -> None:
                raise error

            monkeypatch.setattr(repairing, "repair_file", fail)
            finished = do(task, no_progress, ignore)
            assert finished.row.state == "failed"
            assert finished.row.problem is not None
            assert text in finished.row.problem.what
            assert finished.input is finished.output is None
            assert ("Traceback" in finished.trace) == isinstance(error, ZeroDivisionError)

    def test_a_file_where_a_folder_is_needed(self, tmp_path: Path) -> None:
        (tmp_path / "out").write_bytes(b"")
        task = task_of(write_trial(tmp_path / "a.c3d"), tmp_path / "out" / "a.c3d")
        problem = do(task, no_progress, ignore).row.problem
        assert problem is not None
        assert problem.where == str(tmp_path / "out")

    def test_to_cancel_is_no_failure(self, tmp_path: Path) -> None:
        task = task_of(write_trial(tmp_path / "a.c3d"), tmp_path / "out.c3d")

        def cancel(fraction: float, /) -> None:
            raise Cancelled

        with pytest.raises(Cancelled):
            do(task, cancel, ignore)
        assert [path.name for path in tmp_path.iterdir()] == ["a.c3d"]

    def test_a_recording_that_changes_meanwhile_is_not_taken_for_done(
        self, tmp_path: Path, monkeypatch: pytest.MonkeyPatch
    ) -> None:
        path = write_trial(tmp_path / "a.c3d")
        repair = repairing.repair_file

        def change(*arguments: object) -> object:
            done = repair(*arguments)
            os.utime(path, (1, 1))
            return done

        monkeypatch.setattr(repairing, "repair_file", change)
        row = do(task_of(path, tmp_path / "out.c3d"), no_progress, ignore).row
        assert row.problem is not None
        assert "changed" in row.problem.what


def test_reasons_that_differ_in_numbers_are_one() -> None:
    unfilled = [
        Unfilled(Gap(0, 0, 5), "5 frames (50 ms) is too long"),
        Unfilled(Gap(0, 10, 30), "20 frames (12.5 ms) is too long"),
        Unfilled(Gap(1, 0, 50), "never seen before frame 50"),
    ]
    assert reasons_of(unfilled) == (
        Reason(2, 25, "20 frames (12.5 ms) is too long"),
        Reason(1, 50, "never seen before frame 50"),
    )


class TestTotals:
    def test_what_needs_attention_comes_first(self) -> None:
        def row(file: str, **figures: object) -> Row:
            return Row(file=file, state="repaired", figures=replace(NOTHING, **figures))

        bad = Row(file="z", state="failed", problem=Problem("Broken."))
        waiting = Row(file="y", state="waiting")
        open_most = row("x", samples_missing=9)
        open_less = row("w", samples_missing=9, samples_filled=5)
        unsure = row("v", no_estimate=1)
        worst = row("u", expected_worst_mm=5.0)
        same = [row("a", expected_worst_mm=1.0), row("b", expected_worst_mm=1.0)]
        earlier = replace(row("t", expected_worst_mm=0.5), state="unchanged")
        ordered = [bad, waiting, open_most, open_less, unsure, worst, *same, earlier]
        assert by_need(reversed(ordered)) == ordered
        assert by_need(ordered) == ordered

    def test_sums(self) -> None:
        rows = [
            Row(file="a", state="repaired", seconds=1.5, figures=replace(
                NOTHING, gaps=3, filled=1, left_open=2, tracked_before=50.0, tracked_after=80.0,
            )),
            Row(file="b", state="unchanged", seconds=0.5, figures=replace(
                NOTHING, frames=30, samples_missing=4, samples_filled=1, tracked_before=90.0,
                tracked_after=100.0,
            )),
            Row(file="c", state="unchanged", figures=NOTHING),
            Row(file="d", state="failed", problem=Problem("Broken.")),
            Row(file="e", state="waiting"),
        ]  # fmt: skip
        totals = Totals.of(rows)
        assert (totals.files, totals.done, totals.failed, totals.waiting) == (5, 3, 1, 1)
        assert (totals.frames, totals.gaps, totals.filled, totals.left_open) == (50, 3, 1, 2)
        assert (totals.samples_missing, totals.samples_filled) == (4, 1)
        assert totals.tracked_before == pytest.approx(80)
        assert totals.tracked_after == pytest.approx(95)
        assert totals.seconds == 2
        assert Totals.of([]).tracked_before is None


class TestShow:
    def test_time_left_goes_by_size(self, tmp_path: Path) -> None:
        clock = [100.0]
        task = task_of(write_trial(tmp_path / "a.c3d"), tmp_path / "out.c3d")
        large = replace(task, file="large", size=3 * SMALLEST)
        small = replace(task, file="small", size=10)
        shown = Tracker([large, small], clock=lambda: clock[0])
        shown.began(large)
        shown.began(small)
        assert shown.line(1) == "0 of 2 files: large"
        shown.at(large, "Filling", 0.5)
        assert shown.line(1) == "0 of 2 files: large (filling 50 %)"
        clock[0] += 90.0
        shown.finished(large, Row(file="large", state="repaired", seconds=90.0))
        assert shown.line(8) == "1 of 2 files, about 30 s left: small"
        clock[0] += 20.0
        assert shown.line(8) == "1 of 2 files, about 10 s left: small"
        shown.finished(small, Row(file="small", state="repaired", seconds=21.0))
        assert shown.line(8) == "2 of 2 files: "

    def test_the_time_left_goes_down_as_time_goes_by(self, tmp_path: Path) -> None:
        task = task_of(tmp_path / "a.c3d", tmp_path / "out.c3d")
        tasks = [replace(task, file=str(n), size=SMALLEST) for n in range(8)]
        clock = [0.0]
        left = TimeLeft(tasks, clock=lambda: clock[0])
        told = []
        for second in range(40):
            clock[0] = float(second)
            pair = second // 10
            if second % 10 == 0 and second:
                for n in (2 * pair - 2, 2 * pair - 1):
                    left.finished(tasks[n], 10.0)
            told.append(left.seconds([str(2 * pair), str(2 * pair + 1)], workers=2))
        assert all(math.isnan(seconds) for seconds in told[:10])
        assert told[10:] == [float(40 - second) for second in range(10, 40)]

    def test_the_last_files_are_not_shared(self, tmp_path: Path) -> None:
        task = task_of(tmp_path / "a.c3d", tmp_path / "out.c3d")
        tasks = [replace(task, file=str(n), size=SMALLEST) for n in range(3)]
        clock = [0.0]
        left = TimeLeft(tasks, clock=lambda: clock[0])
        left.finished(tasks[0], 10.0)
        left.finished(tasks[1], None)
        assert left.seconds(["2"], workers=8) == 10.0
        clock[0] += 12.0
        assert math.isnan(left.seconds(["2"], workers=8)), "it takes longer than was thought"

    def test_a_long_name_does_not_hide_how_far_it_is(self, tmp_path: Path) -> None:
        task = task_of(tmp_path / "a.c3d", tmp_path / "out.c3d")
        long = replace(task, file="subject/" * 20 + "trial 07.c3d")
        shown = Tracker([long], clock=lambda: 0.0)
        shown.at(long, "Filling", 0.25)
        assert shown.line(1).endswith("trial 07.c3d (filling 25 %)")
        assert len(shown.line(1)) < 80

    @pytest.mark.parametrize(
        ("seconds", "text"),
        [(0.0, "0 s"), (0.2, "1 s"), (59.5, "60 s"), (61, "2 min"), (3600, "1 h 00 min"),
         (7260, "2 h 01 min")],
    )  # fmt: skip
    def test_durations(self, seconds: float, text: str) -> None:
        assert duration(seconds) == text

    def test_a_line_for_every_end(self) -> None:
        figures = replace(NOTHING, gaps=2, filled=1, expected_worst_mm=3.14)
        done = Row(file="a", state="repaired", figures=figures, seconds=2)
        assert result_text(done) == ("a: 1 of 2 gaps filled, largest expected error 3.1 mm, 2.0 s")
        bad = Row(file="a", state="failed", problem=Problem("Broken.", "a", "Mend it."))
        assert result_text(bad) == "a: failed: Broken. Mend it."
        assert result_text(Row(file="a", state="waiting")) == "a: not done yet"
