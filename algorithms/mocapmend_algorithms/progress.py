"""How a long computation tells how far it is, and how it is told to stop."""

from typing import Protocol


class Cancelled(Exception):  # noqa: N818 - a request of the user, not an error
    """Raised from a progress call when the user wants the computation to stop."""


class Progress(Protocol):
    """Called often by long computations; may raise `Cancelled`."""

    def __call__(self, fraction: float, /) -> None:
        """Report the share done, from 0 to 1."""


def no_progress(fraction: float, /) -> None:
    """Ignore the report: for callers that neither show progress nor cancel."""


def part(progress: Progress, start: float, stop: float) -> Progress:
    """Return the progress of a part of a computation: its 0 to 1 is start to stop of the whole."""
    return lambda fraction: progress(start * (1 - fraction) + stop * fraction)
