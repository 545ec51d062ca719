"""Training sets made for tests: the walk of somebody else."""

import numpy as np
from joint_samples import walker

from mocapmend_algorithms import Recording
from mocapmend_algorithms.sparse.body import find_body
from mocapmend_algorithms.sparse.bone_space import with_lengths


def another_subject(frames: int = 500, prefix: str = "Bob:") -> Recording:
    """The walk of a body whose bones have other lengths, each by a factor of its own."""
    walk = walker(frames, prefix=prefix)
    body = find_body(walk, walk.present)
    factors = np.random.default_rng(5).uniform(0.7, 1.4, len(body.edges))
    lengths = factors * body.edge_lengths / walk.mm
    return walk.with_points(with_lengths(walk.points, body, lengths))
