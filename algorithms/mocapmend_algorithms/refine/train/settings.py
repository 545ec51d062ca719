"""How a network is trained."""

from dataclasses import dataclass, field, replace

from mocapmend_algorithms.refine.network import Shape
from mocapmend_algorithms.refine.profile import Profile
from mocapmend_algorithms.refine.train.drawing import NO_CHANGES, Changes
from mocapmend_algorithms.refine.windows import LENGTH

PRINTED_FIRST_WIDTH, PRINTED_WIDTH = 128, 226
PRINTED_ROUNDS = 200
PRINTED_STEP = 1e-5
PRINTED_DROPOUT = 0.2
PRINTED_WEIGHT = 5e-4
"""Of sums over the frames of a window, and over bones or coordinates."""
PRINTED_BONES, PRINTED_COORDINATES = 58, 177


@dataclass(frozen=True)
class Settings:
    """How a network is trained.

    Attributes
    ----------
    stacks : int
        Autoencoders behind each other, from 1; the paper has 6.
    width, first_width : int
        See `Shape`.
    skip : bool
        With the linear skip.
    latent : float
        Weight of the latent loss Lc; 0 trains no perceptual autoencoder.
    projected : bool
        Whether the result is what the perceptual autoencoder makes of the stack's output, as in
        the paper; else it is the stack's output, which is closer to the truth.
    bones, smoothness : float
        Weights of Lb and Ls in the second stage; the first has 0.4 of them, as the paper.
    first_rounds, rounds : int
        Times that the pairs are gone through, in the first stage and in the second.
    dropout : float
        Share of what the recurrent layers make that is left out at random. The paper has 0.2;
        without any, the error on held-out repetitions is a fifth less.
    batch : int
        Windows of a step.
    step : float
        The largest step size of Adam; it falls to zero on a cosine.
    steady : bool
        Whether the step size stays as it is instead, as the paper's.
    changes : Changes
        How windows are changed at random.
    seed : int
        Of all that is random.
    """

    stacks: int = 6
    width: int = 64
    first_width: int = 64
    skip: bool = True
    latent: float = 1.0
    projected: bool = False
    bones: float = 0.5
    smoothness: float = 10.0
    first_rounds: int = 30
    rounds: int = 60
    dropout: float = 0.0
    batch: int = 16
    step: float = 2e-3
    steady: bool = False
    changes: Changes = field(default_factory=Changes)
    seed: int = 0

    @classmethod
    def printed(cls, seed: int = 0) -> "Settings":
        """Return the paper's own (Y23, sections 2.2 to 2.4)."""
        return cls(
            width=PRINTED_WIDTH,
            first_width=PRINTED_FIRST_WIDTH,
            skip=False,
            projected=True,
            bones=PRINTED_WEIGHT * LENGTH * PRINTED_BONES,
            smoothness=PRINTED_WEIGHT * LENGTH * PRINTED_COORDINATES,
            dropout=PRINTED_DROPOUT,
            first_rounds=PRINTED_ROUNDS,
            rounds=PRINTED_ROUNDS,
            step=PRINTED_STEP,
            steady=True,
            changes=NO_CHANGES,
            seed=seed,
        )

    def shape(self, profile: Profile) -> Shape:
        """Return the size of the network for a profile, as it is used."""
        trained = self.trained_shape(profile)
        return replace(trained, perceptual=trained.perceptual and self.projected)

    def trained_shape(self, profile: Profile) -> Shape:
        """Return the size of the network as it is trained: for the latent loss it has one more."""
        return Shape(
            inputs=3 * len(profile.inputs),
            outputs=3 * len(profile.outputs),
            stacks=self.stacks,
            width=self.width,
            first_width=self.first_width,
            skip=self.skip,
            perceptual=self.latent > 0,
        )
