"""Samples that are there but wrong: detectors, one per file, and their registry."""

from mocapmend_algorithms.problems.bad_run import BadRun
from mocapmend_algorithms.problems.detect import detect

__all__ = ["BadRun", "detect"]
