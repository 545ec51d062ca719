"""The distances of all pairs of markers, measured once for all detectors."""

from weakref import WeakKeyDictionary

from mocapmend_algorithms.progress import Progress
from mocapmend_algorithms.recording import Recording
from mocapmend_algorithms.skeleton import PairDistances, measure_distances

_measured: "WeakKeyDictionary[Recording, PairDistances]" = WeakKeyDictionary()
"""Recordings never change: what was measured stays true as long as one is there."""


def distances_of(recording: Recording, progress: Progress) -> PairDistances:
    """Measure the distances of all pairs, or return those that were measured before.

    Parameters
    ----------
    recording : Recording
        As `measure_distances` takes it.
    progress : Progress
        Called once per marker, or once.

    Returns
    -------
    PairDistances
        The same for the same recording.
    """
    known = _measured.get(recording)
    if known is None:
        known = _measured[recording] = measure_distances(recording, progress)
    progress(1.0)
    return known
