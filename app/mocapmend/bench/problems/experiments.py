"""Which errors are put in, and which detector is to find them."""

from collections.abc import Mapping
from dataclasses import dataclass, field

from mocapmend.bench.problems import injections as put
from mocapmend.bench.problems.corruption import Corrupt

SWAP_REPEATS = 5
"""Swaps are long: at the same rate there are few."""

SENSITIVE = {"least_mm": 5.0}
"""By default, spikes below 15 mm are left alone."""


@dataclass(frozen=True)
class Experiment:
    """A kind of error.

    Attributes
    ----------
    key : str
        Its name on the command line.
    detector : str
        Id of the detector that is to find it.
    errors : str
        What is put in, for people.
    corrupt : Corrupt
        Puts it in.
    least_f1 : float or None
        The target.
    rivals : bool
        Whether simple thresholds are tried as well.
    params : mapping
        Parameters of the detector that differ from their defaults.
    repeats : int
        How many times as often as the others the recordings are corrupted: errors that are long
        are few.
    """

    key: str
    detector: str
    errors: str
    corrupt: Corrupt
    least_f1: float | None = None
    rivals: bool = False
    params: Mapping[str, float] = field(default_factory=dict)
    repeats: int = 1


EXPERIMENTS = (
    Experiment(
        "spikes", "spikes", "1-5 frames, 20-200 mm", put.spike(20, 200, 1, 5), 0.98, rivals=True
    ),
    Experiment(
        "spikes-1", "spikes", "1 frame, 20-200 mm", put.spike(20, 200, 1, 1), 0.98, rivals=True
    ),
    Experiment(
        "spikes-10",
        "spikes",
        "1-5 frames, 10-20 mm; smallest deviation 5 mm",
        put.spike(10, 20, 1, 5),
        rivals=True,
        params=SENSITIVE,
    ),
    Experiment(
        "spikes-5",
        "spikes",
        "1-5 frames, 5-10 mm; smallest deviation 5 mm",
        put.spike(5, 10, 1, 5),
        rivals=True,
        params=SENSITIVE,
    ),
    Experiment(
        "swaps",
        "swaps",
        "1-500 frames, 50 mm apart or more",
        put.swap(50, 1e9, 500),
        0.95,
        rivals=True,
        repeats=SWAP_REPEATS,
    ),
    Experiment(
        "swaps-gaps",
        "swaps",
        "the same, gaps at one end or both",
        put.swap(50, 1e9, 500, hidden=True),
        repeats=SWAP_REPEATS,
    ),
    Experiment(
        "swaps-near",
        "swaps",
        "1-500 frames, 20-50 mm apart",
        put.swap(20, 50, 500),
        repeats=SWAP_REPEATS,
    ),
    Experiment("fragments", "fragments", "pieces of 5-200 frames", put.fragment(5, 200), repeats=4),
    Experiment("frozen", "frozen", "5-100 frames, 10 mm or more", put.freeze(10, 5, 100)),
    Experiment("tails", "tails", "2-5 frames, bent by 20-100 mm", put.ragged(20, 100)),
    Experiment(
        "bone-breaks", "bone-breaks", "10-100 frames, 50-200 mm", put.shift(50, 200, 10, 100)
    ),
    Experiment("far", "far", "1-20 frames, 2-6 m away", put.shift(2000, 6000, 1, 20)),
    Experiment("reflections", "reflections", "5-100 frames, within 3 mm", put.coincide(3, 5, 100)),
)
