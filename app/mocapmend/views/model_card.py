"""The model card of a network as a page: what it is, what it learnt from, how good it was."""

from html import escape
from typing import Any

from PySide6.QtCore import QCoreApplication

from mocapmend.refine.card import CAUTION, NEW_PEOPLE, card_rows
from mocapmend.views.engine_texts import shown
from mocapmend_algorithms.refine.model import Model

translate = QCoreApplication.translate


def card_html(model: Model) -> str:
    """Return the card of a network as rich text."""
    rows = "".join(
        f"<tr><td style='padding-right: 12px'>{escape(shown(heading))}</td>"
        f"<td>{escape(shown(text))}</td></tr>"
        for heading, text in card_rows(model)
    )
    return (
        f"<p><b>{escape(shown(model.profile.name))}</b></p>"
        f"<p>{escape(shown(CAUTION))} <b>{escape(shown(NEW_PEOPLE))}</b></p>"
        f"<table>{rows}</table>{_figures(model.card)}"
    )


def _figures(card: Any) -> str:
    figures = card.get("figures")
    if not isinstance(figures, dict) or not figures:
        text = translate("ModelCard", "Nothing was held out: how good it is was not measured.")
        return f"<p>{escape(text)}</p>"
    head = translate("ModelCard", "Measured on {0} pairs held out:")
    rows = "".join(
        f"<tr><td>{escape(shown(str(name)))}</td>"
        + "".join(
            f"<td align='right' style='padding-left: 16px'>{_number(row, key, decimals)}</td>"
            for key, decimals in (
                ("position_mm2", 0),
                ("bones_mm2", 1),
                ("smoothness_mm2", 3),
            )
        )
        + "</tr>"
        for name, row in figures.items()
    )
    titles = "".join(
        f"<td align='right' style='padding-left: 16px'>{title} (mm²)</td>"
        for title in ("Lp", "Lb", "Ls")
    )
    meaning = translate(
        "ModelCard",
        "Lp: mean square error of a coordinate. Lb: of bone lengths. Ls: mean square second "
        "difference of a coordinate.",
    )
    return (
        f"<p>{escape(head.format(card.get('measured_on', '?')))}</p>"
        f"<table><tr><td></td>{titles}</tr>{rows}</table><p>{escape(meaning)}</p>"
    )


def _number(row: Any, key: str, decimals: int) -> str:
    value = row.get(key) if isinstance(row, dict) else None
    return f"{value:.{decimals}f}" if isinstance(value, (int, float)) else "–"
