"""What a skeleton is: bones, and segments of markers that move as one."""

from dataclasses import dataclass
from typing import Literal

Bone = tuple[int, int]


@dataclass(frozen=True)
class Segment:
    """Markers that keep their distances to each other.

    Attributes
    ----------
    markers : tuple of int
        Marker indices, ascending; may be one alone.
    name : str
        As "head"; "" where it was found from distances.
    """

    markers: tuple[int, ...]
    name: str = ""


@dataclass(frozen=True)
class Skeleton:
    """The sticks of a recording.

    Attributes
    ----------
    name : str
        Of the template, or "" where there is none.
    bones : tuple of (int, int)
        Marker indices.
    source : str
        Where the bones come from.
    segments : tuple of Segment
        No marker is in two; markers that were hardly seen are in none.
    """

    name: str
    bones: tuple[Bone, ...]
    source: Literal["file", "template", "distances", "none"]
    segments: tuple[Segment, ...] = ()
