"""How sure each label is, and why."""

import math

import numpy as np

from mocapmend_algorithms.labelling.margins import Margin, margins
from mocapmend_algorithms.labelling.result import Labelled
from mocapmend_algorithms.labelling.search import Search

# Logistic regressions on what was right and wrong in the training half of `bench labels`.
LEVEL, OF_MARGIN, OF_LEAD, OF_EXCESS = -1.2, 1.1, 1.7, -1.6
MARGINS, LEADS = (-1.0, 1.25), (-2.0, 4.0)
"""Bounds: beyond them, more says no more."""
NOBODY_LEVEL, NOBODY_OF_MARGIN = 1.6, 1.6
NOBODY_MARGINS = (-1.0, 3.0)
SURE = 0.8
"""From here on, a reason says what speaks for a label and not what speaks against it."""
MANY = 6
"""Labels: that many in another order are a limb, or more."""


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


def _with_label(search: Search, k: int, margin: Margin) -> Labelled:
    label = int(search.labels[k])
    lead = _within(float(search.order.lead[label]), LEADS)
    by = _within(margin.by, MARGINS)
    usual = float(np.median(search.table[search.labels == label, label]))
    excess = max(float(search.table[k, label]) - usual, 0.0)
    value = LEVEL + OF_MARGIN * by + OF_LEAD * lead + OF_EXCESS * excess
    confidence = _logistic(value)
    where = _where(search, k)
    if confidence >= SURE:
        reason = f"{where}; no other label fits nearly as well."
    else:
        # What would have made the most of the difference, had it been as it is at best.
        shortfalls = {
            _other_label: OF_MARGIN * (MARGINS[1] - by),
            _other_order: OF_LEAD * (LEADS[1] - lead) / 2.0,
            _poor_fit: -OF_EXCESS * excess,
        }
        explain = max(shortfalls, key=lambda each: shortfalls[each])
        reason = f"{where}, but {explain(search, k, margin)}."
    return Labelled(search.pieces[k], label, confidence, reason)


def _other_label(search: Search, k: int, margin: Margin) -> str:
    if margin.label < 0:
        return "it may as well be no marker at all"
    return f"{search.model.labels[margin.label]} fits nearly as well"


def _other_order(search: Search, k: int, margin: Margin) -> str:
    order, label = search.order, search.labels[k]
    rival = search.model.labels[order.rival[label]]
    if order.moved[label] >= MANY:
        return (
            f"left and right can hardly be told apart: with {order.moved[label]} labels in each "
            f"other's place, and {rival} here, the body fits nearly as well"
        )
    return f"by the shape of the body that was learned, it may be {rival} throughout"


def _poor_fit(search: Search, k: int, margin: Margin) -> str:
    return "the other pieces with this label fit better"


def _where(search: Search, k: int) -> str:
    label = search.model.labels[search.labels[k]]
    away = search.away[k]
    if math.isnan(away):
        return f"Its distances to the other markers are those of {label}"
    return f"It is {away:.0f} mm from where the other markers put {label}"


def _without(search: Search, k: int, margin: Margin) -> Labelled:
    confidence = _logistic(NOBODY_LEVEL + NOBODY_OF_MARGIN * _within(margin.by, NOBODY_MARGINS))
    if not search.begun:
        confidence = 0.0
        reason = "Too few points are seen at once to tell which labels they are."
    elif margin.label < 0:
        reason = "It is where no label would be."
    else:
        name = search.model.labels[margin.label]
        reason = f"It is most like {name}, but other points fit that better."
    return Labelled(search.pieces[k], None, confidence, reason)


def _within(value: float, bounds: tuple[float, float]) -> float:
    return min(max(value, bounds[0]), bounds[1])


def _logistic(value: float) -> float:
    return 1.0 / (1.0 + math.exp(-value))
