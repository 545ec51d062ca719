"""Finding the bones of a recording. No Qt."""

from collections.abc import Sequence
from dataclasses import replace

from mocapmend import user_templates
from mocapmend.files import Source
from mocapmend_algorithms import Progress, Recording
from mocapmend_algorithms.skeleton import (
    Skeleton,
    Template,
    match_template,
    segments_from_distances,
    skeleton_from_distances,
)
from mocapmend_resources import skeletons


def find_skeleton(source: Source, progress: Progress) -> Skeleton:
    """Find the bones: the file's own, else by known labels, else by constant distances.

    The user's templates come before those that ship with the program where both fit as well.
    """
    return skeleton_of(source, user_templates.load()[0], progress)


def search_skeleton(recording: Recording, progress: Progress) -> Skeleton:
    """Find the bones of a recording whose file has none, as `find_skeleton` does."""
    return _searched(recording, user_templates.load()[0], progress)


def skeleton_of(source: Source, own: Sequence[Template], progress: Progress) -> Skeleton:
    """Find the bones as `find_skeleton` does, with the user's templates at hand."""
    stated = stated_skeleton(source)
    return _searched(source.recording, own, progress) if stated is None else stated


def stated_skeleton(source: Source) -> Skeleton | None:
    """Return the bones that a file itself names, None if it names none."""
    return Skeleton(source.kind, source.bones, "file") if source.bones else None


def _searched(recording: Recording, own: Sequence[Template], progress: Progress) -> Skeleton:
    known = match_template(recording.labels, (*own, *skeletons.load()))
    if known is None:
        return skeleton_from_distances(recording, progress)
    if known.segments:
        return known
    return replace(known, segments=segments_from_distances(recording, progress))
