"""Which markers a repair is about. No Qt."""

from collections.abc import Collection, Sequence
from dataclasses import replace

from mocapmend.errors import MocapmendError
from mocapmend.files import Source
from mocapmend_algorithms import Gap
from mocapmend_algorithms.fill.contract import FillResult, Unfilled

NOT_CHOSEN = "the marker is not among those asked for"
MOST_LISTED = 60


def choose(source: Source, words: Sequence[str] | None) -> frozenset[int]:
    """Find markers by their labels.

    Parameters
    ----------
    source : Source
        Where to look.
    words : sequence of str, optional
        Labels, or several joined by commas; all markers if None. A label that several markers
        have means all of them.

    Returns
    -------
    frozenset of int
        Indices of markers.

    Raises
    ------
    MocapmendError
        If there is no such marker.
    """
    labels = source.recording.labels
    if words is None:
        return frozenset(range(len(labels)))
    # A label may hold a comma itself.
    parts = [part for word in words for part in ([word] if word in labels else word.split(","))]
    wanted = {part.strip() for part in parts} - {""}
    require(source, wanted)
    return frozenset(index for index, label in enumerate(labels) if label in wanted)


def require(source: Source, wanted: Collection[str]) -> None:
    """Make sure that a recording has markers of these labels.

    Raises
    ------
    MocapmendError
        If there is no such marker.
    """
    unknown = sorted(set(wanted).difference(source.recording.labels))
    if unknown:
        known = list(dict.fromkeys(source.recording.labels))
        listed = ", ".join(known[:MOST_LISTED]) + (", ..." if len(known) > MOST_LISTED else "")
        raise MocapmendError(
            f"There is no marker {unknown[0]!r}.", str(source.path), f"The markers are: {listed}."
        )


def with_the_others(result: FillResult, gaps: Sequence[Gap], wanted: Collection[int]) -> FillResult:
    """Add the gaps of markers that were not asked for to those left open, in the gaps' order."""
    reasons = {entry.gap: entry for entry in result.unfilled}
    reasons |= {gap: Unfilled(gap, NOT_CHOSEN) for gap in gaps if gap.marker not in wanted}
    return replace(result, unfilled=tuple(reasons[gap] for gap in gaps if gap in reasons))
