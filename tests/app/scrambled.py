"""The bundled walk as a system without labels delivers it."""

from dataclasses import replace
from pathlib import Path

import numpy as np
from c3d_synthetic import Synthetic, encode

from mocapmend.bench.labels.scrambling import Scrambled, scramble
from mocapmend.files import read_c3d

SEED = 3
FRAMES = 150
"""Of the recording, that are taken: labels are found sooner."""


def write_scrambled(walk: Path, out: Path, *, keep: float = 0.3) -> Scrambled:
    """Write the beginning of a recording in pieces, most of them without labels; return the truth.

    Parameters
    ----------
    walk : Path
        The labelled recording.
    out : Path
        The file that is written.
    keep : float
        Share of the markers that keep their labels.
    """
    whole = read_c3d(walk).recording
    made = scramble(replace(whole, points=whole.points[:FRAMES], seen=None), SEED, keep=keep)
    points = np.nan_to_num(made.recording.points)
    fourth = np.where(made.recording.present, 0.0, -1.0)
    labels = list(made.recording.labels)
    out.write_bytes(encode(Synthetic(points, fourth=fourth, labels=labels)))
    return made
