"""Samples that are there but wrong: detectors, one per file, and their registry."""

from mocapmend_algorithms.problems.bad_run import BadRun

__all__ = ["BadRun"]
