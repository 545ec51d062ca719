"""How long refining takes, about: what a user wants to know before."""

from mocapmend_algorithms.refine.mirroring import is_asked_twice
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
    windows = len(Windows.over(frames, stride).starts) * (2 if is_asked_twice(model) else 1)
    return windows * model.size / SPEED
