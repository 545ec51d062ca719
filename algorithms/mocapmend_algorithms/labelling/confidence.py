"""How sure each label is, and why."""

import math

from mocapmend_algorithms.labelling.costs import NOWHERE
from mocapmend_algorithms.labelling.margins import Margin, margins
from mocapmend_algorithms.labelling.result import Labelled
from mocapmend_algorithms.labelling.search import Search

# Logistic regression on what was right and wrong in the training half of `bench labels`.
LEVEL, OF_MARGIN, OF_LEAD, OF_COST = -1.0, 2.0, 1.0, 0.0
LARGEST_MARGIN, LARGEST_LEAD = 3.0, 4.0
LARGEST_COST = 6.0
NOBODY = -1.0, 1.5
"""Level and weight of the margin, of a piece that is to have no label."""
SURE = 0.8
"""From here on, a reason says what speaks for a label and not what speaks against it."""
MANY = 8
"""Labels: that many in another order are half of the body."""


def judged(search: Search) -> list[Labelled]:
    """Say how sure a search is of each piece's label.

    Parameters
    ----------
    search : Search
        That has run.

    Returns
    -------
    list of Labelled
        In the order of its pieces.
    """
    found = margins(search.table, search.labels, search.pieces)
    return [
        _with_label(search, k, margin) if search.labels[k] >= 0 else _without(search, k, margin)
        for k, margin in enumerate(found)
    ]


def features(search: Search, k: int, margin: Margin) -> tuple[float, float, float]:
    """Return what the confidence of a labelled piece rests on, within its bounds."""
    label = search.labels[k]
    return (
        float(min(margin.by, LARGEST_MARGIN)),
        float(min(search.order.lead[label], LARGEST_LEAD)),
        float(min(search.table[k, label], LARGEST_COST)),
    )


def _with_label(search: Search, k: int, margin: Margin) -> Labelled:
    label = int(search.labels[k])
    by, lead, cost = features(search, k, margin)
    confidence = _logistic(LEVEL + OF_MARGIN * by + OF_LEAD * lead + OF_COST * cost)
    names, order = search.model.labels, search.order
    where = _where(search, k)
    if confidence >= SURE:
        reason = f"{where}; no other label fits nearly as well."
    elif OF_MARGIN * by <= OF_LEAD * lead or not math.isfinite(lead):
        other = "being no marker at all" if margin.label < 0 else names[margin.label]
        reason = f"{where}, but {other} fits nearly as well."
    elif order.moved[label] >= MANY:
        reason = (
            f"{where}, but left and right can hardly be told apart: with {order.moved[label]} "
            f"labels in each other's place, and this one {names[order.rival[label]]}, the body "
            "fits nearly as well."
        )
    else:
        reason = (
            f"{where}, but throughout the recording {names[order.rival[label]]} is nearly as "
            "likely, by the shape of the body that was learned."
        )
    return Labelled(search.pieces[k], label, confidence, reason)


def _where(search: Search, k: int) -> str:
    label = search.model.labels[search.labels[k]]
    away = search.away[k]
    if math.isnan(away):
        return f"Its distances to the other markers are those of {label}"
    return f"It is {away:.0f} mm from where the other markers put {label}"


def _without(search: Search, k: int, margin: Margin) -> Labelled:
    level, weight = NOBODY
    confidence = _logistic(level + weight * min(max(margin.by, -1.0), LARGEST_MARGIN))
    if margin.label < 0 or not search.table[k, margin.label] < NOWHERE:
        reason = "It is where no label would be."
    else:
        name = search.model.labels[margin.label]
        reason = f"Of all labels {name} fits best, but another piece fits it better, or is nearer."
    return Labelled(search.pieces[k], None, confidence, reason)


def _logistic(value: float) -> float:
    return 1.0 / (1.0 + math.exp(-value))
