"""Gather a training set for the methods that learn from other recordings.

Of every recording, the measured frames are taken that show all markers which the recordings have in
common; markers are known by their labels, without the prefix of a subject, and those named *... are
left out. The same recordings give the same file, byte for byte. Use it with --param training=FILE.
"""

import argparse
import math
import os
import time
from dataclasses import dataclass, field
from pathlib import Path

from mocapmend import engine, training
from mocapmend.cli import target
from mocapmend.cli.common import count
from mocapmend.cli.console import Console
from mocapmend.errors import MocapmendError
from mocapmend.files import FORMATS, Source, read_recording, same_file
from mocapmend.files.atomic import write_atomically, writer_of
from mocapmend_algorithms.sparse.part_training import PartSettings
from mocapmend_algorithms.sparse.training_set import (
    TrainingSet,
    TrainingSetError,
    encode_training_set,
    read_training_set,
)

SUFFIX = ".npz"
SKELETON = ".asf"
"""Holds no motion of its own."""
MOST_NAMES = 5
ROUNDS = 10
MOST_ATOMS = 10_000
RATES = (1e-3, 1e6)
"""Hz that can be meant."""


def add_arguments(parser: argparse.ArgumentParser) -> None:
    """Say what the command takes."""
    parser.add_argument(
        "--motion",
        nargs="+",
        action="extend",
        required=True,
        type=Path,
        metavar="FILE_OR_FOLDER",
        help="recordings to learn from; a folder stands for those in it (not in its subfolders), "
        "and what cannot be read there is skipped; may be given several times",
    )
    parser.add_argument(
        "-o",
        "--output",
        type=Path,
        required=True,
        metavar="FILE.npz",
        help="the training set",
    )
    parser.add_argument("--overwrite", action="store_true", help="replace what is there")
    parser.add_argument(
        "--markers",
        nargs="+",
        action="extend",
        default=[],
        metavar="LABEL[,LABEL...]",
        help="learn these markers alone: a marker that is rarely seen leaves few complete frames",
    )
    parser.add_argument(
        "--rate",
        type=_rate,
        metavar="HZ",
        help="frames per second of the set; a lower one makes it smaller (default: the lowest of "
        "the recordings)",
    )
    parser.add_argument(
        "--atoms",
        type=_count,
        default=0,
        metavar="N",
        help="also train dictionaries of so many atoms for the five parts of a skeleton, for "
        "--param dictionary=trained (default: none; the paper has 1000)",
    )
    parser.add_argument(
        "--rounds",
        type=_count,
        default=ROUNDS,
        metavar="N",
        help="of that training at most (default: %(default)s)",
    )
    parser.add_argument(
        "--resume",
        action="store_true",
        help="go on with the training of dictionaries that was broken off: what FILE.npz has of "
        "the same motion and settings is kept",
    )
    parser.add_argument(
        "--about", metavar="TEXT", help="what the set is of (default: the names of the files)"
    )


def run(arguments: argparse.Namespace, console: Console) -> int:
    """Make the training set, say what is in it, and return the exit code."""
    start = time.perf_counter()
    out: Path = arguments.output
    if out.suffix.lower() != SUFFIX:
        raise MocapmendError(
            f"The name of a training set ends with {SUFFIX}.", str(out), "Choose another name."
        )
    target.check_place(out, overwrite=arguments.overwrite or arguments.resume)
    earlier = _earlier(out) if arguments.resume else None
    read = _read(_without(_listed(arguments.motion), out), console)
    names = ", ".join(source.path.name for source in read.sources[:MOST_NAMES])
    more = len(read.sources) - MOST_NAMES
    about = arguments.about or (f"{names} and {more} more" if more > 0 else names)
    console.start("Learning")
    made = engine.train_sparse(
        [source.measured for source in read.sources],
        about,
        [label.strip() for word in arguments.markers for label in word.split(",")],
        arguments.rate,
        PartSettings(arguments.atoms, arguments.rounds) if arguments.atoms else None,
        console.progress,
        earlier,
        lambda done: _write(done, out),
    )
    _write(made, out)
    seconds = time.perf_counter() - start
    console.result(
        output=str(out),
        recordings=[
            {
                "file": str(source.path),
                "frames": source.recording.frames,
                "rate_hz": source.recording.rate,
                "warnings": list(source.warnings),
            }
            for source in read.sources
        ],
        skipped=[{"file": str(path), "reason": why} for path, why in read.skipped.items()],
        about=made.about,
        frames=len(made.poses),
        parts=len(made.lengths),
        rate_hz=made.rate,
        up_axis=made.up,
        markers=list(made.labels),
        atoms=max((atoms.shape[1] for atoms in made.atoms.values()), default=0),
        seconds=seconds,
    )
    console.say(f"Training set: {out}")
    console.say(f"Recordings:   {len(read.sources)}")
    console.say(
        f"Frames:       {len(made.poses)} in {count(len(made.lengths), 'unbroken part')}, "
        f"{made.rate:g} Hz, {len(made.poses) / made.rate:.2f} s"
    )
    console.say(f"Markers:      {len(made.labels)}")
    for name, atoms in made.atoms.items():
        console.say(f"Dictionary:   {name}, {atoms.shape[1]} atoms")
    return 0


