"""Names and exchanges after which each label is one point."""

from collections.abc import Sequence
from dataclasses import dataclass, replace

import numpy as np

from mocapmend_algorithms.arrays import IntArray
from mocapmend_algorithms.corrections import Exchange, corrected
from mocapmend_algorithms.gaps import Gap, runs
from mocapmend_algorithms.labelling.result import Labelled, Labelling
from mocapmend_algorithms.names import without_subject
from mocapmend_algorithms.recording import Recording


@dataclass(frozen=True)
class LabelChanges:
    """What makes a labelling true.

    Attributes
    ----------
    names : dict of int to str
        The new label of each point that gets another one.
    exchanges : tuple of Exchange
        In this order; see `mocapmend_algorithms.corrections`.
    left_over : tuple of Gap
        Where, after the exchanges, a labelled point holds what is not its own, because no other
        point is free for it: to be set aside.
    """

    names: dict[int, str]
    exchanges: tuple[Exchange, ...]
    left_over: tuple[Gap, ...]


def changes(
    labelling: Labelling, recording: Recording, *, least_confidence: float = 0.0
) -> LabelChanges:
    """Work out how each label becomes one point.

    A label's point is the one that holds most of its samples, or that has been trusted to be it.
    What other points hold of it is exchanged into its own, and what its own point holds besides is
    exchanged into a point that is no label's and has nothing there.

    Parameters
    ----------
    labelling : Labelling
        Of this recording.
    recording : Recording
        The recording.
    least_confidence : float
        Proposals below it are left as they are: their samples count as not labelled.

    Returns
    -------
    LabelChanges
    """
    used = [
        proposal
        for proposal in labelling.proposals
        if proposal.label is not None and (proposal.kept or proposal.confidence >= least_confidence)
    ]
    homes = _homes(labelling, used, recording.markers)
    # The label of each stored sample; a sample of no label is -1, a missing one -2.
    content = np.where(recording.present, -1, -2)
    for proposal in used:
        piece = proposal.piece
        # A recording may have fewer points than labels.
        label = proposal.label if proposal.label in homes else -1
        content[piece.start : piece.stop, piece.point] = label
    exchanges = _gather(content, homes)
    # What has a name of its own is no place for what is left over.
    named = {p.piece.point for p in labelling.proposals if p.kept and p.label is None}
    moved, left_over = _clear(content, homes, named)
    names = _names(labelling.labels, homes, recording.labels)
    return LabelChanges(names, (*exchanges, *moved), left_over)


def _homes(labelling: Labelling, used: Sequence[Labelled], points: int) -> dict[int, int]:
    """Return the point of each label that has one."""
    from scipy.optimize import linear_sum_assignment

    samples = np.zeros((len(labelling.labels), points))
    for proposal in used:
        assert proposal.label is not None
        # A point that is trusted to be a label is its own, however little it holds.
        worth = proposal.piece.length * (1.0 if not proposal.kept else 1e6)
        samples[proposal.label, proposal.piece.point] += worth
    labels, homes = linear_sum_assignment(samples, maximize=True)
    return {
        label: home
        for label, home in zip(labels.tolist(), homes.tolist(), strict=True)
        if samples[label].any()
    }


def _gather(content: IntArray, homes: dict[int, int]) -> list[Exchange]:
    """Bring what is a label's into its point, label by label; `content` follows."""
    made = []
    for label, home in homes.items():
        for point in np.flatnonzero((content == label).any(axis=0)).tolist():
            if point == home:
                continue
            for start, stop in runs(content[:, point] == label):
                made.append(Exchange(point, home, start, stop))
                pair = [point, home]
                content[start:stop, pair] = content[start:stop, pair[::-1]]
    return made


def _clear(
    content: IntArray, homes: dict[int, int], named: set[int]
) -> tuple[list[Exchange], tuple[Gap, ...]]:
    """Bring what is no label's out of the points of labels, where there is room."""
    made: list[Exchange] = []
    left = []
    taken = named.union(homes.values())
    others = [point for point in range(content.shape[1]) if point not in taken]
    for home in homes.values():
        for start, stop in runs(content[:, home] == -1):
            free = next((p for p in others if (content[start:stop, p] == -2).all()), None)
            if free is None:
                left.append(Gap(home, start, stop))
                continue
            made.append(Exchange(home, free, start, stop))
            content[start:stop, [home, free]] = content[start:stop, [free, home]]
    return made, tuple(sorted(left))


def _names(labels: Sequence[str], homes: dict[int, int], old: Sequence[str]) -> dict[int, str]:
    """Return the labels that change; a point that is called like a label but is not it, gets *n."""
    subjects = {label.rpartition(":")[0] for label in old if ":" in label}
    # One subject: its points go on being called after it.
    prefix = f"{subjects.pop()}:" if len(subjects) == 1 else ""
    new = {
        home: old[home] if without_subject(old[home]) == labels[label] else prefix + labels[label]
        for label, home in homes.items()
    }
    taken = {without_subject(name) for name in new.values()}
    number = 0
    used = set(old)
    for point, label in enumerate(old):
        if point not in new and without_subject(label) in taken:
            while f"*{number}" in used:
                number += 1
            new[point] = f"*{number}"
            used.add(new[point])
    return {point: name for point, name in sorted(new.items()) if name != old[point]}


def labelled_recording(recording: Recording, made: LabelChanges) -> Recording:
    """Return a recording with changes made: renamed, exchanged, and what is left over missing.

    Raises
    ------
    ValueError
        If they are another recording's.
    """
    labels = tuple(made.names.get(k, label) for k, label in enumerate(recording.labels))
    return replace(corrected(recording, made.exchanges, made.left_over), labels=labels)
