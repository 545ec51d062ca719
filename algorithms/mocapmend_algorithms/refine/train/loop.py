"""Training in two stages (Y23, section 2.4): first the perceptual autoencoder, then the stack."""

import math
from collections.abc import Callable, Iterator, Sequence
from dataclasses import dataclass
from typing import Any

import numpy as np
import torch
from torch import Tensor, nn

from mocapmend_algorithms.progress import Progress
from mocapmend_algorithms.refine.network import smoothed
from mocapmend_algorithms.refine.profile import Profile
from mocapmend_algorithms.refine.scaling import Scaling
from mocapmend_algorithms.refine.train.drawing import NO_CHANGES, Drawer, Drawn
from mocapmend_algorithms.refine.train.losses import (
    UNIT,
    Target,
    Weighting,
    kinematic_loss,
    latent_loss,
)
from mocapmend_algorithms.refine.train.modules import Stack
from mocapmend_algorithms.refine.train.pairs import Pair
from mocapmend_algorithms.refine.train.settings import Settings

STAGES = ("perceptual", "stack")
FIRST_SHARE = 0.4
"""Of the weights of Lb and Ls in the first stage: the paper's 2e-4 beside 5e-4."""
LARGEST_SLOPE = 1.0
RIDGE = 1e-2
"""Beside standardised inputs."""
WARM_UP = 0.05
"""Share of a stage in which the step size grows."""


@dataclass(frozen=True)
class Round:
    """How a round of training went.

    Attributes
    ----------
    stage : str
        "perceptual" or "stack".
    number : int
        From 1.
    loss : float
        Mean of the loss over the round's steps.
    """

    stage: str
    number: int
    loss: float


