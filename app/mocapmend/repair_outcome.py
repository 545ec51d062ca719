"""What became of one file that was repaired by a plan. No Qt."""

from collections import Counter
from collections.abc import Sequence
from dataclasses import dataclass
from functools import cached_property
from typing import Any

import numpy as np

from mocapmend.changes import Repaired, earlier, filled, smoothed
from mocapmend.engine import Exported
from mocapmend.files import Source
from mocapmend.fixing import exchanged_kinds
from mocapmend.layers import Layers
from mocapmend.prospects import Way
from mocapmend.report import (
    About,
    EditRow,
    Methods,
    PutRight,
    RepairRow,
    SmoothRow,
    describe,
    method_text,
    put_right,
    refining,
    summarise,
)
from mocapmend.wording import count, span
from mocapmend_algorithms import Gap, Recording, no_progress
from mocapmend_algorithms.fill import registry
from mocapmend_algorithms.fill.contract import FillResult
from mocapmend_algorithms.fill.limits import Limits
from mocapmend_algorithms.fill.registry import Method
from mocapmend_algorithms.problems import BadRun
from mocapmend_algorithms.problems.registry import detector
from mocapmend_algorithms.skeleton import Skeleton
from mocapmend_algorithms.smooth.contract import SmoothResult


@dataclass(frozen=True, eq=False)
class Outcome:
    """A finished repair, or a dry run.

    Attributes
    ----------
    layers : Layers
        What was exchanged and set aside, by earlier repairs too.
    fixed : tuple of BadRun
        The bad samples that were found and put right now.
    way : Way
        The method and its parameters.
    limits : Limits
        What it was allowed to fill.
    result : FillResult
        Every gap, filled or with the reason why it is open.
    smoothing : SmoothResult or None
        What was smoothed after that; None without smoothing.
    exported : Exported or None
        What was written, and the proofs; None in a dry run.
    """

    layers: Layers
    fixed: tuple[BadRun, ...]
    way: Way
    limits: Limits
    result: FillResult
    smoothing: SmoothResult | None
    exported: Exported | None

    @property
    def source(self) -> Source:
        """The file as it was read."""
        return self.layers.source

    @cached_property
    def made(self) -> Repaired:
        """The recording with all its repairs, layer by layer."""
        made = filled(earlier(self.layers), self.result, *self.way)
        return made if self.smoothing is None else smoothed(made, self.smoothing)

    @property
    def method(self) -> Method:
        """The method."""
        return registry.method(self.way.method)

    @property
    def params(self) -> Any:
        """Its parameter dataclass."""
        return self.way.params

    @cached_property
    def repairs(self) -> tuple[RepairRow, ...]:
        """The filled gaps."""
        recording, method = self.source.recording, self.way.method
        return tuple(
            RepairRow.of(patch, method, recording, self.result.donors(patch.gap))
            for patch in self.result.patches
        )

    @property
    def all_repairs(self) -> tuple[RepairRow, ...]:
        """The gaps that the file's earlier repairs fill, and those that were filled now."""
        rows = [RepairRow.from_record(gap, record) for gap, record in self.layers.earlier.items()]
        return tuple(sorted([*rows, *self.repairs], key=lambda row: row.gap))

    @property
    def samples_filled(self) -> int:
        """Number of samples that were filled."""
        return sum(row.gap.length for row in self.repairs)

    @property
    def samples_missing(self) -> int:
        """Number of samples that were to be filled, bad ones included."""
        present = earlier(self.layers).recording.present
        return int(np.count_nonzero(~present))

    @property
    def after(self) -> Recording:
        """The recording with all its repairs."""
        return self.made.recording

    @property
    def about(self) -> About:
        """The head of the report."""
        provenance = self.source.provenance
        return About(
            file=self.source.path.name,
            methods=(self.method_text,),
            limits=self.limits_text,
            warnings=self.source.warnings,
            earlier=len(self.source.repairs),
            earlier_program=provenance.program if provenance is not None else "",
            proof=() if self.exported is None else self.exported.sentences,
            edits=self._edits(),
            put_right=self.put_right,
            refining=refining(provenance),
        )

    @cached_property
    def put_right(self) -> PutRight:
        """What was set aside, exchanged and smoothed, by earlier repairs too."""
        found = Counter(exchanged_kinds(self.fixed))
        smoothed = (
            SmoothRow.of(run, one.method, one.parameters, one.chosen, one.rms_change_mm)
            for run, one in self.made.smoothed.items()
        )
        layers = self.layers
        return put_right(
            layers.set_aside,
            layers.moves,
            smoothed,
            found,
            moved_before=layers.source.moves,
            renamed=self.made.renamed,
        )

    @property
    def method_text(self) -> str:
        """The method with those parameters that were chosen."""
        return method_text(*self.way)

    @property
    def limits_text(self) -> str:
        """The limits that held, as a sentence."""
        rate = self.source.recording.rate
        frames = self.limits.frames(self.method, rate)
        parts = []
        if frames is not None:
            longest = count(frames, "frame")
            parts.append(f"no gap longer than {longest} ({1000 * frames / rate:.0f} ms)")
        if np.isfinite(self.limits.error_mm):
            parts.append(f"no expected error above {self.limits.error_mm:g} mm")
        return (", ".join(parts) or "none") + (" (default guard)" if self.limits.default else "")

    def place(self, gap: Gap) -> str:
        """Say where a gap is: marker and frames as the file counts them."""
        recording = self.source.recording
        first = recording.first_frame
        frames = span(first + gap.start, first + gap.stop - 1)
        return f"{recording.labels[gap.marker]}, frames {frames}"

    def methods(self) -> Methods:
        """Return what a paper says about it."""
        no_bones = Skeleton("", (), "none")
        rows, unfilled = self.all_repairs, self.result.unfilled
        figures = summarise(
            self.source.measured,
            self.after,
            no_bones,
            rows,
            unfilled,
            no_progress,
            self.put_right,
        )
        return describe(figures, self.about)

    def _edits(self) -> tuple[EditRow, ...]:
        rows = []
        for kind in sorted({run.kind for run in self.fixed}):
            bad = [Gap(run.marker, run.start, run.stop) for run in self.fixed if run.kind == kind]
            word = "set aside" if detector(kind).remedy == "missing" else "exchange"
            cleared = sum(run.length for run in bad) if word == "set aside" else 0
            rows.append(_row(f"{word} {count(len(bad), 'run')} ({kind})", bad, cleared=cleared))
        gaps = [row.gap for row in self.repairs]
        if gaps:
            text = f"fill {count(len(gaps), 'gap')} ({self.way.method})"
            rows.append(_row(text, gaps, filled=self.samples_filled))
        if self.smoothing is not None and self.smoothing.runs:
            runs = [done.run for done in self.smoothing.runs]
            text = f"smooth {count(len(runs), 'marker')} ({self.smoothing.method})"
            rows.append(_row(text, runs))
        return tuple(rows)


def _row(text: str, runs: Sequence[Gap], filled: int = 0, cleared: int = 0) -> EditRow:
    return EditRow(text, len({run.marker for run in runs}), len(runs), filled, cleared)
