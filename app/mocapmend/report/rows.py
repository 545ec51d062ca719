"""Many repairs described at once: one by one, ten thousand take half a second."""

from collections.abc import Sequence

import numpy as np

from mocapmend.report.model import RepairRow
from mocapmend_algorithms import Recording
from mocapmend_algorithms.arrays import FloatArray, IntArray
from mocapmend_algorithms.fill.contract import Patch


def repair_rows(
    made: Sequence[tuple[Patch, str, tuple[str, ...]]], recording: Recording
) -> list[RepairRow]:
    """Describe patches of a recording, each with its method and its donors; see `RepairRow.of`."""
    if not made:
        return []
    lengths = np.array([patch.gap.length for patch, _, _ in made])
    starts = np.cumsum(lengths) - lengths
    sigma = np.concatenate([patch.sigma for patch, _, _ in made])
    errors = np.sqrt(3.0 * np.add.reduceat(sigma**2, starts) / lengths) * recording.mm
    r90 = _medians(np.concatenate([patch.r90 for patch, _, _ in made]), starts, lengths)
    return [
        RepairRow(patch.gap, method, error, radius, donors)
        for (patch, method, donors), error, radius in zip(
            made, errors.tolist(), (r90 * recording.mm).tolist(), strict=True
        )
    ]


def _medians(values: FloatArray, starts: IntArray, lengths: IntArray) -> FloatArray:
    """Return the median of each run of values that are known; NaN where none is."""
    # NaN is sorted behind all numbers of its run.
    ordered = values[np.lexsort((values, np.repeat(np.arange(len(lengths)), lengths)))]
    known = np.add.reduceat(~np.isnan(values), starts, dtype=np.int64)
    low, high = starts + np.maximum(known - 1, 0) // 2, starts + known // 2
    high = np.minimum(high, starts + lengths - 1)
    return np.asarray((ordered[low] + ordered[high]) / 2)
