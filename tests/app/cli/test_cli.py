"""The command line: exit codes, clean streams, and JSON that keeps to its schema."""

import json
import os
import signal
import subprocess
import sys
from collections.abc import Callable
from pathlib import Path
from types import ModuleType
from typing import Any

import numpy as np
import pytest
from c3d_synthetic import Synthetic, encode, walk
from jsonschema import Draft202012Validator

from mocapmend import __version__, engine
from mocapmend.cli import console, main
from mocapmend.cli.dispatch import COMMANDS

RECORDINGS = ("gait_plug_in_gait", "sprint_basketball", "walk_cmu_02_01")

Json = Callable[..., tuple[int, Any]]


def bad_files(folder: Path, sample: Path) -> dict[str, Path]:
    """Make files that hold no recording."""
    made = {name: folder / f"{name}.c3d" for name in ("empty", "text", "cut", "folder")}
    made["empty"].write_bytes(b"")
    made["text"].write_text("frame,x,y,z\n" * 500)
    made["cut"].write_bytes(sample.read_bytes()[:700])
    made["folder"].mkdir()
    made["missing"] = folder / "missing.c3d"
    return made


@pytest.fixture
def pointless(tmp_path: Path) -> Path:
    """Write a recording of analog data alone."""
    analog = np.arange(400.0).reshape(20, 10, 2)
    path = tmp_path / "analog.c3d"
    path.write_bytes(encode(Synthetic(np.zeros((20, 0, 3)), analog=analog)))
    return path


# --- the schema ----------------------------------------------------------------------------------


def test_the_schema_is_one_and_strict(validator: Draft202012Validator) -> None:
    Draft202012Validator.check_schema(validator.schema)
    assert {ref["$ref"].rsplit("/", 1)[1] for ref in validator.schema["oneOf"]} == {
        *COMMANDS, "error", "version",
    }  # fmt: skip
    for document in ({}, {"schema": 1}, {"schema": 1, "command": "info"}):
        assert not validator.is_valid(document)
    error = {"schema": 1, "command": "info", "error": {"what": "a", "where": "b", "todo": "c"}}
    assert validator.is_valid(error)
    assert not validator.is_valid({**error, "schema": 2})
    assert not validator.is_valid({**error, "more": 1})


def test_nan_becomes_null() -> None:
    value = {"a": [float("nan"), 1.5, (float("inf"), 2)], "b": float("-inf")}
    assert console.without_nan(value) == {"a": [None, 1.5, [None, 2]], "b": None}


# --- info, gaps, version -------------------------------------------------------------------------


@pytest.mark.parametrize("name", RECORDINGS)
def test_info_and_gaps_agree(run_json: Json, samples: Path, name: str) -> None:
    path = samples / f"{name}.c3d"
    code, info = run_json("info", path)
    assert code == 0
    code, listed = run_json("gaps", path)
    assert code == 0
    assert info["file"] == listed["file"] == str(path)
    assert info["warnings"] == listed["warnings"]
    by_marker = {index: [] for index in range(len(info["markers"]))}
    for gap in listed["gaps"]:
        by_marker[gap["marker_index"]].append(gap)
        assert gap["marker"] == info["markers"][gap["marker_index"]]["label"]
        assert info["first_frame"] <= gap["first_frame"] <= gap["last_frame"] <= info["last_frame"]
        assert gap["length_frames"] == gap["last_frame"] - gap["first_frame"] + 1
        assert gap["length_ms"] == pytest.approx(1000 * gap["length_frames"] / info["rate_hz"])
        starts, ends = (
            gap["first_frame"] == info["first_frame"],
            gap["last_frame"] == info["last_frame"],
        )
        assert gap["kind"] == {
            (False, False): "interior", (True, False): "leading",
            (False, True): "trailing", (True, True): "whole",
        }[starts, ends]  # fmt: skip
    for index, marker in enumerate(info["markers"]):
        lengths = [gap["length_frames"] for gap in by_marker[index]]
        assert marker["gaps"] == len(lengths)
        assert marker["longest_gap"] == max(lengths, default=0)
        assert marker["missing_percent"] == pytest.approx(100 * sum(lengths) / info["frames"])
    assert listed["missing_samples"] == sum(gap["length_frames"] for gap in listed["gaps"])
    assert listed["markers_with_gaps"] == sum(map(bool, by_marker.values()))


