"""The commands on recordings of every format, and `mocapmend convert`."""

from collections.abc import Callable
from pathlib import Path
from typing import Any

import numpy as np
import pytest
from c3d_synthetic import Synthetic, encode, walk
from recording_samples import SOURCES, TARGETS, digest, repair, write_sample

from mocapmend.cli import main
from mocapmend.cli.dispatch import COMMANDS
from mocapmend.files import read_c3d, read_recording
from mocapmend.files.sidecar import sidecar_path

Json = Callable[..., tuple[int, Any]]
IMPORTED = [kind for kind in SOURCES if kind != "c3d"]
ALL = ("--max-error", "inf")


def content(folder: Path) -> dict[str, bytes]:
    return {path.name: path.read_bytes() for path in folder.iterdir()}


# --- info, gaps, repair, replay, check -----------------------------------------------------------


@pytest.mark.parametrize("kind", SOURCES)
def test_info_and_gaps(run_json: Json, kind: str, tmp_path: Path) -> None:
    path = write_sample(tmp_path, kind)
    source = read_recording(path)
    code, info = run_json("info", path)
    assert code == 0
    assert info["format"] == source.kind
    assert (info["processor"] is None) == (info["number_format"] is None) == (kind != "c3d")
    assert (info["unit"], info["up_axis"]) == (source.recording.unit, source.recording.up)
    assert info["skeleton"]["source"] == "file" or not source.bones
    code, listed = run_json("gaps", path)
    assert code == 0
    lengths = [gap["length_frames"] for gap in listed["gaps"]]
    assert lengths == [5, 10]
    assert [gap["first_frame"] - info["first_frame"] for gap in listed["gaps"]] == [10, 20]


@pytest.mark.parametrize("target", TARGETS)
@pytest.mark.parametrize("kind", SOURCES)
def test_repair_and_replay(run_json: Json, kind: str, target: str, tmp_path: Path) -> None:
    path = write_sample(tmp_path, kind)
    out, again, recipe = (tmp_path / f"{name}.{target}" for name in ("out", "again", "recipe.json"))
    code, done = run_json("repair", path, "-o", out, "--recipe", recipe, *ALL)
    assert code == 0
    assert (done["totals"]["filled"], done["totals"]["samples_missing_after"]) == (2, 0)
    assert (done["check"] is not None) == (kind == target == "c3d")
    assert done["repair_record"] == {
        "place": "group" if target == "c3d" else "sidecar",
        "file": None if target == "c3d" else str(sidecar_path(out)),
    }
    assert len(read_recording(out).repairs) == 2
    code, made = run_json("replay", recipe, path, "-o", again)
    assert code == 0
    assert (made["same_input"], made["filled"], made["reopened"]) == (True, 2, 0)
    assert made["repair_record"]["place"] == done["repair_record"]["place"]
    first, second = (read_recording(file).recording.points for file in (out, again))
    np.testing.assert_array_equal(first, second)
    assert target == "trc" or digest(out) == digest(again)
    code, info = run_json("info", out)
    assert [row["method"] for row in info["repairs"]] == ["auto", "auto"]
    assert [row["donors"] for row in info["repairs"]] == [row["donors"] for row in done["gaps"]]


@pytest.mark.parametrize("kind", IMPORTED)
def test_check_says_that_it_compares_c3d_files(
    run_json: Json, capsys: pytest.CaptureFixture[str], kind: str, tmp_path: Path
) -> None:
    path, out = write_sample(tmp_path, kind), tmp_path / "out.c3d"
    repair(path, out)
    code, document = run_json("check", path, out)
    assert code == 1
    assert document["error"]["where"] == str(path)
    assert "C3D" in document["error"]["what"]
    assert main(["check", str(path), str(out)]) == 1
    assert capsys.readouterr().err.count("\n") == 1


@pytest.mark.parametrize("kind", ["trc", "csv", "npz"])
@pytest.mark.parametrize("command", ["repair", "convert", "replay"])
def test_the_recording_is_not_replaced_by_mistake(
    run_json: Json, kind: str, command: str, tmp_path: Path
) -> None:
    path, recipe = write_sample(tmp_path, kind), tmp_path / "recipe.json"
    assert run_json("repair", path, "-o", tmp_path / "o.npz", "--recipe", recipe)[0] == 0
    before = content(tmp_path)
    first = [recipe, path] if command == "replay" else [path]
    code, document = run_json(command, *first, "-o", path, "--overwrite")
    assert code == 1
    assert document["error"]["what"] == "This is the recording itself."
    assert ("--in-place" in document["error"]["todo"]) == (command != "convert")
    assert content(tmp_path) == before


