"""What `bench paper` is doing, on a line of the terminal."""

import sys


def say(text: str) -> None:
    """Say what is being done, where somebody looks."""
    if sys.stderr.isatty():
        sys.stderr.write(f"\r{text.ljust(78)}")
        sys.stderr.flush()
