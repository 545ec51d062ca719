"""Which pairs a network does not see while it is trained, so that it can be measured on them."""

from collections.abc import Sequence
from dataclasses import dataclass
from typing import Literal

from mocapmend_algorithms.refine.train.pairs import Pair

By = Literal["repetition", "performer"]


@dataclass(frozen=True)
class HeldOut:
    """The pairs that are held out.

    Attributes
    ----------
    by : str
        "repetition" or "performer".
    numbers : tuple of int
        Of those.
    """

    by: By
    numbers: tuple[int, ...]

    def split(self, pairs: Sequence[Pair]) -> tuple[list[Pair], list[Pair]]:
        """Return the pairs to learn from and those that are held out."""
        learnt = [pair for pair in pairs if getattr(pair, self.by) not in self.numbers]
        rest = [pair for pair in pairs if getattr(pair, self.by) in self.numbers]
        return learnt, rest

    def __str__(self) -> str:
        return f"{self.by}s {', '.join(map(str, self.numbers))}"


NOTHING = HeldOut("repetition", ())
SEEN = HeldOut("repetition", (8, 9, 10))
UNSEEN = HeldOut("performer", (8, 9, 10))
"""The splits of UI-PRMD: performers that are in the training set, and those that are not."""
