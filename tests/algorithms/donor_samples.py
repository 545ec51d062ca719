"""Bodies made for tests of the methods that look at other markers."""

from dataclasses import replace

import numpy as np
from hypothesis import strategies as st
from scipy.spatial.transform import Rotation
from synthetic import UNITS, punch, record, smooth_motion

from mocapmend_algorithms import Gap

GAPS = [Gap(0, 60, 75), Gap(0, 140, 150), Gap(3, 70, 100)]


def body(frames, markers, *, seed=0, skin=3.0, turn=1.0, travel=1.0, rate=100.0):
    """A limb: a shape that turns and travels, and skin that moves by millimetres."""
    rng = np.random.default_rng(seed)
    shape = rng.uniform(-150, 150, (markers, 3))
    angles = turn * smooth_motion(frames, 1, seed=seed + 1, rate=rate)[:, 0] / 400
    turned = shape @ Rotation.from_rotvec(angles).as_matrix().swapaxes(1, 2)
    sway = smooth_motion(frames, markers, seed=seed + 3, rate=rate)
    path = travel * smooth_motion(frames, 1, seed=seed + 2, rate=rate)
    return turned + path + skin * sway / np.std(sway)


def jittery(points, size=0.1):
    """Add what a camera adds."""
    return points + np.random.default_rng(9).normal(0, size, points.shape)


def scattered(points, share, *, seed=0):
    """Lose samples at random, for some frames each."""
    rng = np.random.default_rng(seed)
    points = np.array(points)
    frames, markers, _ = points.shape
    while np.isnan(points[:, :, 0]).mean() < share:
        start, marker = rng.integers(frames), rng.integers(markers)
        points[start : start + rng.integers(1, 20), marker] = np.nan
    return points


def with_up(recording, up):
    """Say which way is up."""
    return replace(recording, up=up)


def rms(values, truth):
    """Root of the mean squared 3-D distance."""
    return float(np.sqrt(np.mean(np.sum((values - truth) ** 2, axis=-1))))


def truth_of(points, gap):
    """What was there before a gap was punched."""
    return points[gap.start : gap.stop, gap.marker]


@st.composite
def broken_bodies(draw):
    """Bodies of any size, shape and stiffness, with missing runs, in any unit, at any rate."""
    frames = draw(st.sampled_from([2, 3, 9, 30, 90]))
    markers = draw(st.integers(1, 9))
    seed = draw(st.integers(0, 10_000))
    rng = np.random.default_rng(seed)
    points = body(
        frames,
        markers,
        seed=seed,
        skin=draw(st.sampled_from([0.0, 3.0])),
        turn=draw(st.sampled_from([0.0, 1.0])),
        travel=draw(st.sampled_from([0.0, 1.0])),
    )
    points *= draw(st.sampled_from([np.zeros(3), np.array([1.0, 0, 0]), np.ones(3)]))
    points += draw(st.sampled_from([0.0, 1e6])) * rng.normal(size=3)
    if draw(st.booleans()):
        frozen = draw(st.integers(0, frames - 1))
        points[frozen:] = points[frozen]
    points[rng.random((frames, markers)) < draw(st.sampled_from([0.0, 0.3]))] = np.nan
    for _ in range(draw(st.integers(0, 4))):
        start, length = rng.integers(frames), rng.integers(1, frames + 1)
        points[start : start + length, rng.integers(markers)] = np.nan
    return record(points, rate=draw(st.floats(10, 1000)), unit=draw(st.sampled_from(UNITS)))


def punched(points, gaps=tuple(GAPS), **options):
    """Make a recording with gaps."""
    return record(punch(points, gaps), **options)
