"""Which differences between a file and its repaired copy their repair records allow."""

from collections.abc import Iterable, Iterator

import numpy as np
from numpy.typing import NDArray

from mocapmend.files.c3d_layout import Layout
from mocapmend.files.check_corrections import Order
from mocapmend.files.findings import Findings
from mocapmend.files.provenance import Provenance
from mocapmend.files.records import RecordedRun
from mocapmend.files.repairs import listed_samples


class Allowed:
    """What the repair records allow to differ; found samples that they do are forgiven.

    Attributes
    ----------
    unlisted, protected : ndarray of bool, shape (frames, points)
        Samples that differ although the record does not list them, or keeps them missing.
    """

    def __init__(
        self,
        order: Order,
        earlier: Provenance | None,
        record: Provenance | None,
        found: Findings,
        layout: Layout,
    ) -> None:
        reverted = found.forgive(order.of(_listed(earlier, layout)))
        self.exchanged = order.exchanged
        self.ends = self.set_aside = self.smoothed = 0
        self.unlisted = np.zeros_like(found.changed)
        self.protected = np.zeros_like(found.changed)
        if record is None:
            return
        smoothed = _marked(record.corrections.smoothed, layout)
        aside = _marked(record.corrections.set_aside, layout)
        self.smoothed = int(np.count_nonzero(found.changed & found.measured & smoothed))
        found.measured &= ~smoothed
        self.set_aside = found.forgive_set_aside(aside)
        self.ends = found.forgive_ends(_runs(record, layout))
        rest = found.changed & ~reverted & ~found.restored
        self.protected = rest & _marked(record.kept_open, layout) & ~aside
        known = _marked(record.repairs, layout) | aside | smoothed | self.protected
        self.unlisted = rest & ~known

    def sentences(self) -> Iterator[str]:
        """Say what differs besides missing samples and may."""
        for count, what in (
            (self.ends, "at the ends of repaired gaps were replaced"),
            (self.set_aside, "were set aside, or are no longer"),
            (self.smoothed, "were smoothed"),
        ):
            if count:
                plural = "" if count == 1 else "s"
                yield f"{count} measured sample{plural} {what}; the repair record lists them."
        if self.exchanged:
            plural = "" if self.exchanged == 1 else "s"
            yield (
                f"{self.exchanged} sample{plural} changed places between markers; the repair "
                "record lists them."
            )


def _listed(record: Provenance | None, layout: Layout) -> NDArray[np.bool_]:
    """Mark the samples that a record says were replaced, shape (frames, points)."""
    if record is None:
        return _marked((), layout)
    return _marked(record.repairs, layout) | _marked(record.corrections.smoothed, layout)


def _marked(entries: Iterable[RecordedRun], layout: Layout) -> NDArray[np.bool_]:
    """Mark the samples of entries, shape (frames, points)."""
    return listed_samples(entries, (layout.frames, layout.points), layout.first_frame)


def _runs(record: Provenance, layout: Layout) -> Iterator[tuple[slice, int]]:
    """Yield frames and point of the repairs that a record lists."""
    for repair in record.repairs:
        start, stop = repair.rows(layout.first_frame)
        if 0 < repair.point <= layout.points:
            yield slice(max(start, 0), max(stop, 0)), repair.point - 1
