"""Labels for points that have none, learned from recordings that have them.

1. `LabelModel.learn`: what a labelled recording says about its markers (model.py).
2. `cut_pieces`: the stretches of the points within which nothing jumps (pieces.py).
3. `label`: which label each piece has, how sure, and why (proposal.py).
4. `changes`: the names and exchanges that make each label one point (changes.py).
"""

from mocapmend_algorithms.labelling.changes import LabelChanges, changes
from mocapmend_algorithms.labelling.result import Labelled, Labelling, Piece

__all__ = [
    "LabelChanges",
    "Labelled",
    "Labelling",
    "Piece",
    "changes",
]
