"""What people should know of a network before they trust it: its model card, as text."""

from collections.abc import Iterator, Mapping
from dataclasses import dataclass
from typing import Any

from mocapmend.refine.new_people import KEY
from mocapmend_algorithms.refine.model import Model

CAUTION = (
    "What a network computes is an estimate, not a measurement. It was trained on the people and "
    "movements that its card names; of other movements it knows nothing."
)
NEW_PEOPLE = (
    "For a person whom it has not seen, expect no more than from smoothing and regression: see "
    "the figures for new people on its card, if there are some. Paired recordings of that "
    "person to calibrate with, one of each movement, take much of the error away."
)


MEASURED = "Measured on pairs held out ({0}):"
MEASURED_NEW = "Measured after the same training without some people ({0}; pairs: {1}):"


@dataclass(frozen=True)
class Measured:
    """A table of figures.

    Attributes
    ----------
    head : str
        MEASURED or MEASURED_NEW.
    parts : tuple of str
        What it is filled with.
    figures : mapping
        Of each way, the mean square errors by their names.
    """

    head: str
    parts: tuple[str, ...]
    figures: Mapping[str, Any]


def measured(model: Model) -> Iterator[Measured]:
    """Yield the tables of figures that a card has."""
    for head, card, names in (
        (MEASURED, model.card, ("measured_on",)),
        (MEASURED_NEW, model.card.get(KEY), ("held_out", "measured_on")),
    ):
        if not isinstance(card, Mapping):
            continue
        figures = card.get("figures")
        if isinstance(figures, Mapping) and figures:
            yield Measured(head, tuple(str(card.get(name, "?")) for name in names), figures)


def card_rows(model: Model) -> list[tuple[str, str]]:
    """Return what the card says, each with its heading."""
    card, shape = model.card, model.shape
    network = f"{shape.stacks} stacked bidirectional recurrent autoencoders of width {shape.width}"
    network += ", a linear skip" if shape.skip else ""
    network += ", a perceptual autoencoder" if shape.perceptual else ""
    network += "; each window counts as it is and in a mirror" if model.mirrored else ""
    trained = f"{card.get('pairs', '?')} pairs of recordings of {card.get('performers', '?')} "
    trained += f"people and {card.get('movements', '?')} movements, {card.get('frames', '?')} "
    trained += "frames at 60 Hz"
    return [
        ("About", str(card.get("about", "nothing is said"))),
        ("Trained on", trained),
        ("Held out", str(card.get("held_out") or "nothing")),
        ("Network", f"{network}; {model.size} weights"),
        ("Made by", str(card.get("command", "nobody says"))),
    ]


def card_text(model: Model) -> str:
    """Return the card of a network, in lines."""
    lines = [model.profile.name, "", CAUTION, NEW_PEOPLE, ""]
    lines += [f"{heading + ':':12} {text}" for heading, text in card_rows(model)]
    for table in measured(model):
        lines += ["", table.head.format(*table.parts)]
        width = max(map(len, table.figures))
        lines += [
            f"  {name:{width}}  Lp {row['position_mm2']:6.0f}  Lb {row['bones_mm2']:6.1f}  "
            f"Ls {row['smoothness_mm2']:6.3f} mm²"
            for name, row in table.figures.items()
        ]
    return "\n".join(lines)
