"""Text files of Qualisys Track Manager, OptiTrack Motive and Vicon Nexus."""

from pathlib import Path

import numpy as np
import pytest
from text_samples import MOTIVE, NAN, NEXUS, POINTS, QUALISYS, QUALISYS_ROWS

from mocapmend.errors import MocapmendError
from mocapmend.files import Source, read_recording

QUALISYS_POINTS = np.array(
    [
        [[1.5, 2.5, 3.5], [-4, 5, 6]],
        [[1.6, 2.6, 3.6], [NAN, NAN, NAN]],
        [[NAN, NAN, NAN], [-4.2, 5.2, 6.2]],
    ]
)


def read(tmp_path: Path, text: str, name: str = "file.csv") -> Source:
    path = tmp_path / name
    path.write_bytes(text.encode())
    return read_recording(path)


def qualisys(header: str = "", first_frame: int | None = None) -> str:
    rows = QUALISYS_ROWS
    if first_frame is not None:
        rows = [
            f"{i}\t{(i - 1) / 200:.5f}\t{row}" for i, row in enumerate(QUALISYS_ROWS, first_frame)
        ]
    return QUALISYS + header + "\n".join(rows) + "\n"


COLUMNS = "Frame\tTime\thead top X\thead top Y\thead top Z\tL_wrist X\tL_wrist Y\tL_wrist Z\n"


@pytest.mark.parametrize("name", ["file.tsv", "file.txt"])
@pytest.mark.parametrize(
    ("text", "first_frame"),
    [
        (qualisys(), 1),
        (qualisys().replace("\n", "\r\n"), 1),
        (qualisys(COLUMNS.removeprefix("Frame\tTime\t")), 1),
        (qualisys("", 1), 1),
        (qualisys("", 1).replace("\n", "\t\n"), 1),
        (qualisys(COLUMNS, 2), 2),
    ],
)
def test_qualisys(text: str, first_frame: int, name: str, tmp_path: Path) -> None:
    source = read(tmp_path, text, name)
    recording = source.recording
    assert source.kind == "Qualisys TSV"
    np.testing.assert_array_equal(recording.points, QUALISYS_POINTS)
    assert recording.labels == ("head top", "L_wrist")
    assert (recording.rate, recording.unit, recording.up) == (200.0, "mm", "+z")
    assert recording.first_frame == first_frame
    assert [(event.label, event.frame, event.time) for event in source.events] == [
        ("Heel strike", 2 - first_frame, 0.005),
        ("Toe off", 3 - first_frame, 0.01),
    ]
    assert not source.truncated
    assert [text for text in source.warnings if "(0, 0, 0)" in text]


def test_a_truncated_qualisys_file(tmp_path: Path) -> None:
    source = read(tmp_path, qualisys().rpartition("\t\t\t")[0], "file.tsv")
    assert source.truncated
    assert source.recording.frames == 2
    assert any("3 frames, but only 2" in text for text in source.warnings)


@pytest.mark.parametrize(
    ("old", "new"), [("DATA_INCLUDED\t3D", "DATA_INCLUDED\t2D"), ("MARKER_NAMES", "BODY_NAMES")]
)
def test_qualisys_files_without_markers(old: str, new: str, tmp_path: Path) -> None:
    with pytest.raises(MocapmendError, match="holds no 3D markers"):
        read(tmp_path, qualisys().replace(old, new), "file.tsv")


def test_an_external_timebase_has_no_rate(tmp_path: Path) -> None:
    source = read(tmp_path, qualisys("", 1).replace("Y\t200", "Y\tEXT"), "file.tsv")
    assert source.recording.rate == 200.0
    assert any("times say 200 Hz" in text for text in source.warnings)


def test_motive(tmp_path: Path) -> None:
    source = read(tmp_path, MOTIVE)
    recording = source.recording
    assert source.kind == "Motive CSV"
    np.testing.assert_array_equal(
        recording.points,
        [
            [[1.5, 2.5, 3.5], [1.6, 2.6, 3.6]],
            [[1.7, 2.7, 3.7], [NAN, NAN, NAN]],
            [[1.9, 2.9, 3.9], [1.8, 2.8, 3.8]],
        ],
    )
    assert recording.labels == ("Club:Marker1", "Club:Marker1")
    assert (recording.rate, recording.unit, recording.up) == (120.0, "m", "+y")
    assert recording.first_frame == 0
    assert source.model_outputs == ("Club",)
    assert not source.truncated
    assert source.warnings == (
        "Markers that are not measured, but where Motive expects them on a body or bone: 1 of 2.",
        "The poses of bodies and bones are left out: Club.",
        "1 point has the label of another point.",
    )


def test_motive_with_parents_time_codes_and_millimetres(tmp_path: Path) -> None:
    head, blank, *rows = MOTIVE.splitlines()
    cells = [row.split(",") for row in rows]
    cells.insert(3, ["", "Parent", *cells[2][2:]])
    for row in cells:
        row[2:2] = ["12:13:14:15.02" if row[0].isdigit() else ""]
    text = "\r\n".join([head.replace("Meters", "Millimeters"), blank, *map(",".join, cells)])
    recording = read(tmp_path, text + "\r\n").recording
    np.testing.assert_array_equal(recording.points, read(tmp_path, MOTIVE).recording.points)
    assert recording.unit == "mm"


def test_a_truncated_motive_file(tmp_path: Path) -> None:
    source = read(tmp_path, MOTIVE[: MOTIVE.index("2,0.016667") + 20])
    assert source.truncated
    assert source.recording.frames == 2


def test_motive_with_bodies_only(tmp_path: Path) -> None:
    text = MOTIVE.replace("Rigid Body Marker", "Rigid Body").replace(",Marker", ",Rigid Body")
    with pytest.raises(MocapmendError, match=r"no markers, only the poses of Club, Club:Marker1"):
        read(tmp_path, text)


@pytest.mark.parametrize("separator", [",", "\t", ";"])
def test_nexus(separator: str, tmp_path: Path) -> None:
    source = read(tmp_path, NEXUS.replace(",", separator), "file.txt")
    recording = source.recording
    assert source.kind == "Nexus CSV"
    np.testing.assert_array_equal(recording.points, POINTS)
    assert recording.labels == ("Ann:LASI", "Ann:RASI")
    assert (recording.rate, recording.unit, recording.first_frame) == (100.0, "mm", 101)
    assert any("left out: Devices" in text for text in source.warnings)


def test_nexus_with_velocities(tmp_path: Path) -> None:
    start = NEXUS.index("Trajectories")
    text = NEXUS[start : NEXUS.index("\nModel")].replace("RASI,,", "RASI,,,LASI',,")
    text = text.replace("X,Y,Z\n", "X,Y,Z,X',Y',Z'\n").replace("6\n", "6,7,8,9\n")
    recording = read(tmp_path, text).recording
    np.testing.assert_array_equal(recording.points, POINTS)


def test_nexus_without_trajectories(tmp_path: Path) -> None:
    text = NEXUS.replace("Trajectories", "Joints")
    with pytest.raises(MocapmendError, match="no trajectories, only Devices, Joints, Model Out"):
        read(tmp_path, text)