def test_info_knows_the_gait_recording(run_json: Json, samples: Path) -> None:
    _, info = run_json("info", samples / "gait_plug_in_gait.c3d")
    assert (info["frames"], info["first_frame"], info["last_frame"]) == (293, 725, 1017)
    assert (info["rate_hz"], info["unit"], info["up_axis"]) == (100, "mm", "+z")
    assert len(info["markers"]) == 56
    assert len(info["model_outputs"]) == 36
    assert info["analog"] == {"channels": 34, "rate_hz": 1000}
    assert [plate["type"] for plate in info["force_plates"]] == [2, 2, 2]
    assert [plate["channels"][0] for plate in info["force_plates"]] == [1, 7, 13]
    assert info["force_plates"][0]["corners_mm"][0] == pytest.approx([-0.025, -92.026, 0], abs=1e-3)
    assert info["skeleton"]["source"] == "template"
    assert len(info["events"]) == 12


def test_info_of_force_plates_that_are_half_described(
    run_json: Json, capsys: pytest.CaptureFixture[str], tmp_path: Path
) -> None:
    path = tmp_path / "plates.c3d"
    corners = np.array([[[0.5, 0.25, 0], [0.5, 0, 0], [0, 0, 0], [0, 0.25, 0]]])
    parameters = {
        "POINT:UNITS": "m",
        "FORCE_PLATFORM:USED": [2],
        "FORCE_PLATFORM:TYPE": [2],
        "FORCE_PLATFORM:CORNERS": corners,
        "FORCE_PLATFORM:CHANNEL": np.array([[1, 2, 3, 4, 5, 6], [7, 8, 9, 10, 11, 12]]),
    }
    path.write_bytes(encode(Synthetic(walk(), analog=np.ones((40, 1, 6)), parameters=parameters)))
    _, info = run_json("info", path)
    assert info["force_plates"] == [
        {"type": 2, "corners_mm": (1000 * corners[0]).tolist(), "channels": [1, 2, 3, 4, 5, 6]},
        {"type": None, "corners_mm": None, "channels": []},
    ]
    assert main(["info", str(path)]) == 0
    assert "Force plates:  2, of type 2 and unknown\n" in capsys.readouterr().out


@pytest.mark.parametrize("command", ["info", "gaps"])
def test_people_get_a_short_table(
    capsys: pytest.CaptureFixture[str], samples: Path, command: str
) -> None:
    assert main([command, str(samples / "gait_plug_in_gait.c3d")]) == 0
    printed = capsys.readouterr()
    assert printed.err == ""
    assert "*53" in printed.out
    lines = printed.out.splitlines()
    table = lines[next(i for i, line in enumerate(lines) if line.startswith("Marker  ")) :]
    assert table[0].split()[0] == "Marker"
    assert all(line == line.rstrip() for line in lines)


def test_warnings_of_the_file_go_to_stderr(
    capsys: pytest.CaptureFixture[str], samples: Path
) -> None:
    path = samples / "sprint_basketball.c3d"
    assert main(["gaps", str(path), "--json"]) == 0
    printed = capsys.readouterr()
    warnings = json.loads(printed.out)["warnings"]
    assert warnings
    assert printed.err.splitlines() == [f"mocapmend: {path}: {text}" for text in warnings]


def test_version(run_json: Json, capsys: pytest.CaptureFixture[str]) -> None:
    assert main(["--version"]) == 0
    assert capsys.readouterr().out == f"mocapmend {__version__}\n"
    assert run_json("--version") == (
        0, {"schema": 1, "command": "version", "version": __version__},
    )  # fmt: skip


def test_a_file_without_points_holds_something_else(run_json: Json, pointless: Path) -> None:
    code, info = run_json("info", pointless)
    assert code == 0
    assert info["markers"] == []
    assert info["analog"] == {"channels": 2, "rate_hz": 1000}
    assert any("nothing to repair" in warning for warning in info["warnings"])
    code, listed = run_json("gaps", pointless)
    assert (code, listed["gaps"]) == (0, [])


