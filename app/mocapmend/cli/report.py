"""Write a report on a recording that was repaired earlier, as HTML or PDF.

How gaps were filled is taken from the repair record of REPAIRED. A file that another program has
repaired has none: then the report says what differs, and not by which method.
"""

import argparse
from dataclasses import replace
from pathlib import Path

from mocapmend import engine
from mocapmend.cli import common, target
from mocapmend.cli.console import Console
from mocapmend.errors import MocapmendError
from mocapmend.files import C3DFile, Source, check_files, read_recording, same_file
from mocapmend.report import About, RepairRow, SmoothRow, check_report_ending, put_right, refining
from mocapmend_algorithms.fill.contract import Unfilled


def add_arguments(parser: argparse.ArgumentParser) -> None:
    """Say what the command takes."""
    parser.add_argument("original", type=Path, metavar="ORIGINAL", help="the recording as it was")
    parser.add_argument("repaired", type=Path, metavar="REPAIRED", help="the repaired recording")
    parser.add_argument(
        "-o",
        "--output",
        type=Path,
        metavar="FILE",
        required=True,
        help="the report: .html or .pdf, by its ending",
    )
    parser.add_argument(
        "--overwrite", action="store_true", help="replace what is there of this name"
    )


def run(arguments: argparse.Namespace, console: Console) -> int:
    """Write the report and return the exit code."""
    out: Path = arguments.output
    check_report_ending(out)
    for path in (arguments.original, arguments.repaired):
        if same_file(out, path):
            raise MocapmendError("This is one of the recordings.", str(out), "Choose another name.")
    target.check_place(out, overwrite=arguments.overwrite)
    original = read_recording(arguments.original)
    repaired = read_recording(arguments.repaired)
    for source in (original, repaired):
        common.show_warnings(source, console)
    _require_same_shape(original, repaired)
    # Repairs name markers as they are called now.
    before = replace(original.measured, labels=repaired.recording.labels)
    known = zip(repaired.repaired, repaired.repairs, strict=True)
    rows = [RepairRow.from_record(gap, record) for gap, record in known]
    console.start("Report")
    engine.write_report(
        before,
        repaired.recording,
        engine.find_skeleton(original, console.progress),
        rows,
        [Unfilled(gap, entry.reason) for gap, entry in repaired.kept_open.items()],
        _about(original, repaired),
        out,
        console.progress,
    )
    console.result(
        original=str(arguments.original),
        repaired=str(arguments.repaired),
        report=str(out),
        repairs=len(rows),
    )
    console.say(f"Report:   {out}")
    console.say(f"Repairs:  {len(rows)} in the repair record of {arguments.repaired.name}")
    return 0


def _about(original: Source, repaired: Source) -> About:
    both_c3d = isinstance(original, C3DFile) and isinstance(repaired, C3DFile)
    found = check_files(original.path, repaired.path) if both_c3d else None
    provenance = repaired.provenance
    smoothed = (
        SmoothRow.of(run, one.method, one.parameters, one.chosen, one.rms_change_mm)
        for run, one in repaired.smoothed.items()
    )
    return About(
        file=repaired.path.name,
        methods=tuple(sorted({record.method for record in repaired.repairs})),
        warnings=repaired.warnings,
        earlier=len(repaired.repairs),
        earlier_program=provenance.program if provenance is not None else "",
        proof=() if found is None else (found.sentence, *found.allowed, *found.other_differences),
        put_right=put_right(
            repaired.set_aside,
            repaired.moves,
            smoothed,
            moved_before=original.moves,
            renamed=() if provenance is None else provenance.corrections.renamed,
        ),
        refining=refining(provenance),
    )


def _require_same_shape(original: Source, repaired: Source) -> None:
    one, other = original.recording, repaired.recording
    same_size = (one.frames, one.unit) == (other.frames, other.unit)
    if not same_size or original.first_labels != repaired.first_labels:
        raise MocapmendError(
            "The two recordings differ in their markers, frames or unit: they cannot be compared.",
            str(repaired.path),
            "Choose the recording that this one was made from.",
        )
