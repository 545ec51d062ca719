"""Walk through the program in one language and at one scale: python -m screens.walk."""

import argparse
import tempfile
from pathlib import Path

from screens import around, bare, dialogs, names, panes, refining, space
from screens.proofread import Proofreader
from screens.stage import Stage

THEMES = ("dark", "light")


def walk(folder: Path, language: str, size: tuple[int, int], text: float) -> None:
    """Take all pictures, with texts that are so many times as large."""
    with tempfile.TemporaryDirectory() as home:
        stage = Stage(folder, Path(home), language, size, THEMES, text)
        reader = Proofreader(chinese=language.startswith("zh"))
        stage.looks.append(reader.look)
        panes.welcome(stage)
        around.menus(stage, "empty")
        dialogs.of_the_window(stage)
        dialogs.of_files(stage)
        bare.bare(stage)
        around.tour(stage)
        panes.repairing(stage)
        panes.problems(stage)
        panes.filling(stage)
        panes.smoothing(stage)
        panes.working(stage)
        stage.close_all()
        panes.time(stage)
        around.menus(stage, "open")
        panes.plots(stage)
        panes.floating(stage)
        space.space(stage)
        dialogs.of_a_recording(stage)
        stage.close_all()
        names.names(stage)
        refining.refining(stage)
        around.tabs(stage)
        stage.close_all()
        stage.window.close()
    complaints = [f"{where}: {what}" for what, where in reader.found.items()]
    (folder / "proofread.txt").write_text("\n".join([*complaints, ""]), encoding="utf-8")


def main() -> None:
    """Read the command line."""
    parser = argparse.ArgumentParser(description=__doc__)
    parser.add_argument("folder", type=Path)
    parser.add_argument("language")
    parser.add_argument("size", type=int, nargs=2)
    parser.add_argument("text", type=float)
    arguments = parser.parse_args()
    width, height = arguments.size
    walk(arguments.folder, arguments.language, (width, height), arguments.text)


if __name__ == "__main__":
    main()
