"""Make the pictures of the documentation: python docs/make_screenshots.py (no display needed).

With --all FOLDER make pictures of every screen in both themes, languages and at several scales.
"""

import argparse
import tempfile
from pathlib import Path

from screens import every
from screens.refining import refine_squat
from screens.stage import Stage, wait_until, worth_a_look

IMAGES = Path(__file__).parent / "images"
SIZE = (1280, 720)


def document() -> None:
    """Walk through the program and take the pictures of the documentation."""
    IMAGES.mkdir(exist_ok=True)
    with tempfile.TemporaryDirectory() as home:
        stage = Stage(IMAGES, Path(home), "en", SIZE, ())
        stage.choose("dark")
        shoot(stage, "welcome")
        workspace = stage.open_sample("sprint_basketball")
        wait_until(lambda: not workspace.survey.running and workspace.survey.portions > 1)
        workspace.view.go_to(worth_a_look(workspace))
        wait_until(lambda: workspace.view.preview is not None and not workspace.previewer.busy)
        shoot(stage, "preview")
        workspace.zoom_all()
        shoot(stage, "window")
        workspace.show_plan()
        wait_until(lambda: workspace.filling.job is None and workspace.plan.model.rowCount())
        shoot(stage, "plan")
        workspace.fill_all()
        wait_until(lambda: workspace.document.undo_stack.count() > 0)
        stage.choose("light")
        before = workspace.report.report
        stage.show_pane(workspace.report)
        wait_until(lambda: workspace.report.report is not before)
        shoot(stage, "report")
        stage.choose("dark")
        stage.show_pane(workspace.repairs)
        workspace.view.go_to(min(workspace.document.repairs))
        shoot(stage, "repairs")
        stage.close_all()
        stage.open_sample("squat_kinect")
        stage.show_pane(refine_squat(stage).report)
        stage.workspace.report.tabs.setCurrentIndex(stage.workspace.report.tabs.count() - 1)
        shoot(stage, "refined")
        stage.close_all()
        stage.window.close()


def shoot(stage: Stage, name: str) -> None:
    """Save what the window shows."""
    stage.window.statusBar().clearMessage()
    stage.wait()
    stage.window.grab().save(str(IMAGES / f"{name}.png"))


def main() -> None:
    """Read the command line."""
    parser = argparse.ArgumentParser(
        description=__doc__, formatter_class=argparse.RawDescriptionHelpFormatter
    )
    parser.add_argument("--all", type=Path, metavar="FOLDER", help="make those of every screen")
    folder = parser.parse_args().all
    if folder is None:
        document()
    else:
        every.make(folder)


if __name__ == "__main__":
    main()
