"""The parameters of new C3D files."""

from collections.abc import Sequence
from dataclasses import dataclass

import numpy as np
from numpy.typing import NDArray

from mocapmend.files.c3d_numbers import Processor
from mocapmend.files.c3d_section import (
    LARGEST_WORD,
    MOST_ROWS,
    float_record,
    group_record,
    integer_record,
    numbered,
    text_record,
    text_records,
)
from mocapmend.files.c3d_space import SOFTWARE
from mocapmend.files.source import Event
from mocapmend_algorithms.recording import Recording

INTEL = Processor.INTEL
LARGEST_EXACT = 2**24
"""Above it not every whole number is a float of 32 bits."""
POINT, ANALOG, TRIAL, EVENT, MANUFACTURER = range(1, 6)


@dataclass(frozen=True, eq=False)
class NewParameters:
    """What a recording says beside its samples, as a C3D file can hold it.

    Attributes
    ----------
    labels, event_labels, event_contexts : tuple of bytes
        UTF-8, at most 255 bytes each.
    times : ndarray, shape (events, 2), float32
        Minutes and seconds from frame 1, in order.
    notes : tuple of str
        What is not as it was given.
    """

    labels: tuple[bytes, ...]
    event_labels: tuple[bytes, ...]
    event_contexts: tuple[bytes, ...]
    times: NDArray[np.float32]
    notes: tuple[str, ...]

    @classmethod
    def of(cls, recording: Recording, events: Sequence[Event]) -> "NewParameters":
        """Encode labels and events."""
        rate = float(np.float32(recording.rate))
        frames = np.array([event.frame for event in events], np.float64)
        seconds = (frames + recording.first_frame - 1) / rate
        minutes = np.floor(seconds / 60)
        times = np.stack([minutes, seconds - 60 * minutes], axis=1).astype(np.float32)
        order = np.argsort(_seconds(times), kind="stable")
        sorted_events = [events[i] for i in order]
        texts = [
            recording.labels,
            [event.label for event in sorted_events],
            [event.context for event in sorted_events],
        ]
        labels, event_labels, contexts = (tuple(map(_row, part)) for part in texts)
        rows = [*labels, *event_labels, *contexts]
        given = [text for part in texts for text in part]
        changed = [text for text, row in zip(given, rows, strict=True) if text != row.decode()]
        notes = [
            f"Names that a C3D file cannot hold were cut ({len(changed)}); the first is {text!r}."
            for text in changed[:1]
        ]
        return cls(labels, event_labels, contexts, times[order], tuple(notes))

    @property
    def shown_labels(self) -> tuple[str, ...]:
        """The labels as our reader shows them."""
        return tuple(row.decode() or f"point {i}" for i, row in enumerate(self.labels, 1))

    @property
    def shown_events(self) -> list[tuple[str, str, float]]:
        """Label, context and time of each event as our reader shows them."""
        texts = zip(self.event_labels, self.event_contexts, _seconds(self.times), strict=True)
        return [(label.decode(), context.decode(), float(time)) for label, context, time in texts]


def new_records(recording: Recording, parameters: NewParameters, data_block: int) -> list[bytes]:
    """Return the records of a new file whose data begin at a block."""
    frames = recording.frames
    last = recording.first_frame + frames - 1
    right = "+Y" if recording.up[1] == "x" else "+X"
    long = [float_record(POINT, "LONG_FRAMES", frames, INTEL)]
    return [
        group_record(POINT, "POINT", INTEL),
        integer_record(POINT, "USED", recording.markers, INTEL),
        float_record(POINT, "SCALE", -1.0, INTEL),
        float_record(POINT, "RATE", recording.rate, INTEL),
        integer_record(POINT, "DATA_START", data_block, INTEL),
        integer_record(POINT, "FRAMES", min(frames, LARGEST_WORD), INTEL),
        *(long if LARGEST_WORD < frames <= LARGEST_EXACT else []),
        text_record(POINT, "UNITS", recording.unit.encode(), INTEL),
        text_record(POINT, "X_SCREEN", right.encode(), INTEL),
        text_record(POINT, "Y_SCREEN", recording.up.upper().encode(), INTEL),
        *text_records(POINT, "LABELS", parameters.labels, INTEL),
        group_record(ANALOG, "ANALOG", INTEL),
        integer_record(ANALOG, "USED", 0, INTEL),
        group_record(TRIAL, "TRIAL", INTEL),
        integer_record(TRIAL, "ACTUAL_START_FIELD", _words(recording.first_frame), INTEL),
        integer_record(TRIAL, "ACTUAL_END_FIELD", _words(last), INTEL),
        *(_event_records(parameters) if parameters.event_labels else []),
        group_record(MANUFACTURER, "MANUFACTURER", INTEL),
        text_record(MANUFACTURER, "SOFTWARE", SOFTWARE.encode(), INTEL),
    ]


def _event_records(parameters: NewParameters) -> list[bytes]:
    count = len(parameters.event_labels)
    times = [
        float_record(
            EVENT, numbered("TIMES", part), parameters.times[start : start + MOST_ROWS], INTEL
        )
        for part, start in enumerate(range(0, count, MOST_ROWS), 1)
    ]
    return [
        group_record(EVENT, "EVENT", INTEL),
        integer_record(EVENT, "USED", count, INTEL),
        *text_records(EVENT, "CONTEXTS", parameters.event_contexts, INTEL),
        *text_records(EVENT, "LABELS", parameters.event_labels, INTEL),
        *times,
    ]


def _words(frame: int) -> tuple[int, int]:
    """Split a frame number into its low and high 16 bits."""
    return frame % 65536, frame // 65536


def _seconds(times: NDArray[np.float32]) -> NDArray[np.float64]:
    """Return times in seconds from minutes and seconds."""
    both = times.astype(np.float64)
    return np.asarray(60.0 * both[:, 0] + both[:, 1])


def _row(text: str) -> bytes:
    """Encode a name without what readers take for its padding, cut between two characters."""
    raw = text.replace("\0", " ").strip().encode("utf-8", "replace")[:MOST_ROWS]
    return raw.decode("utf-8", "ignore").rstrip().encode()
