"""Which of the stored points are markers, what they are called, and the events of a file."""

import struct

import numpy as np

from mocapmend.files.c3d_layout import Layout
from mocapmend.files.c3d_numbers import decode_floats
from mocapmend.files.c3d_parameters import decode_text
from mocapmend.files.labels import complete_labels
from mocapmend.files.source import Event

MODEL_GROUPS = ("ANGLES", "FORCES", "MOMENTS", "POWERS", "SCALARS")
HEADER_EVENTS_KEY = 12345
HEADER_EVENTS = 18


def point_labels(layout: Layout, warnings: list[str]) -> tuple[str, ...]:
    """Return one label per stored point, "point N" where the file has none."""
    return complete_labels(layout.parameters.texts("POINT:LABELS"), layout.points, warnings)


def model_points(layout: Layout, labels: tuple[str, ...]) -> frozenset[int]:
    """Return the stored points that are results of a model (angles, forces, ...), not markers."""
    parameters = layout.parameters
    # TYPE_GROUPS lists pairs of a parameter and what one of its points is called.
    groups = {*MODEL_GROUPS, *map(str.upper, parameters.texts("POINT:TYPE_GROUPS")[::2])}
    names = {text for group in groups for text in parameters.texts(f"POINT:{group}") if text}
    # The lists may leave out the subject that labels begin with, as in "Ann:LKneeAngles".
    return frozenset(
        i for i, label in enumerate(labels) if label in names or label.split(":")[-1] in names
    )


def analog_labels(layout: Layout) -> tuple[str, ...]:
    """Return one label per analog channel, "channel N" where the file has none."""
    stated = layout.parameters.texts("ANALOG:LABELS")[: layout.channels]
    padded = stated + ("",) * (layout.channels - len(stated))
    return tuple(text or f"channel {i}" for i, text in enumerate(padded, 1))


def analog_units(layout: Layout) -> tuple[str, ...]:
    """Return one unit per analog channel as the file writes it, empty where it has none."""
    stated = layout.parameters.texts("ANALOG:UNITS")[: layout.channels]
    return stated + ("",) * (layout.channels - len(stated))


def read_events(layout: Layout) -> tuple[Event, ...]:
    """Return the events of the group EVENT and those of the header that it does not repeat."""
    listed = _group_events(layout)
    times = np.array([event.time for event in listed])
    added = [
        event
        for event in _header_events(layout)
        if not (abs(times - event.time) < 0.5 / layout.rate).any()
    ]
    return tuple(sorted([*listed, *added], key=lambda event: event.time))


def _event(layout: Layout, label: str, context: str, time: float) -> Event:
    return Event(label, context, time * layout.rate + 1 - layout.first_frame, time)


def _group_events(layout: Layout) -> list[Event]:
    parameters = layout.parameters
    # Pairs of minutes and seconds.
    times = parameters.numbers("EVENT:TIMES")
    used = parameters.number("EVENT:USED", unsigned=True)
    count = len(times) // 2 if used is None else min(int(used), len(times) // 2)
    labels = parameters.texts("EVENT:LABELS")
    contexts = parameters.texts("EVENT:CONTEXTS")
    return [
        _event(
            layout,
            labels[i] if i < len(labels) else "",
            contexts[i] if i < len(contexts) else "",
            float(60.0 * times[2 * i] + times[2 * i + 1]),
        )
        for i in range(count)
        if np.isfinite(times[2 * i : 2 * i + 2]).all()
    ]


def _header_events(layout: Layout) -> list[Event]:
    raw = layout.header.event_words
    key, count = struct.unpack_from(layout.processor.byte_order + "2H", raw)
    if key != HEADER_EVENTS_KEY or count > HEADER_EVENTS:
        return []
    times = decode_floats(raw[6:78], layout.processor).astype(np.float64)[:count]
    labels = [decode_text(raw[98 + 4 * i : 102 + 4 * i]) for i in range(count)]
    return [
        _event(layout, label, "", float(time))
        for label, time in zip(labels, times, strict=True)
        if np.isfinite(time)
    ]
