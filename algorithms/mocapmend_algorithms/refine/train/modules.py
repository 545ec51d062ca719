"""The stacked autoencoders for PyTorch; `refine.network` has the same for inference."""

from itertools import pairwise

import torch
from torch import Tensor, nn

from mocapmend_algorithms.refine.network import DENSE, SKIP_REACH, Shape, skip_kernel


class Half(nn.Module):
    """An encoder or a decoder without its recurrent layer's place in the order."""

    def __init__(self, sizes: list[int], entrance: int, width: int) -> None:
        super().__init__()
        self.dense = nn.ModuleList([nn.Linear(a, b) for a, b in pairwise(sizes)])
        self.recurrent = nn.LSTM(entrance, width, batch_first=True, bidirectional=True)


class Autoencoder(nn.Module):
    """Three dense layers and a recurrent one, and the same mirrored (Y23, figure 4)."""

    def __init__(self, entrance: int, width: int, outputs: int, dropout: float) -> None:
        super().__init__()
        self.encoder = Half([entrance, *[width] * DENSE], width, width)
        self.decoder = Half([2 * width, *[width] * (DENSE - 1), outputs], 2 * width, width)
        self.dropout = nn.Dropout(dropout)

    def encode(self, signal: Tensor) -> Tensor:
        """Return the latent variables, shape (windows, frames, 2 x width)."""
        for dense in self.encoder.dense:
            signal = torch.tanh(dense(signal))
        latent: Tensor = self.encoder.recurrent(signal)[0]
        return latent

    def forward(self, signal: Tensor) -> Tensor:
        """Return what is decoded, shape (windows, frames, outputs)."""
        signal = self.dropout(self.encode(signal))
        signal = self.dropout(self.decoder.recurrent(signal)[0])
        for at, dense in enumerate(self.decoder.dense):
            signal = dense(signal)
            if at < DENSE - 1:
                signal = torch.tanh(signal)
        return signal


class Stack(nn.Module):
    """The whole network; names of its parameters are those of `Shape.expected`.

    Parameters
    ----------
    shape : Shape
        Its size.
    dropout : float
        Share of what the recurrent layers make that is left out while it is trained.
    """

    kernel: Tensor

    def __init__(self, shape: Shape, dropout: float = 0.0) -> None:
        super().__init__()
        self.shape = shape
        self.stack = nn.ModuleList(
            [
                Autoencoder(
                    shape.outputs if at else shape.inputs,
                    shape.width if at else shape.first_width,
                    shape.outputs,
                    dropout,
                )
                for at in range(shape.stacks)
            ]
        )
        if shape.perceptual:
            self.perceptual = Autoencoder(shape.outputs, shape.width, shape.outputs, dropout)
        if shape.skip:
            self.skip = nn.Linear(shape.inputs, shape.outputs)
        self.register_buffer("kernel", torch.from_numpy(skip_kernel()), persistent=False)

    def forward(self, windows: Tensor) -> list[Tensor]:
        """Return what comes out of each stacked autoencoder, shapes (windows, frames, outputs)."""
        outputs: list[Tensor] = []
        signal = windows
        for at, autoencoder in enumerate(self.stack):
            made = autoencoder(signal)
            if self.shape.skip:
                made = made + (signal if at else self.skip(self._smoothed(windows)))
            signal = made
            outputs.append(signal)
        return outputs

    def _smoothed(self, windows: Tensor) -> Tensor:
        ends = windows[:, :1], windows[:, -1:]
        before, after = (end.expand(-1, SKIP_REACH, -1) for end in ends)
        padded = torch.cat([before, windows, after], dim=1)
        return (padded.unfold(1, len(self.kernel), 1) * self.kernel).sum(dim=-1)
