"""Make the edits of a recipe again, with the same bytes as result."""

import argparse
from collections.abc import Iterator
from pathlib import Path

from mocapmend import engine, recipe, replaying
from mocapmend.cli import common, target
from mocapmend.cli.console import Console
from mocapmend.files import check_ending, read_recording
from mocapmend.files.sidecar import hash_file

COUNTED = (
    ("filled", "fills", "gap", "filled"),
    ("reopened", "reopened", "repair", "reopened"),
    ("kept_open", "kept_open", "gap", "kept open"),
    ("freed", "freed", "gap", "freed"),
    ("set_aside", "set_aside", "run", "set aside"),
    ("believed", "believed", "run", "believed again"),
    ("moved", "moved", "run", "moved to another marker"),
    ("moved_back", "moved_back", "run", "moved back"),
    ("smoothed", "smoothed", "run", "smoothed"),
    ("renamed", "renamed", "marker", "renamed"),
    ("renamed_back", "renamed_back", "marker", "without the former name"),
)
"""Edits of a recipe: in the JSON document, in the recipe, and what people read of them."""
ALWAYS = frozenset({"fills", "reopened"})
"""Those that people are told of where there is none, too."""


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
        **{key: len(getattr(made, name)) for key, name, _, _ in COUNTED},
        **common.written(exported),
    )
    console.say(f"Replayed: {out}")
    console.say(f"Edits:    {', '.join(_told(made))}")
    for sentence in exported.sentences:
        console.say(sentence)
    return 0


def _told(made: recipe.Recipe) -> Iterator[str]:
    for _, name, thing, what in COUNTED:
        number = len(getattr(made, name))
        if number or name in ALWAYS:
            yield f"{common.count(number, thing)} {what}"
