"""CSV files with a line per frame or per sample: as people write them, and as we do."""

import csv
from pathlib import Path
from typing import Literal

import numpy as np
import pytest
from hypothesis import given
from hypothesis import strategies as st
from text_samples import LONG, POINTS, WIDE, assert_same, recordings

from mocapmend.errors import MocapmendError
from mocapmend.files import Source, read_recording
from mocapmend.files.formats import write_csv
from mocapmend_algorithms.recording import Recording

LAYOUTS = ("wide", "long")


def read(tmp_path: Path, text: str | bytes, name: str = "file.csv") -> Source:
    path = tmp_path / name
    path.write_bytes(text if isinstance(text, bytes) else text.encode())
    return read_recording(path)


@pytest.mark.parametrize("text", [WIDE, LONG])
def test_a_file_by_hand(text: str, tmp_path: Path) -> None:
    source = read(tmp_path, text)
    assert source.kind == "CSV"
    np.testing.assert_array_equal(source.recording.points, POINTS)
    assert source.recording.labels == ("LASI", "R ASI")
    assert (source.recording.rate, source.recording.unit) == (50.0, "m")
    assert source.recording.first_frame == 1
    assert len(source.warnings) == 3


def german(text: str) -> str:
    return text.replace(",", ";").replace(".", ",")


@pytest.mark.parametrize("text", [WIDE, LONG])
@pytest.mark.parametrize(
    "change",
    [
        lambda text: text.replace("\n", "\r\n"),
        lambda text: text.replace(",", "\t"),
        german,
        lambda text: german(text).encode("utf-16"),
        lambda text: text.encode("utf-16-le"),
        lambda text: text.encode("utf-16-be"),
        lambda text: text.encode("utf-8-sig"),
        lambda text: text.replace(",,", ",NaN,NaN").replace("NaN,NaN\n", "NaN,NaN,NaN\n", 1),
        lambda text: text.replace("1.5", '"1.5"').replace("5.2", " 5.2 "),
        lambda text: text + ",,,,,\n\n",
        lambda text: "A comment of somebody\n\n" + text,
        lambda text: text.replace("time", "Time (s)").replace("frame", "Frame#"),
        lambda text: text.replace("0.02", "20").replace("0.04", "40").replace("time", "time_ms"),
        lambda text: text.rstrip("\n"),
    ],
)
def test_dialects_change_nothing(text: str, change: object, tmp_path: Path) -> None:
    assert callable(change)
    source = read(tmp_path, change(text))
    np.testing.assert_array_equal(source.recording.points, POINTS)
    assert source.recording.labels == ("LASI", "R ASI")
    assert source.recording.rate == 50.0


@pytest.mark.parametrize("mark", [".", " ", ":", "-", ""])
@pytest.mark.parametrize("axes", ["xyz", "XYZ"])
def test_ways_to_name_columns(mark: str, axes: str, tmp_path: Path) -> None:
    text = WIDE
    for old, new in zip("xyz", axes, strict=True):
        text = text.replace(f"_{old}", mark + new)
    source = read(tmp_path, text)
    assert source.recording.labels == ("LASI", "R ASI")
    np.testing.assert_array_equal(source.recording.points, POINTS)


@pytest.mark.parametrize(
    ("header", "labels"),
    [
        (",,LASI,,,R ASI,,\nframe,time,X,Y,Z,X,Y,Z", ("LASI", "R ASI")),
        (",,LASI,,,R ASI,,\nframe,time,X,Y,Z,X,Y,Z\n,,m,m,m,m,m,m", ("LASI", "R ASI")),
        ("frame,time,x,y,z,x,y,z", ("point 1", "point 2")),
        ("frame,time,x1,y1,z1,x2,y2,z2", ("point 1", "point 2")),
        ("frame,time,a_x [m],a_y [m],a_z [m],a_x [m],a_y [m],a_z [m]", ("a", "a")),
    ],
)
def test_other_headers(header: str, labels: tuple[str, ...], tmp_path: Path) -> None:
    source = read(tmp_path, header + WIDE[WIDE.index("\n") :])
    assert source.recording.labels == labels
    assert source.recording.unit == "m"
    np.testing.assert_array_equal(source.recording.points, POINTS)
    assert any("no length unit" in text for text in source.warnings) != ("m" in header[-5:])


def test_columns_that_are_no_coordinates_are_left_out(tmp_path: Path) -> None:
    rows = [line.split(",") for line in WIDE.splitlines()]
    for row, cell in zip(rows, ['"a, b"', "x", "NaN", '"1,2"'], strict=True):
        row[2:2] = [cell]
        row[6:6] = [cell]
    source = read(tmp_path, "\n".join(map(",".join, rows)))
    np.testing.assert_array_equal(source.recording.points, POINTS)


def test_labels_in_windows_letters(tmp_path: Path) -> None:
    source = read(tmp_path, WIDE.replace("R ASI", "Hüfte").encode("cp1252"))
    assert source.recording.labels == ("LASI", "Hüfte")


def test_a_spreadsheet_keeps_our_comments(tmp_path: Path) -> None:
    recording = Recording(POINTS.copy(), ("a", "b"), 59.94, "cm", "-y", 7)
    write_csv(recording, tmp_path / "file.csv")
    text = (tmp_path / "file.csv").read_text()
    lines = [line + ",,,,,,," if line.startswith("#") else line for line in text.splitlines()]
    source = read(tmp_path, "\r\n".join(lines))
    assert_same(source.recording, recording)
    assert source.warnings == ()


