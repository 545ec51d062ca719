"""Candidates as one: blended by what they leave over in the trials of a gap."""

from collections.abc import Sequence
from dataclasses import replace

import numpy as np

from mocapmend_algorithms.arrays import FloatArray
from mocapmend_algorithms.fill.candidate import Candidate
from mocapmend_algorithms.fill.stack import LEAST_MM, Stack, blend


def blended(candidates: Sequence[Candidate], pull: float) -> tuple[Candidate, FloatArray]:
    """Blend candidates.

    Parameters
    ----------
    candidates : sequence of Candidate
        At least one, of the same gap and trials.
    pull : float
        How strongly the weights are pulled towards equal ones; see `Stack`.

    Returns
    -------
    candidate : Candidate
        Its errors are those of each trial with the weights of all the others; its spread is in mm.
    weights : ndarray, shape (candidates,)
        Not negative, summing to one.
    """
    errors = list(zip(*(candidate.errors for candidate in candidates), strict=True))
    stack = Stack(errors, np.full(len(candidates), 1 / len(candidates)), pull)
    weights = stack.weights()
    scaled = weights * np.array([_unit(candidate) for candidate in candidates])
    spreads = zip(*(candidate.spreads for candidate in candidates), strict=True)
    whole = Candidate(
        blend([candidate.values for candidate in candidates], weights),
        blend([candidate.spread for candidate in candidates], scaled),
        tuple(stack.left_out()),
        tuple(blend(spread, scaled) for spread in spreads),
    )
    return whole, weights


def grown(candidate: Candidate, factor: float) -> Candidate:
    """Return a candidate that is taken to err more than its trials say."""
    return replace(candidate, errors=tuple(factor * error for error in candidate.errors))


def _unit(candidate: Candidate) -> float:
    """Return how many mm a candidate's unit of spread stands for, by its trials."""
    if not candidate.errors:
        return 1.0
    error = max(np.sqrt(3) * candidate.error, LEAST_MM)
    return float(error / np.sqrt(np.mean(np.concatenate(candidate.spreads) ** 2)))
