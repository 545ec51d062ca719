"""What `repair` says about what it did: JSON, text, and the head of the report."""

import dataclasses
from collections.abc import Mapping
from dataclasses import dataclass
from functools import cached_property
from pathlib import Path
from typing import Any

import numpy as np

from mocapmend.cli import common
from mocapmend.cli.console import Console
from mocapmend.engine import Exported, repaired
from mocapmend.files import Source
from mocapmend.report import About, EditRow, Methods, RepairRow, describe, method_text, summarise
from mocapmend_algorithms import Recording, no_progress
from mocapmend_algorithms.fill.contract import FillResult
from mocapmend_algorithms.fill.limits import Limits
from mocapmend_algorithms.fill.registry import Method
from mocapmend_algorithms.skeleton import Skeleton

_NOTHING_WRITTEN: Mapping[str, Any] = dict.fromkeys(
    (
        "methods_paragraph",
        "references",
        "repair_record",
        "converted_to_floats",
        "notes",
        "second_reader",
        "check",
    )
)


@dataclass(frozen=True, eq=False)
class Outcome:
    """A finished repair, or a dry run: then nothing is exported."""

    source: Source
    method: Method
    params: Any
    limits: Limits
    result: FillResult
    exported: Exported | None

    @cached_property
    def repairs(self) -> tuple[RepairRow, ...]:
        """The filled gaps."""
        recording, method = self.source.recording, self.method.id
        return tuple(
            RepairRow.of(patch, method, recording, self.result.donors(patch.gap))
            for patch in self.result.patches
        )

    @property
    def all_repairs(self) -> tuple[RepairRow, ...]:
        """The gaps that the file's earlier repairs fill, and those that were filled now."""
        known = zip(self.source.repaired, self.source.repairs, strict=True)
        rows = [RepairRow.from_record(gap, record) for gap, record in known]
        return tuple(sorted([*rows, *self.repairs], key=lambda row: row.gap))

    @property
    def about(self) -> About:
        """The head of the report."""
        provenance = self.source.provenance
        return About(
            file=self.source.path.name,
            methods=(self._method_text(),),
            limits=self._limits_text(),
            warnings=self.source.warnings,
            earlier=len(self.source.repairs),
            earlier_program=provenance.program if provenance is not None else "",
            proof=() if self.exported is None else self.exported.sentences,
            edits=self._edits(),
        )

    def _edits(self) -> tuple[EditRow, ...]:
        gaps = [row.gap for row in self.repairs]
        if not gaps:
            return ()
        text = f"fill {common.count(len(gaps), 'gap')} ({self.method.id})"
        markers, samples = {gap.marker for gap in gaps}, sum(gap.length for gap in gaps)
        return (EditRow(text, len(markers), len(gaps), samples),)

    @property
    def after(self) -> Recording:
        """The recording with all its repairs."""
        return repaired(self.source.recording, self.result)

    def methods(self) -> Methods:
        """Return what a paper says about it."""
        no_bones = Skeleton("", (), "none")
        rows, unfilled = self.all_repairs, self.result.unfilled
        figures = summarise(self.source.measured, self.after, no_bones, rows, unfilled, no_progress)
        return describe(figures, self.about)

    # --- JSON --------------------------------------------------------------------------------

    def as_json(self, files: Mapping[str, Path | None], *, samples: bool) -> dict[str, Any]:
        """Return the document's content."""
        recording = self.source.recording
        missing = int(np.count_nonzero(~recording.present))
        filled = sum(row.gap.length for row in self.repairs)
        exported = self.exported
        return {
            **common.facts(self.source),
            "dry_run": exported is None,
            "output": None if exported is None else str(exported.saved.path),
            **{name: None if path is None else str(path) for name, path in files.items()},
            "method": self.method.id,
            "parameters": dataclasses.asdict(self.params),
            "limits": {
                "default_guard": self.limits.default,
                "max_gap_frames": self.limits.frames(self.method, recording.rate),
                "max_error_mm": self.limits.error_mm,
            },
            "gaps": self._gaps(samples=samples),
            "totals": {
                "gaps": len(self.repairs) + len(self.result.unfilled),
                "filled": len(self.repairs),
                "left_open": len(self.result.unfilled),
                "samples_filled": filled,
                "samples_missing_before": missing,
                "samples_missing_after": missing - filled,
            },
            **(_NOTHING_WRITTEN if exported is None else self._as_written(exported)),
        }

    def _as_written(self, exported: Exported) -> dict[str, Any]:
        methods = self.methods()
        return {
            "methods_paragraph": methods.paragraph,
            "references": list(methods.references),
            **common.written(exported),
        }

    def _gaps(self, *, samples: bool) -> list[dict[str, Any]]:
        recording = self.source.recording
        rows = {}
        for repair, patch in zip(self.repairs, self.result.patches, strict=True):
            rows[repair.gap] = {
                **common.place(recording, repair.gap),
                "method": repair.method,
                "donors": list(repair.donors),
                "expected_error_mm": repair.expected_error_mm,
                "r90_mm": repair.r90_mm,
                "filled": True,
                "reason": None,
            }
            if samples:
                rows[repair.gap]["r90_samples_mm"] = (patch.r90 * recording.mm).tolist()
        for entry in self.result.unfilled:
            rows[entry.gap] = {
                **common.place(recording, entry.gap),
                "method": None,
                "donors": [],
                "expected_error_mm": None,
                "r90_mm": None,
                "filled": False,
                "reason": entry.reason,
            }
            if samples:
                rows[entry.gap]["r90_samples_mm"] = None
        return [rows[gap] for gap in sorted(rows)]

    # --- text --------------------------------------------------------------------------------

    def show(self, console: Console, files: Mapping[str, Path | None]) -> None:
        """Print it for people."""
        exported = self.exported
        if exported is None:
            console.say("Dry run:  nothing is written")
        else:
            console.say(f"Repaired: {exported.saved.path}")
        for name, path in files.items():
            if path is not None:
                console.say(f"{name.capitalize() + ':':<10}{path}")
        console.say(f"Method:   {self._method_text()}")
        console.say(f"Limits:   {self._limits_text()}")
        total = len(self.repairs) + len(self.result.unfilled)
        filled = sum(row.gap.length for row in self.repairs)
        title = "To fill:" if exported is None else "Filled:"
        console.say(
            f"{title:<10}{len(self.repairs)} of {common.count(total, 'gap')}, "
            f"{common.count(filled, 'sample')}{self._worst()}"
        )
        for note in () if exported is None else exported.sentences:
            console.say(note)
        self._show_open_gaps(console)

    def _show_open_gaps(self, console: Console) -> None:
        unfilled, recording = self.result.unfilled, self.source.recording
        if not unfilled:
            return
        console.say(f"\n{common.count(len(unfilled), 'gap')} left open:")
        console.table(
            ("Marker", ">Frames", ">Length", "Why"),
            [
                (
                    recording.labels[entry.gap.marker],
                    common.frames_text(recording, entry.gap),
                    str(entry.gap.length),
                    entry.reason,
                )
                for entry in unfilled[: common.MOST_ROWS]
            ],
        )
        if len(unfilled) > common.MOST_ROWS:
            console.say(
                f"and {len(unfilled) - common.MOST_ROWS} more: --json and --report list them all."
            )
        if self.limits.default:
            console.say("--max-gap and --max-error replace the default guard.")

    def _worst(self) -> str:
        known = [row for row in self.repairs if not np.isnan(row.expected_error_mm)]
        if not known:
            return ""
        worst = max(known, key=lambda row: row.expected_error_mm)
        recording = self.source.recording
        return (
            f"; largest expected error {worst.expected_error_mm:.1f} mm "
            f"({recording.labels[worst.gap.marker]}, frames "
            f"{common.frames_text(recording, worst.gap)})"
        )

    def _method_text(self) -> str:
        return method_text(self.method.id, self.params)

    def _limits_text(self) -> str:
        rate = self.source.recording.rate
        frames = self.limits.frames(self.method, rate)
        parts = []
        if frames is not None:
            longest = common.count(frames, "frame")
            parts.append(f"no gap longer than {longest} ({1000 * frames / rate:.0f} ms)")
        if np.isfinite(self.limits.error_mm):
            parts.append(f"no expected error above {self.limits.error_mm:g} mm")
        return (", ".join(parts) or "none") + (" (default guard)" if self.limits.default else "")
