"""Files without markers: nothing can be repaired in them."""

from pathlib import Path

import numpy as np

from mocapmend.files import read_c3d
from mocapmend.views.samples import sample_recordings
from screens.stage import Stage


def bare(stage: Stage) -> None:
    """Show a file that holds events and analog channels only, and one that holds nothing."""
    analog_only, nothing = stage.home / "analog_only.c3d", stage.home / "no_frames.c3d"
    _make(analog_only, nothing)
    workspace = stage.open(analog_only)
    assert workspace.analog is not None
    stage.shoot("no_markers")
    stage.dialog("no_markers_notes", stage.window.notes.click)
    stage.dialog("no_markers_palette", stage.window.show_palette)
    stage.open(nothing)
    stage.shoot("no_frames")
    stage.close_all()


def _make(analog_only: Path, nothing: Path) -> None:
    """Write both files: a sample without its points, and one without its frames."""
    path = sample_recordings()[1][0]
    layout, data = read_c3d(path).layout, path.read_bytes()
    head = bytearray(data[: layout.data_start])
    nothing.write_bytes(head)
    used = layout.parameters["POINT:USED"].data
    head[2:4] = head[used : used + 2] = bytes(2)
    rows = np.frombuffer(data[layout.data_start : layout.data_stop], np.uint8)
    rows = rows.reshape(layout.frames, layout.frame_bytes)
    analog_only.write_bytes(head + rows[:, layout.points * layout.slot :].tobytes())
