"""Train a network that refines recordings of a cheap sensor, as of the Kinect.

It learns from pairs of recordings of the same movements: those of the sensor, and those of a better
system. The pairs are brought to the same time and axes. Training takes an hour or more; it can be
broken off with Ctrl+C after any round and gone on with by --resume. It needs PyTorch (the extra
`train`); refining does not.
"""

import argparse
import shlex
import time
from dataclasses import asdict, replace
from pathlib import Path
from typing import Any

from mocapmend.cli import target
from mocapmend.cli.common import count
from mocapmend.cli.console import Console
from mocapmend.errors import MocapmendError
from mocapmend.files.atomic import write_atomically, write_bytes, writer_of
from mocapmend.files.sidecar import hash_file
from mocapmend.refine.holding_out import NOTHING, By, HeldOut
from mocapmend.refine.learning import Course, learn, state_path
from mocapmend.refine.measuring import measure
from mocapmend.refine.models import DEFAULT, SUFFIX
from mocapmend.refine.new_people import read_new_people, with_new_people
from mocapmend.refine.pair_lists import HELP, read_pairs
from mocapmend.refine.profiles import profile_named, profiles
from mocapmend_algorithms.progress import part
from mocapmend_algorithms.refine.model import (
    LARGEST_WIDTH,
    MOST_STACKS,
    Model,
    encode_model,
    read_model,
)
from mocapmend_algorithms.refine.train.drawing import NO_CHANGES
from mocapmend_algorithms.refine.train.settings import Settings

MOST_ROUNDS = 100_000
LARGEST_SEED = 2**31 - 1


def add_arguments(parser: argparse.ArgumentParser) -> None:
    """Say what the command takes."""
    ours = Settings()
    parser.add_argument(
        "--pairs",
        required=True,
        type=Path,
        metavar="LIST.csv",
        help=HELP + " The packed pairs of UI-PRMD (.npz) are taken too.",
    )
    parser.add_argument(
        "--profile",
        default=DEFAULT,
        choices=list(profiles()),
        help="which joints go in and which come out (default: %(default)s)",
    )
    parser.add_argument(
        "-o", "--output", type=Path, required=True, metavar="MODEL.npz", help="the network"
    )
    parser.add_argument(
        "--curve",
        type=Path,
        metavar="FILE.csv",
        help="also write the loss of each round to a table; the network's card has it too",
    )
    parser.add_argument("--overwrite", action="store_true", help="replace what is there")
    parser.add_argument(
        "--resume",
        action="store_true",
        help="go on with a training of the same pairs and settings that was broken off",
    )
    parser.add_argument(
        "--hold-out",
        type=_held_out,
        default=NOTHING,
        metavar="repetitions=8,9,10",
        help="pairs that are not learnt from, by repetition or performer; the network is measured "
        "on them, and its card says how good it was",
    )
    parser.add_argument(
        "--new-people",
        type=Path,
        metavar="MODEL.npz",
        help="a network that was trained in the same way with performers held out: how good it was "
        "on them goes on the card too",
    )
    parser.add_argument("--about", metavar="TEXT", help="what was recorded, for the card")
    parser.add_argument(
        "--printed",
        action="store_true",
        help="the paper's network and training: width 226, no skip, 200 + 200 rounds, step 1e-5",
    )
    parser.add_argument("--stacks", type=_stacks, metavar="N", help=f"(default: {ours.stacks})")
    parser.add_argument("--width", type=_width, metavar="N", help=f"(default: {ours.width})")
    parser.add_argument(
        "--rounds", type=_rounds, metavar="N", help=f"of the stack (default: {ours.rounds})"
    )
    parser.add_argument(
        "--first-rounds",
        type=_rounds,
        metavar="N",
        help=f"of the perceptual autoencoder (default: {ours.first_rounds})",
    )
    parser.add_argument(
        "--no-latent", action="store_true", help="leave out the perceptual autoencoder"
    )
    parser.add_argument(
        "--projected",
        action="store_true",
        help="let the perceptual autoencoder make the result, as the paper does",
    )
    parser.add_argument(
        "--no-skip", action="store_true", help="leave out the linear skip, as the paper does"
    )
    parser.add_argument(
        "--no-changes", action="store_true", help="do not change windows at random, as the paper"
    )
    parser.add_argument("--seed", type=_seed, default=0, metavar="N", help="(default: 0)")


