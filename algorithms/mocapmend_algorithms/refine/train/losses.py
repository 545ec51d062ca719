"""The losses of the training (Y23, equations 1 to 8), as means, in units of 100 mm.

The paper prints sums over frames, bones and axes. The weights of means that stand for its 2e-4 and
5e-4 at its sizes are about 0.2 and 4, and 0.5 and 10.
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
    known = target.seen.any(dim=2)
    position = ((poses - target.poses) ** 2).mean(dim=-1)[target.seen].mean()
    deviation = (_lengths(poses, bones) - target.lengths[:, None]) ** 2
    counted = known[..., None] & target.measured[:, None]
    stretch = deviation[counted].mean()
    bends = (poses[:, 2:] - 2 * poses[:, 1:-1] + poses[:, :-2]) ** 2
    rough = bends.mean(dim=(-1, -2))[known[:, 2:]].mean()
    return position + weighting.bones * stretch + weighting.smoothness * rough


def latent_loss(made: Tensor, wanted: Tensor, known: Tensor) -> Tensor:
    """Return Lc of latent variables, shape (windows, frames, latent), where frames are known."""
    squares: Tensor = ((made - wanted) ** 2).mean(dim=-1)
    return squares[known].mean()


def _lengths(poses: Tensor, bones: Tensor) -> Tensor:
    along = poses[:, :, bones[:, 0]] - poses[:, :, bones[:, 1]]
    # The root of zero has no slope.
    return torch.sqrt((along**2).sum(dim=-1) + 1e-12)
