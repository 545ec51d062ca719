"""The two things to do with a checkout: run the program, run the tests."""

import argparse
import os
import subprocess
import sys
from collections.abc import Sequence
from pathlib import Path

import environment
import libraries
from environment import Environment
from steps import ROOT, SetupError, step

SAMPLE = ROOT / "resources" / "mocapmend_resources" / "samples" / "sprint_basketball.c3d"
HEADLESS = ROOT / "build" / "headless"
# One process per core, but no more memory than eight take; who is done takes over others' tests.
IN_PARALLEL = ("-n", "auto", "--maxprocesses", "8", "--dist", "worksteal")
HELP = """\
python3 packaging/dev.py run [FILE]           open the window, by default on a bundled recording
python3 packaging/dev.py test [ARGUMENT ...]  run the linters, the type checker and the tests;
                                              with arguments for pytest, pytest alone;
                                              -n0 runs them in one process

Both first make a virtual environment (.venv, or the folder that MOCAPMEND_VENV names) and install
what is missing. Without a display, run repairs the recording from the command line instead.
"""


def main(arguments: Sequence[str]) -> int:
    """Do what the command line says; return the exit code."""
    task, file, passed_on = parse(arguments)
    try:
        return run(file) if task == "run" else test(passed_on)
    except SetupError as error:
        print(error, file=sys.stderr)
        return 1
    except KeyboardInterrupt:
        return 130


def parse(arguments: Sequence[str]) -> tuple[str, Path | None, list[str]]:
    """Split the command line into the task, the file of run, and the arguments for pytest."""
    own = list(arguments)
    passed_on: list[str] = []
    if own[:1] == ["test"] and own[1:2] not in (["-h"], ["--help"]):
        own, passed_on = own[:1], own[1:]
    parser = argparse.ArgumentParser(
        prog="dev.py", description=HELP, formatter_class=argparse.RawDescriptionHelpFormatter
    )
    tasks = parser.add_subparsers(dest="task", required=True, metavar="run | test")
    run_parser = tasks.add_parser("run", help="set up and run the program")
    run_parser.add_argument("file", nargs="?", type=Path, metavar="FILE")
    tasks.add_parser("test", help="set up and run the tests", usage="dev.py test [ARGUMENT ...]")
    parsed = parser.parse_args(own)
    return parsed.task, getattr(parsed, "file", None), passed_on


def prepare(extra: str = "", *, window: bool) -> Environment:
    """Return an environment with everything in it, system libraries included."""
    chosen = environment.chosen()
    libraries.provide(window=window, new_environment=chosen.probe() is None)
    environment.refresh(chosen, extra)
    return chosen


def run(file: Path | None) -> int:
    """Open the window on a file, or do the headless job on it where there is no display."""
    recording = SAMPLE if file is None else file.absolute()
    named = libraries.has_display()
    ready = prepare(window=named)
    program: list[str | Path] = [ready.python, "-m", "mocapmend"]
    if named and (sys.platform != "linux" or ready.reaches_display()):
        return subprocess.call([*program, recording])
    trouble = "The display cannot be reached" if named else "There is no display"
    print(f"{trouble}, so the recording is repaired from the command line.", flush=True)
    return repair(program, recording)


def repair(program: Sequence[str | Path], recording: Path) -> int:
    """Repair a recording, prove that nothing else in it changed, say where the results are."""
    HEADLESS.mkdir(parents=True, exist_ok=True)
    repaired = HEADLESS / f"{recording.stem}_repaired.c3d"
    report = HEADLESS / f"{recording.stem}_report.html"
    for old in (repaired, report):
        old.unlink(missing_ok=True)
    code = subprocess.call([*program, "repair", recording, "-o", repaired, "--report", report])
    code = code or subprocess.call([*program, "check", recording, repaired])
    if code == 0:
        print(f"Recording: {recording}\nRepaired:  {repaired}\nReport:    {report}", flush=True)
    return code


def test(arguments: Sequence[str]) -> int:
    """Run the checks and the tests; pytest comes last, so that its summary closes the output."""
    python = prepare("test", window=False).python
    checks = {
        "Linting": ["ruff", "check"],
        "Checking the format": ["ruff", "format", "--check"],
        "Checking the types": ["mypy"],
    }
    passed = True
    if not arguments:
        for title, words in checks.items():
            passed &= step(title, [python, "-m", *words])
    variables = {"QT_QPA_PLATFORM": "offscreen", **os.environ}
    command = [str(python), "-m", "pytest", *IN_PARALLEL, *arguments]
    code = subprocess.call(command, cwd=ROOT, env=variables)
    return code if passed else code or 1
