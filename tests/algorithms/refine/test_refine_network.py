"""The network in numpy, against PyTorch and against a second implementation of its equations."""

import numpy as np
import pytest
from refine_samples import network
from scipy.special import expit

from mocapmend_algorithms.refine.network import SKIP_REACH, Shape, skip_kernel, smoothed, stacked

SHAPES = [
    Shape(6, 9, 1, 4, 4, skip=True, perceptual=False),
    Shape(6, 9, 3, 5, 4, skip=True, perceptual=True),
    Shape(6, 9, 2, 3, 7, skip=False, perceptual=True),
]


def dense(weights: dict[str, np.ndarray], name: str, rows: np.ndarray) -> np.ndarray:
    return rows @ weights[f"{name}weight"].T + weights[f"{name}bias"]


def memory(weights: dict[str, np.ndarray], name: str, end: str, rows: np.ndarray) -> np.ndarray:
    """Run a long short-term memory over one sequence, gate by gate."""
    w, u = weights[f"{name}weight_ih_l0{end}"], weights[f"{name}weight_hh_l0{end}"]
    b = weights[f"{name}bias_ih_l0{end}"] + weights[f"{name}bias_hh_l0{end}"]
    hidden = cell = np.zeros(u.shape[1])
    states = []
    for row in rows:
        i, f, g, o = np.split(w @ row + u @ hidden + b, 4)
        cell = expit(f) * cell + expit(i) * np.tanh(g)
        hidden = expit(o) * np.tanh(cell)
        states.append(hidden)
    return np.array(states)


def both_ways(weights: dict[str, np.ndarray], name: str, rows: np.ndarray) -> np.ndarray:
    back = memory(weights, name, "_reverse", rows[::-1])[::-1]
    return np.hstack([memory(weights, name, "", rows), back])


def autoencoder(weights: dict[str, np.ndarray], name: str, rows: np.ndarray) -> np.ndarray:
    for at in range(3):
        rows = np.tanh(dense(weights, f"{name}encoder.dense.{at}.", rows))
    rows = both_ways(weights, f"{name}encoder.recurrent.", rows)
    rows = both_ways(weights, f"{name}decoder.recurrent.", rows)
    for at in range(2):
        rows = np.tanh(dense(weights, f"{name}decoder.dense.{at}.", rows))
    return dense(weights, f"{name}decoder.dense.2.", rows)


@pytest.mark.parametrize("shape", SHAPES)
def test_the_network_does_what_the_equations_say(shape: Shape) -> None:
    weights = network(shape)
    windows = np.random.default_rng(1).standard_normal((2, 20, 6)).astype(np.float32)
    for one, found in zip(
        windows, zip(*stacked(shape, weights, windows), strict=True), strict=True
    ):
        expected, signal = [], one.astype(float)
        for stack in range(shape.stacks):
            made = autoencoder(weights, f"stack.{stack}.", signal)
            if shape.skip:
                made += signal if stack else dense(weights, "skip.", smoothed(one[None])[0])
            expected.append(signal := made)
        if shape.perceptual:
            expected.append(autoencoder(weights, "perceptual.", signal))
        assert len(found) == len(expected)
        for a, b in zip(found, expected, strict=True):
            np.testing.assert_allclose(a, b, atol=1e-5)


@pytest.mark.parametrize("shape", SHAPES)
def test_the_network_does_what_it_does_in_pytorch(shape: Shape) -> None:
    torch = pytest.importorskip("torch", reason="PyTorch is not installed")
    from mocapmend_algorithms.refine.train.modules import Stack

    weights = network(shape, seed=3)
    windows = np.random.default_rng(2).standard_normal((3, 50, 6)).astype(np.float32)
    stack = Stack(shape).eval()
    stack.load_state_dict({name: torch.from_numpy(array) for name, array in weights.items()})
    with torch.no_grad():
        expected = stack(torch.from_numpy(windows))
        if shape.perceptual:
            expected.append(stack.perceptual(expected[-1]))
    for a, b in zip(stacked(shape, weights, windows), expected, strict=True):
        np.testing.assert_allclose(a, b.numpy(), atol=1e-5)


def test_the_smoothing_before_the_skip_keeps_lines_and_averages_noise() -> None:
    line = np.linspace(-1, 3, 60, dtype=np.float32)[None, :, None]
    inside = slice(SKIP_REACH, -SKIP_REACH)
    np.testing.assert_allclose(smoothed(line)[0, inside], line[0, inside], atol=1e-6)
    noise = np.random.default_rng(0).standard_normal((1, 20_000, 1)).astype(np.float32)
    assert smoothed(noise).var() == pytest.approx((skip_kernel() ** 2).sum(), rel=0.05)


def test_the_paper_s_network_has_its_size() -> None:
    """15.1 million weights: 75 -> 128 and five times 177 -> 226, and the perceptual one."""
    shape = Shape(75, 177, 6, 226, 128, skip=False, perceptual=True)
    count = sum(int(np.prod(size)) for size in shape.expected().values())
    assert count == pytest.approx(15.1e6, rel=0.005)


@pytest.mark.parametrize("size", ["inputs", "outputs", "stacks", "width", "first_width"])
def test_impossible_sizes_are_refused(size: str) -> None:
    sizes = {"inputs": 6, "outputs": 9, "stacks": 1, "width": 4, "first_width": 4, size: 0}
    with pytest.raises(ValueError, match="positive"):
        Shape(**sizes, skip=True, perceptual=False)
