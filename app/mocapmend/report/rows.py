"""Many repairs described at once."""

from collections.abc import Sequence

from mocapmend.report.model import RepairRow
from mocapmend_algorithms import Recording
from mocapmend_algorithms.fill.contract import Patch


def repair_rows(
    made: Sequence[tuple[Patch, str, tuple[str, ...]]], recording: Recording
) -> list[RepairRow]:
    """Describe patches of a recording, each with its method and its donors; see `RepairRow.of`."""
    return [RepairRow.of(patch, method, recording, donors) for patch, method, donors in made]
