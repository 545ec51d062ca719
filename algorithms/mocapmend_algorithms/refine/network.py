"""The stacked bidirectional recurrent autoencoders in numpy: inference without a runtime.

Yang, Li and Liu, "Kinect motion data refinement by stacked bidirectional recurrent autoencoders"
(Y23), section 2.2. `train.modules` has the same network for PyTorch; weights have its names.
"""

from collections.abc import Mapping
from dataclasses import dataclass

import numpy as np
from numpy.typing import NDArray

FloatArray32 = NDArray[np.float32]
Weights = Mapping[str, FloatArray32]

DENSE = 3
"""Fully connected layers of an encoder, and of a decoder."""
SKIP_SIGMA = 1.6
"""Frames; the linear skip sees the input below about 5 Hz at 60 frames per second."""
SKIP_REACH = 5


@dataclass(frozen=True)
class Shape:
    """The size of a network.

    Attributes
    ----------
    inputs, outputs : int
        Numbers per frame.
    stacks : int
        Autoencoders behind each other, N.
    width : int
        Of the dense layers and of each direction of the recurrent ones.
    first_width : int
        The same for the first autoencoder (Y23: 128 where all others have 226).
    skip : bool
        Whether the first autoencoder adds to a linear map of its smoothed input and the others to
        their input, instead of making the whole output; not in the paper.
    perceptual : bool
        Whether a perceptual autoencoder comes last.

    Raises
    ------
    ValueError
        If a size is impossible.
    """

    inputs: int
    outputs: int
    stacks: int
    width: int
    first_width: int
    skip: bool
    perceptual: bool

    def __post_init__(self) -> None:
        sizes = (self.inputs, self.outputs, self.stacks, self.width, self.first_width)
        if min(sizes) < 1:
            raise ValueError(f"the sizes of a network are positive, not {sizes}")

    def expected(self) -> dict[str, tuple[int, ...]]:
        """Return the shape of each array of weights by its name."""
        shapes: dict[str, tuple[int, ...]] = {}
        for stack in range(self.stacks):
            entrance = self.outputs if stack else self.inputs
            width = self.width if stack else self.first_width
            shapes |= _autoencoder(f"stack.{stack}.", entrance, width, self.outputs)
        if self.perceptual:
            shapes |= _autoencoder("perceptual.", self.outputs, self.width, self.outputs)
        if self.skip:
            shapes |= _dense("skip.", self.inputs, self.outputs)
        return shapes


def _autoencoder(name: str, entrance: int, width: int, outputs: int) -> dict[str, tuple[int, ...]]:
    sizes = [entrance, *[width] * DENSE]
    shapes: dict[str, tuple[int, ...]] = {}
    for at in range(DENSE):
        shapes |= _dense(f"{name}encoder.dense.{at}.", sizes[at], sizes[at + 1])
    shapes |= _recurrent(f"{name}encoder.recurrent.", width, width)
    shapes |= _recurrent(f"{name}decoder.recurrent.", 2 * width, width)
    sizes = [2 * width, *[width] * (DENSE - 1), outputs]
    for at in range(DENSE):
        shapes |= _dense(f"{name}decoder.dense.{at}.", sizes[at], sizes[at + 1])
    return shapes


def _dense(name: str, entrance: int, outputs: int) -> dict[str, tuple[int, ...]]:
    return {f"{name}weight": (outputs, entrance), f"{name}bias": (outputs,)}


def _recurrent(name: str, entrance: int, width: int) -> dict[str, tuple[int, ...]]:
    shapes: dict[str, tuple[int, ...]] = {}
    for end in ("", "_reverse"):
        shapes |= {
            f"{name}weight_ih_l0{end}": (4 * width, entrance),
            f"{name}weight_hh_l0{end}": (4 * width, width),
            f"{name}bias_ih_l0{end}": (4 * width,),
            f"{name}bias_hh_l0{end}": (4 * width,),
        }
    return shapes


