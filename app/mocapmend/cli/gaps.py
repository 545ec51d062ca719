"""List the gaps of a file: runs of frames in which a marker is missing."""

import argparse

import numpy as np

from mocapmend.cli import common
from mocapmend.cli.console import Console
from mocapmend.files import read_recording
from mocapmend_algorithms import find_gaps


def add_arguments(parser: argparse.ArgumentParser) -> None:
    """Say what the command takes."""
    common.add_file(parser)


def run(arguments: argparse.Namespace, console: Console) -> int:
    """Print every gap and return the exit code."""
    source = read_recording(arguments.file)
    common.show_warnings(source, console)
    recording = source.recording
    gaps = find_gaps(recording.present)
    missing = int(np.count_nonzero(~recording.present))
    console.result(
        **common.facts(source),
        gaps=[
            {
                **common.place(recording, gap),
                "length_frames": gap.length,
                "length_ms": common.milliseconds(recording, gap),
                "kind": gap.kind(recording.frames),
            }
            for gap in gaps
        ],
        missing_samples=missing,
        markers_with_gaps=len({gap.marker for gap in gaps}),
    )
    if gaps:
        console.table(
            ("Marker", ">Frames", ">Length", ">ms", "Kind"),
            [
                (
                    recording.labels[gap.marker],
                    common.frames_text(recording, gap),
                    str(gap.length),
                    f"{common.milliseconds(recording, gap):.0f}",
                    gap.kind(recording.frames),
                )
                for gap in gaps
            ],
        )
    console.say(
        f"{common.count(len(gaps), 'gap')}, {common.count(missing, 'missing sample')} "
        f"of {recording.present.size}."
    )
    return 0
