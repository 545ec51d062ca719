"""Turn the joints of a cheap sensor, as the Kinect, into markers of a motion-capture system.

A network that was trained on pairs of recordings smooths the joints, bridges what is missing, and
computes markers that the sensor does not see. None of them is measured: they are estimates, and
--card says how good they were on recordings whose truth is known. IN is not changed; OUT holds the
computed markers alone, and says so.
"""

import argparse
import math
from pathlib import Path
from typing import Any

from mocapmend.cli import common, target
from mocapmend.cli.console import Console
from mocapmend.cli.usage import UsageError
from mocapmend.files import check_ending, read_recording
from mocapmend.refine.card import card_text
from mocapmend.refine.models import DEFAULT, load_model, names
from mocapmend.refine.running import RefinedFile, refine_file
from mocapmend_algorithms.refine.comparing import Comparison
from mocapmend_algorithms.refine.refining import HIGHEST_CUTOFF, LOWEST_CUTOFF, RefineParams
from mocapmend_algorithms.refine.windows import STRIDES


def add_arguments(parser: argparse.ArgumentParser) -> None:
    """Say what the command takes."""
    parser.add_argument(
        "file", nargs="?", type=Path, metavar="IN", help="a recording with the network's joints"
    )
    parser.add_argument(
        "--model",
        default=DEFAULT,
        metavar="NAME|FILE.npz",
        help=f"a network that ships with the program ({', '.join(names())}) or one of your own, "
        "from “mocapmend train refine” (default: %(default)s)",
    )
    parser.add_argument(
        "--stride",
        default="60",
        choices=[str(stride) for stride in reversed(STRIDES)],
        help="60 keeps the middle 60 frames of each window of 120; 1 keeps the middle frame, as "
        "the paper does, and takes about sixty times as long (default: %(default)s)",
    )
    parser.add_argument(
        "--cutoff",
        type=_cutoff,
        metavar="HZ",
        help="smooth the outcome with a zero-lag low-pass filter, usually of 6 Hz (default: none)",
    )
    parser.add_argument(
        "--reference",
        type=Path,
        metavar="FILE",
        help="what a better system has recorded meanwhile, to measure the outcome against; it may "
        "have begun up to a second earlier or later, and may have other axes",
    )
    parser.add_argument(
        "--calibrate",
        nargs=2,
        action="append",
        default=[],
        type=Path,
        metavar=("RECORDING", "REFERENCE"),
        help="another recording of the same person and what a better system has recorded "
        "meanwhile: the mean error of each marker there is subtracted; may be given several times",
    )
    parser.add_argument("--card", action="store_true", help="print what is known of the network")
    target.add_output(parser, "the computed markers: a C3D, TRC, CSV or NumPy file, by its ending")


def run(arguments: argparse.Namespace, console: Console) -> int:
    """Refine the recording, say how, and return the exit code."""
    if arguments.card:
        return _show_card(arguments.model, console)
    if arguments.file is None:
        raise UsageError("give a recording, or --card to read about the network")
    out = target.choose(arguments)
    source = read_recording(arguments.file)
    check_ending(source, out)
    common.show_warnings(source, console)
    console.start("Refining")
    done = refine_file(
        source,
        arguments.model,
        RefineParams(arguments.stride, arguments.cutoff),
        out,
        arguments.reference,
        [(recording, reference) for recording, reference in arguments.calibrate],
        arguments.accept_truncated,
        console.progress,
    )
    for label, frames in done.bridged.items():
        console.warn(f"{label} was missing in {common.count(frames, 'frame')} and was bridged")
    console.result(
        **common.facts(source),
        output=str(out),
        model=arguments.model,
        profile=done.model.profile.id,
        stride=int(arguments.stride),
        calibrated_with=[[str(path) for path in pair] for pair in arguments.calibrate],
        cutoff_hz=arguments.cutoff,
        frames=done.refined.recording.frames,
        markers=list(done.refined.recording.labels),
        bridged_frames=dict(done.bridged),
        repair_record=common.record_place(done.saved),
        notes=list(done.saved.notes),
        comparison=None if done.comparison is None else _as_json(done, done.comparison),
    )
    _say(done, out, console)
    return 0


def _show_card(name: str, console: Console) -> int:
    model = load_model(name)
    console.result(model=name, profile=model.profile.id, card=dict(model.card))
    console.say(card_text(model))
    return 0


def _say(done: RefinedFile, out: Path, console: Console) -> None:
    recording = done.refined.recording
    console.say(f"Refined: {out}")
    console.say(
        f"{common.count(recording.markers, 'marker')} computed in "
        f"{common.count(recording.frames, 'frame')} by {done.model.profile.name}"
    )
    for note in done.saved.notes:
        console.say(note)
    if done.comparison is not None:
        found = done.comparison
        console.say(
            f"Against the reference, over {common.count(found.errors.frames, 'frame')} at 60 Hz, "
            f"after the best turn and a lag of {1000 * found.alignment.seconds:+.0f} ms:"
        )
        headers = ("", ">Lp (mm²)", ">Lb (mm²)", ">Ls (mm²)")
        rows = [
            (name, f"{e.position:.0f}", f"{e.bones:.1f}", f"{e.smoothness:.3f}")
            for name, e in (("refined", found.errors), ("reference itself", found.truth))
        ]
        console.table(headers, rows)


def _as_json(done: RefinedFile, found: Comparison) -> dict[str, Any]:
    return {
        "frames": found.errors.frames,
        "lag_s": found.alignment.seconds,
        "position_mm2": found.errors.position,
        "bones_mm2": found.errors.bones,
        "smoothness_mm2": found.errors.smoothness,
        "reference_bones_mm2": found.truth.bones,
        "reference_smoothness_mm2": found.truth.smoothness,
        "rms_mm": dict(zip(done.model.profile.outputs, found.rms.tolist(), strict=True)),
    }


def _cutoff(text: str) -> float:
    try:
        cutoff = float(text)
    except ValueError:
        cutoff = math.nan
    if not LOWEST_CUTOFF <= cutoff <= HIGHEST_CUTOFF:
        raise argparse.ArgumentTypeError(
            f"{text!r} is not a frequency from {LOWEST_CUTOFF:g} to {HIGHEST_CUTOFF:g} Hz"
        )
    return cutoff
