"""`mocapmend repair`: limits, methods, parameters, donors and markers that the user chooses."""

from collections.abc import Callable
from pathlib import Path
from typing import Any

import numpy as np
import pytest
from c3d_synthetic import Synthetic, encode
from recording_samples import digest

from mocapmend.cli import main
from mocapmend.files import read_c3d
from mocapmend_algorithms.fill.registry import METHODS

Json = Callable[..., tuple[int, Any]]


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
