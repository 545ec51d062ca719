"""Label the points of a recording, learned from labelled recordings of its marker set.

Trajectories may be in pieces, stored in any points; each piece is listed with the label proposed
for it, how sure that is (about the share of such proposals that are right), and why. Points whose
names the labelled recordings have keep them. With -o a copy is written in which each label is one
point: pieces are brought together, and nothing but names and places changes.
"""

import argparse
import math
from pathlib import Path
from typing import Any

from mocapmend import engine
from mocapmend.cli import common, target
from mocapmend.cli.console import Console
from mocapmend.files import Source, check_ending, read_recording
from mocapmend.label_templates import model_of, write_template
from mocapmend.layers import Layers
from mocapmend.relabelling import relabelled
from mocapmend_algorithms.labelling import Labelled, Labelling, LabelParams, label

LEAST = 0.5
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
        help="labelled recordings of the same marker set, best of the same subject, or a template "
        "that was learned from some",
    )
    parser.add_argument(
        "--save-template",
        type=Path,
        metavar="FILE.json",
        help="write down what was learned, to be given to --from in place of the recordings",
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
    parser.add_argument(
        "--least-confidence",
        type=_share,
        default=LEAST,
        metavar="SHARE",
        help=f"with -o: leave pieces as they are of which it is less sure (default: {LEAST})",
    )
    target.add_output(parser, "a copy with these labels; without it nothing is written")


def run(arguments: argparse.Namespace, console: Console) -> int:
    """Print the proposals, write what was asked for, and return the exit code."""
    out = None if arguments.output is None else target.choose(arguments)
    source = read_recording(arguments.file)
    common.show_warnings(source, console)
    doubted = [name.strip() for word in arguments.doubt for name in word.split(",")]
    params = LabelParams(keep_names=not arguments.ignore_names, doubted=tuple(doubted))
    if out is not None:
        check_ending(source, out)
    console.start("Labelling")
    layers = Layers.of(source)
    model = model_of(arguments.examples, console.progress)
    if arguments.save_template is not None:
        target.check_place(arguments.save_template, overwrite=arguments.overwrite)
        write_template(model, arguments.save_template)
    found = label(layers.recording, model, params, console.progress)
    exported = None
    if out is not None:
        console.start("Writing")
        made = relabelled(layers, found, arguments.least_confidence).changes()
        accept = arguments.accept_truncated
        exported = engine.export(source, made, out, False, accept, console.progress)  # noqa: FBT003
    console.result(
        **common.facts(source),
        **({"output": None} if exported is None else {"output": str(out)}),
        **({} if exported is None else common.written(exported)),
        examples=[str(path) for path in arguments.examples],
        labels=list(found.labels),
        scale=found.scale,
        pieces=[_as_json(source, found, proposal) for proposal in found.proposals],
    )
    if found.proposals:
        headers = ("Point", ">Frames", "Label", ">Confidence", "Reason")
        console.table(headers, [_row(source, found, each) for each in found.proposals])
    console.say(_summary(found))
    if exported is not None:
        console.say(f"Labelled: {out}")
        for sentence in exported.sentences:
            console.say(sentence)
    return 0


def _share(text: str) -> float:
    try:
        share = float(text)
    except ValueError:
        share = math.nan
    if not 0 <= share <= 1:
        raise argparse.ArgumentTypeError(f"{text!r} is not a share from 0 to 1")
    return share


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
