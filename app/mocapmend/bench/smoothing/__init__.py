"""`bench smoothing`: how much of added noise each method takes away, and what of the motion.

White noise is added to recordings, all markers are smoothed with the default parameters, and the
result is held against the recording before the noise. That is no perfect truth: what jitter it has
of its own counts as motion. An impact is one of the hundredth of the samples whose velocity
changes most within 40 ms.
"""

from mocapmend.bench.smoothing.command import add_arguments, run

__all__ = ["add_arguments", "run"]
