"""Repair of marker trajectories: numpy and scipy only, no Qt and no files."""

from mocapmend_algorithms.gaps import Gap, find_gaps
from mocapmend_algorithms.progress import Cancelled, Progress, no_progress
from mocapmend_algorithms.recording import Recording

__all__ = ["Cancelled", "Gap", "Progress", "Recording", "find_gaps", "no_progress"]
