"""What a card says of people whom a network has not seen.

A network that ships is trained on all people that there are, so that nobody is left to measure it
on as a new person. One that was trained the same way without some of them tells.
"""

from collections.abc import Mapping
from dataclasses import asdict, replace
from pathlib import Path
from typing import Any

from mocapmend.errors import MocapmendError
from mocapmend.refine.models import load_model
from mocapmend_algorithms.refine.model import Model
from mocapmend_algorithms.refine.profile import Profile
from mocapmend_algorithms.refine.train.settings import Settings

KEY = "new_people"


def read_new_people(path: Path, profile: Profile, settings: Settings) -> Mapping[str, Any]:
    """Return what the card of a network says of the performers whom it has not seen.

    Parameters
    ----------
    path : Path
        The network.
    profile : Profile
        What it has to be for.
    settings : Settings
        How it has to have been trained.

    Raises
    ------
    MocapmendError
        If it cannot be read, is another kind of network, or was not measured on performers.
    """
    model = load_model(str(path))
    card = model.card
    if model.profile != profile or card.get("settings") != asdict(settings):
        raise MocapmendError(
            "This network was trained for another profile or with other settings.",
            str(path),
            "Train one with the same options, and --hold-out performers=… beside them.",
        )
    if not str(card.get("held_out", "")).startswith("performers") or "figures" not in card:
        raise MocapmendError(
            "This network was not measured on performers whom it has not seen.",
            str(path),
            "Train it with --hold-out performers=….",
        )
    return {name: card[name] for name in ("held_out", "measured_on", "figures")}


def with_new_people(model: Model, found: Mapping[str, Any]) -> Model:
    """Return a network whose card says of new people what was found."""
    return replace(model, card={**model.card, KEY: dict(found)})