class Training:
    """A training that can be stopped after any round and gone on with later.

    The same pairs and settings give the same weights on one kind of machine, in one go or in
    several.

    Parameters
    ----------
    pairs : sequence of Pair
        To learn from.
    profile : Profile
        What is learnt.
    settings : Settings
        How.

    Raises
    ------
    ValueError
        If there is nothing to learn from.
    """

    def __init__(self, pairs: Sequence[Pair], profile: Profile, settings: Settings) -> None:
        if not pairs:
            raise ValueError("there are no pairs to learn from")
        self.settings = settings
        self.curve: list[Round] = []
        torch.manual_seed(settings.seed)
        self._expected = settings.shape(profile).expected()
        self.network = Stack(settings.trained_shape(profile), settings.dropout)
        whole = Drawer(pairs, profile, NO_CHANGES).round(self._rng(0, 0))
        self.scaling = Scaling.of(whole.joints, whole.markers)
        self._drawer = Drawer(pairs, profile, settings.changes)
        self._bones = torch.tensor(profile.bones)
        if settings.skip:
            self._start_skip(whole)
        self._optimiser = self._new_optimiser(self._stage)

    def _rng(self, stage: int, number: int) -> np.random.Generator:
        """Return the same generator for a round whenever it is run."""
        return np.random.default_rng([self.settings.seed, stage, number])

    @property
    def _stage(self) -> int:
        done = len(self.curve)
        return 0 if self.settings.latent > 0 and done < self.settings.first_rounds else 1

    @property
    def rounds(self) -> int:
        """How many rounds there are in all."""
        first = self.settings.first_rounds if self.settings.latent > 0 else 0
        return first + self.settings.rounds

    def run(self, progress: Progress, after: Callable[["Training"], None]) -> None:
        """Go on to the end.

        Parameters
        ----------
        progress : Progress
            Called after each step.
        after : callable
            Called after each round: the place to save `state`.
        """
        while len(self.curve) < self.rounds:
            self._round(progress)
            after(self)

    def state(self) -> dict[str, Any]:
        """Return all that is needed to go on; `torch.save` takes it."""
        return {
            "network": self.network.state_dict(),
            "optimiser": self._optimiser.state_dict(),
            "curve": [(one.stage, one.number, one.loss) for one in self.curve],
        }

    def resume(self, state: dict[str, Any]) -> None:
        """Go on from a state of a training with the same pairs and settings.

        Raises
        ------
        ValueError
            If it is of another network.
        """
        try:
            curve = [Round(str(a), int(b), float(c)) for a, b, c in state["curve"]]
            self.network.load_state_dict(state["network"])
            self.curve = curve
            self._optimiser = self._new_optimiser(self._stage)
            if curve and curve[-1].stage == STAGES[self._stage]:
                self._optimiser.load_state_dict(state["optimiser"])
        except (KeyError, TypeError, RuntimeError, ValueError) as error:
            raise ValueError("the state is of another training") from error

    def weights(self) -> dict[str, np.ndarray[Any, np.dtype[np.float32]]]:
        """Return the weights of `Settings.shape`, as `refine.network` takes them."""
        state = self.network.state_dict()
        return {
            name: np.array(state[name].detach().numpy(), dtype=np.float32)
            for name in self._expected
        }

    def _start_skip(self, whole: Drawn) -> None:
        """Begin with the linear map of least squares from input to output."""
        inputs = smoothed(self.scaling.standardised(whole.joints))
        rows = inputs.reshape(-1, inputs.shape[-1]).astype(np.float64)
        wanted = (whole.markers - self.scaling.output_mean) / self.scaling.output_spread
        targets = wanted.reshape(len(rows), -1)
        known = ~np.isnan(targets).any(axis=1)
        rows = np.column_stack([rows[known], np.ones(np.count_nonzero(known))])
        gram = rows.T @ rows
        gram[np.diag_indices(len(gram) - 1)] += RIDGE * len(rows)
        solved = np.linalg.solve(gram, rows.T @ targets[known])
        with torch.no_grad():
            self.network.skip.weight.copy_(torch.from_numpy(solved[:-1].T))
            self.network.skip.bias.copy_(torch.from_numpy(solved[-1]))

    def _new_optimiser(self, stage: int) -> torch.optim.Adam:
        network: nn.Module = self.network
        perceptual = [p for name, p in network.named_parameters() if name.startswith("percep")]
        others = [p for name, p in network.named_parameters() if not name.startswith("percep")]
        return torch.optim.Adam(others if stage else perceptual, lr=self.settings.step)

    def _round(self, progress: Progress) -> None:
        stage = self._stage
        before = [one for one in self.curve if one.stage == STAGES[stage]]
        if not before:
            self._optimiser = self._new_optimiser(stage)
        number = len(before) + 1
        drawn = self._drawer.round(self._rng(stage + 1, number))
        torch.manual_seed(self.settings.seed * 1_000_003 + stage * 10_007 + number)
        self.network.train()
        if self.settings.latent > 0 and stage:
            self.network.perceptual.eval().requires_grad_(requires_grad=False)
        in_stage = self.settings.rounds if stage else self.settings.first_rounds
        losses = []
        steps = list(_batches(len(drawn.joints), self.settings.batch))
        for at, batch in enumerate(steps):
            self._set_step((number - 1 + at / len(steps)) / in_stage)
            losses.append(self._learn(drawn, batch, stage))
            progress((len(self.curve) + (at + 1) / len(steps)) / self.rounds)
        self.curve.append(Round(STAGES[stage], number, float(np.mean(losses))))

    def _set_step(self, done: float) -> None:
        """Set the step size where a share of the stage is done."""
        size = self.settings.step
        if not self.settings.steady:
            size *= min(1.0, done / WARM_UP + 0.01) * (1 + math.cos(math.pi * done)) / 2
        for group in self._optimiser.param_groups:
            group["lr"] = size

    def _learn(self, drawn: Drawn, batch: slice, stage: int) -> float:
        settings, network = self.settings, self.network
        target = Target.of(torch.from_numpy(drawn.markers[batch] / UNIT).float(), self._bones)
        weighting = Weighting(settings.bones, settings.smoothness)
        if stage:
            outputs = network(torch.from_numpy(self.scaling.standardised(drawn.joints[batch])))
            loss = sum(
                (
                    kinematic_loss(self._poses(one), target, self._bones, weighting)
                    for one in outputs
                ),
                torch.zeros(()),
            )
            if settings.latent > 0:
                loss = loss + settings.latent * self._latent(outputs[-1], target)
        else:
            weighting = Weighting(FIRST_SHARE * settings.bones, FIRST_SHARE * settings.smoothness)
            made = network.perceptual(self._standard(target))
            loss = kinematic_loss(self._poses(made), target, self._bones, weighting)
        self._optimiser.zero_grad()
        loss.backward()  # type: ignore[no-untyped-call]
        # Not of the whole network: the slopes of the first stage are still there in the second.
        learnt = [one for group in self._optimiser.param_groups for one in group["params"]]
        nn.utils.clip_grad_norm_(learnt, LARGEST_SLOPE)
        self._optimiser.step()
        return float(loss.detach())

    def _latent(self, made: Tensor, target: Target) -> Tensor:
        standard = self._standard(target)
        # What is not known is taken to be as it was made.
        seen = target.seen.repeat_interleave(3, dim=-1)
        with torch.no_grad():
            wanted = self.network.perceptual.encode(torch.where(seen, standard, made))
        return latent_loss(self.network.perceptual.encode(made), wanted, target.known)

    def _poses(self, outputs: Tensor) -> Tensor:
        """Return poses in units of 100 mm of what the network makes."""
        mean, spread = self._output_scaling()
        return outputs.reshape(*outputs.shape[:2], *mean.shape) * spread + mean

    def _standard(self, target: Target) -> Tensor:
        """Return standardised targets, 0 where they are not known."""
        mean, spread = self._output_scaling()
        return ((target.poses - mean) / spread * target.seen[..., None]).flatten(start_dim=-2)

    def _output_scaling(self) -> tuple[Tensor, Tensor]:
        mean, spread = self.scaling.output_mean, self.scaling.output_spread
        return torch.from_numpy(mean / UNIT).float(), torch.from_numpy(spread / UNIT).float()


def _batches(count: int, size: int) -> Iterator[slice]:
    for start in range(0, count, size):
        yield slice(start, start + size)
