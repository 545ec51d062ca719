"""What was put right besides filling gaps, as a report tells it."""

from collections.abc import Iterable, Mapping, Sequence
from dataclasses import dataclass
from typing import Any, Protocol, Self

import numpy as np

from mocapmend import wording
from mocapmend.files import Renamed
from mocapmend_algorithms import Gap, Recording
from mocapmend_algorithms.arrays import BoolArray
from mocapmend_algorithms.corrections import Move, merged_runs
from mocapmend_algorithms.smooth.registry import AMOUNTS, SMOOTHERS


@dataclass(frozen=True)
class SmoothRow:
    """One smoothed run.

    Attributes
    ----------
    run : Gap
        Which.
    method : str
        Method id.
    chosen : tuple of str
        Those of its parameters that differ from their defaults, as "name=value".
    cutoffs_hz : tuple of float
        Of x, y and z; empty where unknown.
    automatic : bool
        Whether the method has chosen how much to smooth.
    rms_mm : float
        How far samples were moved; NaN where unknown.
    """

    run: Gap
    method: str
    chosen: tuple[str, ...]
    cutoffs_hz: tuple[float, ...]
    automatic: bool
    rms_mm: float

    @classmethod
    def of(
        cls,
        run: Gap,
        method: str,
        params: Mapping[str, Any],
        chosen: Mapping[str, Any],
        rms_mm: float,
    ) -> Self:
        """Describe a run by what a record has of it."""
        known = SMOOTHERS[method].params() if method in SMOOTHERS else None
        other = {
            name: value
            for name, value in params.items()
            if known is None or value != getattr(known, name, None)
        }
        given = any(params.get(name) is not None for name in AMOUNTS)
        cutoffs = tuple(float(hz) for hz in chosen.get("cutoff_hz", ()))
        texts = tuple(f"{name}={value}" for name, value in other.items())
        return cls(run, method, texts, cutoffs, not given, rms_mm)

    @property
    def cutoff_text(self) -> str:
        """The cut-offs in Hz; "" where unknown."""
        return wording.cutoffs(self.cutoffs_hz)


@dataclass(frozen=True)
class AsideRow:
    """Samples that were set aside for one reason: the id of the detector, or "by hand"."""

    problem: str
    runs: int
    samples: int


@dataclass(frozen=True)
class PutRight:
    """All of it.

    Attributes
    ----------
    aside : tuple of AsideRow
        What was set aside, most samples first.
    moved_runs, moved_samples, moved_markers : int
        What is held by another marker than it was stored as: runs, samples, and of how many
        markers.
    found_as : tuple of (str, int)
        Ids of the detectors that found what was exchanged, and how many problems; empty where
        that is not known.
    smoothed : tuple of SmoothRow
        The smoothed runs, by marker and start.
    renamed : tuple of (str, str)
        The first and the present label of each marker that was renamed.
    bad : tuple of Gap
        Where the recording before holds what nobody shall believe: samples that are set aside,
        or that belong to another marker.
    """

    aside: tuple[AsideRow, ...] = ()
    moved_runs: int = 0
    moved_samples: int = 0
    moved_markers: int = 0
    found_as: tuple[tuple[str, int], ...] = ()
    smoothed: tuple[SmoothRow, ...] = ()
    renamed: tuple[tuple[str, str], ...] = ()
    bad: tuple[Gap, ...] = ()

    def __bool__(self) -> bool:
        return bool(self.aside or self.moved_runs or self.smoothed)

    def wrong_in(self, before: Recording) -> BoolArray:
        """Say which samples of the recording before were there but wrong, (frames, markers)."""
        return marked(self.bad, before) & before.present

    @property
    def smoothed_markers(self) -> int:
        """How many markers are smoothed somewhere."""
        return len({row.run.marker for row in self.smoothed})


NOTHING_PUT_RIGHT = PutRight()


def marked(runs: Iterable[Gap], recording: Recording) -> BoolArray:
    """Mark the samples of runs of a recording, shape (frames, markers)."""
    mask = np.zeros(recording.present.shape, np.bool_, order="F")
    for run in runs:
        mask[run.start : run.stop, run.marker] = True
    return mask


class _Reasoned(Protocol):
    @property
    def problem(self) -> str: ...


def put_right(
    set_aside: Mapping[Gap, _Reasoned],
    moves: Sequence[Move],
    smoothed: Iterable[SmoothRow],
    found_as: Mapping[str, int] | None = None,
    *,
    moved_before: Iterable[Move] = (),
    renamed: Iterable[Renamed] = (),
) -> PutRight:
    """Gather what was put right.

    Parameters
    ----------
    set_aside : mapping of Gap to what has a problem's id
        The runs that are set aside.
    moves : sequence of Move
        What is not where it was stored.
    smoothed : iterable of SmoothRow
        What is smoothed.
    found_as : mapping of str to int, optional
        See `PutRight`.
    moved_before : iterable of Move
        Which of that the recording before has had already.
    renamed : iterable of Renamed
        What is called otherwise.
    """
    of_problem: dict[str, list[Gap]] = {}
    for run, entry in set_aside.items():
        of_problem.setdefault(entry.problem, []).append(run)
    aside = [
        AsideRow(problem, len(runs), sum(run.length for run in runs))
        for problem, runs in of_problem.items()
    ]
    return PutRight(
        aside=tuple(sorted(aside, key=lambda row: (-row.samples, row.problem))),
        moved_runs=len(moves),
        moved_samples=sum(move.run.length for move in moves),
        moved_markers=len({move.marker for move in moves}),
        found_as=tuple((found_as or {}).items()),
        smoothed=tuple(sorted(smoothed, key=lambda row: row.run)),
        renamed=tuple((entry.former, entry.marker) for entry in renamed),
        bad=tuple(merged_runs([*set_aside, *(move.run for move in {*moves} ^ {*moved_before})])),
    )
