"""Analog channels in the window: chosen, read in the background, drawn over the time axis."""

from collections.abc import Callable, Iterator
from pathlib import Path

import numpy as np
import pytest
from c3d_synthetic import ENCODINGS, Machine, Synthetic, encode, walk
from PySide6.QtCore import Qt
from PySide6.QtWidgets import QDockWidget
from pytestqt.qtbot import QtBot

from mocapmend.files import C3DFile, read_c3d
from mocapmend.jobs import Jobs
from mocapmend.theme import DARK
from mocapmend.views import analog_data
from mocapmend.views.analog_data import read_channels
from mocapmend.views.analog_pane import AnalogPane
from mocapmend.views.main_window import MainWindow
from mocapmend.viewstate import ViewState
from mocapmend_algorithms import no_progress

FRAMES, SAMPLES, CHANNELS = 40, 5, 4
SCALES, OFFSETS = [0.5, 0.25, 2.0, 1.0], [0, 10, 3, 7]


def write(path: Path, machine: Machine = "intel", is_float: bool = True, **more: object) -> Path:
    rng = np.random.default_rng(1)
    analog = rng.integers(-900, 900, (FRAMES, SAMPLES, CHANNELS)).astype(float)
    parameters = {
        "ANALOG:LABELS": ["Fx1", "Fz1", "EMG left", "EMG right"],
        "ANALOG:UNITS": ["N", "N", "V", "V"],
        "ANALOG:SCALE": SCALES,
        "ANALOG:OFFSET": OFFSETS,
        "ANALOG:GEN_SCALE": [0.5],
        "ANALOG:RATE": [100.0 * SAMPLES],
    } | more
    path.write_bytes(
        encode(Synthetic(walk(), machine, is_float, 0.125, analog=analog, parameters=parameters))
    )
    return path


@pytest.fixture
def pane(tmp_path: Path, jobs: Jobs, qtbot: QtBot) -> Iterator[AnalogPane]:
    """Return the pane of a small file, not shown yet."""
    source = read_c3d(write(tmp_path / "analog.c3d"))
    made = AnalogPane(source, ViewState(FRAMES), jobs, DARK)
    qtbot.addWidget(made)
    made.resize(900, 400)
    yield made
    made.stop()


@pytest.mark.parametrize(("machine", "is_float"), ENCODINGS)
def test_chosen_channels_are_those_of_all(tmp_path: Path, machine: Machine, is_float: bool) -> None:
    source = read_c3d(write(tmp_path / "analog.c3d", machine, is_float))
    everything = source.read_analog()
    assert everything.shape == (FRAMES * SAMPLES, CHANNELS)
    np.testing.assert_array_equal(source.read_analog([2, 0]), everything[:, [2, 0]])
    found = read_channels(source, [3], no_progress)
    np.testing.assert_array_equal(found[3].rows[0], everything[:, 3].astype(np.float32))


def test_the_values_are_those_that_ezc3d_reads(tmp_path: Path, samples: Path) -> None:
    ezc3d = pytest.importorskip("ezc3d")
    for path in (write(tmp_path / "analog.c3d"), samples / "gait_plug_in_gait.c3d"):
        theirs = ezc3d.c3d(str(path))["data"]["analogs"][0]
        found = read_channels(read_c3d(path), [0, 2], no_progress)
        for channel, envelope in found.items():
            np.testing.assert_allclose(envelope.rows[0], theirs[channel], rtol=1e-6)


def test_a_large_file_is_read_by_channel(
    pane: AnalogPane, monkeypatch: pytest.MonkeyPatch, qtbot: QtBot
) -> None:
    monkeypatch.setattr(analog_data, "SMALL", 10)
    pane.choose((1,))
    qtbot.waitUntil(lambda: set(pane._read) == {1})
    pane.choose((1, 3))
    qtbot.waitUntil(lambda: set(pane._read) == {1, 3})


def test_the_first_channel_is_read_when_the_pane_is_first_seen(
    pane: AnalogPane, qtbot: QtBot
) -> None:
    assert pane.chosen() == ()
    pane.show()
    qtbot.waitExposed(pane)
    assert pane.chosen() == (0,)
    assert pane.plots._message((0,)) == "Reading…"
    qtbot.waitUntil(lambda: 0 in pane._read)
    assert pane.plots._message((0,)) == ""


def test_channels_are_stacked_or_overlaid(pane: AnalogPane, qtbot: QtBot) -> None:
    pane.show()
    pane.choose((0, 2, 3))
    qtbot.waitUntil(lambda: set(pane._read) == set(range(CHANNELS)))
    assert pane.plots.lanes() == [(0,), (2,), (3,)]
    stacked = pane.plots.grab().toImage()
    pane.overlay.setChecked(True)
    assert pane.plots.lanes() == [(0, 2, 3)]
    assert pane.plots.grab().toImage() != stacked
    pane.overlay.setChecked(False)
    pane.resize(900, 120)
    pane.plots.grab()
    assert len(pane.plots.lanes()) + pane.plots._left_out == 3
    assert pane.plots._left_out > 0