def test_without_frames_and_times_the_rate_is_assumed(tmp_path: Path) -> None:
    text = "\n".join(",".join(line.split(",")[2:]) for line in WIDE.splitlines())
    source = read(tmp_path, text, "file.txt")
    np.testing.assert_array_equal(source.recording.points, POINTS)
    assert source.recording.rate == 100.0
    assert any("100 Hz is assumed" in warning for warning in source.warnings)


@pytest.mark.parametrize("rate", [24.0, 30.0, 59.94, 120.0, 250.0])
@pytest.mark.parametrize("digits", [3, 6])
def test_the_rate_of_rounded_times(rate: float, digits: int, tmp_path: Path) -> None:
    rows = [f"{i},{i / rate:.{digits}f},1,2,3" for i in range(1000)]
    source = read(tmp_path, "frame,time,a_x,a_y,a_z\n" + "\n".join(rows) + "\n")
    assert source.recording.rate == pytest.approx(rate, rel=1e-3)
    assert (source.recording.rate == rate) == rate.is_integer()


def test_samples_in_any_order(tmp_path: Path) -> None:
    head, *rows = LONG.splitlines()
    shuffled = [rows[i] for i in (4, 0, 5, 2, 1)]
    source = read(tmp_path, "\n".join([head, *shuffled]) + "\n")
    assert source.recording.labels == ("LASI", "R ASI")
    np.testing.assert_array_equal(source.recording.points, POINTS)


def test_samples_without_frames_or_times(tmp_path: Path) -> None:
    rows = [line.split(",") for line in LONG.splitlines()]
    for column in (0, 1):
        text = "\n".join(",".join(row[:column] + row[column + 1 :]) for row in rows)
        source = read(tmp_path, text + "\n")
        np.testing.assert_array_equal(source.recording.points, POINTS)
        assert source.recording.rate == (50.0 if column == 0 else 100.0)


def test_a_sample_at_zero_is_missing_unless_the_file_says_how(tmp_path: Path) -> None:
    for text in (WIDE, LONG):
        text = text.replace("-4,5,6", "0,0,0")
        source = read(tmp_path, text)
        assert np.isnan(source.recording.points[0, 1]).all()
        assert any("(0, 0, 0)" in warning for warning in source.warnings)
        source = read(tmp_path, "# missing=empty\n" + text)
        assert source.recording.points[0, 1].tolist() == [0, 0, 0]


@given(recordings(), st.sampled_from(LAYOUTS), st.booleans())
def test_round_trip(
    tmp_path_factory: pytest.TempPathFactory,
    recording: Recording,
    layout: Literal["wide", "long"],
    states: bool,
) -> None:
    path = tmp_path_factory.mktemp("csv") / "file.csv"
    filled = np.ones((recording.frames, recording.markers), bool) if states else None
    if layout == "long" and not recording.frames:
        return
    assert write_csv(recording, path, layout=layout, filled=filled) == ()
    source = read_recording(path)
    assert_same(source.recording, recording)


def test_labels_that_a_table_could_be_confused_by(tmp_path: Path) -> None:
    labels = ("a,b", 'say "x"', "a;b", "#1", "x", "frame", "a_x", "nan", "Jürgen 山", "x", "= 1")
    points = np.arange(2 * len(labels) * 3, dtype=float).reshape(2, -1, 3)
    recording = Recording(points, labels, 100.0)
    for layout in LAYOUTS:
        path = tmp_path / f"{layout}.csv"
        write_csv(recording, path, layout=layout)
        assert_same(read_recording(path).recording, recording)


def test_the_long_layout_says_what_was_filled(tmp_path: Path) -> None:
    filled = np.zeros((3, 2), bool)
    filled[0, 1] = filled[1, 1] = True
    path = tmp_path / "file.csv"
    write_csv(Recording(POINTS.copy(), ("a", "b"), 50.0), path, layout="long", filled=filled)
    lines = [line for line in path.read_text().splitlines() if not line.startswith("#")]
    rows = list(csv.DictReader(lines))
    assert [row["state"] for row in rows] == [
        "measured", "filled", "measured", "missing", "measured", "measured",
    ]  # fmt: skip
    assert rows[0] == {
        "frame": "1", "time": "0.000000", "marker": "a", "x": "1.5", "y": "2.5", "z": "3.5",
        "state": "measured",
    }  # fmt: skip


def test_a_second_reader_finds_the_same_numbers(tmp_path: Path) -> None:
    path = tmp_path / "file.csv"
    points = np.random.default_rng(1).normal(size=(50, 3, 3)) * 1000
    points[7, 1] = np.nan
    write_csv(Recording(points, ("a", "b", "c"), 50.0), path)
    table = np.genfromtxt(path, delimiter=",", skip_header=6)
    np.testing.assert_array_equal(table[:, 2:].reshape(50, 3, 3), points)


def test_a_failed_export_leaves_the_old_file(
    tmp_path: Path, monkeypatch: pytest.MonkeyPatch
) -> None:
    path = tmp_path / "file.csv"
    path.write_text("precious")
    recording = Recording(POINTS.copy(), ("a", "b"), 50.0)
    monkeypatch.setattr(
        "mocapmend.files.formats.export_csv.coordinates",
        lambda points, _: ["1,2,3,4,5,6"] * len(points),
    )
    with pytest.raises(MocapmendError, match="does not hold what it should"):
        write_csv(recording, path)
    assert path.read_text() == "precious"
    assert [entry.name for entry in tmp_path.iterdir()] == ["file.csv"]
