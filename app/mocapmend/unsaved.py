"""What an export has to write, as it was at one moment: a thread works it out."""

from collections.abc import Mapping
from dataclasses import dataclass
from pathlib import Path
from typing import TYPE_CHECKING

import numpy as np
from numpy.typing import NDArray

from mocapmend import engine
from mocapmend.changes import Changes, Repaired, renames, smoothed_record
from mocapmend.exporting import Apart, Exported
from mocapmend.files import KeptGap, RepairRecord, SmoothedRun, Source
from mocapmend.layers import Layers
from mocapmend.written import Places
from mocapmend_algorithms import Gap, Progress

if TYPE_CHECKING:
    from mocapmend.edits import Repair, Smoothed


@dataclass(frozen=True, eq=False)
class Unsaved:
    """Samples that may differ from those of the file, and all repairs.

    Attributes
    ----------
    layers : Layers
        What was exchanged and set aside.
    places : Places
        Where the samples are.
    values : ndarray, shape (n, 3)
        What is there, NaN where missing.
    repairs : mapping of Gap to Repair
        Earlier ones included.
    smoothed : mapping of Gap to Smoothed
        The runs that are smoothed.
    labels : tuple of str
        What the markers are called.
    never, set_aside : mapping of Gap to str
        Gaps that shall never be filled, and that the user left open, with the reasons.
    """

    layers: Layers
    places: Places
    values: NDArray[np.float64]
    repairs: "Mapping[Gap, Repair]"
    never: Mapping[Gap, str]
    set_aside: Mapping[Gap, str]
    smoothed: "Mapping[Gap, Smoothed]"
    labels: tuple[str, ...]

    def changes(self) -> Changes:
        """Return what differs from the file."""
        fills = dict(zip(sorted(self.repairs), self.records(), strict=True))
        kept, smoothed = self._kept_open(), self._smoothed()
        return Repaired(
            self.layers,
            self.places,
            self.values,
            fills,
            kept,
            smoothed,
            renames(self.source, self.labels),
        ).changes()

    def _smoothed(self) -> dict[Gap, SmoothedRun]:
        earlier = self.source.smoothed
        return {
            run: earlier[run]
            if run in earlier and made.params is earlier[run].parameters
            else smoothed_record(self.source, run, *made)
            for run, made in self.smoothed.items()
        }

    @property
    def source(self) -> Source:
        """The file."""
        return self.layers.source

    def records(self) -> tuple[RepairRecord, ...]:
        """Return all repairs as the repair record has them."""
        return tuple(
            engine.record(self.source, made.patch, made.method, made.params, donors=made.donors)
            for _, made in sorted(self.repairs.items(), key=lambda item: item[0])
        )

    def kept_open(self) -> tuple[KeptGap, ...]:
        """Return the gaps that are kept open as the repair record has them."""
        return tuple(self._kept_open().values())

    def _kept_open(self) -> dict[Gap, KeptGap]:
        kept = {self._missing(gap): (True, reason) for gap, reason in self.never.items()}
        kept |= {self._missing(gap): (False, reason) for gap, reason in self.set_aside.items()}
        return {
            gap: engine.kept_gap(self.source, gap, never=kept[gap][0], reason=kept[gap][1])
            for gap in sorted(kept)
        }

    def _missing(self, gap: Gap) -> Gap:
        """Return a gap without the measured samples that its ends cover: the file keeps these."""
        present = self.layers.recording.present[gap.start : gap.stop, gap.marker]
        gone = gap.start + np.flatnonzero(~present)
        return Gap(gap.marker, int(gone[0]), int(gone[-1]) + 1)


def export(
    unsaved: Unsaved,
    out: Path,
    replace_source: bool,  # noqa: FBT001 - a job passes its arguments by position
    apart: Apart | None,
    progress: Progress,
) -> Exported:
    """Write the repaired copy of an open recording; see `engine.export`.

    The user has agreed to whatever the file lacks.

    Raises
    ------
    MocapmendError
        If it cannot be written, or if a proof fails. Then nothing has changed.
    """
    source = unsaved.source
    changes = unsaved.changes()
    return engine.export(source, changes, out, replace_source, source.truncated, progress, apart)


def write_recipe(unsaved: Unsaved, path: Path, progress: Progress) -> None:
    """Write the recipe of an open recording; see `recipe.write_recipe`.

    Raises
    ------
    MocapmendError
        If it cannot be written.
    """
    # Not at the top: the window starts without it.
    from mocapmend import recipe

    recipe.write_recipe(
        unsaved.source,
        unsaved.records(),
        path,
        progress,
        kept_open=unsaved.kept_open(),
        corrections=unsaved.changes().corrections,
    )