def run(arguments: argparse.Namespace, console: Console) -> int:
    """Train the network, say how good it is, and return the exit code."""
    start = time.perf_counter()
    out: Path = arguments.output
    if out.suffix.lower() != SUFFIX:
        raise MocapmendError(
            f"The name of a network ends with {SUFFIX}.", str(out), "Choose another name."
        )
    target.check_place(out, overwrite=arguments.overwrite)
    state = state_path(out)
    target.check_place(state, overwrite=arguments.overwrite or arguments.resume)
    if arguments.curve is not None:
        target.check_place(arguments.curve, overwrite=arguments.overwrite)
    profile = profile_named(arguments.profile)
    settings = _settings(arguments)
    new_people = arguments.new_people and read_new_people(arguments.new_people, profile, settings)
    console.start("Reading")
    held_out: HeldOut = arguments.hold_out
    learnt, rest = held_out.split(read_pairs(arguments.pairs, profile, console.progress))
    if not learnt:
        raise MocapmendError(
            "All pairs are held out.", str(arguments.pairs), "Hold out fewer of them."
        )
    card: dict[str, Any] = {
        "about": arguments.about or arguments.pairs.name,
        "data": {"file": arguments.pairs.name, "sha256": hash_file(arguments.pairs)},
        "command": _command(arguments),
        "held_out": str(held_out) if held_out.numbers else "",
    }
    console.start("Training")
    course = Course(profile, settings, state, card)
    model = learn(course, learnt, part(console.progress, 0.0, 0.98), resume=arguments.resume)
    if rest:
        model = measure(model, learnt, rest, part(console.progress, 0.98, 1.0))
    if new_people:
        model = with_new_people(model, new_people)
    write_atomically(out, writer_of(encode_model(model)), _verify)
    if arguments.curve is not None:
        write_bytes(arguments.curve, _curve(model))
    state.unlink(missing_ok=True)
    _tell(model, out, time.perf_counter() - start, console)
    return 0


def _curve(model: Model) -> bytes:
    rows = [f"{stage},{number},{loss}\n" for stage, number, loss in model.card["curve"]]
    return "".join(["stage,round,loss\n", *rows]).encode("ascii")


def _verify(written: Path) -> None:
    read_model(written)


def _settings(arguments: argparse.Namespace) -> Settings:
    settings = Settings.printed() if arguments.printed else Settings()
    given = {
        "stacks": arguments.stacks,
        "width": arguments.width,
        "first_width": arguments.width,
        "rounds": arguments.rounds,
        "first_rounds": arguments.first_rounds,
        "latent": 0.0 if arguments.no_latent else None,
        "projected": arguments.projected or None,
        "skip": False if arguments.no_skip else None,
        "changes": NO_CHANGES if arguments.no_changes else None,
        "seed": arguments.seed,
    }
    return replace(settings, **{name: one for name, one in given.items() if one is not None})


def _command(arguments: argparse.Namespace) -> str:
    """Return the command that makes the same network, with the names of files alone."""
    words = ["mocapmend", "train", "refine", "--pairs", arguments.pairs.name]
    words += ["--profile", arguments.profile, "-o", arguments.output.name]
    if arguments.hold_out.numbers:
        numbers = ",".join(map(str, arguments.hold_out.numbers))
        words += ["--hold-out", f"{arguments.hold_out.by}s={numbers}"]
    if arguments.new_people is not None:
        words += ["--new-people", arguments.new_people.name]
    for name in ("printed", "no_latent", "projected", "no_skip", "no_changes"):
        if getattr(arguments, name):
            words.append(f"--{name.replace('_', '-')}")
    for name in ("stacks", "width", "rounds", "first_rounds"):
        if getattr(arguments, name) is not None:
            words += [f"--{name.replace('_', '-')}", str(getattr(arguments, name))]
    return shlex.join([*words, "--seed", str(arguments.seed)])


def _tell(model: Model, out: Path, seconds: float, console: Console) -> None:
    card = model.card
    console.result(
        output=str(out),
        profile=model.profile.id,
        shape=asdict(model.shape),
        card=dict(card),
        seconds=seconds,
    )
    console.say(f"Network:    {out}")
    console.say(f"Profile:    {model.profile.name}")
    console.say(f"Learnt:     {count(card['pairs'], 'pair')}, {card['frames']} frames at 60 Hz")
    for stage in dict.fromkeys(stage for stage, _, _ in card["curve"]):
        losses = [loss for own, _, loss in card["curve"] if own == stage]
        console.say(
            f"Loss:       {losses[0]:.3f} to {losses[-1]:.3f} in {count(len(losses), 'round')}, "
            f"{stage}"
        )
    console.say(f"Weights:    {model.size}")
    if "figures" in card:
        console.say(
            f"Measured on {count(card['measured_on'], 'pair')} held out: {card['held_out']}"
        )
        rows = [
            (
                name,
                f"{figures['position_mm2']:.0f}",
                f"{figures['bones_mm2']:.1f}",
                f"{figures['smoothness_mm2']:.2f}",
            )
            for name, figures in card["figures"].items()
        ]
        console.table(("", ">Lp (mm²)", ">Lb (mm²)", ">Ls (mm²)"), rows)


def _held_out(text: str) -> HeldOut:
    name, _, listed = text.partition("=")
    kinds: dict[str, By] = {"repetitions": "repetition", "performers": "performer"}
    try:
        numbers = tuple(int(number) for number in listed.split(","))
        return HeldOut(kinds[name.strip()], numbers)
    except (KeyError, ValueError):
        raise argparse.ArgumentTypeError(
            f"{text!r} is not like repetitions=8,9,10 or performers=3"
        ) from None


def _number(text: str, least: int, most: int) -> int:
    try:
        number = int(text)
    except ValueError:
        number = least - 1
    if not least <= number <= most:
        raise argparse.ArgumentTypeError(f"{text!r} is not a number from {least} to {most}")
    return number


def _stacks(text: str) -> int:
    return _number(text, 1, MOST_STACKS)


def _width(text: str) -> int:
    return _number(text, 1, LARGEST_WIDTH)


def _rounds(text: str) -> int:
    return _number(text, 1, MOST_ROUNDS)


def _seed(text: str) -> int:
    return _number(text, 0, LARGEST_SEED)
