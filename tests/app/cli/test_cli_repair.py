"""`mocapmend repair`: what it writes, what it refuses, and what it says about both."""

import hashlib
import os
import re
import warnings
from collections.abc import Callable
from pathlib import Path
from typing import Any

import c3d
import numpy as np
import pytest
from c3d_synthetic import Synthetic, encode, walk

from mocapmend.cli import main, target
from mocapmend.files import read_c3d
from mocapmend_algorithms import find_gaps
from mocapmend_algorithms.fill.limits import INTERPOLATIONS
from mocapmend_algorithms.fill.registry import METHODS

Json = Callable[..., tuple[int, Any]]


@pytest.fixture
def out(tmp_path: Path) -> Path:
    """Return where the repaired file shall go."""
    return tmp_path / "out.c3d"


@pytest.fixture
def holed(tmp_path: Path) -> Path:
    """Write a recording at 100 Hz with gaps of 5, 30 and (leading) 4 frames; first frame 7."""
    points = walk(frames=120)
    fourth = np.zeros(points.shape[:2])
    for rows, marker in ((slice(10, 15), 0), (slice(40, 70), 0), (slice(0, 4), 2)):
        fourth[rows, marker] = -1
        points[rows, marker] = 0
    labels = ["A", "B,C", "D", "A", "E"]
    path = tmp_path / "holed.c3d"
    path.write_bytes(encode(Synthetic(points, fourth=fourth, labels=labels, first_frame=7)))
    return path


def digest(path: Path) -> str:
    return hashlib.sha256(path.read_bytes()).hexdigest()


def slots(path: Path) -> np.ndarray:
    """Read coordinates and residuals with the independent library, shape (frames, points, 5)."""
    with path.open("rb") as stream, warnings.catch_warnings():
        warnings.simplefilter("ignore")
        return np.array([points for _, points, _ in c3d.Reader(stream).read_frames()])


# --- what is written -----------------------------------------------------------------------------


@pytest.mark.parametrize("method", METHODS)
@pytest.mark.parametrize("limit", [[], ["--max-error", "inf"]])
def test_repair_changes_what_it_says_and_check_proves_it(
    run_json: Json, samples: Path, out: Path, method: str, limit: list[str]
) -> None:
    source = samples / "gait_plug_in_gait.c3d"
    code, done = run_json("repair", source, "-o", out, "--method", method, *limit)
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


# --- limits, methods, markers --------------------------------------------------------------------


def filled(document: dict[str, Any]) -> list[tuple[int, int]]:
    return [(row["marker_index"], row["first_frame"]) for row in document["gaps"] if row["filled"]]


@pytest.mark.parametrize(
    ("arguments", "expected", "limits"),
    [
        (["--max-gap", "3"], [], (False, 3, None)),
        (["--max-gap", "29"], [(0, 17), (2, 7)], (False, 29, None)),
        (["--max-gap", "30"], [(0, 17), (0, 47), (2, 7)], (False, 30, None)),
        (["--max-error", "inf"], [(0, 17), (0, 47), (2, 7)], (False, None, None)),
        (["--max-error", "0"], [], (False, None, 0)),
        (["--max-error", "inf", "--max-gap", "9"], [(0, 17), (2, 7)], (False, 9, None)),
        (["--method", "cubic"], [(0, 17)], (True, 20, 20)),
        (["--method", "kalman", "--max-error", "inf"], [(0, 17), (0, 47)], (False, None, None)),
    ],
)
def test_limits(
    run_json: Json,
    holed: Path,
    out: Path,
    arguments: list[str],
    expected: list[tuple[int, int]],
    limits: tuple[bool, int | None, float | None],
) -> None:
    code, done = run_json("repair", holed, "-o", out, *arguments)
    assert code == 0
    assert filled(done) == expected
    assert tuple(done["limits"].values()) == limits
    assert len(done["gaps"]) == 3


