"""What `bench kinect` takes, and the run."""

import argparse
import time
from collections.abc import Iterator, Sequence
from dataclasses import replace
from pathlib import Path

from threadpoolctl import threadpool_limits

from mocapmend.bench.arguments import add_data, at_least
from mocapmend.bench.grid import Report
from mocapmend.bench.kinect import tables
from mocapmend.bench.kinect.few_shot import Worth, calibrated
from mocapmend.bench.kinect.networks import (
    BRA,
    BRA_S,
    BRA_S_C,
    NETWORKS,
    SPLITS,
    STACKED,
    Network,
    Rounds,
    Shelf,
    settings_of,
)
from mocapmend.bench.kinect.rivals import RIDGE, raw_errors, rivals
from mocapmend.bench.say import say
from mocapmend.files.uiprmd import read_packed
from mocapmend.refine.measuring import Predict, errors_over, refining, remembering, smoothing
from mocapmend.refine.models import DEFAULT, load_model, names
from mocapmend.refine.profiles import profile_named
from mocapmend_algorithms import no_progress
from mocapmend_algorithms.arrays import FloatArray
from mocapmend_algorithms.refine.measures import Errors
from mocapmend_algorithms.refine.model import Model
from mocapmend_algorithms.refine.profile import Profile
from mocapmend_algorithms.refine.refining import refined_poses
from mocapmend_algorithms.refine.train.pairs import Pair
from mocapmend_algorithms.refine.train.settings import Settings
from mocapmend_algorithms.refine.windows import STRIDES

PAIRS = Path("kinect") / "uiprmd_kinect22_vicon39.npz"
RAW = "raw joints, beside the nearest markers"
WITH_FILTER = ", 6 Hz"
SHIPPED = "ships"
ONE_WAY = ", mirror left out"
PROJECTED = f"{BRA_S_C.name}, through the perceptual autoencoder"
"""As the paper has it."""
CALIBRATED = (RIDGE, BRA.name, BRA_S.name, BRA_S_C.name, SHIPPED)
FRAMES_TIMED = {60: 6000, 1: 600}
SOME = 20
"""Pairs on which strides are compared: stride 1 is slow."""


def add_arguments(parser: argparse.ArgumentParser) -> None:
    """Say what the benchmark takes."""
    usual = Settings()
    add_data(parser)
    parser.add_argument(
        "--networks", type=Path, metavar="DIR", help="where trained networks are kept"
    )
    parser.add_argument(
        "--train", action="store_true", help="train those that are not there (hours)"
    )
    parser.add_argument(
        "--rounds", type=at_least(1), default=usual.rounds, help="(default: %(default)s)"
    )
    parser.add_argument(
        "--first-rounds",
        type=at_least(1),
        default=usual.first_rounds,
        help="(default: %(default)s)",
    )
    parser.add_argument("--seed", type=at_least(0), default=0, help="(default: %(default)s)")


def run(arguments: argparse.Namespace) -> Report:
    """Train what is asked for, measure, and make the tables."""
    profile = profile_named(DEFAULT)
    pairs = read_packed(arguments.data / PAIRS, profile)
    shelf = Shelf(arguments.networks)
    rounds = Rounds(arguments.rounds, arguments.first_rounds, arguments.seed)
    shipped = load_model(DEFAULT) if DEFAULT in names() else None
    if arguments.train:
        _train(shelf, rounds, shipped, pairs)
    rows: list[tables.Row] = []
    by_stacks: dict[Network, tuple[Model, Errors]] = {}
    calibration: list[Worth] = []
    for split, held_out in SPLITS.items():
        learnt, rest = held_out.split(pairs)
        say(f"{split}: {len(learnt)} pairs to learn from, {len(rest)} held out")
        ways: dict[str, Predict] = rivals(learnt, profile)
        ridge = errors_over(rest, ways[RIDGE], profile)
        rows.append(tables.Row(split, RAW, raw_errors(rest, profile), ridge))
        found = {one: shelf.find(one.name, split, one.settings(rounds)) for one in NETWORKS}
        trained = {one.name: model for one, model in found.items()}
        trained[SHIPPED] = shipped
        if shipped is not None and split == "unseen":
            trained[SHIPPED] = shelf.find(SHIPPED, split, settings_of(shipped))
        measured = list(_measured(split, rest, ways, profile))
        for name, model in _used(trained).items():
            predict = remembering(refining(model))
            if name in CALIBRATED:
                ways[name] = predict
            both = {name: predict, name + WITH_FILTER: smoothing(predict)}
            measured += _measured(split, rest, both, profile)
        rows += [tables.Row(split, name, errors, ridge) for name, errors in measured]
        if split == "seen":
            by_stacks = _by_stacks(found, rows)
        else:
            calibration = _calibration(rest, ways, profile)
    grids = [
        tables.stacks(by_stacks),
        tables.structures([BRA, BRA_S, BRA_S_C]),
        tables.comparison([row for row in rows if _is_compared(row)]),
        tables.calibration(calibration, calibration[0].before.position),
    ]
    if shipped is not None:
        timed = _speeds(shipped, SPLITS["seen"].split(pairs)[1], profile)
        reached = tables.targets(rows, SHIPPED, SHIPPED + WITH_FILTER, timed[0][1])
        grids += [tables.speed(timed), reached]
    return Report("Refinement of Kinect joints (UI-PRMD, 22 -> 39)", grids, _notes(arguments))


