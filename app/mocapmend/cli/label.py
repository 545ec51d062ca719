"""Propose labels for the points of a recording, learned from labelled recordings of its marker set.

Trajectories may be in pieces, stored in any points; each piece is listed with the label proposed
for it, how sure that is (about the share of such proposals that are right), and why. Points whose
names the labelled recordings have keep them. Nothing is written.
"""

import argparse
from pathlib import Path
from typing import Any

from mocapmend import engine
from mocapmend.cli import common
from mocapmend.cli.console import Console
from mocapmend.files import Source, read_recording
from mocapmend_algorithms.labelling import Labelled, Labelling, LabelParams

UNSURE = 0.8
"""Proposals below it are counted for the user to look at."""


def add_arguments(parser: argparse.ArgumentParser) -> None:
    """Say what the command takes."""
    common.add_file(parser)
    parser.add_argument(
        "--from",
        dest="examples",
        nargs="+",
        action="extend",
        required=True,
        type=Path,
        metavar="LABELLED",
        help="labelled recordings of the same marker set, best of the same subject; may be given "
        "several times",
    )
    parser.add_argument(
        "--ignore-names", action="store_true", help="label points anew that have names"
    )
    parser.add_argument(
        "--doubt",
        nargs="+",
        action="extend",
        default=[],
        metavar="LABEL[,LABEL...]",
        help="label anew the points with these names alone",
    )


def run(arguments: argparse.Namespace, console: Console) -> int:
    """Print the proposals and return the exit code."""
    source = read_recording(arguments.file)
    examples = [read_recording(path) for path in arguments.examples]
    for read in (source, *examples):
        common.show_warnings(read, console)
    doubted = [name.strip() for word in arguments.doubt for name in word.split(",")]
    params = LabelParams(keep_names=not arguments.ignore_names, doubted=tuple(doubted))
    console.start("Labelling")
    found = engine.label(
        source.recording, [example.recording for example in examples], params, console.progress
    )
    console.result(
        **common.facts(source),
        examples=[str(example.path) for example in examples],
        labels=list(found.labels),
        scale=found.scale,
        pieces=[_as_json(source, found, proposal) for proposal in found.proposals],
    )
    if found.proposals:
        headers = ("Point", ">Frames", "Label", ">Confidence", "Reason")
        console.table(headers, [_row(source, found, each) for each in found.proposals])
    console.say(_summary(found))
    return 0


def _as_json(source: Source, found: Labelling, proposal: Labelled) -> dict[str, Any]:
    recording, piece = source.recording, proposal.piece
    return {
        "point": recording.labels[piece.point],
        "point_index": piece.point,
        "first_frame": recording.first_frame + piece.start,
        "last_frame": recording.first_frame + piece.stop - 1,
        "label": _name(found, proposal),
        "confidence": proposal.confidence,
        "kept": proposal.kept,
        "reason": proposal.reason,
    }


def _row(source: Source, found: Labelling, proposal: Labelled) -> tuple[str, ...]:
    recording, piece = source.recording, proposal.piece
    first = recording.first_frame
    return (
        recording.labels[piece.point],
        common.span(first + piece.start, first + piece.stop - 1),
        _name(found, proposal) or "-",
        f"{proposal.confidence:.0%}",
        proposal.reason,
    )


def _name(found: Labelling, proposal: Labelled) -> str | None:
    return None if proposal.label is None else found.labels[proposal.label]


def _summary(found: Labelling) -> str:
    new = [proposal for proposal in found.proposals if not proposal.kept]
    labelled = [proposal for proposal in new if proposal.label is not None]
    unsure = sum(proposal.confidence < UNSURE for proposal in labelled)
    kept = len(found.proposals) - len(new)
    return (
        f"{common.count(len(new), 'piece')} without a trusted name: {len(labelled)} with a label, "
        f"{unsure} of them with a confidence below {UNSURE:.0%}; "
        f"{common.count(kept, 'other piece')} left as named."
    )
