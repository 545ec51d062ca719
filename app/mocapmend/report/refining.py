"""How a network has made a recording, for its report."""

from collections.abc import Mapping
from dataclasses import dataclass, field

from mocapmend.files import Provenance
from mocapmend.refine.judging import Judged
from mocapmend.refine.profiles import profiles


@dataclass(frozen=True)
class Refining:
    """How a network has made a recording, and how good the outcome is, where that is known.

    Attributes
    ----------
    network : str
        Its name.
    sha256 : str
        Of its file.
    profile : str
        Name of what it was made for.
    parameters : mapping
        Of the refinement.
    judged : Judged or None
        Against a reference.
    """

    network: str
    sha256: str
    profile: str
    parameters: Mapping[str, object] = field(default_factory=dict)
    judged: Judged | None = None

    @property
    def settings(self) -> tuple[str, str]:
        """Stride, and cut-off of the output filter, "" where there is none."""
        cutoff = self.parameters.get("cutoff_hz")
        filtered = f"{cutoff:g} Hz" if isinstance(cutoff, (int, float)) else ""
        return str(self.parameters.get("stride", "?")), filtered

    @property
    def calibrations(self) -> int:
        """How many recordings of the same person calibrated it."""
        digests = self.parameters.get("calibration_sha256")
        return len(digests) // 2 if isinstance(digests, (tuple, list)) else 0


def refining(provenance: Provenance | None, judged: Judged | None = None) -> Refining | None:
    """Return what a repair record says of a network, None where none was at work."""
    made = None if provenance is None else provenance.refined
    if made is None:
        return None
    profile = profiles().get(made.profile)
    name = made.profile if profile is None else profile.name
    return Refining(made.model, made.model_sha256, name, made.parameters, judged)