def test_without_limits_the_expected_error_decides(
    run_json: Json, samples: Path, out: Path, tmp_path: Path
) -> None:
    source = samples / "gait_plug_in_gait.c3d"
    code, done = run_json("repair", source, "-o", out)
    assert code == 0
    assert done["method"] == "auto"
    assert done["limits"] == {"default_guard": True, "max_gap_frames": None, "max_error_mm": 20}
    every = tmp_path / "every.c3d"
    _, whole = run_json("repair", source, "-o", every, "--max-error", "inf")
    for row, unguarded in zip(done["gaps"], whole["gaps"], strict=True):
        error = unguarded["expected_error_mm"]
        if error is None:
            assert not row["filled"] or row["last_frame"] - row["first_frame"] < 20
        else:
            assert row["filled"] == (error <= 20)
    assert 0 < done["totals"]["filled"] < whole["totals"]["filled"]


def test_samples_are_reported_on_request(run_json: Json, holed: Path, out: Path) -> None:
    limit = ["--max-error", "inf"]
    _, done = run_json("repair", holed, "-o", out, *limit, "--samples")
    for row in done["gaps"]:
        if row["filled"]:
            samples = row["r90_samples_mm"]
            assert len(samples) == row["last_frame"] - row["first_frame"] + 1
            assert row["r90_mm"] == pytest.approx(np.median(samples))
            assert row["expected_error_mm"] > 0
        else:
            assert row["r90_samples_mm"] is None
    _, done = run_json("repair", holed, "-o", out, *limit, "--overwrite")
    assert all("r90_samples_mm" not in row for row in done["gaps"])


def test_lengths_are_in_millimetres_whatever_the_file_has(
    run_json: Json, holed: Path, out: Path, tmp_path: Path
) -> None:
    recording = read_c3d(holed).recording
    points = np.nan_to_num(recording.points) / 1000
    metres = tmp_path / "metres.c3d"
    metres.write_bytes(
        encode(
            Synthetic(
                points,
                fourth=np.where(recording.present, 0.0, -1.0),
                parameters={"POINT:UNITS": "m"},
                labels=list(recording.labels),
                first_frame=7,
            )
        )
    )
    _, small = run_json("repair", holed, "-o", out)
    _, large = run_json("repair", metres, "-o", out, "--overwrite")
    assert small["gaps"][0]["filled"]
    for key in ("expected_error_mm", "r90_mm"):
        assert large["gaps"][0][key] == pytest.approx(small["gaps"][0][key], rel=1e-3)


def test_parameters_reach_the_method(run_json: Json, holed: Path, out: Path) -> None:
    arguments = ["--method", "kalman", "--param", "direction=causal", "--param", "noise_mm=2"]
    _, done = run_json("repair", holed, "-o", out, *arguments)
    assert done["parameters"]["direction"] == "causal"
    assert done["parameters"]["noise_mm"] == 2
    assert done["parameters"]["velocity_interval_ms"] is None


def test_donors_are_reported_in_the_order_of_use(run_json: Json, samples: Path, out: Path) -> None:
    source = samples / "gait_plug_in_gait.c3d"
    _, done = run_json("repair", source, "-o", out, "--max-error", "inf")
    recording = read_c3d(source).recording
    filled = [row for row in done["gaps"] if row["filled"]]
    assert any(row["donors"] for row in filled)
    for row in done["gaps"]:
        assert row["marker"] not in row["donors"]
        assert set(row["donors"]) <= set(recording.labels)
        assert row["filled"] or not row["donors"]
    records = read_c3d(out).repairs
    assert [list(record.donors) for record in records] == [row["donors"] for row in filled]
    _, info = run_json("info", out)
    assert [row["donors"] for row in info["repairs"]] == [row["donors"] for row in filled]


