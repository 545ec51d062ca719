"""Arguments that several benchmarks take."""

import argparse
from collections.abc import Callable


def add_size(parser: argparse.ArgumentParser) -> None:
    """Take the number of runs and the size of the recording."""
    parser.add_argument(
        "--runs", type=at_least(1), default=5, help="counted runs (their median is shown)"
    )
    parser.add_argument(
        "--frames", type=at_least(100), default=100_000, help="frames of the recording"
    )


def at_least(least: int) -> Callable[[str], int]:
    """Return a reader of whole numbers that are not too small."""

    def number(text: str) -> int:
        value = int(text)
        if value < least:
            raise argparse.ArgumentTypeError(f"at least {least}, not {value}")
        return value

    return number
