"""The losses of the training (Y23, equations 1 to 8), as means, in units of 100 mm.

The paper prints Lp as a mean and Lb and Ls as sums over frames, bones and axes, with weights of
2e-4 in the first stage and 5e-4 in the second. Weights of means do not grow with the body.
"""

from dataclasses import dataclass

import torch
from torch import Tensor

UNIT = 100.0
"""Millimetres."""


@dataclass(frozen=True)
class Weighting:
    """How much each loss counts beside the position's.

    Attributes
    ----------
    bones, smoothness : float
        Of Lb and Ls.
    latent : float
        Of Lc; 0 leaves it out.
    """

    bones: float
    smoothness: float
    latent: float = 0.0


@dataclass(frozen=True, eq=False)
class Target:
    """What windows should become.

    Attributes
    ----------
    poses : Tensor, shape (windows, frames, outputs, 3)
        In units of 100 mm, 0 where missing.
    seen : Tensor of bool, shape (windows, frames, outputs)
        Where they are known.
    lengths : Tensor, shape (windows, bones)
        Mean bone lengths, 0 of those never seen.
    measured : Tensor of bool, shape (windows, bones)
        Which were seen.
    """

    poses: Tensor
    seen: Tensor
    lengths: Tensor
    measured: Tensor

    @property
    def known(self) -> Tensor:
        """Frames in which something is known, shape (windows, frames)."""
        return self.seen.any(dim=2)

    @classmethod
    def of(cls, markers: Tensor, bones: Tensor) -> "Target":
        """Make targets of markers, shape (windows, frames, outputs, 3), NaN where missing."""
        seen = ~markers[..., 0].isnan()
        lengths = _lengths(markers, bones).nanmean(dim=1)
        return cls(markers.nan_to_num(), seen, lengths.nan_to_num(), ~lengths.isnan())


def kinematic_loss(poses: Tensor, target: Target, bones: Tensor, weighting: Weighting) -> Tensor:
    """Return Lp + weighted Lb and Ls of poses, shape (windows, frames, outputs, 3).

    Frames in which nothing is known are left out.
    """
    known = target.known
    position = _mean(((poses - target.poses) ** 2).mean(dim=-1), target.seen)
    deviation = (_lengths(poses, bones) - target.lengths[:, None]) ** 2
    stretch = _mean(deviation, known[..., None] & target.measured[:, None])
    bends = (poses[:, 2:] - 2 * poses[:, 1:-1] + poses[:, :-2]) ** 2
    rough = _mean(bends.mean(dim=(-1, -2)), known[:, 2:])
    return position + weighting.bones * stretch + weighting.smoothness * rough


def latent_loss(made: Tensor, wanted: Tensor, known: Tensor) -> Tensor:
    """Return Lc of latent variables, shape (windows, frames, latent), where frames are known."""
    return _mean(((made - wanted) ** 2).mean(dim=-1), known)


def _mean(values: Tensor, counted: Tensor) -> Tensor:
    """Average what is counted; nothing is 0."""
    return (values * counted).sum() / counted.sum().clamp(min=1)


def _lengths(poses: Tensor, bones: Tensor) -> Tensor:
    along = poses[:, :, bones[:, 0]] - poses[:, :, bones[:, 1]]
    # The root of zero has no slope.
    return torch.sqrt((along**2).sum(dim=-1) + 1e-12)