@pytest.mark.parametrize("method", ["auto", "rigid", "pattern", "local-frame"])
def test_donors_are_picked_by_hand(run_json: Json, holed: Path, out: Path, method: str) -> None:
    words = ["--method", method, "--max-error", "inf", "--markers", "A"]
    donors = ["--param", 'donors=E, D,"B,C"']
    code, done = run_json("repair", holed, "-o", out, *words, *donors)
    assert code == 0
    assert done["parameters"]["donors"] == ["E", "D", "B,C"]
    filled = [row for row in done["gaps"] if row["filled"]]
    assert len(filled) == 2
    assert all(row["donors"] and {*row["donors"]} <= {"E", "D", "B,C"} for row in filled)
    assert [record.parameters["donors"] for record in read_c3d(out).repairs] == [
        ("E", "D", "B,C")
    ] * 2
    other = out.with_name("other.c3d")
    run_json("repair", holed, "-o", other, *words, "--param", 'donors=E,D,"B,C"')
    assert digest(other) == digest(out)


def test_an_unknown_donor_is_refused(run_json: Json, holed: Path, out: Path) -> None:
    code, document = run_json("repair", holed, "-o", out, "--param", "donors=E,Z")
    assert code == 1
    assert "'Z'" in document["error"]["what"]
    assert "B,C, D" in document["error"]["todo"]
    assert not out.exists()


def test_people_read_which_donors_were_picked(
    capsys: pytest.CaptureFixture[str], holed: Path, out: Path
) -> None:
    picked = 'donors=D,"B,C"'
    assert main(["repair", str(holed), "-o", str(out), "--param", picked]) == 0
    assert 'auto (donors=D, "B,C")' in capsys.readouterr().out


def test_unknown_method_lists_the_ids(capsys: pytest.CaptureFixture[str]) -> None:
    with pytest.raises(SystemExit):
        main(["repair", "a.c3d", "-o", "b.c3d", "--method", "magic"])
    printed = capsys.readouterr().err
    assert all(method in printed for method in METHODS)


@pytest.mark.parametrize(
    ("words", "chosen"),
    [(["A"], {0, 3}), (["B,C"], {1}), (["D", "E"], {2, 4}), (["A,D"], {0, 2, 3}), (["D,"], {2})],
)
def test_markers_are_chosen_by_label(
    run_json: Json, holed: Path, out: Path, words: list[str], chosen: set[int]
) -> None:
    arguments = ["--max-error", "inf", "--markers", *words]
    code, done = run_json("repair", holed, "-o", out, *arguments)
    assert code == 0
    assert len(done["gaps"]) == 3
    for row in done["gaps"]:
        asked = row["marker_index"] in chosen
        assert asked or not row["filled"]
        assert asked != (row["reason"] == "the marker is not among those asked for")


def test_an_unknown_marker_lists_the_known_ones(run_json: Json, holed: Path, out: Path) -> None:
    code, document = run_json("repair", holed, "-o", out, "--markers", "A,Z")
    assert code == 1
    assert "'Z'" in document["error"]["what"]
    assert "B,C, D" in document["error"]["todo"]
    assert not out.exists()


# --- where it may write --------------------------------------------------------------------------


def aliases(source: Path, folder: Path, kind: str) -> Path:
    """Return another name of a file."""
    if kind == "same":
        return source
    if kind == "relative":
        return Path(os.path.relpath(source))
    link = folder / "link.c3d"
    if kind == "symlink":
        link.symlink_to(source)
    elif kind == "hard link":
        link.hardlink_to(source)
    else:
        (folder / "sub").symlink_to(folder)
        return folder / "sub" / source.name
    return link


@pytest.mark.parametrize("kind", ["same", "relative", "symlink", "hard link", "linked folder"])
@pytest.mark.parametrize("option", ["-o", "--report"])
def test_the_source_is_never_replaced_by_mistake(
    run_json: Json, holed: Path, out: Path, tmp_path: Path, kind: str, option: str
) -> None:
    before = holed.read_bytes()
    name = aliases(holed, tmp_path, kind)
    arguments = ["-o", name] if option == "-o" else ["-o", out, "--report", name]
    code, document = run_json("repair", holed, *arguments, "--overwrite")
    assert code == 1
    assert document["error"]["where"] == str(name)
    assert document["error"]["todo"]
    assert holed.read_bytes() == before
    assert not out.exists()


