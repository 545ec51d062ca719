"""Whether unnamed columns can be what they are taken for: a person has the lengths of a person."""

from collections.abc import Mapping, Sequence

import numpy as np
from numpy.typing import NDArray

Lengths = Mapping[tuple[str, str], tuple[float, float]]
"""The least and the greatest distance (m) of two markers or joints that a person may have."""

METRES = {"m": 1.0, "cm": 0.01, "mm": 0.001}


@np.errstate(all="ignore")
def unit_by_lengths(
    points: NDArray[np.float64], labels: Sequence[str], lengths: Lengths
) -> str | None:
    """Find the unit in which some frames show a person, tall or small.

    Parameters
    ----------
    points : ndarray, shape (frames, markers, 3)
        NaN or exactly (0, 0, 0) where a marker is missing.
    labels : sequence of str
        What the markers are taken for.
    lengths : mapping
        What they must then have; the median over the frames counts.

    Returns
    -------
    str or None
        "m", "cm" or "mm"; None where a length does not fit, or most are never seen.
    """
    seen = np.where((points != 0).any(axis=2, keepdims=True), points, np.nan)
    place = {label: i for i, label in enumerate(labels)}
    ends = np.array([[place[a], place[b]] for a, b in lengths])
    bounds = np.array(list(lengths.values()))
    distances = np.linalg.norm(seen[:, ends[:, 0]] - seen[:, ends[:, 1]], axis=2)
    known = ~np.isnan(distances).all(axis=0)
    if 2 * np.count_nonzero(known) <= len(known):
        return None
    medians = np.nanmedian(distances[:, known], axis=0)
    least, greatest = bounds[known].T
    for unit, metres in METRES.items():
        if ((least <= medians * metres) & (medians * metres <= greatest)).all():
            return unit
    return None
