"""`mocapmend repair`: what it writes, what it refuses, and what it says about both."""

import re
import warnings
from collections.abc import Callable
from pathlib import Path
from typing import Any

import c3d
import numpy as np
import pytest
from c3d_synthetic import Synthetic, encode
from recording_samples import digest

from mocapmend.cli import main
from mocapmend.files import read_c3d
from mocapmend_algorithms import find_gaps
from mocapmend_algorithms.fill.limits import INTERPOLATIONS
from mocapmend_algorithms.fill.registry import METHODS

Json = Callable[..., tuple[int, Any]]


def slots(path: Path) -> np.ndarray:
    """Read coordinates and residuals with the independent library, shape (frames, points, 5)."""
    with path.open("rb") as stream, warnings.catch_warnings():
        warnings.simplefilter("ignore")
        return np.array([points for _, points, _ in c3d.Reader(stream).read_frames()])


# --- what is written -----------------------------------------------------------------------------


QUICK = {
    "bone-dictionary": ["--param", "atoms=20"],
    "smbs": ["--param", "atoms=20"],
    "pose-code": ["--param", "poses=50"],
    "tsmc": ["--param", "around_s=1"],
}
"""Parameters that make slow methods quick."""
WAYS = [(method, ["--max-error", "inf"]) for method in METHODS]
WAYS += [(method, []) for method in METHODS if method not in QUICK]


@pytest.mark.parametrize(("method", "limit"), WAYS)
def test_repair_changes_what_it_says_and_check_proves_it(
    run_json: Json, samples: Path, out: Path, method: str, limit: list[str]
) -> None:
    source = samples / "gait_plug_in_gait.c3d"
    quick = QUICK.get(method, [])
    code, done = run_json("repair", source, "-o", out, "--method", method, *quick, *limit)
    assert code == 0
    assert done["method"] == method
    recording = read_c3d(source).recording
    gaps = find_gaps(recording.present)
    assert [
        (row["marker_index"], row["first_frame"], row["last_frame"]) for row in done["gaps"]
    ] == [(gap.marker, 725 + gap.start, 725 + gap.stop - 1) for gap in gaps]
    assert all(row["marker"] == recording.labels[row["marker_index"]] for row in done["gaps"])
    after = read_c3d(out).recording
    for row, gap in zip(done["gaps"], gaps, strict=True):
        assert after.present[gap.start : gap.stop, gap.marker].all() == row["filled"]
        assert row["filled"] == (row["reason"] is None) == (row["method"] == method)
        if limit and gap.kind(recording.frames) == "interior":
            assert row["filled"] or re.search("needs|no other cycle", row["reason"])
        elif not limit and row["filled"] and method in INTERPOLATIONS:
            assert gap.length <= 20
        if not limit and row["filled"] and row["expected_error_mm"] is not None:
            assert row["expected_error_mm"] <= 20
    code, proof = run_json("check", source, out)
    assert code == 0
    assert proof["passed"]
    assert proof["changed_samples"] == done["totals"]["samples_filled"]
    assert {k: proof[k] for k in done["check"]} == done["check"]
    assert done["totals"]["samples_missing_after"] == int(np.count_nonzero(~after.present))


def test_an_independent_reader_sees_nothing_else_changed(
    run_json: Json, samples: Path, out: Path
) -> None:
    source = samples / "sprint_basketball.c3d"
    _, done = run_json("repair", source, "-o", out, "--method", "cubic")
    before, after = slots(source), slots(out)
    changed = (before != after).any(axis=2)
    first = 0
    expected = np.zeros_like(changed)
    for row in done["gaps"]:
        if row["filled"]:
            rows = slice(row["first_frame"] - first, row["last_frame"] - first + 1)
            expected[rows, row["marker_index"]] = True
    assert np.array_equal(changed, expected)
    assert (after[..., 3][changed] == 0).all()


@pytest.mark.parametrize("name", ["gait_plug_in_gait", "sprint_basketball", "walk_cmu_02_01"])
def test_max_gap_0_copies_byte_for_byte(
    run_json: Json, samples: Path, out: Path, name: str
) -> None:
    source = samples / f"{name}.c3d"
    code, done = run_json("repair", source, "-o", out, "--max-gap", "0")
    assert code == 0
    assert digest(source) == digest(out)
    assert done["totals"]["filled"] == 0
    assert done["totals"]["left_open"] == len(done["gaps"])
    assert all(row["reason"] for row in done["gaps"])
    assert done["check"]["identical"]


