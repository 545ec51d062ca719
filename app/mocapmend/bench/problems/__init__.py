"""Detectors of bad samples on recordings that were corrupted on purpose.

Errors of known place and size are put into real recordings, at 0.1 % of their samples. Precision
and recall count samples; latency is how many frames after the first bad sample of an error the
first one is found. Whatever else is found counts as false, real errors of the recordings included.
"""

from mocapmend.bench.problems.command import add_arguments, run

__all__ = ["add_arguments", "run"]
