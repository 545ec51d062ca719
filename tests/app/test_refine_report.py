"""What the report says of a refined recording, in the window and in its files."""

from collections.abc import Callable
from pathlib import Path

import numpy as np
import pytest
from pytestqt.qtbot import QtBot
from refine_networks import write_kinect22, write_network, write_reference

from mocapmend import report
from mocapmend.files import read_recording
from mocapmend.refine.apart import Order, carry_out
from mocapmend.refine.card import CAUTION, NEW_PEOPLE
from mocapmend.refine.judging import Judged
from mocapmend.report import page
from mocapmend.report.content import contents
from mocapmend.report.refining_text import NO_REFERENCE
from mocapmend.views.main_window import MainWindow
from mocapmend.views.workspace import Workspace
from mocapmend_algorithms import no_progress
from mocapmend_algorithms.refine.refining import RefineParams
from mocapmend_algorithms.skeleton import Skeleton

Open = Callable[[Path], MainWindow]


@pytest.fixture
def out(tmp_path: Path) -> Path:
    """Write a refined recording."""
    joints, network = write_kinect22(tmp_path), write_network(tmp_path / "own.npz")
    path = tmp_path / "refined.c3d"
    stamp = read_recording(joints).stamp
    carry_out(Order(joints, stamp, str(network), RefineParams("60", 6.0), path), no_progress)
    return path


@pytest.fixture
def judged(tmp_path: Path) -> Judged:
    """Return the figures of an outcome that was given a reference."""
    joints, network = write_kinect22(tmp_path), write_network(tmp_path / "own.npz")
    stamp, reference = read_recording(joints).stamp, write_reference(tmp_path)
    order = Order(joints, stamp, str(network), RefineParams(), tmp_path / "r.c3d", reference)
    done = carry_out(order, no_progress)
    assert done.judged is not None
    return done.judged


def html(path: Path, figures: Judged | None) -> str:
    source = read_recording(path)
    recording = source.recording
    summary = report.summarise(recording, recording, Skeleton("", (), "none"), [], [], no_progress)
    about = report.About("refined.c3d", refining=report.refining(source.provenance, figures))
    return page.render(summary, about)


def text_of(workspace: Workspace, qtbot: QtBot) -> str:
    """Return what the page of the pane says, when it is up to date."""
    qtbot.waitUntil(lambda: workspace.arranged)
    workspace.show_pane(workspace.report)
    workspace.report.tabs.setCurrentIndex(workspace.report.tabs.count() - 1)
    qtbot.waitUntil(lambda: workspace.report.report is not None)
    qtbot.waitUntil(lambda: workspace.report.up_to_date)
    refinement = workspace.report.pages.refinement
    assert refinement is not None
    return refinement.text.text()


def test_the_report_says_plainly_that_there_is_no_reference(out: Path) -> None:
    text = html(out, None)
    assert ">Refinement</h2>" in text
    for part in (CAUTION, NEW_PEOPLE, NO_REFERENCE, "zero-lag low-pass of 6 Hz", "own"):
        assert part in text
    assert "All of its markers had been computed" in text
    assert "No computed sample was changed." in text
    assert "Lp (mm²)" not in text


def test_figures_of_a_reference_are_in_the_report(out: Path, judged: Judged) -> None:
    text = html(out, judged)
    assert NO_REFERENCE not in text
    assert "vicon_positions.txt" in text
    for errors in (judged.refined, judged.truth):
        for number in (f"{errors.bones:.1f}", f"{errors.smoothness:.3f}"):
            assert f">{number}</td>" in text
    assert f">{judged.refined.position:.0f}</td>" in text
    assert f"{1000 * judged.lag:+.0f} ms" in text
    assert f">{judged.rms[0][1]:.1f}</td>" in text


def test_what_was_not_refined_has_no_such_section(samples: Path) -> None:
    assert ">Refinement</h2>" not in html(samples / "gait_plug_in_gait.c3d", None)


def test_the_figures_are_those_of_the_comparison(judged: Judged) -> None:
    assert len(judged.rms) == 39
    assert judged.truth.position == 0.0
    assert judged.refined.position > judged.truth.position
    squares = [mm**2 for _, mm in judged.rms if not np.isnan(mm)]
    assert judged.refined.position == pytest.approx(sum(squares) / len(squares) / 3, rel=1e-6)


def test_the_pdf_has_it_too(out: Path, judged: Judged, tmp_path: Path) -> None:
    source = read_recording(out)
    recording = source.recording
    summary = report.summarise(recording, recording, Skeleton("", (), "none"), [], [], no_progress)
    about = report.About("refined.c3d", refining=report.refining(source.provenance, judged))
    titles = [section.title for section in contents(summary, about).sections]
    assert titles.index("Refinement") < titles.index("Tracking success")
    report.write_report(summary, about, tmp_path / "r.pdf")
    assert (tmp_path / "r.pdf").read_bytes().startswith(b"%PDF")


def test_the_pane_has_a_page_for_refined_recordings_alone(
    open_in: Open, out: Path, gait: Path, qtbot: QtBot
) -> None:
    window = open_in(gait)
    assert window.workspace is not None
    assert window.workspace.report.tabs.count() == 5
    assert window.workspace.report.pages.refinement is None
    window = open_in(out)
    workspace = window.workspace
    assert workspace is not None
    assert workspace.report.tabs.count() == 6
    text = text_of(workspace, qtbot)
    for part in ("Network: own", "Stride 60, output filter 6 Hz", CAUTION, NO_REFERENCE):
        assert part in text
    assert workspace.view.companion is None, "the file does not know where its original is"
    refinement = workspace.report.pages.refinement
    assert refinement is not None
    assert not refinement.errors.isVisible()


def test_the_page_follows_the_reference(
    open_in: Open, out: Path, tmp_path: Path, qtbot: QtBot
) -> None:
    workspace = open_in(out).workspace
    assert workspace is not None
    text_of(workspace, qtbot)
    reference = write_reference(tmp_path)
    workspace.comparing.look(reference)
    refinement = workspace.report.pages.refinement
    assert refinement is not None
    qtbot.waitUntil(refinement.errors.isVisible)
    assert NO_REFERENCE not in refinement.text.text()
    assert reference.name in refinement.text.text()
    judged = workspace.facts.beside
    assert judged is not None
    item = refinement.errors.item(0, 1)
    assert item is not None
    assert item.text() == f"{judged.refined.position:.0f}"
    assert refinement.distances.rowCount() == 39
