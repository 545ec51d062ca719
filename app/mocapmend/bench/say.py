"""What benchmarks tell people who wait."""

import sys


def say(text: str) -> None:
    """Write a line on stderr at once."""
    sys.stderr.write(f"{text}\n")
    sys.stderr.flush()