def test_a_value_is_read_where_it_is_drawn(pane: AnalogPane, qtbot: QtBot) -> None:
    pane.show()
    pane.choose((2,))
    qtbot.waitUntil(lambda: 2 in pane._read)
    pane.plots.grab()
    samples = pane._read[2].rows[0]
    frame = pane.plots._frames[0]
    for sample in (0, 7, FRAMES * SAMPLES - 1):
        x = float(frame.x(sample / SAMPLES))
        readout = pane.plots._readout(pane.plots._axis.frame_at(x), 0)
        assert readout.rows[0].values == (f"{samples[sample]:.5g} V",)


def test_typing_filters_the_list(pane: AnalogPane, qtbot: QtBot) -> None:
    qtbot.keyClicks(pane.filter, "emg")
    seen = [not pane.list.item(row).isHidden() for row in range(pane.list.count())]
    assert seen == [False, False, True, True]
    pane.filter.clear()
    assert not any(pane.list.item(row).isHidden() for row in range(CHANNELS))


def test_the_keyboard_checks_a_channel(pane: AnalogPane, qtbot: QtBot) -> None:
    pane.show()
    pane.list.setCurrentRow(2)
    qtbot.keyClick(pane.list, Qt.Key.Key_Space)
    assert pane.chosen() == (0, 2)


def test_an_error_is_written_in_the_plot(pane: AnalogPane, qtbot: QtBot) -> None:
    pane._source.path.unlink()
    with qtbot.assertNotEmitted(pane.failed):
        pane.choose((1,))
        qtbot.waitUntil(lambda: pane._job is None)
    assert "There is no such file." in pane.plots._message((1,))
    pane.plots.grab()


def test_values_that_are_no_numbers_are_called_so(tmp_path: Path, jobs: Jobs, qtbot: QtBot) -> None:
    scales = [float("nan"), 1.0, 1.0, 1.0]
    source = read_c3d(write(tmp_path / "odd.c3d", **{"ANALOG:SCALE": scales}))
    pane = AnalogPane(source, ViewState(FRAMES), jobs, DARK)
    qtbot.addWidget(pane)
    pane.choose((0, 1))
    qtbot.waitUntil(lambda: pane._job is None)
    assert "no numbers" in pane.plots._message((0,))
    assert pane.plots._message((1,)) == ""
    pane.plots.grab()


def test_a_long_recording_costs_no_more_points_than_pixels() -> None:
    envelope = analog_data.Envelope(np.zeros((1, 2_000_000), np.float32))
    places, _ = envelope.lines(0, 2_000_000, 900)
    assert len(places) <= 4 * 900 + 8


def test_the_window_has_the_pane_where_the_file_has_channels(
    open_in: Callable[[Path], MainWindow], gait: Path, tmp_path: Path, qtbot: QtBot
) -> None:
    window = open_in(gait)
    assert window.workspace is not None
    pane = window.workspace.analog
    assert pane is not None
    assert isinstance(pane._source, C3DFile)
    dock = window.workspace.findChild(QDockWidget, "analog")
    timeline = window.workspace.findChild(QDockWidget, "timeline")
    assert timeline is not None
    assert dock in window.workspace.tabifiedDockWidgets(timeline)
    window.actions_by_id["show_analog"].trigger()
    qtbot.waitUntil(lambda: bool(pane._read))
    bare = tmp_path / "bare.c3d"
    bare.write_bytes(encode(Synthetic(walk())))
    window = open_in(bare)
    assert window.workspace is not None
    assert window.workspace.analog is None
    window.actions_by_id["show_analog"].trigger()
    assert "no analog channels" in window.statusBar().currentMessage()
    window = open_in(gait)
    assert window.workspace is not None
    dock = window.workspace.findChild(QDockWidget, "analog")
    qtbot.waitUntil(lambda: window.workspace is not None and window.workspace.arranged)
    assert dock is not None
    assert not dock.isHidden()


def test_a_file_of_analog_data_alone_shows_them(
    open_in: Callable[[Path], MainWindow], tmp_path: Path, qtbot: QtBot
) -> None:
    path = tmp_path / "emg.c3d"
    analog = np.ones((FRAMES, SAMPLES, 2))
    path.write_bytes(encode(Synthetic(np.zeros((FRAMES, 0, 3)), analog=analog)))
    window = open_in(path)
    assert window.workspace is not None
    pane = window.workspace.analog
    assert pane is not None
    qtbot.waitUntil(lambda: bool(pane._read))
    assert pane.isVisible()


def test_the_channels_of_a_file_without_markers_take_the_window(
    open_in: Callable[[Path], MainWindow], tmp_path: Path, qtbot: QtBot
) -> None:
    path = tmp_path / "analog_only.c3d"
    analog = np.ones((FRAMES, SAMPLES, CHANNELS))
    path.write_bytes(encode(Synthetic(np.empty((FRAMES, 0, 3)), analog=analog)))
    workspace = open_in(path).workspace
    assert workspace is not None
    assert workspace.analog is not None
    qtbot.waitUntil(lambda: workspace.analog.height() > 0.6 * workspace.height())
    assert workspace.panes()[0].titleBarWidget() is None
