"""A body of rigid segments on joints that swing, with markers on it, and what becomes of it."""

from dataclasses import replace

import numpy as np
from scipy.spatial.transform import Rotation

from mocapmend_algorithms import Recording

# Segment: its parent, where its joint is in the parent, its markers about the joint, and by how
# much (degrees) and about which axis it swings.
SEGMENTS = {
    "pelvis": (None, (0, 0, 950), {"LASI": (110, 120, 20), "RASI": (110, -120, 20),
                                   "LPSI": (-90, 55, 60), "RPSI": (-90, -55, 60)}, 5, "z"),
    "trunk": ("pelvis", (0, 0, 80), {"C7": (-60, 0, 480), "T10": (-110, 10, 260),
                                     "CLAV": (80, 0, 410), "RBAC": (-100, -90, 380)}, 8, "y"),
    "head": ("trunk", (0, 0, 520), {"LHEAD": (70, 75, 130), "RHEAD": (75, -75, 135),
                                    "BHEAD": (-95, 10, 150)}, 12, "z"),
    "left arm": ("trunk", (0, 190, 430), {"LSHO": (0, 10, 40), "LUPA": (25, 55, -140),
                                          "LELB": (-10, 45, -290)}, 25, "y"),
    "left forearm": ("left arm", (0, 0, -290), {"LFRM": (10, 50, -110), "LWRA": (40, 10, -240),
                                                "LWRB": (-35, 10, -245)}, 20, "y"),
    "right arm": ("trunk", (0, -190, 430), {"RSHO": (0, -10, 40), "RUPA": (30, -50, -190),
                                            "RELB": (-10, -45, -290)}, -25, "y"),
    "right forearm": ("right arm", (0, 0, -290), {"RFRM": (15, -45, -150), "RWRA": (40, -10, -240),
                                                  "RWRB": (-35, -10, -245)}, -20, "y"),
    "left thigh": ("pelvis", (0, 95, -40), {"LTHI": (40, 75, -200), "LKNE": (0, 60, -410)},
                   -22, "y"),
    "left shank": ("left thigh", (0, 0, -410), {"LTIB": (60, 40, -180), "LANK": (-10, 45, -400)},
                   18, "y"),
    "left foot": ("left shank", (0, 0, -410), {"LHEE": (-75, 5, -40), "LTOE": (150, 15, -45),
                                               "LMT5": (110, 60, -50)}, 15, "y"),
    "right thigh": ("pelvis", (0, -95, -40), {"RTHI": (45, -70, -240), "RKNE": (0, -60, -410)},
                    22, "y"),
    "right shank": ("right thigh", (0, 0, -410), {"RTIB": (60, -40, -230),
                                                  "RANK": (-10, -45, -400)}, -18, "y"),
    "right foot": ("right shank", (0, 0, -410), {"RHEE": (-75, -5, -40), "RTOE": (150, -15, -45),
                                                 "RMT5": (110, -60, -50)}, -15, "y"),
}  # fmt: skip
LABELS = tuple(label for part in SEGMENTS.values() for label in part[2])


def body(frames=240, *, phase=0.0, pace=1.0, scale=1.0, noise=0.5, seed=0):
    """Return a labelled recording in mm at 100 Hz, z up, of a body that marches on."""
    rng = np.random.default_rng(seed)
    t = np.arange(frames) / 100.0 * pace
    turns, places, markers = {}, {}, {}
    for number, (name, (parent, joint, own, swing, axis)) in enumerate(SEGMENTS.items()):
        angle = np.radians(swing) * np.sin(2 * np.pi * t + phase + 0.3 * number)
        turn = Rotation.from_euler(axis, angle[:, None])
        if parent is None:
            turns[name] = turn
            places[name] = np.array(joint) + np.outer(t, [900.0, 0.0, 0.0])
        else:
            turns[name] = turns[parent] * turn
            places[name] = places[parent] + turns[parent].apply(np.array(joint, float))
        for label, place in own.items():
            markers[label] = places[name] + turns[name].apply(np.array(place, float))
    points = scale * np.stack([markers[label] for label in LABELS], axis=1)
    points += noise * rng.standard_normal(points.shape)
    return Recording(points, LABELS, 100.0)


def unlabelled(recording, *, seed=0, turn=0.0, shift=(0.0, 0.0, 0.0), pieces=1, ghosts=0):
    """Return a recording in points without labels, out of order, and the truth.

    Each marker is hidden for 8 frames between its pieces, which all are points of their own.
    The truth is the label of each point, None for ghosts.
    """
    rng = np.random.default_rng(seed)
    points = recording.points @ Rotation.from_euler("z", turn).as_matrix().T + np.array(shift)
    columns, truth = [], []
    for marker, label in enumerate(recording.labels):
        cuts = np.sort(rng.choice(np.arange(20, recording.frames - 20), pieces - 1, replace=False))
        for start, stop in zip([0, *(cuts + 8)], [*cuts, recording.frames], strict=True):
            if start < stop:
                column = np.full((recording.frames, 3), np.nan)
                column[start:stop] = points[start:stop, marker]
                columns.append(column)
                truth.append(label)
    for _ in range(ghosts):
        column = np.full((recording.frames, 3), np.nan)
        start = int(rng.integers(recording.frames - 30))
        aside = rng.standard_normal(3)
        beside = points[start : start + 30, rng.integers(recording.markers)]
        column[start : start + 30] = beside + 150.0 * aside / np.linalg.norm(aside)
        columns.append(column)
        truth.append(None)
    order = rng.permutation(len(columns))
    stored = np.stack([columns[k] for k in order], axis=1)
    labels = tuple(f"*{k}" for k in range(len(order)))
    return replace(recording, points=stored, labels=labels), [truth[k] for k in order]


def share_right(labelling, truth):
    """Return the share of the samples of true markers that have their label."""
    right = total = 0
    for proposal in labelling.proposals:
        name = truth[proposal.piece.point]
        if name is not None:
            total += proposal.piece.length
            given = None if proposal.label is None else labelling.labels[proposal.label]
            right += proposal.piece.length * (given == name)
    return right / total
