"""Bad samples that detectors find, put right as a plan says. No Qt."""

from collections.abc import Iterable, Sequence

from mocapmend.doubts import Doubt
from mocapmend.layers import Layers
from mocapmend_algorithms import Gap, Progress, Recording
from mocapmend_algorithms.corrections import Exchange, corrected
from mocapmend_algorithms.problems import BadRun, detect, registry
from mocapmend_algorithms.progress import part
from mocapmend_algorithms.skeleton import Skeleton


def fix(
    layers: Layers, skeleton: Skeleton, ids: Iterable[str], progress: Progress
) -> tuple[Layers, list[BadRun]]:
    """Look for bad samples, and put right what is found.

    What is exchanged comes first: the rest is looked for in samples that are where they belong.

    Parameters
    ----------
    layers : Layers
        What was corrected before.
    skeleton : Skeleton
        The recording's bones.
    ids : iterable of str
        The detectors.
    progress : Progress
        Called often; may cancel.

    Returns
    -------
    layers : Layers
        With what is exchanged and set aside now.
    fixed : list of BadRun
        What was found and put right, by marker and start.

    Raises
    ------
    KeyError
        If there is no detector of an id; the message lists the ids.
    """
    found = find(layers.recording, skeleton, ids, progress)
    fixed = sorted(found, key=lambda run: (run.marker, run.start))
    return layers.corrected(*remedies(found)), fixed


def find(
    recording: Recording, skeleton: Skeleton, ids: Iterable[str], progress: Progress
) -> list[BadRun]:
    """Look for bad samples that can be put right.

    Parameters
    ----------
    recording : Recording
        What is believed so far.
    skeleton : Skeleton
        Its bones.
    ids : iterable of str
        The detectors.
    progress : Progress
        Called often; may cancel.

    Returns
    -------
    list of BadRun
        What is to be exchanged, and then what is to be set aside after that.

    Raises
    ------
    KeyError
        If there is no detector of an id; the message lists the ids.
    """
    chosen = registry.chosen(ids)
    every: list[BadRun] = []
    for count, remedy in enumerate(("exchange", "missing")):
        names = [each.id for each in chosen if each.remedy == remedy]
        step = part(progress, count / 2.0, (count + 1) / 2.0)
        found = detect(recording, skeleton, names, step) if names else []
        found = [run for run in found if is_fixable(run)]
        recording = corrected(recording, remedies(found)[0], ())
        every += found
    return every


def is_fixable(run: BadRun) -> bool:
    """Say whether there is something to do: a ghost belongs to no marker."""
    return registry.detector(run.kind).remedy == "missing" or run.other is not None


def exchanged_kinds(found: Iterable[BadRun]) -> tuple[str, ...]:
    """Return the ids of the detectors that found what is to be exchanged, one for each problem."""
    return tuple(run.kind for run in found if registry.remedy(run) == "exchange")


def remedies(found: Sequence[BadRun]) -> tuple[list[Exchange], dict[Gap, Doubt]]:
    """Return what puts bad samples right: exchanges, and runs to be set aside after these."""
    exchanges, aside = [], {}
    for run in found:
        if registry.detector(run.kind).remedy == "missing":
            aside[Gap(run.marker, run.start, run.stop)] = Doubt(run.kind, run.reason)
        elif run.other is not None:
            exchanges.append(Exchange(run.marker, run.other, run.start, run.stop))
    return exchanges, aside
