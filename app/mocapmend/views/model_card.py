"""The model card of a network as a page: what it is, what it learnt from, how good it was."""

from html import escape
from typing import Any

from PySide6.QtCore import QCoreApplication

from mocapmend.refine.card import CAUTION, NEW_PEOPLE, Measured, card_rows, measured
from mocapmend.translate import QT_TRANSLATE_NOOP
from mocapmend.views.engine_texts import shown
from mocapmend_algorithms.refine.model import Model

translate = QCoreApplication.translate

WORDS = (
    QT_TRANSLATE_NOOP("ModelCard", "About"),
    QT_TRANSLATE_NOOP("ModelCard", "Trained on"),
    QT_TRANSLATE_NOOP("ModelCard", "Held out"),
    QT_TRANSLATE_NOOP("ModelCard", "Network"),
    QT_TRANSLATE_NOOP("ModelCard", "Made by"),
    QT_TRANSLATE_NOOP("ModelCard", "nothing is said"),
    QT_TRANSLATE_NOOP("ModelCard", "nothing"),
    QT_TRANSLATE_NOOP("ModelCard", "nobody says"),
    QT_TRANSLATE_NOOP("ModelCard", "network"),
    QT_TRANSLATE_NOOP("ModelCard", "network, 6 Hz"),
    QT_TRANSLATE_NOOP("ModelCard", "ridge on 5 Hz Butterworth"),
)
"""Headings and words of a card; too short to be looked for in all sentences."""


def card_html(model: Model) -> str:
    """Return the card of a network as rich text."""
    rows = "".join(
        f"<tr><td style='padding-right: 12px'>{_word(heading)}</td><td>{_word(text)}</td></tr>"
        for heading, text in card_rows(model)
    )
    return (
        f"<p><b>{escape(shown(model.profile.name))}</b></p>"
        f"<p>{escape(shown(CAUTION))} <b>{escape(shown(NEW_PEOPLE))}</b></p>"
        f"<table>{rows}</table>{_figures(model)}"
    )


def _figures(model: Model) -> str:
    tables = [_table(table) for table in measured(model)]
    if not tables:
        text = translate("ModelCard", "Nothing was held out: how good it is was not measured.")
        return f"<p>{escape(text)}</p>"
    meaning = translate(
        "ModelCard",
        "Lp: mean square error of a coordinate. Lb: of bone lengths. Ls: mean square second "
        "difference of a coordinate.",
    )
    return "".join(tables) + f"<p>{escape(meaning)}</p>"


def _table(table: Measured) -> str:
    head = shown(table.head).format(*table.parts)
    rows = "".join(
        f"<tr><td>{_word(str(name))}</td>"
        + "".join(
            f"<td align='right' style='padding-left: 16px'>{_number(row, key, decimals)}</td>"
            for key, decimals in (
                ("position_mm2", 0),
                ("bones_mm2", 1),
                ("smoothness_mm2", 3),
            )
        )
        + "</tr>"
        for name, row in table.figures.items()
    )
    titles = "".join(
        f"<td align='right' style='padding-left: 16px'>{title} (mm²)</td>"
        for title in ("Lp", "Lb", "Ls")
    )
    return f"<p>{escape(head)}</p><table><tr><td></td>{titles}</tr>{rows}</table>"


def _number(row: Any, key: str, decimals: int) -> str:
    value = row.get(key) if isinstance(row, dict) else None
    return f"{value:.{decimals}f}" if isinstance(value, (int, float)) else "–"


def _word(text: str) -> str:
    """Return what a card says in the user's language, or as it is."""
    return escape(translate("ModelCard", text) if text in WORDS else shown(text))
