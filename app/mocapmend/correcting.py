"""What putting samples right changes in an open recording: one undoable step. No widgets."""

from collections.abc import Iterable, Iterator, Mapping, Sequence
from dataclasses import replace
from typing import NamedTuple

from mocapmend.believed import Correction
from mocapmend.document import Document
from mocapmend.doubts import Change, Doubt
from mocapmend.edits import Edit
from mocapmend.layers import Layers
from mocapmend_algorithms import Gap
from mocapmend_algorithms.corrections import Exchange, exchanges_between, stored_places


class Step(NamedTuple):
    """What is to be done.

    Attributes
    ----------
    edits : list of Edit
        Gaps that are open again first: repairs and protections of gaps that the correction changes.
    correction : Correction
        What then is exchanged and set aside.
    """

    edits: list[Edit]
    correction: Correction


def step(
    document: Document,
    *,
    exchanges: Sequence[Exchange] = (),
    set_aside: Mapping[Gap, Doubt] | None = None,
    believe: Iterable[Gap] = (),
    found_as: tuple[str, ...] = (),
) -> Step:
    """Return the step that exchanges samples, sets others aside, or believes them again.

    Parameters
    ----------
    document : Document
        The recording.
    exchanges : sequence of Exchange
        Made first, in this order.
    set_aside : mapping of Gap to Doubt, optional
        Runs of which the measured samples are set aside then.
    believe : iterable of Gap
        Runs in which none is set aside any more.
    found_as : tuple of str
        See `Correction`.
    """
    before = document.layers
    after = before.corrected(exchanges, {}).believing(believe).corrected((), set_aside or {})
    edits, correction = _between(document, before, after, exchanges)
    return Step(edits, replace(correction, found_as=found_as))


def towards(document: Document, wanted: Layers) -> Step:
    """Return the step after which exactly that is exchanged and set aside which layers say.

    Parameters
    ----------
    document : Document
        The recording.
    wanted : Layers
        Of its file.
    """
    before = document.layers
    shape = document.original.present.shape
    now, then = (
        stored_places(shape) if layers.origins is None else layers.origins
        for layers in (before, wanted)
    )
    return Step(*_between(document, before, wanted, exchanges_between(now, then)))


def _between(
    document: Document, before: Layers, after: Layers, exchanges: Sequence[Exchange]
) -> tuple[list[Edit], Correction]:
    gone = {r: d for r, d in before.set_aside.items() if after.set_aside.get(r) != d}
    come = {r: d for r, d in after.set_aside.items() if before.set_aside.get(r) != d}
    correction = Correction(tuple(exchanges), Change(gone, come))
    return [Edit.clear(gap) for gap in _touched(document, correction)], correction


def _touched(document: Document, correction: Correction) -> Iterator[Gap]:
    """Yield the gaps, repaired or kept open, that the runs of a correction meet."""
    of_marker: dict[int, list[Gap]] = {}
    for run in correction.runs:
        of_marker.setdefault(run.marker, []).append(run)
    for gap in sorted({*document.repairs, *document.never, *document.set_aside}):
        for run in of_marker.get(gap.marker, ()):
            # A gap beside a run may become one with it.
            if gap.start <= run.stop and run.start <= gap.stop:
                yield gap
                break