@dataclass(frozen=True)
class _Read:
    """What became of the files: those of folders that hold no recording are skipped."""

    sources: list[Source] = field(default_factory=list)
    skipped: dict[Path, str] = field(default_factory=dict)


def _rate(text: str) -> float:
    try:
        rate = float(text)
    except ValueError:
        rate = math.nan
    if not RATES[0] <= rate <= RATES[1]:
        raise argparse.ArgumentTypeError(f"{text!r} is not a frame rate in Hz")
    return rate


def _earlier(out: Path) -> TrainingSet | None:
    """Read what an earlier training has left; there may be nothing."""
    try:
        return read_training_set(out) if out.exists() else None
    except TrainingSetError as error:
        raise training.complaint(error, str(out), "Leave out --resume.") from error


def _count(text: str) -> int:
    try:
        number = int(text)
    except ValueError:
        number = -1
    if not 0 <= number <= MOST_ATOMS:
        raise argparse.ArgumentTypeError(f"{text!r} is not a number from 0 to {MOST_ATOMS}")
    return number


def _listed(motion: list[Path]) -> dict[Path, bool]:
    """Return the files, each once, and whether they were named or found in a folder."""
    found: dict[str, tuple[Path, bool]] = {}
    for path in motion:
        named = not path.is_dir()
        for file in [path] if named else _recordings(path):
            first, named_before = found.get(os.path.realpath(file), (file, False))
            found[os.path.realpath(file)] = first, named or named_before
    return dict(found.values())


def _recordings(folder: Path) -> list[Path]:
    """Return the files of a folder that may be recordings, in the same order everywhere."""
    suffixes = {suffix for item in FORMATS for suffix in item.suffixes} - {SKELETON}
    try:
        files = [path for path in folder.iterdir() if path.suffix.lower() in suffixes]
    except OSError as error:
        raise MocapmendError(
            f"The folder cannot be read: {error.strerror}.", str(folder), "Choose another one."
        ) from error
    if not files:
        raise MocapmendError(
            "There is no recording in this folder.", str(folder), "Choose another one."
        )
    return sorted((path for path in files if path.is_file()), key=lambda path: path.name)


def _without(files: dict[Path, bool], out: Path) -> dict[Path, bool]:
    """Leave out the training set that is to be replaced; a recording must not be."""
    if not out.exists():
        return files
    for path, named in files.items():
        if same_file(out, path) and (named or not _is_training_set(path)):
            raise MocapmendError("This is one of the recordings.", str(out), "Choose another name.")
    return {path: named for path, named in files.items() if not same_file(out, path)}


def _is_training_set(path: Path) -> bool:
    try:
        read_training_set(path)
    except TrainingSetError:
        return False
    return True


def _read(files: dict[Path, bool], console: Console) -> _Read:
    console.start("Reading")
    read = _Read()
    for number, (path, named) in enumerate(files.items()):
        console.progress(number / len(files))
        try:
            source = read_recording(path)
        except MocapmendError as error:
            if named:
                raise
            console.warn(f"skipped: {error}")
            read.skipped[path] = error.what
            continue
        for warning in source.warnings:
            console.warn(f"{path}: {warning}")
        read.sources.append(source)
    return read


def _write(made: TrainingSet, out: Path) -> None:
    try:
        write_atomically(out, writer_of(encode_training_set(made)), _verify)
    except TrainingSetError as error:
        raise training.complaint(error, str(out), "Choose other recordings.") from error


def _verify(path: Path) -> None:
    read_training_set(path)
