"""How long refining takes, about: what a user wants to know before."""

from mocapmend_algorithms.refine.model import Model
from mocapmend_algorithms.refine.preparing import RATE
from mocapmend_algorithms.refine.windows import Windows

SPEED = 2.5e8
"""Weights times windows that a common computer does in a second, with a thread."""


def seconds_for(duration: float, stride: int, model: Model) -> float:
    """Guess how long a network takes.

    Parameters
    ----------
    duration : float
        Of the recording in seconds.
    stride : int
        Frames from window to window.
    model : Model
        The network.
    """
    frames = max(1, round(duration * RATE))
    return len(Windows.over(frames, stride).starts) * model.size / SPEED