def test_the_same_command_makes_the_same_bytes(samples: Path, tmp_path: Path) -> None:
    made = []
    for name in ("a", "b"):
        c3d_out, html = tmp_path / f"{name}.c3d", tmp_path / f"{name}.html"
        source = str(samples / "gait_plug_in_gait.c3d")
        assert main(["repair", source, "-o", str(c3d_out), "--report", str(html)]) == 0
        made.append((digest(c3d_out), digest(html)))
    assert made[0] == made[1]


# --- odd recordings ------------------------------------------------------------------------------


def test_a_truncated_file_is_saved_only_if_accepted(
    run_json: Json, samples: Path, out: Path, tmp_path: Path
) -> None:
    whole = (samples / "sprint_basketball.c3d").read_bytes()
    path = tmp_path / "truncated.c3d"
    path.write_bytes(whole[: len(whole) // 3])
    words = ["repair", path, "-o", out, "--method", "cubic"]
    code, document = run_json(*words)
    assert code == 1
    assert "--accept-truncated" in document["error"]["todo"]
    assert not out.exists()
    code, done = run_json(*words, "--accept-truncated")
    assert code == 0
    assert done["truncated"]
    assert (out.stat().st_size - path.stat().st_size) % 512 == 0
    assert read_c3d(out).layout.frames == read_c3d(path).layout.frames
    assert run_json("check", path, out)[0] == 0


def test_nothing_to_repair_without_markers(run_json: Json, out: Path, tmp_path: Path) -> None:
    path = tmp_path / "analog.c3d"
    analog = np.arange(400.0).reshape(20, 10, 2)
    path.write_bytes(encode(Synthetic(np.zeros((20, 0, 3)), analog=analog)))
    code, document = run_json("repair", path, "-o", out)
    assert code == 1
    assert "nothing to repair" in document["error"]["what"]
    assert not out.exists()


def test_check_finds_what_is_not_a_repair(
    run_json: Json, capsys: pytest.CaptureFixture[str], samples: Path, out: Path
) -> None:
    source = samples / "gait_plug_in_gait.c3d"
    raw = bytearray(source.read_bytes())
    raw[-600] ^= 1
    out.write_bytes(raw)
    code, proof = run_json("check", source, out)
    assert code == 1
    assert not proof["passed"]
    assert proof["other_differences"]
    assert main(["check", str(source), str(out)]) == 1
    printed = capsys.readouterr()
    assert "failed" in printed.out
    assert proof["other_differences"][0] in printed.err


# --- what people read ----------------------------------------------------------------------------


def test_people_read_what_was_done_and_what_was_not(
    capsys: pytest.CaptureFixture[str], holed: Path, out: Path, tmp_path: Path
) -> None:
    html = tmp_path / "report.html"
    files = ["-o", str(out), "--report", str(html)]
    assert main(["repair", str(holed), *files, "--method", "cubic"]) == 0
    printed = capsys.readouterr()
    assert "label of another point" in printed.err
    assert printed.err.count("\n") == 1
    for part in (
        str(out), str(html), "cubic", "default guard", "1 of 3 gaps", "5 samples",
        "2 gaps left open", "47-76", "7-10", "Check passed", "--max-error",
    ):  # fmt: skip
        assert part in printed.out, part
    page = html.read_text("utf-8")
    assert "holed.c3d" in page
    assert str(tmp_path) not in page
    assert "default guard" in page
    assert "47 – 76" in page


def test_a_long_list_of_open_gaps_is_cut_and_says_so(
    capsys: pytest.CaptureFixture[str], samples: Path, out: Path
) -> None:
    source = samples / "sprint_basketball.c3d"
    assert main(["repair", str(source), "-o", str(out), "--max-gap", "0"]) == 0
    printed = capsys.readouterr().out
    assert "803 gaps left open" in printed
    assert "and 783 more" in printed
    assert len(printed.splitlines()) < 40
