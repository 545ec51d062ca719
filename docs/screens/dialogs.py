"""Every dialog, and what goes wrong."""

import time
from functools import partial
from pathlib import Path

from PySide6.QtWidgets import QWidget

from mocapmend.files import read_recording
from mocapmend.journal import Abandoned
from mocapmend.journal.history import Subject
from mocapmend.views.palette import Palette
from mocapmend.views.recovery_dialog import RecoveryDialog
from mocapmend.views.samples import sample_recordings
from mocapmend.views.shortcuts_dialog import ShortcutsDialog
from screens.panes import go_to
from screens.stage import Stage, wait_until


def of_the_window(stage: Stage) -> None:
    """Show the dialogs that need no recording."""
    window = stage.window
    stage.dialog("open", window.files.ask_and_open)
    stage.dialog("about", window.show_about)
    stage.dialog("shortcuts", window.show_shortcuts)
    stage.dialog("shortcuts_found", window.show_shortcuts, _search_and_change)
    stage.dialog("palette", window.show_palette)
    stage.dialog("palette_found", window.show_palette, lambda d: _type(d, "fi"))
    stage.dialog("palette_nothing", window.show_palette, lambda d: _type(d, "qqqq"))
    stage.dialog("recovery", lambda: RecoveryDialog(window, _abandoned(3)).open())
    stage.dialog("recovery_one", lambda: RecoveryDialog(window, _abandoned(1)).open())
    stage.dialog("unexpected", lambda: window.show_error(ValueError("a mistake of ours")))


def of_files(stage: Stage) -> None:
    """Show what is said about files that cannot be read, or only in part."""
    sample = sample_recordings()[1][0].read_bytes()
    for name, data in (
        ("empty.c3d", b""),
        ("no_recording.c3d", b"not a recording at all, but a text\n" * 40),
        ("unknown.xyz", b"1 2 3"),
    ):
        path = stage.home / name
        path.write_bytes(data)
        stage.dialog(f"error_{path.stem}", partial(stage.window.open, path))
    stage.dialog("error_gone", lambda: stage.window.open(stage.home / "gone.c3d"))
    truncated = stage.home / "truncated.c3d"
    truncated.write_bytes(sample[: len(sample) * 2 // 3])
    stage.open(truncated)
    stage.shoot("truncated")
    stage.dialog("notes", stage.window.notes.click)
    stage.dialog("export_truncated", lambda: stage.window.files.export(stage.home / "copy.c3d"))
    stage.close_all()


def of_a_recording(stage: Stage) -> None:
    """Show the dialogs of an open recording with edits."""
    window, workspace = stage.window, stage.workspace
    for gap in workspace.document.gaps[:2]:
        go_to(stage, gap)
        stage.do("apply")
    stage.dialog("export", window.files.ask_and_export)
    stage.dialog("save_report", window.files.ask_and_save_report)
    stage.dialog("save_recipe", window.proofs.ask_and_save_recipe)
    stage.dialog("replay_recipe", window.proofs.ask_and_replay)
    stage.dialog("save_plan", window.proofs.ask_and_save_plan)
    stage.dialog("load_plan", window.proofs.ask_and_load_plan)
    stage.dialog("check_copy", window.proofs.ask_and_check)
    stage.dialog("unsaved", window.files.close)
    stage.dialog("save_layout", window.layouts.ask_and_save)
    stage.dialog("replace", lambda: window.files.export(workspace.document.source.path))
    workspace.fill_all()
    wait_until(lambda: workspace.filling.job is None)
    go_to(stage, workspace.document.gaps[0])
    stage.dialog("reason", workspace.ask_why_open)
    stage.dialog("left_open", workspace.repair.left_open.click)
    _export_and_check(stage)


def _export_and_check(stage: Stage) -> None:
    """Export, read what the report says about it, and compare files."""
    window, workspace = stage.window, stage.workspace
    copy, spoiled = stage.home / "gait_repaired.c3d", stage.home / "gait_spoiled.c3d"
    window.files.export(copy)
    wait_until(lambda: workspace.saved and not window.files.writing)
    stage.show_pane(workspace.report)
    stage.wait()
    stage.shoot("exported")
    data = bytearray(copy.read_bytes())
    data[-2000:] = bytes(2000)
    data[30] ^= 1
    spoiled.write_bytes(data)
    stage.dialog("check_passed", lambda: window.proofs.check(copy))
    stage.dialog("check_failed", lambda: window.proofs.check(spoiled))
    original = workspace.document.source.path
    stage.dialog("check_same", lambda: window.proofs.check(original))
    window.files.export(stage.home / "gait.csv")
    wait_until(lambda: not window.files.writing)
    stage.shoot("exported_csv")
    stage.open(copy)
    stage.show_pane(stage.workspace.repairs)
    stage.shoot("repaired_before")


def _abandoned(count: int) -> list[Abandoned]:
    made = time.mktime((2026, 3, 4, 15, 6, 0, 0, 0, -1))
    source = read_recording(sample_recordings()[2][0])
    return [
        Abandoned(
            Path("journal"),
            Subject(Path(f"/home/user/trial {k + 1}/{path.name}"), source.stamp, 0),
            7 * k + 1,
            made + 5000 * k,
        )
        for k, (path, _) in enumerate(sample_recordings()[:count])
    ]


def _type(dialog: QWidget, text: str) -> None:
    assert isinstance(dialog, Palette | ShortcutsDialog)
    dialog.field.setText(text)


def _search_and_change(dialog: QWidget) -> None:
    """Search in the list of keys, and type a key that is taken."""
    assert isinstance(dialog, ShortcutsDialog)
    dialog.field.setText("Ctrl+Shift")
    dialog.edit.setKeySequence("Ctrl+O")
