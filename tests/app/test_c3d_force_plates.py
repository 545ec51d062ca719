"""Force plates: every encoding, every type, and what is odd about them."""

from pathlib import Path

import numpy as np
import pytest
from c3d_synthetic import ENCODINGS, Machine, Synthetic, Value, encode, walk

from mocapmend.files import C3DFile, read_c3d

CORNERS = np.array([[464.0, 508, 0], [464, 0, 0], [0, 0, 0], [0, 508, 0]])
SIDEWAYS = np.array([470.0, 0, 0])
ORIGIN = np.array([0.25, -0.5, -38.0])


def two_plates(kind: int = 2, per_plate: int = 6) -> dict[str, Value | None]:
    """Describe two plates side by side, with the channels of the second one first."""
    channels = np.arange(1, 2 * per_plate + 1).reshape(2, per_plate)[::-1]
    return {
        "FORCE_PLATFORM:USED": [2],
        "FORCE_PLATFORM:TYPE": [kind, kind],
        "FORCE_PLATFORM:CORNERS": np.stack([CORNERS, CORNERS + SIDEWAYS]),
        "FORCE_PLATFORM:ORIGIN": np.stack([ORIGIN, -ORIGIN]),
        "FORCE_PLATFORM:CHANNEL": channels,
        "FORCE_PLATFORM:ZERO": [1, 10],
    }


def opened(
    parameters: dict[str, Value | None],
    folder: Path,
    machine: Machine = "intel",
    is_float: bool = True,
    channels: int = 16,
) -> C3DFile:
    path = folder / "plates.c3d"
    analog = np.ones((40, 1, channels))
    path.write_bytes(
        encode(Synthetic(walk(), machine, is_float, 0.125, analog=analog, parameters=parameters))
    )
    return read_c3d(path)


@pytest.mark.parametrize(("machine", "is_float"), ENCODINGS)
def test_plates_in_every_encoding(machine: Machine, is_float: bool, tmp_path: Path) -> None:
    file = opened(two_plates(), tmp_path, machine, is_float)
    first, second = file.force_plates
    assert (first.type, second.type) == (2, 2)
    assert (first.channels, second.channels) == ((6, 7, 8, 9, 10, 11), (0, 1, 2, 3, 4, 5))
    np.testing.assert_array_equal(first.corners, CORNERS)
    np.testing.assert_array_equal(second.corners, CORNERS + SIDEWAYS)
    np.testing.assert_array_equal(second.origin, -ORIGIN)
    assert file.warnings == ()


@pytest.mark.parametrize(("kind", "per_plate"), [(1, 6), (2, 6), (3, 8), (5, 8), (6, 12), (7, 8)])
def test_every_type_with_its_channels(kind: int, per_plate: int, tmp_path: Path) -> None:
    file = opened(two_plates(kind, per_plate), tmp_path, channels=24)
    assert [(plate.type, len(plate.channels)) for plate in file.force_plates] == [
        (kind, per_plate)
    ] * 2
    assert file.warnings == ()


def test_plates_of_different_types_share_a_table(tmp_path: Path) -> None:
    table = np.array([[1, 2, 3, 4, 5, 6, 0, 0], [7, 8, 9, 10, 11, 12, 13, 14]])
    parameters = two_plates() | {
        "FORCE_PLATFORM:TYPE": [2, 3],
        "FORCE_PLATFORM:CHANNEL": table,
    }
    file = opened(parameters, tmp_path)
    assert [plate.channels for plate in file.force_plates] == [
        (0, 1, 2, 3, 4, 5),
        (6, 7, 8, 9, 10, 11, 12, 13),
    ]
    assert file.warnings == ()


def test_a_single_plate_in_plain_lists(tmp_path: Path) -> None:
    parameters: dict[str, Value | None] = {
        "FORCE_PLATFORM:USED": [1],
        "FORCE_PLATFORM:TYPE": [2],
        "FORCE_PLATFORM:CORNERS": CORNERS.ravel().tolist(),
        "FORCE_PLATFORM:ORIGIN": ORIGIN.tolist(),
        "FORCE_PLATFORM:CHANNEL": [1, 2, 3, 4, 5, 6],
    }
    (plate,) = opened(parameters, tmp_path).force_plates
    np.testing.assert_array_equal(plate.corners, CORNERS)
    assert plate.channels == (0, 1, 2, 3, 4, 5)