@pytest.mark.parametrize("kind", ["c3d", "trc", "csv", "npz"])
def test_in_place(run_json: Json, kind: str, tmp_path: Path) -> None:
    path = write_sample(tmp_path, kind)
    original = digest(path)
    code, done = run_json("repair", path, "--in-place", *ALL)
    assert code == 0
    assert done["output"] == str(path)
    back = read_recording(path)
    assert back.recording.present.all()
    assert back.provenance is not None
    assert back.provenance.inputs == (original,)


@pytest.mark.parametrize("kind", ["bvh", "amc", "tsv"])
def test_what_cannot_be_written_cannot_be_replaced(
    run_json: Json, kind: str, tmp_path: Path
) -> None:
    path = write_sample(tmp_path, kind)
    before = content(tmp_path)
    code, document = run_json("repair", path, "--in-place")
    assert code == 1
    assert f"end in .{kind} cannot be written" in document["error"]["what"]
    assert content(tmp_path) == before


@pytest.mark.parametrize("command", ["repair", "convert"])
@pytest.mark.parametrize("name", ["out.xlsx", "out", "out.bvh"])
def test_other_endings_are_refused_before_anything_is_filled(
    run_json: Json, monkeypatch: pytest.MonkeyPatch, command: str, name: str, tmp_path: Path
) -> None:
    monkeypatch.setattr("mocapmend.engine.fill", pytest.fail)
    path = write_sample(tmp_path, "trc")
    code, document = run_json(command, path, "-o", tmp_path / name)
    assert code == 1
    assert document["error"]["where"] == str(tmp_path / name)
    assert ".c3d" in document["error"]["todo"]


# --- convert -------------------------------------------------------------------------------------


@pytest.mark.parametrize("target", TARGETS)
@pytest.mark.parametrize("kind", SOURCES)
def test_convert(run_json: Json, kind: str, target: str, tmp_path: Path) -> None:
    path, out = write_sample(tmp_path, kind), tmp_path / f"out.{target}"
    code, done = run_json("convert", path, "-o", out)
    assert code == 0
    source, back = read_recording(path), read_recording(out)
    assert (done["format"], done["output"]) == (source.kind, str(out))
    assert done["repair_record"] == {"place": None, "file": None}
    points = source.recording.points * (source.recording.mm / back.recording.mm)
    np.testing.assert_allclose(back.recording.points, points, rtol=1e-6)
    assert back.recording.labels == source.recording.labels
    assert not back.repairs
    assert bool(done["notes"]) == any("without" in note for note in done["notes"])


@pytest.mark.parametrize("repaired", [False, True])
def test_a_c3d_as_a_c3d_is_a_copy(run_json: Json, tmp_path: Path, *, repaired: bool) -> None:
    path, out = write_sample(tmp_path, "c3d"), tmp_path / "out.c3d"
    if repaired:
        repair(path, tmp_path / "repaired.c3d")
        path = tmp_path / "repaired.c3d"
    code, done = run_json("convert", path, "-o", out)
    assert code == 0
    assert done["check"]["identical"]
    assert digest(out) == digest(path)
    assert read_c3d(out).repairs == read_c3d(path).repairs


def test_convert_takes_the_repair_record_along(run_json: Json, tmp_path: Path) -> None:
    path, out = tmp_path / "repaired.trc", tmp_path / "out.c3d"
    source = repair(write_sample(tmp_path, "c3d"), path)
    code, done = run_json("convert", path, "-o", out)
    assert code == 0
    assert done["repair_record"]["place"] == "group"
    np.testing.assert_array_equal(read_c3d(out).measured.present, source.recording.present)


def test_people_read_what_is_lost(capsys: pytest.CaptureFixture[str], tmp_path: Path) -> None:
    path, out = write_sample(tmp_path, "c3d"), tmp_path / "out.trc"
    assert main(["convert", str(path), "-o", str(out)]) == 0
    lines = capsys.readouterr().out.splitlines()
    assert lines[0] == f"Converted: {out}"
    assert any("without analog data, model outputs" in line for line in lines)


