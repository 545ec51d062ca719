"""Measure how well points without names are labelled, from other recordings.

Labels are taken from recordings of 41 markers, their trajectories broken where markers could be
hidden and stored in points out of order, and ghosts added; a model learned of another recording
labels them. Beside it, what a fixed pose laid over each frame would make of them.
"""

from mocapmend.bench.labels.command import add_arguments, run

__all__ = ["add_arguments", "run"]