@pytest.mark.parametrize(
    "parameters",
    [
        {},
        {"FORCE_PLATFORM:USED": [0]},
        two_plates() | {"FORCE_PLATFORM:USED": None},
        two_plates() | {"FORCE_PLATFORM:USED": [0]},
    ],
)
def test_no_plates(parameters: dict[str, Value | None], tmp_path: Path) -> None:
    file = opened(parameters, tmp_path)
    assert file.force_plates == ()
    assert file.warnings == ()


MATRIX = np.stack([np.eye(6), 2 * np.eye(6)])
NO_SURFACE = np.zeros((2, 4, 3))


@pytest.mark.parametrize(
    ("changed", "warning"),
    [
        ({"USED": [5]}, "it has 5 force plates and describes 2"),
        ({"TYPE": None}, "Force plates 1, 2: the type is not known"),
        ({"TYPE": [2, 0]}, "Force plate 2: the type is not known"),
        ({"TYPE": [np.nan, 2.0]}, "Force plate 1: the type is not known"),
        ({"TYPE": [2, 99]}, "Force plate 2: type 99 is not known"),
        ({"CORNERS": np.full((2, 4, 3), np.nan)}, "Force plates 1, 2: the corners span no"),
        ({"CORNERS": NO_SURFACE}, "Force plates 1, 2: the corners span no"),
        ({"CORNERS": CORNERS[None]}, "Force plate 2: the corners span no"),
        ({"CORNERS": None}, "Force plates 1, 2: the corners span no"),
        ({"CHANNEL": None}, "Force plates 1, 2: not all analog channels"),
        ({"CHANNEL": np.arange(12).reshape(2, 6) + 8}, "Force plate 2: not all analog"),
        ({"CHANNEL": np.array([[1, 2, 0, 4, 5, 6]] * 2)}, "1, 2: not all analog channels"),
        ({"TYPE": [2, 3]}, "Force plate 2: 6 analog channels do not belong to type 3"),
        ({"TYPE": [2, 4]}, "Force plate 2: type 4 needs a calibration matrix"),
        ({"TYPE": [4, 2], "CAL_MATRIX": MATRIX}, "Force plate 2: type 2 has no use for the cal"),
    ],
)
def test_oddities_are_said(changed: dict[str, Value | None], warning: str, tmp_path: Path) -> None:
    parameters = two_plates() | {f"FORCE_PLATFORM:{k}": value for k, value in changed.items()}
    file = opened(parameters, tmp_path)
    assert len(file.force_plates) == 2
    assert len(file.warnings) == 1
    assert warning in file.warnings[0]


def test_plates_with_their_matrices_are_not_odd(tmp_path: Path) -> None:
    parameters = two_plates(4) | {"FORCE_PLATFORM:CAL_MATRIX": MATRIX}
    assert opened(parameters, tmp_path).warnings == ()
    # Qualisys writes matrices of zeros for plates that have none.
    parameters = two_plates(2) | {"FORCE_PLATFORM:CAL_MATRIX": 0 * MATRIX}
    assert opened(parameters, tmp_path).warnings == ()


def test_what_is_missing_is_not_made_up(tmp_path: Path) -> None:
    parameters: dict[str, Value | None] = {
        "FORCE_PLATFORM:USED": [1],
        "FORCE_PLATFORM:TYPE": [2],
    }
    (plate,) = opened(parameters, tmp_path).force_plates
    assert np.isnan(plate.corners).all()
    assert plate.corners.shape == (4, 3)
    assert np.isnan(plate.origin).all()
    assert plate.channels == ()


def test_a_damaged_count_makes_no_plates(tmp_path: Path) -> None:
    file = opened({"FORCE_PLATFORM:USED": [65535]}, tmp_path)
    assert file.force_plates == ()
    assert "65535 force plates and describes 0" in file.warnings[0]
