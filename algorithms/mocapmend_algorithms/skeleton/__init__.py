"""Which markers belong together: from a known label set, or from the recording itself.

A *bone* is a pair of markers whose distance is nearly constant, a *segment* a group of markers
that keep all their distances.
"""

from mocapmend_algorithms.skeleton.distances import PairDistances, measure_distances
from mocapmend_algorithms.skeleton.found import (
    joining_bones,
    segments_from_distances,
    skeleton_from_distances,
)
from mocapmend_algorithms.skeleton.model import Bone, Segment, Skeleton
from mocapmend_algorithms.skeleton.segments import Mate, find_segments, segment_mates
from mocapmend_algorithms.skeleton.templates import Template, match_template, parse_template

__all__ = [
    "Bone",
    "Mate",
    "PairDistances",
    "Segment",
    "Skeleton",
    "Template",
    "find_segments",
    "joining_bones",
    "match_template",
    "measure_distances",
    "parse_template",
    "segment_mates",
    "segments_from_distances",
    "skeleton_from_distances",
]
