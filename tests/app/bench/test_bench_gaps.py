"""`bench gaps`: recordings with known errors, through to the printed tables."""

import json
from collections.abc import Sequence
from importlib.resources import files
from itertools import pairwise
from pathlib import Path
from typing import Any

import numpy as np
import pytest
from gap_case_samples import SPLINE, TITS, entry, write_cases
from jsonschema import Draft202012Validator

from mocapmend.bench import main
from mocapmend.bench.gaps import scaling
from mocapmend.bench.gaps.cases import read_cases
from mocapmend.bench.gaps.trials import attempt, load, run_case
from mocapmend.errors import MocapmendError
from mocapmend_algorithms import Gap, Recording, find_gaps
from mocapmend_algorithms.fill import registry
from mocapmend_algorithms.fill.contract import FillResult, Patch, Unfilled
from mocapmend_algorithms.fill.interpolate import LinearParams

LINE_MM = 10 * np.sqrt(34 / 3)
"""Over frames 10 to 12 a line is 3, 4 and 3 cm off the parabola."""


def parabolas(frames: int = 40) -> np.ndarray:
    """Return three markers that move as t^2, a straight line, and not at all."""
    t = np.arange(float(frames))
    still = np.zeros(frames)
    return np.stack(
        [
            np.stack([t**2, still, still + 1], axis=1),
            np.stack([3 * t, 4 * t, still + 2], axis=1),
            np.stack([still + 5, still + 6, still + 7], axis=1),
        ],
        axis=1,
    )


@pytest.fixture
def data(tmp_path: Path) -> Path:
    """Return a folder of a recording in cm, and cases on it."""
    points = np.insert(parabolas(), 1, 0.5, axis=1)
    names = ["P", "*0", "L", "S"]
    np.savez(tmp_path / "a.npz", pos=points, fps=100.0, names=names, units="cm", up="z")
    np.savez(tmp_path / "b.npz", pos=points, fps=100.0, names=names, units="cm", up="z")
    peers = {TITS: {"rmse_mm": LINE_MM / 2}, SPLINE: {"rmse_mm": LINE_MM / 4}}
    write_cases(
        tmp_path / "peers" / "cases.json",
        entry("bent", peers=peers),
        entry("straight", gaps=[[1, 10, 13], [2, 20, 25]], peers={}),
        entry("edge", protocol="P5", gaps=[[0, 0, 5]]),
        entry("other", recording="b", file="b.npz", peers=peers | {"New 2030": {"rmse_mm": 1.0}}),
    )
    return tmp_path


Run = Any


@pytest.fixture
def run(capsys: pytest.CaptureFixture[str]) -> Run:
    """Return a function that runs the command with --json and validates what it prints."""
    text = files("mocapmend_resources").joinpath("schemas/cli.json").read_text("utf-8")
    validator = Draft202012Validator(json.loads(text))

    def run_it(*arguments: object) -> Any:
        assert main(["gaps", *map(str, arguments), "--json"]) == 0
        document = json.loads(capsys.readouterr().out, parse_constant=pytest.fail)
        validator.validate(document)
        return document

    return run_it


def half_filler(
    recording: Recording, gaps: Sequence[Gap], params: object, progress: object
) -> FillResult:
    """Fill all gaps but the last with the truth, 5 cm off; state no radius in the first frame."""
    truth = parabolas(recording.frames)
    patches = []
    for gap in gaps[:-1]:
        radius = np.full(gap.length, 4.0)
        radius[0] = np.nan
        values = truth[gap.start : gap.stop, gap.marker] + (3.0, 0.0, 4.0)
        patches.append(Patch(gap, values, radius, radius))
    return FillResult(tuple(patches), (Unfilled(gaps[-1], "because"),) if gaps else ())


@pytest.fixture
def auto(monkeypatch: pytest.MonkeyPatch) -> None:
    """Register a method of known error that leaves gaps open."""
    method = registry.Method("auto", "Auto", "Automatic", half_filler, LinearParams, "")
    monkeypatch.setitem(registry.METHODS, "auto", method)


