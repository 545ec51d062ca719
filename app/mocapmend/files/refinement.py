"""What a repair record says of a recording that a network has made: none of it was measured."""

from collections.abc import Mapping
from dataclasses import asdict, dataclass, field
from typing import Any

from mocapmend.files.record_values import Kinds, parameter, values_of

_REFINEMENT: Kinds = {
    "model": (str,),
    "model_sha256": (str,),
    "profile": (str,),
    "parameters": (dict,),
}


@dataclass(frozen=True)
class Refinement:
    """How all markers of a file were computed from the joints of another recording.

    Attributes
    ----------
    model : str
        Name of the network, or of its file.
    model_sha256 : str
        Of its file.
    profile : str
        Id of its profile.
    parameters : mapping
        Of the refinement.
    """

    model: str
    model_sha256: str
    profile: str
    parameters: Mapping[str, Any] = field(default_factory=dict)

    @property
    def place(self) -> tuple[int, int]:
        """What entries are ordered by: there is one alone."""
        return (0, 0)

    def as_json(self) -> dict[str, Any]:
        """Return it for a JSON document."""
        return asdict(self)

    @property
    def sentence(self) -> str:
        """What the user should know."""
        return (
            f"All markers were computed by the network “{self.model}” from the joints of another "
            "recording; none was measured."
        )


def refinement(data: object) -> Refinement:
    """Read a refinement from a JSON document.

    Raises
    ------
    ValueError
        If it is none.
    """
    values = values_of(data, _REFINEMENT, "the refinement", long=("parameters",))
    parameters = {str(key): parameter(value) for key, value in values["parameters"].items()}
    return Refinement(**{**values, "parameters": parameters})
