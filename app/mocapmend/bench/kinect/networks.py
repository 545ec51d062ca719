"""The networks that are compared, and where they are kept."""

from collections.abc import Mapping, Sequence
from dataclasses import dataclass, replace
from pathlib import Path

from mocapmend.bench.say import say
from mocapmend.files.atomic import write_bytes
from mocapmend.refine.holding_out import SEEN, UNSEEN, HeldOut
from mocapmend.refine.learning import Course, learn, state_path
from mocapmend.refine.models import DEFAULT, SUFFIX
from mocapmend.refine.profiles import profile_named
from mocapmend_algorithms.progress import no_progress
from mocapmend_algorithms.refine.model import Model, encode_model, read_model
from mocapmend_algorithms.refine.train.drawing import Changes
from mocapmend_algorithms.refine.train.pairs import Pair
from mocapmend_algorithms.refine.train.settings import Settings

SPLITS: Mapping[str, HeldOut] = {"seen": SEEN, "unseen": UNSEEN}
MOST = 6
"""Stacks of the paper."""


@dataclass(frozen=True)
class Network:
    """One of the paper's networks.

    Attributes
    ----------
    name : str
        As the paper calls it: BRA, BRA-S-N or BRA-S-C.
    stacks : int
        Autoencoders behind each other.
    latent : bool
        Whether it is trained with the latent loss, and ends with the perceptual autoencoder.
    splits : tuple of str
        On which it is trained.
    """

    name: str
    stacks: int
    latent: bool
    splits: tuple[str, ...]

    def settings(self, rounds: "Rounds") -> Settings:
        """Return how it is trained."""
        usual = Settings()
        return replace(
            usual,
            stacks=self.stacks,
            latent=usual.latent if self.latent else 0.0,
            projected=self.latent,
            rounds=rounds.stack,
            first_rounds=rounds.perceptual,
            seed=rounds.seed,
        )


BRA = Network("BRA", 1, latent=False, splits=("seen", "unseen"))
BRA_S = Network(f"BRA-S-{MOST}", MOST, latent=False, splits=("seen", "unseen"))
BRA_S_C = Network("BRA-S-C", MOST, latent=True, splits=("seen", "unseen"))
STACKED = tuple(Network(f"BRA-S-{n}", n, latent=False, splits=("seen",)) for n in range(2, MOST))
NETWORKS = (BRA, BRA_S, BRA_S_C, *STACKED)
"""In the order in which they are trained."""


@dataclass(frozen=True)
class Rounds:
    """How long networks are trained, and from which seed."""

    stack: int
    perceptual: int
    seed: int


def settings_of(model: Model) -> Settings:
    """Return how a network was trained, as its card has it."""
    card = model.card["settings"]
    return Settings(**{**card, "changes": Changes(**card["changes"])})


class Shelf:
    """The trained networks of a folder.

    Parameters
    ----------
    folder : Path or None
        Where they are; None has none.
    """

    def __init__(self, folder: Path | None) -> None:
        self._folder = folder

    def find(self, name: str, split: str, settings: Settings) -> Model | None:
        """Return a network that was trained on a split, None if it was not."""
        path = self._path(name, split, settings)
        return read_model(path) if path is not None and path.exists() else None

    def train(self, name: str, split: str, settings: Settings, pairs: Sequence[Pair]) -> None:
        """Train a network on a split, if that has not been done."""
        path = self._path(name, split, settings)
        if path is None or path.exists():
            return
        say(f"training {path.name}")
        course = Course(profile_named(DEFAULT), settings, state_path(path))
        model = learn(course, pairs, no_progress, resume=True)
        write_bytes(path, encode_model(model))
        course.state.unlink(missing_ok=True)

    def _path(self, name: str, split: str, settings: Settings) -> Path | None:
        about = f"{settings.first_rounds}+{settings.rounds}-seed{settings.seed}"
        file = f"{name.lower()}-{split}-{about}{SUFFIX}"
        return None if self._folder is None else self._folder / file