def test_a_truncated_file_is_described(run_json: Json, samples: Path, tmp_path: Path) -> None:
    whole = samples / "sprint_basketball.c3d"
    path = tmp_path / "truncated.c3d"
    path.write_bytes(whole.read_bytes()[: whole.stat().st_size // 2])
    code, info = run_json("info", path)
    assert code == 0
    assert info["truncated"]
    assert info["frames"] < 3678
    assert any("3678" in warning for warning in info["warnings"])


# --- failures ------------------------------------------------------------------------------------


@pytest.mark.parametrize("kind", ["empty", "text", "cut", "folder", "missing"])
@pytest.mark.parametrize("command", ["info", "gaps", "repair", "check"])
def test_bad_input_is_one_message(
    run_json: Json,
    capsys: pytest.CaptureFixture[str],
    samples: Path,
    tmp_path: Path,
    command: str,
    kind: str,
) -> None:
    good = samples / "sprint_basketball.c3d"
    bad = bad_files(tmp_path, good)[kind]
    before = sorted(tmp_path.iterdir())
    more = {"repair": ["-o", tmp_path / "out.c3d"], "check": [good]}.get(command, [])
    code, document = run_json(command, bad, *more)
    assert code == 1
    assert document["command"] == command
    assert document["error"]["where"] == str(bad)
    assert document["error"]["what"]
    assert document["error"]["todo"]
    assert main([command, str(bad), *map(str, more)]) == 1
    printed = capsys.readouterr()
    assert printed.out == ""
    assert printed.err.startswith(f"mocapmend: {bad}: ")
    assert printed.err.count("\n") == 1
    assert sorted(tmp_path.iterdir()) == before


@pytest.mark.parametrize(
    "arguments",
    [
        ["info"],
        ["info", "a.c3d", "b.c3d"],
        ["gaps", "a.c3d", "--nonsense"],
        ["check", "a.c3d"],
        ["--nonsense"],
        ["a.c3d", "--json"],
        ["repiar", "a.c3d", "-o", "b.c3d"],
        ["inof", "a.c3d"],
        ["repair", "a.c3d"],
        ["repair", "a.c3d", "-o", "b.c3d", "--in-place"],
        ["repair", "a.c3d", "-o", "b.c3d", "--method", "magic"],
        ["repair", "a.c3d", "-o", "b.c3d", "--max-gap", "-1"],
        ["repair", "a.c3d", "-o", "b.c3d", "--max-gap", "2.5"],
        ["repair", "a.c3d", "-o", "b.c3d", "--max-error", "nan"],
        ["repair", "a.c3d", "-o", "b.c3d", "--max-error", "-2"],
        ["repair", "a.c3d", "-o", "b.c3d", "--max-error", "much"],
        ["repair", "a.c3d", "-o", "b.c3d", "--param", "direction"],
        ["repair", "a.c3d", "-o", "b.c3d", "--param", "direction=causal"],
        ["repair", "a.c3d", "-o", "b.c3d", "--method", "kalman", "--param", "direction=up"],
        ["repair", "a.c3d", "-o", "b.c3d", "--method", "kalman", "--param", "noise_mm=-1"],
    ],
)
def test_wrong_usage_is_exit_code_2(
    capsys: pytest.CaptureFixture[str], arguments: list[str]
) -> None:
    with pytest.raises(SystemExit) as stopped:
        main(arguments)
    assert stopped.value.code == 2
    printed = capsys.readouterr()
    assert printed.out == ""
    assert printed.err.startswith("usage: mocapmend")


@pytest.mark.parametrize("arguments", [["--help"], *[[name, "--help"] for name in COMMANDS]])
def test_every_command_explains_itself(
    capsys: pytest.CaptureFixture[str], arguments: list[str]
) -> None:
    with pytest.raises(SystemExit) as stopped:
        main(arguments)
    assert stopped.value.code in (0, None)
    printed = capsys.readouterr().out
    assert printed.startswith("usage: ")
    if arguments == ["--help"]:
        assert all(name in printed for name in COMMANDS)


def test_an_unexpected_error_is_one_message_and_a_log(
    run_json: Json,
    capsys: pytest.CaptureFixture[str],
    samples: Path,
    monkeypatch: pytest.MonkeyPatch,
    log_file: Path,
) -> None:
    def broken(*_: object) -> None:
        raise ZeroDivisionError("by surprise")

    monkeypatch.setattr(engine, "load", broken)
    code, document = run_json("info", samples / "walk_cmu_02_01.c3d")
    assert code == 1
    assert "by surprise" in document["error"]["what"]
    assert document["error"]["where"] == str(log_file)
    assert main(["info", str(samples / "walk_cmu_02_01.c3d")]) == 1
    printed = capsys.readouterr()
    assert printed.err.count("\n") == 1
    assert "Traceback" not in printed.err
    assert "Traceback" in log_file.read_text("utf-8")


def test_interrupted(
    capsys: pytest.CaptureFixture[str], samples: Path, monkeypatch: pytest.MonkeyPatch
) -> None:
    def interrupt(*_: object) -> None:
        raise KeyboardInterrupt

    monkeypatch.setattr(engine, "load", interrupt)
    assert main(["info", str(samples / "walk_cmu_02_01.c3d")]) == 130
    printed = capsys.readouterr()
    assert printed.out == ""
    assert printed.err == "mocapmend: Interrupted.\n"


# --- the window ----------------------------------------------------------------------------------


@pytest.fixture
def opened(monkeypatch: pytest.MonkeyPatch) -> list[Path]:
    """Put a stand-in in the window's place that notes what it is to open."""
    paths: list[Path] = []

    def run(file: Path | None) -> int:
        if file is not None:
            paths.append(file)
        return 0

    module = ModuleType("mocapmend.views.application")
    module.run = run  # type: ignore[attr-defined]
    monkeypatch.setitem(sys.modules, "mocapmend.views.application", module)
    return paths


@pytest.mark.parametrize("argument", ["./info", "walk.c3d", "missing.c3d", "repair.c3d"])
def test_a_file_opens_the_window(
    opened: list[Path], tmp_path: Path, monkeypatch: pytest.MonkeyPatch, argument: str
) -> None:
    monkeypatch.chdir(tmp_path)
    (tmp_path / "info").write_bytes(b"")
    assert main([argument]) == 0
    assert opened == [Path(argument)]


def test_no_argument_opens_an_empty_window(opened: list[Path]) -> None:
    assert main([]) == 0
    assert opened == []


@pytest.mark.parametrize(
    ("arguments", "reason"),
    [
        (["walk.c3d", "run.c3d"], "one recording at a time"),
        (["unheard-of", "walk.c3d"], "no command and no file 'unheard-of'"),
        (["repiar", "walk.c3d"], "did you mean 'repair'?"),
    ],
)
def test_two_names_are_wrong_usage(
    opened: list[Path], capsys: pytest.CaptureFixture[str], arguments: list[str], reason: str
) -> None:
    with pytest.raises(SystemExit) as ended:
        main(arguments)
    assert ended.value.code == 2
    assert reason in capsys.readouterr().err
    assert opened == []


def test_a_file_named_almost_like_a_command_opens(
    opened: list[Path], tmp_path: Path, monkeypatch: pytest.MonkeyPatch
) -> None:
    monkeypatch.chdir(tmp_path)
    (tmp_path / "gap").write_bytes(b"")
    assert main(["gap"]) == 0
    assert opened == [Path("gap")]


def test_a_window_that_cannot_be_loaded_says_what_is_missing(
    monkeypatch: pytest.MonkeyPatch, capsys: pytest.CaptureFixture[str]
) -> None:
    monkeypatch.setitem(sys.modules, "mocapmend.views.application", None)
    assert main([]) == 1
    printed = capsys.readouterr().err
    assert "window" in printed
    assert "Traceback" not in printed


def test_benchmarks_that_are_not_there(run_json: Json, monkeypatch: pytest.MonkeyPatch) -> None:
    monkeypatch.setitem(sys.modules, "mocapmend.bench", None)
    code, document = run_json("bench", "io")
    assert code == 1
    assert document["command"] == "bench"


# --- the process ---------------------------------------------------------------------------------


def start(*arguments: object, **options: Any) -> subprocess.Popen[str]:
    words = [sys.executable, "-m", "mocapmend", *map(str, arguments)]
    return subprocess.Popen(words, text=True, stderr=subprocess.PIPE, **options)


def test_stdout_of_the_process_is_json_alone(
    samples: Path, validator: Draft202012Validator
) -> None:
    process = start("gaps", samples / "sprint_basketball.c3d", "--json", stdout=subprocess.PIPE)
    out, err = process.communicate(timeout=60)
    assert process.returncode == 0
    validator.validate(json.loads(out))
    assert err.startswith("mocapmend: ")
    assert "\r" not in err


def test_info_loads_neither_qt_nor_slow_modules(samples: Path) -> None:
    code = (
        "import sys; from mocapmend.cli import main;"
        f"assert main(['info', {str(samples / 'walk_cmu_02_01.c3d')!r}]) == 0;"
        "slow = ('PySide6', 'pyqtgraph', 'jinja2', 'reportlab', 'c3d', 'scipy');"
        "sys.exit(' '.join(m for m in sys.modules if m.split('.')[0] in slow))"
    )
    done = subprocess.run(
        [sys.executable, "-c", code], capture_output=True, text=True, timeout=60, check=False
    )
    assert done.stderr == "\n"


@pytest.mark.skipif(sys.platform == "win32", reason="signals differ")
def test_ctrl_c_ends_without_a_traceback_and_leaves_nothing(samples: Path, tmp_path: Path) -> None:
    source, out = str(samples / "gait_plug_in_gait.c3d"), tmp_path / "out.c3d"
    code = (
        "import os, signal, sys\n"
        "from mocapmend.cli import main\n"
        "from mocapmend.files import c3d_patch\n"
        # A shell lets what it runs in the background ignore the signal.
        "signal.signal(signal.SIGINT, signal.default_int_handler)\n"
        "c3d_patch._Copy.verify = lambda *_: os.kill(os.getpid(), signal.SIGINT)\n"
        f"sys.exit(main(['repair', {source!r}, '-o', {str(out)!r}]))"
    )
    done = subprocess.run(
        [sys.executable, "-c", code], capture_output=True, text=True, timeout=60, check=False
    )
    assert done.returncode == 130, done.stderr
    assert done.stderr == "mocapmend: Interrupted.\n"
    assert done.stdout == ""
    assert list(tmp_path.iterdir()) == []


@pytest.mark.skipif(not hasattr(signal, "SIGPIPE"), reason="pipes differ")
@pytest.mark.parametrize("json_too", [[], ["--json"]])
def test_a_reader_that_has_gone_is_no_disaster(samples: Path, json_too: list[str]) -> None:
    reading, writing = os.pipe()
    os.close(reading)
    process = start("gaps", samples / "sprint_basketball.c3d", *json_too, stdout=writing)
    os.close(writing)
    _, err = process.communicate(timeout=60)
    assert process.returncode == 1
    assert "Traceback" not in err
    assert "Exception" not in err


def test_progress_is_shown_where_somebody_looks(
    monkeypatch: pytest.MonkeyPatch, capsys: pytest.CaptureFixture[str]
) -> None:
    shown = console.Console("repair", as_json=False)
    shown.start("Filling")
    shown.progress(0.25)
    assert capsys.readouterr().err == ""
    monkeypatch.setattr(sys.stderr, "isatty", lambda: True)
    shown.progress(0.5)
    shown.say("Done.")
    printed = capsys.readouterr()
    assert printed.err.startswith("\rFilling  50 %")
    assert printed.err.endswith("\r")
    assert printed.out == "Done.\n"


def test_a_line_that_changes_is_never_wrapped(
    monkeypatch: pytest.MonkeyPatch, capsys: pytest.CaptureFixture[str]
) -> None:
    monkeypatch.setattr(sys.stderr, "isatty", lambda: True)
    monkeypatch.setenv("COLUMNS", "20")
    shown = console.Console("batch", as_json=False)
    shown.status("0 of 1 file: 動作捕捉.c3d")
    shown.close()
    line, _, nothing = capsys.readouterr().err.strip("\r").rpartition("\r")
    assert line == "0 of 1 file: 動作捕"
    assert nothing == " " * 19


def test_labels_cannot_control_the_terminal(
    tmp_path: Path, capsys: pytest.CaptureFixture[str]
) -> None:
    points = walk(markers=1)
    fourth = np.zeros(points.shape[:2])
    fourth[3:5], points[3:5] = -1, 0
    path = tmp_path / "wild.c3d"
    path.write_bytes(encode(Synthetic(points, fourth=fourth, labels=["\x1b[31mred"])))
    assert main(["gaps", str(path)]) == 0
    printed = capsys.readouterr().out
    assert "\x1b" not in printed
    assert "[31mred" in printed
