"""Make the edits of a recipe again, with the same bytes as result."""

import argparse
from pathlib import Path

from mocapmend import engine, recipe, replaying
from mocapmend.cli import common, target
from mocapmend.cli.console import Console
from mocapmend.files import check_ending, read_recording
from mocapmend.files.sidecar import hash_file

COUNTED = {
    "filled": "fills",
    "reopened": "reopened",
    "kept_open": "kept_open",
    "freed": "freed",
    "set_aside": "set_aside",
    "believed": "believed",
    "moved": "moved",
    "moved_back": "moved_back",
    "smoothed": "smoothed",
    "renamed": "renamed",
    "renamed_back": "renamed_back",
}
"""Edits of a recipe that the JSON document counts, by the names that they have there."""


def add_arguments(parser: argparse.ArgumentParser) -> None:
    """Say what the command takes."""
    parser.add_argument("recipe", type=Path, metavar="RECIPE", help="the recipe")
    parser.add_argument("file", type=Path, metavar="IN", help="the recording it was made for")
    target.add_arguments(parser)


def run(arguments: argparse.Namespace, console: Console) -> int:
    """Replay the recipe, say what was done, and return the exit code."""
    made = recipe.read_recipe(arguments.recipe)
    out = target.choose(arguments)
    source = read_recording(arguments.file)
    check_ending(source, out)
    common.show_warnings(source, console)
    same_input = hash_file(source.path) == made.input
    if not same_input:
        console.warn(
            f"{source.path}: the recipe was made for another file; the result may be another one."
        )
    console.start("Replaying")
    changes = replaying.replay(source, made, console.progress)
    console.start("Writing")
    exported = engine.export(
        source,
        changes,
        out,
        arguments.in_place,
        arguments.accept_truncated,
        console.progress,
    )
    console.result(
        **common.facts(source),
        recipe=str(arguments.recipe),
        same_input=same_input,
        output=str(out),
        **{key: len(getattr(made, name)) for key, name in COUNTED.items()},
        **common.written(exported),
    )
    console.say(f"Replayed: {out}")
    edits = [
        f"{common.count(len(made.fills), 'gap')} filled",
        f"{common.count(len(made.reopened), 'repair')} reopened",
    ]
    for entries, thing, what in (
        (made.kept_open, "gap", "kept open"),
        (made.freed, "gap", "freed"),
        (made.set_aside, "run", "set aside"),
        (made.believed, "run", "believed again"),
        (made.moved, "run", "moved to another marker"),
        (made.moved_back, "run", "moved back"),
        (made.smoothed, "run", "smoothed"),
        (made.renamed, "marker", "renamed"),
        (made.renamed_back, "marker", "without the former name"),
    ):
        if entries:
            edits.append(f"{common.count(len(entries), thing)} {what}")
    console.say(f"Edits:    {', '.join(edits)}")
    for sentence in exported.sentences:
        console.say(sentence)
    return 0
