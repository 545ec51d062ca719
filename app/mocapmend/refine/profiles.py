"""The profiles of refinement that ship with the program, made of their files."""

from collections.abc import Sequence
from functools import lru_cache
from typing import Any

from mocapmend.errors import MocapmendError
from mocapmend_algorithms.refine.profile import Profile
from mocapmend_algorithms.skeleton import Template
from mocapmend_resources import refine, skeletons


@lru_cache(maxsize=1)
def profiles() -> dict[str, Profile]:
    """Return all profiles by their ids."""
    return {name: _made(name, data) for name, data in refine.profiles().items()}


def profile_named(name: str) -> Profile:
    """Return a profile.

    Raises
    ------
    MocapmendError
        If there is none of this name.
    """
    try:
        return profiles()[name]
    except KeyError:
        raise MocapmendError(
            "There is no such profile.", name, f"Choose one of {', '.join(profiles())}."
        ) from None


def _made(name: str, data: dict[str, Any]) -> Profile:
    """Make a profile of what its file holds.

    `inputs` and `outputs` are lists of labels or the name of a skeleton template, whose bones are
    taken where there are none.
    """
    inputs, _ = _points(data["inputs"])
    outputs, template = _points(data["outputs"])
    bones = data.get("bones") or (template.bones if template else ())
    return Profile(
        id=name,
        name=data["name"],
        inputs=inputs,
        outputs=outputs,
        bones=tuple((outputs.index(a), outputs.index(b)) for a, b in bones),
        input_root=_places(inputs, data["input_root"]),
        output_root=_places(outputs, data["output_root"]),
        left=_places(inputs, data["left"]),
        right=_places(inputs, data["right"]),
        matches=tuple((inputs.index(a), outputs.index(b)) for a, b in data["matches"]),
    )


def _points(value: str | list[str]) -> tuple[tuple[str, ...], Template | None]:
    if isinstance(value, list):
        return tuple(value), None
    template = skeletons.read(value)
    return template.required, template


def _places(labels: Sequence[str], wanted: Sequence[str]) -> tuple[int, ...]:
    return tuple(labels.index(label) for label in wanted)