def test_convert_keeps_existing_files(run_json: Json, tmp_path: Path) -> None:
    path, out = write_sample(tmp_path, "csv"), tmp_path / "out.trc"
    out.write_text("precious")
    code, document = run_json("convert", path, "-o", out)
    assert code == 1
    assert "--overwrite" in document["error"]["todo"]
    assert out.read_text() == "precious"
    assert run_json("convert", path, "-o", out, "--overwrite")[0] == 0
    assert read_recording(out).kind == "TRC"


def test_convert_needs_a_name(capsys: pytest.CaptureFixture[str], tmp_path: Path) -> None:
    path = write_sample(tmp_path, "csv")
    for more in ([], ["--in-place"]):
        with pytest.raises(SystemExit) as stopped:
            main(["convert", str(path), *more])
        assert stopped.value.code == 2
        assert "--in-place to" not in capsys.readouterr().err


def test_a_truncated_recording_is_converted_only_if_accepted(
    run_json: Json, tmp_path: Path
) -> None:
    path, out = write_sample(tmp_path, "trc"), tmp_path / "out.c3d"
    path.write_bytes(path.read_bytes()[:-800])
    code, document = run_json("convert", path, "-o", out)
    assert code == 1
    assert "--accept-truncated" in document["error"]["todo"]
    assert not out.exists()
    code, done = run_json("convert", path, "-o", out, "--accept-truncated")
    assert code == 0
    assert done["truncated"]


@pytest.mark.parametrize("target", TARGETS)
def test_a_recording_without_markers(run_json: Json, target: str, tmp_path: Path) -> None:
    path, out = tmp_path / "analog.c3d", tmp_path / f"out.{target}"
    path.write_bytes(encode(Synthetic(np.zeros((20, 0, 3)), analog=np.ones((20, 10, 2)))))
    code, document = run_json("convert", path, "-o", out)
    if target == "c3d":
        assert code == 0
        assert digest(out) == digest(path)
    else:
        assert code == 1
        assert "no markers" in document["error"]["what"]
        assert document["error"]["where"] == str(path)
        assert not out.exists()


# --- what people read ----------------------------------------------------------------------------


@pytest.mark.parametrize("target", ["c3d", "trc"])
def test_info_lists_the_repairs(
    capsys: pytest.CaptureFixture[str], target: str, tmp_path: Path
) -> None:
    path, out = write_sample(tmp_path, "csv"), tmp_path / f"out.{target}"
    assert main(["repair", str(path), "-o", str(out), "--markers", "B", *ALL]) == 0
    capsys.readouterr()
    assert main(["info", str(out)]) == 0
    lines = capsys.readouterr().out.splitlines()
    at = next(i for i, line in enumerate(lines) if line.startswith("Repaired marker"))
    assert lines[at].split("  ")[-1] == "Expected error (mm)"
    cells = lines[at + 1].split()
    assert cells[:4] == ["B", "61-65", "5", "auto"]
    assert float(cells[4]) == pytest.approx(read_recording(out).repairs[0].expected_error_mm, 0.1)
    assert lines[at + 2 :] == []


def test_a_long_list_of_repairs_is_cut_and_says_so(
    capsys: pytest.CaptureFixture[str], tmp_path: Path
) -> None:
    points = walk(101, 2)
    points[1:100:2, 0] = np.nan
    np.savez(tmp_path / "walk.npz", pos=points, fps=100.0)
    repair(tmp_path / "walk.npz", tmp_path / "out.npz")
    assert main(["info", str(tmp_path / "out.npz")]) == 0
    lines = capsys.readouterr().out.splitlines()
    assert lines[-1] == "and 30 more: --json lists them all."
    assert sum("linear" in line for line in lines) == 20


@pytest.mark.parametrize("command", [name for name in COMMANDS if name not in {"check", "bench"}])
def test_the_help_does_not_ask_for_a_c3d_file(
    capsys: pytest.CaptureFixture[str], command: str
) -> None:
    with pytest.raises(SystemExit):
        main([command, "--help"])
    assert "a C3D file\n" not in capsys.readouterr().out
