"""What people should know of a network before they trust it: its model card, as text."""

from mocapmend_algorithms.refine.model import Model

CAUTION = (
    "What a network computes is an estimate, not a measurement. It was trained on the people and "
    "movements that its card names; of other movements it knows nothing."
)
NEW_PEOPLE = (
    "For a person whom it has not seen, expect no more than from smoothing and regression: see the "
    "figures for performers held out on its card, if there are some. One paired recording of that "
    "person, to calibrate with, takes much of the error away."
)


def card_rows(model: Model) -> list[tuple[str, str]]:
    """Return what the card says, each with its heading."""
    card, shape = model.card, model.shape
    network = f"{shape.stacks} stacked bidirectional recurrent autoencoders of width {shape.width}"
    network += ", a linear skip" if shape.skip else ""
    network += ", a perceptual autoencoder" if shape.perceptual else ""
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
    figures = model.card.get("figures")
    if isinstance(figures, dict):
        lines += ["", f"Measured on {model.card.get('measured_on', '?')} pairs held out (mm²):"]
        width = max(map(len, figures))
        lines += [
            f"  {name:{width}}  Lp {row['position_mm2']:6.0f}  Lb {row['bones_mm2']:6.1f}  "
            f"Ls {row['smoothness_mm2']:6.3f}"
            for name, row in figures.items()
        ]
    return "\n".join(lines)
