"""Gaps told by the trained dictionaries of a training set, as W18 prints it (`part_codes`)."""

from collections.abc import Sequence

import numpy as np

from mocapmend_algorithms.arrays import BoolArray
from mocapmend_algorithms.fill.edges import EdgeParams, Modelled, obstacle, with_edges
from mocapmend_algorithms.gaps import Gap
from mocapmend_algorithms.progress import Progress
from mocapmend_algorithms.recording import Recording
from mocapmend_algorithms.sparse.body import Body, with_own_lengths
from mocapmend_algorithms.sparse.part_codes import recover
from mocapmend_algorithms.sparse.part_rows import PartDictionary
from mocapmend_algorithms.sparse.part_sets import body_of, parts_of
from mocapmend_algorithms.sparse.training_set import TrainingSet, TrainingSetError


class TrainedParts:
    """The dictionaries of a training set, for one recording.

    Parameters
    ----------
    training : TrainingSet
        With dictionaries; see `part_codes.train_parts`.
    recording : Recording
        What is to be repaired.

    Raises
    ------
    TrainingSetError
        If the set has no dictionaries, is of other markers or has another frame rate.
    """

    def __init__(self, training: TrainingSet, recording: Recording) -> None:
        self._places = training.places_of(recording.labels)
        if training.rate != recording.rate:
            raise TrainingSetError(
                f"the dictionaries were trained at {training.rate:g} Hz, and this recording has "
                f"{recording.rate:g}"
            )
        self._body: Body = body_of(training)
        self._parts: dict[int, PartDictionary] = parts_of(training, self._body)

    def tell(
        self,
        recording: Recording,
        observed: BoolArray,
        gaps: Sequence[Gap],
        params: EdgeParams,
        progress: Progress,
    ) -> dict[Gap, Modelled | str]:
        """Say what the dictionaries make of gaps; see `motion_codes.tell_gaps`."""
        points = np.where(observed[..., None], recording.points, np.nan)[:, self._places]
        seen = observed[:, self._places]
        own = Recording(
            points,
            tuple(recording.labels[place] for place in self._places.tolist()),
            recording.rate,
            recording.unit,
            recording.up,
        )
        body = with_own_lengths(self._body, own)
        found = recover(points * recording.mm, seen, body, self._parts, progress) / recording.mm
        at = {place: number for number, place in enumerate(self._places.tolist())}
        said: dict[Gap, Modelled | str] = {}
        for gap in gaps:
            start, stop = with_edges(observed, gap)
            reason = obstacle(observed, gap, params)
            if not reason and gap.marker not in at:
                reason = "the training set has no such marker"
            if not reason:
                values = found[start:stop, at[gap.marker]]
                if np.isfinite(values).all():
                    said[gap] = Modelled(values, {"parts": len(self._parts)})
                    continue
                reason = "no marker of the training set is seen all through the gap"
            said[gap] = reason
        return said
