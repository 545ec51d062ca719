"""Methods of repair on gap cases with known truth, against published methods' measured errors.

Each method fills the punched gaps as `repair --max-error inf` would, and its values are compared
with the samples that were there. RMSE is the root of the mean squared 3-D distance over those
samples. --scaling measures how the cost grows with gaps and frames instead.
"""

from mocapmend.bench.gaps.command import add_arguments, run

__all__ = ["add_arguments", "run"]