def stacked(shape: Shape, weights: Weights, windows: FloatArray32) -> list[FloatArray32]:
    """Run the network.

    Parameters
    ----------
    shape : Shape
        Its size.
    weights : mapping of str to ndarray
        Arrays as `Shape.expected` has them.
    windows : ndarray, shape (windows, frames, inputs), float32
        Standardised.

    Returns
    -------
    list of ndarray, shape (windows, frames, outputs)
        What comes out of each stacked autoencoder, and of the perceptual one last.
    """
    outputs: list[FloatArray32] = []
    signal = windows
    for stack in range(shape.stacks):
        made = _decoded(weights, f"stack.{stack}.", encoded(weights, f"stack.{stack}.", signal))
        if shape.skip:
            made += signal if stack else _linear(weights, "skip.", smoothed(windows))
        signal = made
        outputs.append(signal)
    if shape.perceptual:
        outputs.append(_decoded(weights, "perceptual.", encoded(weights, "perceptual.", signal)))
    return outputs


def skip_kernel() -> FloatArray32:
    """Return the weights of the frames that the linear skip averages, their sum being 1."""
    at = np.arange(-SKIP_REACH, SKIP_REACH + 1)
    kernel = np.exp(-0.5 * (at / SKIP_SIGMA) ** 2)
    return np.asarray(kernel / kernel.sum(), dtype=np.float32)


def smoothed(windows: FloatArray32) -> FloatArray32:
    """Average neighbouring frames of windows; the first and last frame hold beyond the ends."""
    frames = windows.shape[1]
    padded = np.pad(windows, ((0, 0), (SKIP_REACH, SKIP_REACH), (0, 0)), mode="edge")
    result = np.zeros_like(windows)
    for at, weight in enumerate(skip_kernel()):
        result += weight * padded[:, at : at + frames]
    return result


def encoded(weights: Weights, name: str, signal: FloatArray32) -> FloatArray32:
    """Return the latent variables of an autoencoder, shape (windows, frames, 2 x width)."""
    for at in range(DENSE):
        signal = np.tanh(_linear(weights, f"{name}encoder.dense.{at}.", signal))
    return _bidirectional(weights, f"{name}encoder.recurrent.", signal)


def _decoded(weights: Weights, name: str, latent: FloatArray32) -> FloatArray32:
    signal = _bidirectional(weights, f"{name}decoder.recurrent.", latent)
    for at in range(DENSE):
        signal = _linear(weights, f"{name}decoder.dense.{at}.", signal)
        if at < DENSE - 1:
            np.tanh(signal, out=signal)
    return signal


def _linear(weights: Weights, name: str, signal: FloatArray32) -> FloatArray32:
    rows = signal.reshape(-1, signal.shape[-1]) @ weights[f"{name}weight"].T
    rows += weights[f"{name}bias"]
    return np.asarray(rows.reshape(*signal.shape[:-1], -1), dtype=np.float32)


def _bidirectional(weights: Weights, name: str, signal: FloatArray32) -> FloatArray32:
    """Run a long short-term memory forwards and backwards, side by side."""
    count, frames, _ = signal.shape
    by_frame = signal.swapaxes(0, 1)
    width = weights[f"{name}weight_hh_l0"].shape[1]
    # sigmoid(x) = (1 + tanh(x / 2)) / 2: with halved rows, one tanh does for all four gates.
    halves = np.full((4, width), 0.5, dtype=np.float32)
    halves[2] = 1.0
    scale = halves.reshape(-1)
    entrances, loops = [], []
    for end, frames_in_order in (("", by_frame), ("_reverse", by_frame[::-1])):
        bias = weights[f"{name}bias_ih_l0{end}"] + weights[f"{name}bias_hh_l0{end}"]
        weight = weights[f"{name}weight_ih_l0{end}"] * scale[:, None]
        given = {"weight": weight, "bias": bias * scale}
        entrances.append(_linear(given, "", frames_in_order))
        loops.append((weights[f"{name}weight_hh_l0{end}"] * scale[:, None]).T)
    entrance, loop = np.stack(entrances, axis=1), np.stack(loops)
    hidden = np.zeros((2, count, width), dtype=np.float32)
    cell = np.zeros_like(hidden)
    states = np.empty((frames, 2, count, width), dtype=np.float32)
    for frame in range(frames):
        gates = np.matmul(hidden, loop)
        gates += entrance[frame]
        np.tanh(gates, out=gates)
        taken, kept, new, shown = np.split(gates, 4, axis=-1)
        cell *= 0.5 * kept + 0.5
        cell += (0.5 * taken + 0.5) * new
        np.multiply(0.5 * shown + 0.5, np.tanh(cell), out=hidden)
        states[frame] = hidden
    both = np.concatenate([states[:, 0], states[::-1, 1]], axis=-1)
    return np.ascontiguousarray(both.swapaxes(0, 1))
