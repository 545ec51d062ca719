"""What a worker process has loaded; without Qt itself."""

import sys

from mocapmend_algorithms import Progress


def loaded(names: tuple[str, ...], progress: Progress) -> list[str]:
    """Return those modules of `names` that this process has."""
    return [name for name in names if name in sys.modules]
