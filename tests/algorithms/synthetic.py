"""Recordings made for tests."""

import numpy as np
from hypothesis import strategies as st
from scipy.spatial.transform import Rotation

from mocapmend_algorithms import Recording
from mocapmend_algorithms.fill.registry import METHODS, parse_params

VARIANTS = [
    ("constant", {}),
    ("constant", {"hold": "after"}),
    ("constant", {"hold": "nearest"}),
    ("linear", {}),
    ("cubic", {}),
    ("pchip", {}),
    ("woltring", {}),
    ("woltring", {"smoothing": "10"}),
    ("cyclic", {}),
    ("cyclic", {"period": "0.3"}),
    ("linear", {"edges": "hold"}),
    ("cyclic", {"period": "0.3", "edges": "repeat"}),
    ("kalman", {}),
    ("kalman", {"frame": "world"}),
    ("kalman", {"bone_pull": "true"}),
    ("kalman", {"noise_mm": "5"}),
    ("kalman", {"direction": "causal"}),
    ("kalman", {"direction": "causal", "velocity_interval_ms": "40"}),
]
DONOR_VARIANTS = [
    ("rigid", {}),
    ("rigid", {"donors": "M1,M2,M4,M5"}),
    ("pattern", {}),
    ("pattern", {"donors": "M1,M2,M4"}),
    ("local-frame", {}),
    ("local-frame", {"edges": "leave"}),
    ("auto", {}),
    ("auto", {"donors": "M1,M2,M4", "edges": "leave"}),
]
"""Of the methods that look at other markers; the others' are `VARIANTS`."""
LEAVES_EDGES = [variant for variant in VARIANTS if "edges" not in variant[1]]
LEAVES_EDGES += [variant for variant in DONOR_VARIANTS if variant[1].get("edges") == "leave"]
FILLS_ANYTHING = [variant for variant in VARIANTS if variant != ("cyclic", {})]
"""A period that is given is believed; one that is not must be found first."""
EDGE_TO_EDGE = [
    ("linear", {}),
    ("cubic", {}),
    ("pchip", {}),
    ("woltring", {}),
    ("woltring", {"smoothing": "10"}),
    ("cyclic", {"period": "0.25"}),
    ("kalman", {}),
]
MILLIMETRES = ("noise_mm", "smoothing")
MODEL_VARIANTS = [
    ("pca-r1", {}),
    ("pca-r1", {"meet_edges": "false"}),
    ("pca-r2", {}),
    ("pca-r2", {"weight_scale_mm": "500"}),
    ("burke-lasenby", {}),
    ("burke-lasenby", {"noise_mm": "1"}),
    ("tsmc", {}),
    ("tsmc", {"weight_scale_mm": "5000", "missing_weight": "1", "meet_edges": "false"}),
    ("bone-dictionary", {"atoms": "40"}),
    ("bone-dictionary", {"atoms": "40", "keep_bones": "false"}),
    ("smbs", {"atoms": "40"}),
    ("pose-code", {}),
    ("pose-code", {"relative_to": "place", "centred": "false", "meet_edges": "false"}),
]
"""Of the methods that look at other markers; the others' are `VARIANTS`."""
UNITS = ["mm", "cm", "m"]


def fill_with(variant, recording, gaps, progress=lambda fraction: None):
    """Fill with a method and parameters given as text."""
    method = METHODS[variant[0]]
    return method.function(recording, gaps, parse_params(method, variant[1]), progress)


def record(points, *, rate=100.0, unit="mm", first_frame=1):
    """Make a recording with numbered labels."""
    points = np.array(points, dtype=np.float64)
    labels = tuple(f"M{index}" for index in range(points.shape[1]))
    return Recording(points, labels, rate, unit, first_frame=first_frame)


def smooth_motion(frames, markers, *, seed=0, rate=100.0):
    """Sums of slow sines, about a metre across; shape (frames, markers, 3)."""
    rng = np.random.default_rng(seed)
    time = np.arange(frames)[:, None, None, None] / rate
    frequency = rng.uniform(0.2, 2.0, (markers, 3, 4))
    phase = rng.uniform(0, 2 * np.pi, (markers, 3, 4))
    size = rng.uniform(20, 200, (markers, 3, 4)) / frequency
    return np.sum(size * np.sin(2 * np.pi * frequency * time + phase), axis=3)


def bending_body(frames, markers, *, seed=0, modes=3, rate=100.0):
    """A body of a metre that walks about and bends in a few ways; shape (frames, markers, 3)."""
    rng = np.random.default_rng(seed)
    shape = rng.uniform(-500, 500, (markers, 3))
    bends = rng.normal(0, 0.4, (modes, markers, 3))
    drive = smooth_motion(frames, modes, seed=seed + 1, rate=rate)[:, :, 0]
    path = 3 * smooth_motion(frames, 1, seed=seed + 2, rate=rate / 4)
    return shape + np.einsum("fk,kmc->fmc", drive, bends) + path


def punch(points, gaps):
    """Hide the samples of gaps."""
    points = np.array(points)
    for gap in gaps:
        points[gap.start : gap.stop, gap.marker] = np.nan
    return points


@st.composite
def broken_recordings(draw):
    """Recordings of any size with missing runs, in any unit, at any rate."""
    frames = draw(st.integers(2, 70))
    markers = draw(st.integers(1, 4))
    seed = draw(st.integers(0, 2**32 - 1))
    rng = np.random.default_rng(seed)
    points = smooth_motion(frames, markers, seed=seed) * draw(
        st.sampled_from([0.0, 1e-3, 1.0, 1e3])
    )
    points += draw(st.sampled_from([0.0, 1e6])) * rng.normal(size=3)
    for _ in range(draw(st.integers(0, 8))):
        start = draw(st.integers(0, frames - 1))
        length = draw(st.integers(1, frames))
        points[start : start + length, draw(st.integers(0, markers - 1))] = np.nan
    return record(
        points,
        rate=draw(st.floats(25.0, 1000.0)),
        unit=draw(st.sampled_from(UNITS)),
        first_frame=draw(st.integers(0, 70_001)),
    )


def body_motion(frames, markers, *, seed=0, rate=100.0, skin=3.0):
    """Markers of one limb: a shape that turns and travels, and skin that moves by millimetres."""
    rng = np.random.default_rng(seed)
    shape = rng.uniform(-150, 150, (markers, 3))
    angles = smooth_motion(frames, 1, seed=seed + 1, rate=rate)[:, 0] / 400
    travel = smooth_motion(frames, 1, seed=seed + 2, rate=rate)
    turned = shape @ Rotation.from_rotvec(angles).as_matrix().swapaxes(1, 2)
    sway = smooth_motion(frames, markers, seed=seed + 3, rate=rate)
    return turned + travel + skin * sway / np.std(sway)
