"""The protocols of the gap cases: what a method is held against in each, and its target."""

from collections.abc import Iterable, Mapping
from typing import NamedTuple

from mocapmend_algorithms import Gap

AUTO = "auto"
"""The method that the targets are for."""
FAST = "rigid"
"""The method that its time is held against."""

TITS = "Tits 2018 MocapRecovery"
PCA = "Gloersen-Federolf 2016 R2"
SPLINE = "cubic spline"
RIGID_BODY = "3-donor rigid body"
UNPUBLISHED = ("prototype",)
KNOWN = {
    TITS, PCA, SPLINE, RIGID_BODY, *UNPUBLISHED, "linear", "pchip", "Gloersen-Federolf 2016 R1",
    "Burke-Lasenby 2016 (pyCGM2-like)",
}  # fmt: skip
"""Peers that are expected in a case file; a reference that is spelled otherwise is none."""


class Protocol(NamedTuple):
    """A way to make gaps.

    Attributes
    ----------
    family : str
        As the case file names it.
    size : float
        Where the family is split: length of the gaps, in seconds (P2) or samples (P6); else 0.
    """

    family: str
    size: float = 0.0

    def __str__(self) -> str:
        unit = {"P2": " s", "P6": " samples"}.get(self.family)
        return f"{self.family} {self.size:g}{unit}" if unit else self.family


def protocol_of(family: str, gaps: Iterable[Gap], rate: float) -> Protocol:
    """Return the protocol of a case; `rate` in Hz."""
    longest = max(gap.length for gap in gaps)
    size = {"P2": round(longest / rate, 2), "P6": float(longest)}
    return Protocol(family, size.get(family, 0.0))


_REFERENCES = {
    "P1": (PCA,),
    "P2": (TITS,),
    "P3": (TITS,),
    "P4": (TITS,),
    "P5": (TITS,),
    "P6": (PCA,),
    "P7": (TITS,),
}
_SHORT_P6 = 20

TARGETS = {
    Protocol("P1"): 0.9,
    Protocol("P2", 0.5): 0.6,
    Protocol("P2", 1): 0.6,
    Protocol("P2", 2): 0.5,
    Protocol("P2", 5): 0.4,
    Protocol("P3"): 0.55,
    Protocol("P4"): 0.75,
    Protocol("P5"): 0.6,
    Protocol("P6", 10): 1.0,
    Protocol("P6", 20): 1.0,
    Protocol("P6", 50): 0.35,
    Protocol("P6", 100): 0.35,
    Protocol("P6", 200): 0.35,
    Protocol("P7"): 0.6,
}
"""Most that the geometric mean of the ratios to the reference may be."""


def reference(protocol: Protocol) -> tuple[str, ...]:
    """Return the peers of which the better one is the reference, per case; none if unknown."""
    if protocol.family == "P6" and protocol.size <= _SHORT_P6:
        return (SPLINE, RIGID_BODY)
    return _REFERENCES.get(protocol.family, ())


def best(peers: Mapping[str, float], names: Iterable[str]) -> float | None:
    """Return the smallest RMSE among some peers; None if none has one."""
    return min((peers[name] for name in names if name in peers), default=None)


def best_published(peers: Mapping[str, float]) -> float | None:
    """Return the smallest RMSE of a published method; None if there is none."""
    return best(peers, peers.keys() - set(UNPUBLISHED))
