"""Labels that were proposed for a recording, made true. No Qt."""

from dataclasses import replace

from mocapmend.changes import Repaired, earlier, renames
from mocapmend.doubts import Doubt
from mocapmend.layers import Layers
from mocapmend_algorithms import Gap
from mocapmend_algorithms.labelling import LabelChanges, Labelling, changes

LEFT_OVER = Doubt("labels", "It belongs to none of the labels.")


def relabelled(layers: Layers, labelling: Labelling, least_confidence: float) -> Repaired:
    """Return a recording in which each label is one point.

    Parameters
    ----------
    layers : Layers
        What was corrected before; the labels were proposed for its recording.
    labelling : Labelling
        The proposals.
    least_confidence : float
        Those below it are left as they are.
    """
    found = changes(labelling, layers.recording, least_confidence=least_confidence)
    made = earlier(layers.corrected(found.exchanges, doubts(found)))
    labels = list(layers.source.recording.labels)
    for point, label in found.names.items():
        labels[point] = label
    return replace(made, renamed=renames(layers.source, labels))


def doubts(found: LabelChanges) -> dict[Gap, Doubt]:
    """Return what is to be set aside, since no point is free for it."""
    return dict.fromkeys(found.left_over, LEFT_OVER)
