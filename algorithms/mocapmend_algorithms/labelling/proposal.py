"""A label for each piece of a recording."""

from dataclasses import dataclass, replace

import numpy as np

from mocapmend_algorithms.labelling.confidence import judged
from mocapmend_algorithms.labelling.model import LabelModel
from mocapmend_algorithms.labelling.pieces import cut_pieces
from mocapmend_algorithms.labelling.result import Labelled, Labelling
from mocapmend_algorithms.labelling.search import Search
from mocapmend_algorithms.labelling.upright import upright
from mocapmend_algorithms.names import named_points
from mocapmend_algorithms.params import option
from mocapmend_algorithms.progress import Progress, part
from mocapmend_algorithms.recording import Recording

HAS_NAME = "It has this name already."
OTHER_NAME = "It has a name that the labelled recordings do not have, and is left alone."


@dataclass(frozen=True)
class LabelParams:
    """What a recording's own names are worth."""

    keep_names: bool = option(
        default=True,
        label="Keep names",
        text="Trust the names that the recording has, and label the rest.",
    )
    doubted: tuple[str, ...] = option(
        (),
        label="Doubted names",
        text="Points with these names are labelled anew though names are kept.",
    )


def label(
    recording: Recording, model: LabelModel, params: LabelParams, progress: Progress
) -> Labelling:
    """Propose a label for each piece of a recording's points.

    Parameters
    ----------
    recording : Recording
        Points without labels, or of which some have labels. Trajectories may be in many pieces,
        several of which are one point; markers may be missing; there may be points that are no
        marker. Start pose, heading, place and size of the body do not matter.
    model : LabelModel
        Of the same marker set.
    params : LabelParams
        What its own names are worth.
    progress : Progress
        Called often; may cancel.

    Returns
    -------
    Labelling
        Empty for a recording without points.
    """
    kept, others = _trusted(recording, model, params)
    points = upright(recording)
    cut = cut_pieces(points, recording.rate)
    pieces = [piece for piece in cut if piece.point not in others]
    fixed = np.array([kept.get(piece.point, -1) for piece in pieces], np.int64)
    left = [
        Labelled(piece, None, 1.0, OTHER_NAME, kept=True) for piece in cut if piece.point in others
    ]
    if not pieces:
        progress(1.0)
        return Labelling(model.labels, tuple(left), float("nan"))
    search = Search(model, points, pieces, fixed)
    search.run(part(progress, 0.0, 0.98))
    proposals = [
        replace(proposal, confidence=1.0, reason=HAS_NAME, kept=True) if known >= 0 else proposal
        for proposal, known in zip(judged(search), fixed.tolist(), strict=True)
    ]
    progress(1.0)
    scale = search.scale if (search.labels >= 0).any() else float("nan")
    return Labelling(model.labels, tuple(sorted([*left, *proposals], key=_place)), scale)


def _place(proposal: Labelled) -> tuple[int, int]:
    return proposal.piece.point, proposal.piece.start


def _trusted(
    recording: Recording, model: LabelModel, params: LabelParams
) -> tuple[dict[int, int], set[int]]:
    """Return the label of each point whose name is kept, and the points with other names."""
    if not params.keep_names:
        return {}, set()
    named = named_points(recording.labels)
    index = {name: k for k, name in enumerate(model.labels)}
    believed = {name: point for name, point in named.items() if name not in params.doubted}
    kept = {point: index[name] for name, point in believed.items() if name in index}
    return kept, {point for name, point in believed.items() if name not in index}
