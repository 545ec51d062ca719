"""Write a recording in another format, without repairing it.

The ending of OUT says the format: .c3d, .trc, .csv (a line per frame), .long.csv (a line per
sample) or .npz. A C3D file as a C3D file is a copy, byte for byte.
"""

import argparse
from pathlib import Path

from mocapmend import engine
from mocapmend.changes import earlier
from mocapmend.cli import common, target
from mocapmend.cli.console import Console
from mocapmend.files import check_ending, read_recording
from mocapmend.layers import Layers


def add_arguments(parser: argparse.ArgumentParser) -> None:
    """Say what the command takes."""
    parser.add_argument("file", type=Path, metavar="IN", help="a recording")
    target.add_output(parser, "the new file")


def run(arguments: argparse.Namespace, console: Console) -> int:
    """Convert the recording, say what the new file lacks, and return the exit code."""
    out = target.choose(arguments)
    source = read_recording(arguments.file)
    check_ending(source, out)
    common.show_warnings(source, console)
    console.start("Writing")
    exported = engine.export(
        source,
        earlier(Layers.of(source)).changes(),
        out,
        replace_source=False,
        accept_truncated=arguments.accept_truncated,
        progress=console.progress,
    )
    console.result(
        **common.facts(source),
        format=source.kind,
        output=str(out),
        **common.written(exported),
    )
    console.say(f"Converted: {out}")
    for sentence in exported.sentences:
        console.say(sentence)
    return 0
