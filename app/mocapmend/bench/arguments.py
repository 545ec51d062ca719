"""Arguments that several benchmarks take."""

import argparse
from collections.abc import Callable
from pathlib import Path

DATA = Path("../shared/data")


def add_size(parser: argparse.ArgumentParser) -> None:
    """Take the number of runs and the size of the recording."""
    parser.add_argument(
        "--runs", type=at_least(1), default=5, help="counted runs (their median is shown)"
    )
    parser.add_argument(
        "--frames", type=at_least(100), default=100_000, help="frames of the recording"
    )


def add_data(parser: argparse.ArgumentParser) -> None:
    """Take the folder of the recordings."""
    parser.add_argument(
        "--data",
        type=Path,
        default=DATA,
        metavar="DIR",
        help="the folder of the recordings (default: %(default)s)",
    )


def at_least(least: int) -> Callable[[str], int]:
    """Return a reader of whole numbers that are not too small."""

    def number(text: str) -> int:
        value = int(text)
        if value < least:
            raise argparse.ArgumentTypeError(f"at least {least}, not {value}")
        return value

    return number