def _measured(
    split: str, rest: Sequence[Pair], ways: dict[str, Predict], profile: Profile
) -> Iterator[tuple[str, Errors]]:
    for name, predict in ways.items():
        errors = errors_over(rest, predict, profile)
        say(f"{split}, {name}: Lp {errors.position:.0f}")
        yield name, errors


def _train(shelf: Shelf, rounds: Rounds, shipped: Model | None, pairs: Sequence[Pair]) -> None:
    asked = [(one.name, split, one.settings(rounds)) for one in NETWORKS for split in one.splits]
    if shipped is not None:
        asked.append((SHIPPED, "unseen", settings_of(shipped)))
    for name, split, settings in asked:
        shelf.train(name, split, settings, SPLITS[split].split(pairs)[0])


def _used(trained: dict[str, Model | None]) -> dict[str, Model]:
    """Return the networks that are there, with all the ways in which they are used."""
    models = {name: model for name, model in trained.items() if model is not None}
    for name in (BRA_S.name, SHIPPED):
        if name in models:
            models[name + ONE_WAY] = replace(models[name], mirrored=False)
    if BRA_S_C.name in models:
        models[PROJECTED] = models[BRA_S_C.name]
        models[BRA_S_C.name] = _unprojected(models[BRA_S_C.name])
    return models


def _is_compared(row: tables.Row) -> bool:
    return row.way.removesuffix(WITH_FILTER) not in {network.name for network in STACKED}


def _unprojected(model: Model) -> Model:
    """Return a network whose result is what its stack makes."""
    return replace(model, shape=replace(model.shape, perceptual=False))


def _by_stacks(
    found: dict[Network, Model | None], rows: Sequence[tables.Row]
) -> dict[Network, tuple[Model, Errors]]:
    errors = {row.way: row.errors for row in rows}
    return {
        network: (model, errors[network.name])
        for network, model in found.items()
        if model is not None and not network.latent
    }


def _calibration(rest: Sequence[Pair], ways: dict[str, Predict], profile: Profile) -> list[Worth]:
    chosen = [name for name in CALIBRATED if name in ways]
    return [calibrated(name, rest, ways[name], profile) for name in chosen]


def _speeds(
    model: Model, rest: Sequence[Pair], profile: Profile
) -> list[tuple[int, float, Errors]]:
    import numpy as np

    joints = np.concatenate([pair.joints for pair in rest])
    some = rest[:: max(1, len(rest) // SOME)]
    timed = []
    for stride in sorted(STRIDES, reverse=True):
        part = joints[: FRAMES_TIMED[stride]]
        seconds = []
        with threadpool_limits(1, user_api="blas"):
            for _ in range(3):
                start = time.perf_counter()
                refined_poses(part, model, stride, no_progress)
                seconds.append(time.perf_counter() - start)

        def predict(joints: FloatArray, stride: int = stride) -> FloatArray:
            return refined_poses(joints, model, stride, no_progress)

        errors = errors_over(some, predict, profile)
        timed.append((stride, len(part) / float(np.median(seconds)), errors))
    return timed


def _notes(arguments: argparse.Namespace) -> list[str]:
    splits = "; ".join(f"{name}: {held_out} held out" for name, held_out in SPLITS.items())
    trained = f"Networks: width {Settings().width}, linear skip, {arguments.first_rounds} + "
    trained += f"{arguments.rounds} rounds, seed {arguments.seed}; “{SHIPPED}” is the one in the "
    trained += "program, which was trained on the first split; of the second, one that was "
    trained += "trained by the same settings. Each window counts as it is and in a mirror."
    ridge = "Ridge regression is affine, frame by frame, on joints that are turned to one heading; "
    ridge += "the ratios are to that on joints smoothed at 5 Hz."
    return [f"Splits: {splits}.", trained, ridge]
