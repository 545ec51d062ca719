"""What is known of every sample of a document."""

from enum import IntEnum


class SampleState(IntEnum):
    """The state of one marker in one frame, stored as one byte."""

    MEASURED = 0
    MISSING = 1
    BAD = 2
    """Measured, and set aside: it counts as missing."""
    FILLED = 3
    NEVER = 4
    """Missing, and to be left so: no repair touches it."""
    SMOOTHED = 5
    """Measured, and smoothed since."""


ABSENT = (SampleState.MISSING, SampleState.BAD, SampleState.NEVER)
"""States without coordinates."""
OPEN = (SampleState.MISSING, SampleState.BAD)
"""States of the samples of gaps that are open."""
