"""Refinement networks for the Kinect: a paper's three tables, on UI-PRMD, beside regressions.

Networks are trained where --train is given and --networks DIR does not hold them yet, which takes
hours; a training that is broken off goes on where it was.
"""

from mocapmend.bench.kinect.command import add_arguments, run

__all__ = ["add_arguments", "run"]
