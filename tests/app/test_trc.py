"""TRC files: as they are written by several programs, and by us."""

from dataclasses import replace
from pathlib import Path

import numpy as np
import pytest
from hypothesis import given
from text_samples import NAN, POINTS, TRC, assert_same, recordings

from mocapmend.errors import MocapmendError
from mocapmend.files import Source, read_recording
from mocapmend.files.formats import write_trc
from mocapmend_algorithms.recording import Recording

EXPECTED = POINTS.copy()
EXPECTED[0, 1] = -4.25, 5, 6
EXPECTED[2, 1] = NAN


def read(tmp_path: Path, text: str | bytes) -> Source:
    path = tmp_path / "file.trc"
    path.write_bytes(text if isinstance(text, bytes) else text.encode())
    return read_recording(path)


def test_a_file_by_hand(tmp_path: Path) -> None:
    source = read(tmp_path, TRC)
    recording = source.recording
    assert source.kind == "TRC"
    np.testing.assert_array_equal(recording.points, EXPECTED)
    assert recording.labels == ("LASI", "R.ASI")
    assert (recording.rate, recording.unit, recording.first_frame) == (120.0, "mm", 11)
    assert source.warnings == ("The file does not say which axis points up; +z is a guess.",)
    assert not source.truncated


@pytest.mark.parametrize(
    "text",
    [
        TRC.replace("\n", "\r\n"),
        TRC.replace("\n", "\r"),
        TRC.replace("\t\n", "\n"),
        TRC.replace("\n\n", "\n"),
        TRC.replace("\n\n", "\n\t\t\t\n\n"),
        TRC.replace("\t\tX1\tY1\tZ1\tX2\tY2\tZ2\t\n", ""),
        TRC.replace("LASI\t\t\tR.ASI\t\t\t", "LASI\tR.ASI"),
        TRC.replace("LASI\t\t\tR.ASI\t\t", "LASI_x\tLASI_y\tLASI_z\tR.ASI_x\tR.ASI_y\tR.ASI_z"),
        TRC.replace("120.00\t120.00\t3\t2\tmm\t120.00", "120.00 120.00  3\t2 mm   120.00"),
        TRC.replace("\t1.", "\t 1,").replace("\t2.", "\t2,"),
        TRC.replace("1.5", "1.5 ").replace("NaN", " null"),
        TRC.replace("mm", "Millimeters").replace("Frame#", "frame#"),
        TRC.encode("utf-16"),
        TRC.encode("utf-8-sig"),
        TRC + "\n\n\t\t\t\n",
        TRC.rstrip(),
    ],
)
def test_oddities_change_nothing(text: str | bytes, tmp_path: Path) -> None:
    source = read(tmp_path, text)
    np.testing.assert_array_equal(source.recording.points, EXPECTED)
    assert source.recording.labels == ("LASI", "R.ASI")
    assert (source.recording.rate, source.recording.unit) == (120.0, "mm")
    assert len(source.warnings) == 1


@pytest.mark.parametrize("separator", [" ", "   ", ","])
def test_other_separators(separator: str, tmp_path: Path) -> None:
    text = TRC.replace("\t\t\t", "\t").replace("\t\n", "\n").replace("NaN\t", "NaN ")
    text = text.replace("\t3.6", "\t3.6\tnan\tnan\tnan").replace(" ", "\t").replace("\t", separator)
    source = read(tmp_path, text)
    np.testing.assert_array_equal(source.recording.points, EXPECTED)
    assert source.recording.labels == ("LASI", "R.ASI")


def test_a_truncated_file(tmp_path: Path) -> None:
    source = read(tmp_path, TRC[: TRC.index("2.7")])
    assert source.truncated
    assert (source.recording.frames, source.frames_promised) == (2, 3)
    assert "The last line is cut off; it is left out." in source.warnings
    assert any("3 frames, but only 2 are there" in text for text in source.warnings)


def test_counts_that_are_wrong(tmp_path: Path) -> None:
    source = read(tmp_path, TRC.replace("\t3\t2\tmm", "\t2\t7\tmm"))
    assert source.recording.points.shape == (3, 2, 3)
    assert not source.truncated
    assert any("2 frames by the header, but 3" in text for text in source.warnings)
    assert any("7 markers by the header, but 2" in text for text in source.warnings)


def test_markers_without_a_label(tmp_path: Path) -> None:
    source = read(tmp_path, TRC.replace("R.ASI\t\t\t", ""))
    assert source.recording.labels == ("LASI", "point 2")
    np.testing.assert_array_equal(source.recording.points, EXPECTED)
    assert any("without a label in the file: 1." in text for text in source.warnings)


