"""Skeletons of known label sets."""

from collections.abc import Iterable, Mapping, Sequence
from dataclasses import dataclass, field
from itertools import pairwise
from typing import Any

from mocapmend_algorithms.skeleton.model import Bone, Segment, Skeleton

LEAST_SHARE = 0.8
KEYS = {"name", "required", "optional", "chains", "aliases", "segments"}


@dataclass(frozen=True)
class Template:
    """A known label set and its sticks.

    Attributes
    ----------
    name : str
        For the user.
    required : tuple of str
        Labels by which it is recognised.
    bones : tuple of (str, str)
        Pairs of labels; those with a missing end are left out.
    aliases : mapping of str to str
        Other names of its labels.
    segments : mapping of str to tuple of str
        Name and labels of the markers that move as one.
    """

    name: str
    required: tuple[str, ...]
    bones: tuple[tuple[str, str], ...]
    aliases: Mapping[str, str] = field(default_factory=dict)
    segments: Mapping[str, tuple[str, ...]] = field(default_factory=dict)


def parse_template(data: Mapping[str, Any]) -> Template:
    """Make a template from what a TOML file holds.

    Parameters
    ----------
    data : mapping
        `name`; `required` and `optional`, lists of labels; `chains`, lists of labels to be joined
        one after the other; `aliases`, other names of labels; `segments`, labels by the name of
        their segment.

    Raises
    ------
    ValueError
        If a key is missing, unknown or of a wrong kind, or if a label is used that is neither
        required nor optional, or is in two segments.
    """
    if strange := sorted(set(data) - KEYS):
        raise ValueError(f"it has an unknown key: {', '.join(strange)}")
    name = data.get("name")
    if not isinstance(name, str) or not name.strip():
        raise ValueError("it has no name")
    required = _labels(data, "required")
    if not required:
        raise ValueError("it requires no labels")
    chains = data.get("chains")
    if not isinstance(chains, list) or not chains:
        raise ValueError("it has no chains of labels to join")
    joined = [_words(chain, "a chain") for chain in chains]
    aliases = {alias: _word(label, "an alias") for alias, label in _table(data, "aliases")}
    segments = {name: _words(part, f"segment {name}") for name, part in _table(data, "segments")}
    known = {*required, *_labels(data, "optional")}
    grouped = [label for part in segments.values() for label in part]
    used = {*(label for chain in joined for label in chain), *aliases.values(), *grouped}
    if strange := sorted(used - known):
        raise ValueError(f"it uses labels that it does not list: {', '.join(strange)}")
    if twice := sorted({label for label in grouped if grouped.count(label) > 1}):
        raise ValueError(f"it has labels in two segments: {', '.join(twice)}")
    bones = dict.fromkeys(pair for chain in joined for pair in pairwise(chain))
    return Template(name, required, tuple(bones), aliases, segments)


def _labels(data: Mapping[str, Any], key: str) -> tuple[str, ...]:
    return _words(data.get(key, []), key)


def _table(data: Mapping[str, Any], key: str) -> list[tuple[str, Any]]:
    table = data.get(key, {})
    if not isinstance(table, dict):
        raise ValueError(f"{key} is not a table")
    return list(table.items())


def _words(value: Any, what: str) -> tuple[str, ...]:
    if not isinstance(value, list):
        raise ValueError(f"{what} is not a list of labels")
    return tuple(_word(label, what) for label in value)


def _word(value: Any, what: str) -> str:
    if not isinstance(value, str):
        raise ValueError(f"{what} has something else than a label: {value!r}")
    return value


def match_template(labels: Sequence[str], templates: Iterable[Template]) -> Skeleton | None:
    """Recognise a label set.

    Case and subject prefixes ("Matt:LASI") do not matter; where several subjects are recorded,
    each gets its sticks.

    Parameters
    ----------
    labels : sequence of str
        As the file has them.
    templates : iterable of Template
        The known sets. One fits when at least 80 % of its required labels are there; of those
        that fit, the one with the most labels found wins, then the one with the larger share.

    Returns
    -------
    Skeleton or None
        None where no template fits.
    """
    subjects: dict[str, dict[str, int]] = {}
    for index, label in enumerate(labels):
        subject, _, marker = label.rpartition(":")
        subjects.setdefault(subject, {}).setdefault(marker.strip().upper(), index)
    templates = tuple(templates)
    fits = [fit for found in subjects.values() if (fit := _best_fit(found, templates))]
    if not fits:
        return None
    bones = dict.fromkeys(bone for template, named in fits for bone in _bones(template, named))
    segments = [part for template, named in fits for part in _segments(template, named)]
    return Skeleton(fits[0][0].name, tuple(bones), "template", tuple(segments))


def _best_fit(
    found: Mapping[str, int], templates: Sequence[Template]
) -> tuple[Template, dict[str, int]] | None:
    """Return the template that fits, and the marker of each of the labels found, in capitals."""
    best: tuple[int, float] = (0, 0.0)
    chosen: tuple[Template, dict[str, int]] | None = None
    for template in templates:
        aliases = {a.upper(): label.upper() for a, label in template.aliases.items()}
        named = {aliases.get(label, label): index for label, index in found.items()} | dict(found)
        count = sum(label.upper() in named for label in template.required)
        score = count, count / len(template.required)
        if score[1] >= LEAST_SHARE and score > best:
            best, chosen = score, (template, named)
    return chosen


def _bones(template: Template, named: Mapping[str, int]) -> list[Bone]:
    ends = [(named.get(a.upper()), named.get(b.upper())) for a, b in template.bones]
    return [(a, b) for a, b in ends if a is not None and b is not None]


def _segments(template: Template, named: Mapping[str, int]) -> list[Segment]:
    parts = {
        name: sorted({named[label.upper()] for label in labels if label.upper() in named})
        for name, labels in template.segments.items()
    }
    return [Segment(tuple(markers), name) for name, markers in parts.items() if markers]
