"""The force plates that a C3D file describes."""

import numpy as np
from numpy.typing import NDArray

from mocapmend.files.c3d_layout import Layout
from mocapmend.files.c3d_parameters import Parameters
from mocapmend.files.force_plate import ForcePlate

CHANNELS = {1: 6, 2: 6, 3: 8, 4: 6, 5: 8, 6: 12, 7: 8}
"""Analog channels of the types of plates that c3d.org describes."""
WITH_MATRIX = 4
"""The type of plates whose channels become forces by a matrix."""
MOST = 255
"""The plates are counted by a dimension of one byte."""


def read_force_plates(layout: Layout, warnings: list[str]) -> tuple[ForcePlate, ...]:
    """Return the force plates of the group FORCE_PLATFORM; what is odd about them is a warning."""
    parameters = layout.parameters
    used = int(parameters.number("FORCE_PLATFORM:USED", unsigned=True) or 0)
    if not used:
        return ()
    types = parameters.numbers("FORCE_PLATFORM:TYPE")
    corners = _rows(parameters, "CORNERS", 12)
    origins = _rows(parameters, "ORIGIN", 3)
    channels = _rows(parameters, "CHANNEL", _channel_rows(parameters))
    matrices = _rows(parameters, "CAL_MATRIX", 36)
    described = min(max(len(types), len(corners), len(channels)), MOST)
    if used > described:
        warnings.append(f"The file says that it has {used} force plates and describes {described}.")
    odd: dict[str, list[int]] = {}
    plates = []
    for i in range(min(used, described)):
        plate = ForcePlate(
            _type(types[i]) if i < len(types) else None,
            corners[i].reshape(4, 3) if i < len(corners) else np.full((4, 3), np.nan),
            origins[i] if i < len(origins) else np.full(3, np.nan),
            _inside(channels[i] if i < len(channels) else np.zeros(0), layout.channels),
        )
        plates.append(plate)
        for text in _oddities(plate, calibrated=i < len(matrices) and matrices[i].any()):
            odd.setdefault(text, []).append(i + 1)
    for text, numbers in odd.items():
        which = ", ".join(map(str, numbers))
        warnings.append(f"Force plate{'s' if len(numbers) > 1 else ''} {which}: {text}.")
    return tuple(plates)


def _rows(parameters: Parameters, name: str, length: int) -> NDArray[np.float64]:
    """Return the numbers of a parameter by plate, shape (plates, length)."""
    values = parameters.numbers(f"FORCE_PLATFORM:{name}")
    return values[: len(values) // length * length].reshape(-1, length)


def _channel_rows(parameters: Parameters) -> int:
    """Return how many channels the table has per plate; plates with fewer fill up with 0."""
    table = parameters.get("FORCE_PLATFORM:CHANNEL")
    return max(table.dimensions[0], 1) if table is not None and table.dimensions else 1


def _type(value: float) -> int | None:
    return int(value) if 1 <= value <= MOST else None


def _inside(channels: NDArray[np.float64], count: int) -> tuple[int, ...]:
    """Return channels from 0; none where one of them does not exist, since their order counts."""
    stated = np.trim_zeros(channels, "b")
    if not ((stated >= 1) & (stated <= count)).all():
        return ()
    return tuple(int(channel) - 1 for channel in stated)


def _oddities(plate: ForcePlate, *, calibrated: bool) -> list[str]:
    found = []
    if plate.type not in CHANNELS:
        kind = "the type" if plate.type is None else f"type {plate.type}"
        found.append(f"{kind} is not known")
    if not plate.channels:
        found.append("not all analog channels are in the file")
    elif len(plate.channels) != CHANNELS.get(plate.type or 0, len(plate.channels)):
        found.append(f"{len(plate.channels)} analog channels do not belong to type {plate.type}")
    if plate.type == WITH_MATRIX and not calibrated:
        found.append(f"type {WITH_MATRIX} needs a calibration matrix, and there is none")
    if plate.type in {1, 2, 3} and calibrated:
        found.append(f"type {plate.type} has no use for the calibration matrix")
    if not plate.spans_surface:
        found.append("the corners span no surface")
    return found