def test_zeros_are_missing_and_said(tmp_path: Path) -> None:
    source = read(tmp_path, TRC.replace("-4.25\t5\t6", "0.00\t0\t0"))
    assert np.isnan(source.recording.points[:, 1]).all()
    assert any("at (0, 0, 0) are taken as missing: 1." in text for text in source.warnings)


def test_incomplete_and_infinite_samples_are_missing(tmp_path: Path) -> None:
    source = read(tmp_path, TRC.replace("\t2.5", "\t").replace("2.6", "inf"))
    assert np.isnan(source.recording.points[:2, 0]).all()
    assert sum("taken as missing: 1." in text for text in source.warnings) == 2


def test_frames_that_are_left_out_are_empty(tmp_path: Path) -> None:
    source = read(tmp_path, TRC.replace("13\t0.100000", "14\t0.108333"))
    assert source.recording.points.shape == (4, 2, 3)
    assert np.isnan(source.recording.points[2]).all()
    np.testing.assert_array_equal(source.recording.points[3], EXPECTED[2])
    assert any(
        "leaves out are taken as frames without markers: 1." in text for text in source.warnings
    )


@pytest.mark.parametrize("number", ["nan", "3.5", "1e300", "99999999", "-5", "12"])
def test_frame_numbers_that_cannot_be(number: str, tmp_path: Path) -> None:
    source = read(tmp_path, TRC.replace("13\t0.1", f"{number}\t0.1"))
    np.testing.assert_array_equal(source.recording.points, EXPECTED)
    assert any("consecutive frames" in text for text in source.warnings)


@pytest.mark.parametrize(
    ("change", "rate"), [(("120.00\t120.00\t3", "\t\t3"), 120.0), (("120.00\t", "100\t"), 100.0)]
)
def test_the_rate_of_header_and_times(change: tuple[str, str], rate: float, tmp_path: Path) -> None:
    source = read(tmp_path, TRC.replace(*change))
    assert source.recording.rate == rate
    assert any("times say 120 Hz" in text for text in source.warnings)


@given(recordings(units=("mm", "cm", "m")))
def test_round_trip(tmp_path_factory: pytest.TempPathFactory, recording: Recording) -> None:
    zero = ~recording.points.any(axis=2)
    if zero.any():
        points = recording.points.copy()
        points[zero] = 1.0
        recording = recording.with_points(points)
    path = tmp_path_factory.mktemp("trc") / "file.trc"
    assert write_trc(recording, path) == ()
    source = read_recording(path)
    assert_same(source.recording, recording, up=False)
    assert not source.truncated


def test_other_units_become_mm(tmp_path: Path) -> None:
    recording = Recording(EXPECTED.copy(), ("a", "b"), 100.0, unit="ft")
    notes = write_trc(recording, tmp_path / "file.trc")
    assert len(notes) == 1
    assert "mm" in notes[0]
    back = read_recording(tmp_path / "file.trc").recording
    assert back.unit == "mm"
    np.testing.assert_allclose(back.points, EXPECTED * 304.8)


def test_a_sample_at_zero_is_moved_and_said(tmp_path: Path) -> None:
    points = EXPECTED.copy()
    points[0, 0] = 0
    notes = write_trc(Recording(points, ("a", "b"), 100.0), tmp_path / "file.trc")
    assert notes[0].endswith(": 1.")
    back = read_recording(tmp_path / "file.trc").recording
    assert back.points[0, 0].tolist() == [1e-6, 0, 0]


def test_labels_that_do_not_fit_are_changed_and_said(tmp_path: Path) -> None:
    recording = Recording(EXPECTED.copy(), ("a\tb\n", ""), 100.0)
    (note,) = write_trc(recording, tmp_path / "file.trc")
    assert note.endswith(": 2.")
    assert read_recording(tmp_path / "file.trc").recording.labels == ("a b", "point 2")


def test_nothing_to_write(tmp_path: Path) -> None:
    recording = Recording(np.empty((3, 0, 3)), (), 100.0)
    with pytest.raises(MocapmendError, match="no markers to export"):
        write_trc(recording, tmp_path / "file.trc")
    assert not list(tmp_path.iterdir())


def test_a_folder_that_is_not_there(tmp_path: Path) -> None:
    recording = Recording(EXPECTED.copy(), ("a", "b"), 100.0)
    with pytest.raises(MocapmendError, match="folder does not exist"):
        write_trc(replace(recording, unit="m"), tmp_path / "none" / "file.trc")
