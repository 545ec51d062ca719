"""Prove that a repaired C3D file differs from its original in marker samples alone."""

import argparse
from pathlib import Path

from mocapmend.cli import common
from mocapmend.cli.console import Console
from mocapmend.files import check_files


def add_arguments(parser: argparse.ArgumentParser) -> None:
    """Say what the command takes."""
    parser.add_argument("original", type=Path, metavar="ORIGINAL", help="the C3D file as it was")
    parser.add_argument("repaired", type=Path, metavar="REPAIRED", help="the repaired copy")


def run(arguments: argparse.Namespace, console: Console) -> int:
    """Print what differs; return 0 if nothing but marker samples does, else 1."""
    found = check_files(arguments.original, arguments.repaired)
    console.result(
        original=str(arguments.original),
        repaired=str(arguments.repaired),
        **common.comparison(found),
    )
    if found.changed:
        console.table(
            ("Marker", ">Changed frames", ">Length"),
            [
                (
                    run.label,
                    common.span(run.first_frame, run.last_frame),
                    str(run.frames),
                )
                for run in found.changed
            ],
        )
    console.say(found.sentence)
    for sentence in found.allowed:
        console.say(sentence)
    if not found.passed:
        console.warn(f"{arguments.repaired}: the check failed:")
        for difference in found.other_differences:
            console.warn(difference)
    return 0 if found.passed else 1
