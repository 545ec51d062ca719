"""What is learned of labelled recordings, to label others."""

import json
from collections.abc import Mapping, Sequence
from dataclasses import dataclass
from typing import Any, ClassVar

import numpy as np

from mocapmend_algorithms.arrays import FloatArray
from mocapmend_algorithms.progress import Progress, no_progress
from mocapmend_algorithms.recording import Recording

SCHEMA = 1
LARGEST_MM = 1e6
"""No body is a kilometre large."""


@dataclass(frozen=True, eq=False)
class LabelModel:
    """The shape of a marker set on a body, and how it moves.

    All lengths are in mm, with z up and in the size of the first recording.

    Attributes
    ----------
    labels : tuple of str
        Without a subject.
    length, spread : ndarray, shape (labels, labels)
        Median and robust standard deviation of the distance of two markers; NaN where they were
        never seen together.
    shapes : ndarray, shape (labels, labels, 3)
        Mean place of the markers around each marker, in a frame that moves with those that keep
        their distance to it best.
    wander : ndarray, shape (labels,)
        Standard deviation per axis of each marker's own place in that frame.
    poses : ndarray, shape (poses, labels, 3)
        Poses that differ; NaN where a marker was missing.
    segments : tuple of tuple of int
        Labels that move as one.
    """

    labels: tuple[str, ...]
    length: FloatArray
    spread: FloatArray
    shapes: FloatArray
    wander: FloatArray
    poses: FloatArray
    segments: tuple[tuple[int, ...], ...]

    ARRAYS: ClassVar = ("length", "spread", "shapes", "wander", "poses")

    def __post_init__(self) -> None:
        count = len(self.labels)
        shapes: dict[str, tuple[int, ...]] = {
            "length": (count, count),
            "spread": (count, count),
            "shapes": (count, count, 3),
            "wander": (count,),
            "poses": (len(self.poses), count, 3),
        }
        for name, shape in shapes.items():
            if getattr(self, name).shape != shape:
                raise ValueError(f"{name} must be {shape}, not {getattr(self, name).shape}")
        if len(set(self.labels)) != count:
            raise ValueError("two of the labels are the same")
        if any(not 0 <= label < count for part in self.segments for label in part):
            raise ValueError("a segment has a label that is not there")

    @classmethod
    def learn(
        cls,
        recordings: Sequence[Recording],
        segments: Sequence[Sequence[str]] = (),
        progress: Progress = no_progress,
    ) -> "LabelModel":
        """Learn from labelled recordings; see `mocapmend_algorithms.labelling.learning`.

        Parameters
        ----------
        recordings : sequence of Recording
            Labelled, of one subject or of several of like build. Points without a meaningful label
            are left out, and so are those that share one, unless they are never seen at once.
        segments : sequence of sequence of str
            Labels that move as one, of a template; found from the distances by default.
        progress : Progress
            Called often; may cancel.

        Returns
        -------
        LabelModel

        Raises
        ------
        ValueError
            If there are fewer than four labels, or no frame shows four of them.
        """
        from mocapmend_algorithms.labelling.learning import learn

        return learn(recordings, segments, progress)

    def to_json(self) -> str:
        """Return the model as a JSON document; numbers have a hundredth of a mm."""
        arrays = {name: _rounded(getattr(self, name)) for name in self.ARRAYS}
        parts = [list(part) for part in self.segments]
        document = {"schema": SCHEMA, "labels": list(self.labels), "segments": parts, **arrays}
        return json.dumps(document, allow_nan=False)

    @classmethod
    def from_json(cls, text: str) -> "LabelModel":
        """Read what `to_json` has written.

        Raises
        ------
        ValueError
            If it is no such document.
        """
        try:
            document = json.loads(text)
            if document["schema"] != SCHEMA:
                raise ValueError(f"the schema is {document['schema']!r}, not {SCHEMA}")
            count = len(document["labels"])
            arrays = {name: np.array(document[name], np.float64) for name in cls.ARRAYS}
            arrays["poses"] = arrays["poses"].reshape(-1, count, 3)
            _require_sound(arrays)
            return cls(
                labels=tuple(str(label) for label in document["labels"]),
                segments=tuple(tuple(int(k) for k in part) for part in document["segments"]),
                **arrays,
            )
        except (KeyError, TypeError, AttributeError) as error:
            raise ValueError(f"this is no model of labels: {error!r}") from error


def _require_sound(arrays: Mapping[str, FloatArray]) -> None:
    """Refuse numbers that no body has: a file may have been damaged or edited."""
    for name, values in arrays.items():
        if (np.abs(values) > LARGEST_MM).any():
            raise ValueError(f"{name} has a number that is too large")
    for name in ("length", "spread", "wander"):
        if (arrays[name] < 0).any():
            raise ValueError(f"{name} has a negative number")
    for name in ("shapes", "poses"):
        unknown = np.isnan(arrays[name])
        if (unknown.any(axis=-1) != unknown.all(axis=-1)).any():
            raise ValueError(f"{name} has a place with some coordinates and not others")


def _rounded(array: FloatArray) -> Any:
    listed = np.round(array, 2).astype(object)
    listed[np.isnan(array)] = None
    return listed.tolist()