def test_the_report_does_not_replace_the_repaired_file(
    run_json: Json, holed: Path, out: Path
) -> None:
    code, _ = run_json("repair", holed, "-o", out, "--report", out, "--overwrite")
    assert code == 1
    assert not out.exists()


@pytest.mark.parametrize("name", ["out.c3d", "report.html"])
def test_existing_files_are_kept_without_overwrite(
    run_json: Json, holed: Path, out: Path, tmp_path: Path, name: str
) -> None:
    html = tmp_path / "report.html"
    (tmp_path / name).write_text("precious")
    code, document = run_json("repair", holed, "-o", out, "--report", html)
    assert code == 1
    assert "--overwrite" in document["error"]["todo"]
    assert (tmp_path / name).read_text() == "precious"
    assert sorted(path.name for path in tmp_path.iterdir()) == sorted(["holed.c3d", name])
    code, _ = run_json("repair", holed, "-o", out, "--report", html, "--overwrite")
    assert code == 0
    assert b"precious" not in (tmp_path / name).read_bytes()


@pytest.mark.parametrize("through", ["same", "symlink"])
@pytest.mark.parametrize("named", [False, True])
def test_in_place_replaces_the_recording(
    run_json: Json, holed: Path, tmp_path: Path, through: str, *, named: bool
) -> None:
    original = tmp_path / "original.c3d"
    original.write_bytes(holed.read_bytes())
    given = aliases(holed, tmp_path, through)
    code, done = run_json("repair", given, *(["-o", holed] if named else []), "--in-place")
    assert code == 0
    assert done["check"]["passed"]
    assert not holed.is_symlink()
    assert given.resolve() == holed.resolve()
    code, proof = run_json("check", original, holed)
    assert (code, proof["changed_samples"]) == (0, done["totals"]["samples_filled"])
    assert proof["changed_samples"] > 0


@pytest.mark.skipif(not hasattr(os, "mkfifo"), reason="no named pipes here")
def test_a_pipe_is_not_replaced(run_json: Json, holed: Path, tmp_path: Path) -> None:
    pipe, out = tmp_path / "pipe", tmp_path / "out.c3d"
    os.mkfifo(pipe)
    for arguments in (("-o", pipe), ("-o", out, "--report", pipe)):
        code, document = run_json("repair", holed, *arguments, "--overwrite")
        assert code == 1
        assert "device" in document["error"]["what"]
    assert pipe.is_fifo()


@pytest.mark.parametrize("words", ["", ",", " , "])
def test_markers_that_name_none_are_wrong_usage(
    run_json: Json, holed: Path, out: Path, words: str
) -> None:
    with pytest.raises(SystemExit) as stopped:
        run_json("repair", holed, "-o", out, "--markers", words)
    assert stopped.value.code == 2
    assert not out.exists()


def test_folders_and_missing_folders(run_json: Json, holed: Path, tmp_path: Path) -> None:
    for name in (tmp_path, tmp_path / "nowhere" / "out.c3d"):
        code, document = run_json("repair", holed, "-o", name)
        assert code == 1
        assert document["error"]["todo"]
    assert [path.name for path in tmp_path.iterdir()] == ["holed.c3d"]


def test_a_folder_that_may_not_be_written(
    run_json: Json, holed: Path, out: Path, monkeypatch: pytest.MonkeyPatch
) -> None:
    monkeypatch.setattr(target.os, "access", lambda *_: False)
    code, document = run_json("repair", holed, "-o", out)
    assert code == 1
    assert document["error"]["where"] == str(out.parent)


@pytest.mark.skipif(
    getattr(os, "geteuid", lambda: 0)() == 0, reason="the superuser may write everywhere"
)
def test_a_folder_that_is_read_only(run_json: Json, holed: Path, tmp_path: Path) -> None:
    folder = tmp_path / "closed"
    folder.mkdir()
    folder.chmod(0o500)
    try:
        code, _ = run_json("repair", holed, "-o", folder / "out.c3d")
        assert code == 1
        assert list(folder.iterdir()) == []
    finally:
        folder.chmod(0o700)


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
