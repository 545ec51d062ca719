"""Rows of the table, from what the runs have found."""

from collections.abc import Iterable, Iterator, Mapping, Sequence

import numpy as np

from mocapmend.bench.table import Row

Found = Mapping[str, float]
"""Figures of one run, by name."""


def held_against(
    rival: str,
    unit: str,
    figures: Iterable[tuple[str, str, str]],
    ours: Sequence[Found],
    theirs: Sequence[Found],
) -> Iterator[Row]:
    """Yield for each figure the rival's row and ours, which has the ratio of the two run by run.

    Parameters
    ----------
    rival : str
        What the figures are held against.
    unit : str
        Of the figures.
    figures : iterable of (str, str, str)
        What each is, its name, and what the ratio should be.
    ours, theirs : sequence of Found
        One per run.
    """
    for what, name, target in figures:
        one, other = (np.array([run[name] for run in runs]) for runs in (ours, theirs))
        yield Row(f"{rival}: {what.split(': ')[-1]}", float(np.median(other)), unit)
        yield Row(what, float(np.median(one)), unit, rival, float(np.median(one / other)), target)


def limited(
    figures: Mapping[str, str],
    runs: Sequence[Found],
    unit: str,
    against: str,
    limit: float,
    target: str,
) -> Iterator[Row]:
    """Yield a row for each figure, held against a limit."""
    for name, what in figures.items():
        figure = float(np.median([run[name] for run in runs]))
        yield Row(what, figure, unit, against, figure / limit, target)
