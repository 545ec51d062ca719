"""Labels for points that have none, learned from recordings that have them.

1. `LabelModel.learn`: what a labelled recording says about its markers (model.py).
2. The stretches of the points within which nothing jumps are its pieces (pieces.py).
3. `label`: which label each piece has (search.py), how sure, and why (confidence.py).
4. `changes`: the names and exchanges that make each label one point (changes.py).
"""

from mocapmend_algorithms.labelling.changes import LabelChanges, changes, labelled_recording
from mocapmend_algorithms.labelling.model import LabelModel
from mocapmend_algorithms.labelling.proposal import LabelParams, label
from mocapmend_algorithms.labelling.result import Labelled, Labelling, Piece

__all__ = [
    "LabelChanges",
    "LabelModel",
    "LabelParams",
    "Labelled",
    "Labelling",
    "Piece",
    "changes",
    "label",
    "labelled_recording",
]