def test_the_error_of_a_line_on_a_parabola(data: Path, run: Run) -> None:
    document = run("--data", data, "--methods", "linear,cubic")
    cases = {(row["case"], row["method"]): row for row in document["cases"]}
    bent = cases["bent", "linear"]
    assert (bent["samples"], bent["left_open"], bent["half"]) == (3, 0, "A")
    assert bent["rmse_mm"] == pytest.approx(LINE_MM)
    assert bent["mean_mm"] == pytest.approx(10 * 10 / 3)
    assert bent["reference_mm"] == pytest.approx(LINE_MM / 2)
    assert bent["best_published_mm"] == pytest.approx(LINE_MM / 4)
    assert cases["other", "linear"]["half"] == "B"
    assert cases["straight", "linear"]["rmse_mm"] == pytest.approx(0.0, abs=1e-9)
    assert cases["edge", "linear"]["left_open"] == 5
    assert cases["edge", "linear"]["rmse_mm"] is None
    rows = {(row["protocol"], row["method"]): row for row in document["protocols"]}
    assert list(rows) == [(p, m) for p in ("P3", "P5") for m in ("linear", "cubic")]
    line = rows["P3", "linear"]
    assert (line["cases"], line["filled_cases"], line["compared"]) == (3, 3, 2)
    assert line["to_reference"] == pytest.approx(2.0)
    assert line["mean_rmse_mm"] == pytest.approx(2 * LINE_MM / 3)
    assert rows["P5", "linear"]["left_open"] == 1.0
    assert "targets" not in document
    assert document["notes"][-1] == "Unknown peers, which count as published: New 2030."
    everything = {row["method"]: row for row in document["overall"]}
    assert everything["linear"]["left_open"] == pytest.approx(5 / (3 + 8 + 5 + 3))
    assert everything["linear"]["to_best"] == pytest.approx((4 * LINE_MM) ** 0.5)


@pytest.mark.usefixtures("auto")
def test_a_method_that_leaves_gaps_open_is_judged_by_what_it_fills(data: Path, run: Run) -> None:
    document = run("--data", data, "--methods", "auto,linear", "--protocols", "P3")
    cases = {row["case"]: row for row in document["cases"] if row["method"] == "auto"}
    straight = cases["straight"]
    assert (straight["samples"], straight["left_open"]) == (8, 5)
    assert straight["rmse_mm"] == pytest.approx(50.0)
    assert (straight["stated"], straight["inside_r90"], straight["median_r90_mm"]) == (2, 0, 40.0)
    assert cases["bent"]["rmse_mm"] is None
    row = next(row for row in document["protocols"] if row["method"] == "auto")
    assert (row["filled_cases"], row["compared"], row["to_reference"]) == (0, 0, None)
    assert row["left_open"] == pytest.approx(11 / 14)
    assert row["unstated"] == pytest.approx(1 / 3)
    assert row["target"] == "<= 0.55"
    met = {row["what"]: row["met"] for row in document["targets"]}
    assert met["P3: geometric mean of the RMSE ratios"] is None
    assert met["P3: share of samples inside r90"] is False


def test_the_own_gaps_of_a_recording_are_filled_but_not_judged(tmp_path: Path) -> None:
    points = parabolas()
    points[12:16, 0] = np.nan
    recording = Recording(points, ("P", "L", "S"), 100.0)
    (case,) = read_cases([write_cases(tmp_path / "cases.json", entry())])
    seen: list[Sequence[Gap]] = []

    def spy(recording: Recording, gaps: Sequence[Gap], *rest: object) -> FillResult:
        seen.append(gaps)
        return half_filler(recording, [*gaps, Gap(2, 0, 1)], *rest)

    with pytest.MonkeyPatch.context() as patch:
        method = registry.Method("auto", "Auto", "Automatic", spy, LinearParams, "")
        patch.setitem(registry.METHODS, "auto", method)
        found = attempt(case, recording, "auto")
    assert seen == [[Gap(0, 10, 16)]]
    assert found.samples == 2
    np.testing.assert_allclose(found.errors, [5.0, 5.0])


def test_methods_see_the_punched_recording_and_leave_no_trace_in_the_next(data: Path) -> None:
    case = read_cases([data / "peers" / "cases.json"])[0]
    before = load(case, data).points.copy()
    first, second = (run_case(case, data, order) for order in (("linear", "pchip"), ("pchip",)))
    np.testing.assert_array_equal(first[1].errors, second[0].errors)
    np.testing.assert_array_equal(load(case, data).points, before)
    assert load(case, data).labels == ("P", "L", "S")


def test_filters_choose_cases(data: Path, run: Run, capsys: pytest.CaptureFixture[str]) -> None:
    def names(*arguments: object) -> list[str]:
        document = run("--data", data, "--methods", "linear", *arguments)
        return [row["case"] for row in document["cases"]]

    assert names("--half", "B") == ["other"]
    assert names("--half", "A", "--protocols", "P5") == ["edge"]
    assert names("--recordings", "b,a", "--protocols", "P3, P5") == [
        "bent", "straight", "edge", "other",
    ]  # fmt: skip
    second = write_cases(data / "more.json", entry("more", protocol="P2"))
    assert names("--case-file", second, data / "peers/cases.json", "--protocols", "P2 0.03 s") == [
        "more"
    ]
    document = run("--data", data, "--methods", "linear", "--half", "B")
    assert document["notes"][0] == "Half B alone of the recordings (A: none; B: b)."
    for arguments in (["--protocols", "P9"], ["--recordings", "z"]):
        with pytest.raises(MocapmendError, match="No case is of the"):
            main(["gaps", "--data", str(data), *arguments])
    with pytest.raises(SystemExit) as usage:
        main(["gaps", "--methods", "linear,magic"])
    assert usage.value.code == 2
    assert "there is no method 'magic'" in capsys.readouterr().err


