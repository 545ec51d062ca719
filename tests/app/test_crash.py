"""What is left when the program is killed: the edits, and whole files."""

import os
import re
import subprocess
import sys
from collections import Counter
from pathlib import Path

import pytest
from crash_window import edit_of, gaps_to_fill
from pytestqt.qtbot import QtBot

from mocapmend.commands import EditSamples
from mocapmend.document import Document
from mocapmend.engine import load
from mocapmend.files import atomic
from mocapmend.views.main_window import MainWindow
from mocapmend.views.recovery_dialog import RecoveryDialog
from mocapmend_algorithms import no_progress

HERE = Path(__file__).parent


def edit_and_kill(settings: Path, recording: Path, at_once: int, kill_after: int) -> int:
    """Return how many edits a window had made when it was killed."""
    command = [sys.executable, str(HERE / "crash_window.py"), str(settings), str(recording)]
    with subprocess.Popen(
        [*command, str(at_once)], stdout=subprocess.PIPE, stderr=subprocess.DEVNULL, text=True
    ) as program:
        assert program.stdout is not None
        for line in program.stdout:
            if int(line) == kill_after:
                break
        program.kill()
        after = program.stdout.read()
    complete = after[: after.rfind("\n") + 1].split()
    return int(complete[-1]) if complete else kill_after


@pytest.mark.parametrize(("at_once", "kill_after"), [(1, 1), (1, 9), (300, 2), (300, 60)])
def test_a_killed_window_loses_no_more_than_the_last_edit(
    window: MainWindow, qtbot: QtBot, tmp_path: Path, sprint: Path, at_once: int, kill_after: int
) -> None:
    made = edit_and_kill(tmp_path / "settings.ini", sprint, at_once, kill_after)
    window.get_ready()
    qtbot.waitUntil(lambda: bool(window.findChildren(RecoveryDialog)), timeout=20_000)
    window.findChildren(RecoveryDialog)[0].recover_button.click()
    qtbot.waitUntil(lambda: window.workspace is not None, timeout=20_000)
    assert window.workspace is not None
    recovered = window.workspace.document
    count = recovered.undo_stack.index()
    assert made >= kill_after
    assert count in {made, made + 1}
    expected = Document(*load(sprint, no_progress))
    for number, gap in enumerate(gaps_to_fill(expected)[:count], start=1):
        expected.undo_stack.push(EditSamples(expected, [edit_of(gap, number)], ""))
    assert recovered.points.tobytes() == expected.points.tobytes()
    assert recovered.state.tobytes() == expected.state.tobytes()
    assert window.isWindowModified()


@pytest.mark.skipif(not hasattr(os, "fork"), reason="kills forks of itself")
def test_a_killed_export_leaves_the_old_file_or_the_new_one(tmp_path: Path, gait: Path) -> None:
    done = subprocess.run(
        [sys.executable, str(HERE / "crash_export.py"), str(tmp_path), str(gait)],
        capture_output=True,
        text=True,
        check=True,
        timeout=100,
    )
    endings = Counter()
    for line in done.stdout.splitlines():
        how, state, *others = line.split()
        endings[how, state] += 1
        assert len(others) <= 1
        assert all(re.fullmatch(r"\.mocapmend-[0-9a-f]{16}\.tmp", name) for name in others)
        assert how == "killed" or (state == "new" and not others)
    assert set(endings) <= {("killed", "old"), ("killed", "new"), ("done", "new")}
    assert endings["killed", "old"] > 50
    assert endings["killed", "new"] > 0


def test_what_a_killed_save_has_left_is_cleared_away_by_a_later_one(tmp_path: Path) -> None:
    ages = {
        f".mocapmend-{'0a' * 8}.tmp": atomic.REMNANT_AGE_S + 60.0,
        f".mocapmend-{'1b' * 8}.tmp": atomic.REMNANT_AGE_S - 60.0,
        ".mocapmend-notes.tmp": 10 * atomic.REMNANT_AGE_S,
        "walk.tmp": 10 * atomic.REMNANT_AGE_S,
    }
    for name, age in ages.items():
        path = tmp_path / name
        path.touch()
        changed = path.stat().st_mtime - age
        os.utime(path, (changed, changed))
    atomic.write_atomically(tmp_path / "out", lambda stream: stream.write(b"new"), lambda _: None)
    assert {path.name for path in tmp_path.iterdir()} == {*list(ages)[1:], "out"}