def test_missing_recordings_are_told_before_anything_is_run(
    data: Path, capsys: pytest.CaptureFixture[str]
) -> None:
    (data / "b.npz").unlink()
    with pytest.raises(MocapmendError, match="no such file"):
        main(["gaps", "--data", str(data)])
    assert capsys.readouterr().err == ""


def test_several_processes_find_the_same(data: Path, run: Run) -> None:
    def errors(jobs: int) -> list[Any]:
        document = run("--data", data, "--methods", "linear,pchip", "--jobs", jobs)
        return [(row["case"], row["method"], row["rmse_mm"]) for row in document["cases"]]

    assert errors(1) == errors(2)


@pytest.mark.usefixtures("auto")
def test_the_tables_are_printed_and_the_cases_told(
    data: Path, capsys: pytest.CaptureFixture[str]
) -> None:
    assert main(["gaps", "--data", str(data), "--methods", "linear,auto"]) == 0
    printed, told = capsys.readouterr()
    assert printed.startswith("Repair of 4 gap cases on 2 recordings  \n")
    assert "\n| protocol | method | cases | all filled | left open |" in printed
    assert "\n| P5 | linear | 1 | 0 | 100.0% |  |  |" in printed
    assert "\nTargets of auto\n" in printed
    lines = told.splitlines()
    assert len(lines) == 4
    assert lines[0].startswith("1 of 4: bent: linear 33.7 mm ")
    assert lines[3].startswith("4 of 4: other: auto open ")


def test_our_splines_have_the_published_errors(shared: Path) -> None:
    cases = [case for case in read_cases([shared / "peers/cases.json"]) if case.family == "P3"]
    peers = {"linear": "linear", "cubic": "cubic spline", "pchip": "pchip"}
    for case in cases[::3]:
        for found in run_case(case, shared, tuple(peers)):
            assert found.rmse == pytest.approx(case.peers[peers[found.method]], rel=0.01)


def test_the_cost_of_growing_recordings(monkeypatch: pytest.MonkeyPatch, run: Run) -> None:
    monkeypatch.setattr(scaling, "SECONDS", 5.0)
    monkeypatch.setattr(scaling, "GAPS", (2, 4))
    monkeypatch.setattr(scaling, "SOME_GAPS", 3)
    seconds = iter([1.0, 10.0, 3.0, 20.0, 5.0, 50.0, 6.0, 50.0, 20.0, 200.0])
    sizes: list[tuple[int, int]] = []

    def timed(recording: Recording, method: str) -> tuple[FillResult, float]:
        sizes.append((len(find_gaps(recording.present)), recording.frames))
        return FillResult((), (Unfilled(Gap(0, 1, 2), "because"),)), next(seconds)

    monkeypatch.setattr(scaling, "timed_fill", timed)
    rows = run("--scaling", "--methods", "linear,cubic")["scaling"]
    assert sizes[::2] == [(2, 600), (4, 600), (3, 600), (3, 1200), (3, 2400)]
    growth = [
        (row["method"], row["grows"], row["times"], row["to_linear"])
        for row in rows
    ]  # fmt: skip
    assert growth == [
        ("linear", "gaps", 1.0, 1.0),
        ("linear", "gaps", 3.0, 1.5),
        ("linear", "frames", 1.0, 1.0),
        ("linear", "frames", 1.2, 0.6),
        ("linear", "frames", 4.0, 1.0),
        ("cubic", "gaps", 1.0, 1.0),
        ("cubic", "gaps", 2.0, 1.0),
        ("cubic", "frames", 1.0, 1.0),
        ("cubic", "frames", 1.0, 0.5),
        ("cubic", "frames", 4.0, 1.0),
    ]
    assert {row["left_open"] for row in rows} == {1}


def test_the_recording_whose_cost_is_measured() -> None:
    walk = scaling.bundled_walk()
    long = scaling.tiled(walk, 1000)
    step = np.abs(np.diff(long.points, axis=0)).max()
    assert step < np.abs(np.diff(walk.points, axis=0)).max() + 10 * scaling.JITTER_MM
    assert not np.array_equal(long.points[:300], long.points[684:984])
    gaps = find_gaps(scaling.with_gaps(long, 12).present)
    assert len(gaps) == 12
    assert {gap.length for gap in gaps} == {60}
    assert {gap.kind(1000) for gap in gaps} == {"interior"}
    ordered = sorted(gaps, key=lambda gap: gap.start)
    assert all(one.stop < two.start for one, two in pairwise(ordered))
