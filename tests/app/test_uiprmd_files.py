"""Recordings of the data set UI-PRMD: joints of a Kinect in two files, markers of a Vicon."""

import gzip
import random
import re
from pathlib import Path

import numpy as np
import pytest
from kinect_samples import REST_39, FloatArray, person, rows, uiprmd, uiprmd_positions

from mocapmend.errors import MocapmendError
from mocapmend.files import Source, read_recording
from mocapmend.views.engine_texts import find
from mocapmend_resources import skeletons

NAMES = ("m01_s01_e01_positions.txt", "m01_s01_e01_angles.txt")
TOKENS = [
    b"",
    b"7",
    b"-",
    b",",
    b"\n",
    b"nan",
    b"inf",
    b"1e308",
    b"1e400",
    b"x",
    b"\0",
    b" ",
    b"\xff",
]
ASSUMED = "The file states no frame rate; 30 Hz is assumed."


def write(positions: Path, angles: Path, frames: int = 30) -> tuple[FloatArray, FloatArray]:
    """Write a recording into two files; return what they hold."""
    offsets, turns = uiprmd(frames)
    for path, values in ((positions, offsets), (angles, turns)):
        path.parent.mkdir(parents=True, exist_ok=True)
        path.write_text(rows(values))
    return offsets, turns


def read(path: Path) -> Source:
    source = read_recording(path)
    assert source.path == path
    assert [said for said in source.warnings if find(said) is None] == []
    return source


def refused(path: Path) -> MocapmendError:
    with pytest.raises(MocapmendError) as caught:
        read_recording(path)
    assert find(caught.value.what) is not None
    assert find(caught.value.todo) is not None
    return caught.value


# --- Kinect --------------------------------------------------------------------------------------


@pytest.mark.parametrize("opened", [0, 1])
def test_either_file_opens_the_recording(opened: int, tmp_path: Path) -> None:
    paths = [tmp_path / name for name in NAMES]
    offsets, turns = write(*paths)
    source = read(paths[opened])
    recording = source.recording
    template = skeletons.read("kinect_22")
    assert source.kind == "UI-PRMD Kinect"
    np.testing.assert_allclose(recording.points, uiprmd_positions(offsets, turns), atol=1e-6)
    assert recording.labels == template.required
    named = {(recording.labels[a], recording.labels[b]) for a, b in source.bones}
    assert named == set(template.bones)
    assert (recording.unit, recording.up, recording.rate) == ("mm", "+y", 30.0)
    assert source.warnings == (ASSUMED,)


@pytest.mark.parametrize(
    ("positions", "angles"),
    [
        NAMES,
        ("m01_s01_positions_inc.txt", "m01_s01_angles_inc.txt"),
        ("kinect_positions__m01_s02_e03.txt", "kinect_angles__m01_s02_e03.txt"),
        ("Kinect/Positions/m1_positions.txt", "Kinect/Angles/m1_angles.txt"),
        ("SmallPositions/M1_POSITIONS.csv", "SmallAngles/M1_ANGLES.csv"),
        ("positions/Positions.txt", "angles/Angles.txt"),
        ("my positions/of positions.txt", "my positions/of angles.txt"),
    ],
)
def test_the_other_file_is_found_by_its_name(positions: str, angles: str, tmp_path: Path) -> None:
    paths = tmp_path / positions, tmp_path / angles
    offsets, turns = write(*paths)
    for path in paths:
        points = read(path).recording.points
        np.testing.assert_allclose(points, uiprmd_positions(offsets, turns), atol=1e-6)


def test_from_the_folder_of_the_file_too(tmp_path: Path, monkeypatch: pytest.MonkeyPatch) -> None:
    write(tmp_path / "Positions" / NAMES[0], tmp_path / "Angles" / NAMES[1])
    monkeypatch.chdir(tmp_path / "Angles")
    assert read(Path(NAMES[1])).recording.frames == 30


@pytest.mark.parametrize("opened", [0, 1])
def test_a_missing_file_is_named(opened: int, tmp_path: Path) -> None:
    paths = [tmp_path / name for name in NAMES]
    write(*paths)
    paths[1 - opened].unlink()
    error = refused(paths[opened])
    assert error.where == str(paths[opened])
    assert error.what.endswith(f"the other one is not there: {NAMES[1 - opened]}.")


def test_a_name_without_the_word_leads_nowhere(tmp_path: Path) -> None:
    write(tmp_path / "walk.txt", tmp_path / "walk_angles.txt")
    error = refused(tmp_path / "walk.txt")
    assert "name of this one does not say which is the other" in error.what
    assert error.where == str(tmp_path / "walk.txt")


@pytest.mark.parametrize("other", ["same", "text", "wide", "empty"])
def test_the_other_file_must_be_what_its_name_says(other: str, tmp_path: Path) -> None:
    paths = [tmp_path / name for name in NAMES]
    write(*paths)
    texts = {
        "same": paths[0].read_text(),
        "text": "Dear diary,\n",
        "wide": rows(person()),
        "empty": "",
    }
    paths[1].write_text(texts[other])
    error = refused(paths[0])
    assert error.where == str(paths[1])
    assert ("holds something else" in error.what) == (other != "empty")


def test_the_shorter_file_counts(tmp_path: Path) -> None:
    paths = [tmp_path / name for name in NAMES]
    offsets, turns = write(*paths)
    paths[1].write_text(rows(turns[:25])[:-30])
    source = read(paths[0])
    points = uiprmd_positions(offsets[:24], turns[:24])
    np.testing.assert_allclose(source.recording.points, points, atol=1e-6)
    assert source.warnings == (
        "The last line is cut off; it is left out.",
        "There are 30 frames of positions and 24 of angles; the first 24 are read.",
        ASSUMED,
    )


def test_numbers_that_are_none_make_joints_missing(tmp_path: Path) -> None:
    paths = [tmp_path / name for name in NAMES]
    offsets, turns = write(*paths)
    turns[4, 7] = np.nan
    offsets[6, 0] = 1e300
    offsets[8] = 0
    for path, values in zip(paths, (offsets, turns), strict=True):
        path.write_text(rows(values))
    source = read(paths[0])
    missing = {tuple(at) for at in np.argwhere(~source.recording.present).tolist()}
    assert missing == {(4, 8), (4, 9)} | {(6, i) for i in range(22)} | {(8, i) for i in range(22)}
    assert source.warnings[0].startswith("24 samples depend on values that are no numbers")
    assert source.warnings[1] == "Samples exactly at (0, 0, 0) are taken as missing: 22."


@pytest.mark.parametrize("which", [0, 1])
def test_a_bad_line_is_named(which: int, tmp_path: Path) -> None:
    paths = [tmp_path / name for name in NAMES]
    write(*paths)
    lines = paths[which].read_text().split("\n")
    lines[7] = lines[7][:50]
    paths[which].write_text("\n".join(lines))
    for path in paths:
        error = refused(path)
        assert error.where == str(paths[which])
        assert re.fullmatch(r"Line 8 has \d numbers, but the first line has 66\.", error.what)


@pytest.mark.parametrize("which", [0, 1])
def test_mutants_open_or_are_refused(which: int, tmp_path: Path) -> None:
    paths = [tmp_path / name for name in NAMES]
    write(*paths, frames=4)
    original, rng = paths[which].read_bytes(), random.Random(which)
    opened = 0
    for _ in range(150):
        raw = bytearray(original)
        for _ in range(rng.choice([1, 1, 3])):
            at = rng.randrange(len(raw) + 1)
            raw[at : at + rng.choice([0, 1, 1, 300])] = rng.choice(TOKENS)
        paths[which].write_bytes(raw)
        try:
            source = read(paths[1 - which])
        except MocapmendError as error:
            assert error.where == str(paths[which])
            assert find(error.what) is not None
            continue
        opened += 1
        assert np.isfinite(source.recording.points[source.recording.present]).all()
        assert np.isnan(source.recording.points[~source.recording.present]).all()
    assert opened > 10


# --- Vicon ---------------------------------------------------------------------------------------


def test_markers_of_the_vicon_system(tmp_path: Path) -> None:
    points = person(50, REST_39)
    points[10:20, 4] = 0
    path = tmp_path / "m01_s01_e01_positions.txt"
    path.write_text(rows(points))
    source = read(path)
    recording = source.recording
    points[10:20, 4] = np.nan
    assert source.kind == "UI-PRMD Vicon"
    np.testing.assert_array_equal(recording.points, points)
    assert (recording.unit, recording.up, recording.rate) == ("mm", "+z", 100.0)
    full = next(each for each in skeletons.load() if each.name == "Plug-in Gait, full body")
    assert set(recording.labels) >= set(full.required)
    assert source.warnings == (
        "Samples exactly at (0, 0, 0) are taken as missing: 10.",
        "The file states no frame rate; 100 Hz is assumed.",
        "The file does not name its markers; Plug-in Gait's names are assumed.",
    )


# --- real files ----------------------------------------------------------------------------------


def unpacked(shared: Path, folder: Path, pattern: str) -> list[Path]:
    """Decompress files of the data set; return their paths."""
    found = sorted((shared / "kinect" / "uiprmd_raw_samples").glob(pattern))
    for path in found:
        (folder / path.stem).write_bytes(gzip.decompress(path.read_bytes()))
    return [folder / path.stem for path in found]


def decoded(archive: Path, prefix: str, path: Path) -> FloatArray:
    """Return a recording as it was decoded before (mm), which is rounded to 0.1 mm."""
    with np.load(archive) as arrays:
        key = [0, *map(int, re.findall(r"_[mse]?(\d\d)(?=_|\.)", path.name.replace("__m", "__")))]
        (at,) = np.flatnonzero((arrays["keys"] == key).all(axis=1))
        counts = arrays[f"n{prefix.lower()}"].astype(int)
        start, count = np.maximum(counts[:at] - 1, 0).sum(), counts[at]
        part = slice(start, start + count - 1)
        low, high = (arrays[f"{prefix}b{i}"][:, part].astype(int) for i in (0, 1))
        zigzag = low + 256 * high
        steps = ((zigzag >> 1) ^ -(zigzag & 1)).T
        first = arrays[f"{prefix}0"][at]
    frames = np.cumsum([first, *np.cumsum(steps, axis=0)], axis=0) / 10
    return frames.reshape(count, -1, 3)


@pytest.mark.parametrize("movement", ["m01", "m02", "m07", "m09"])
@pytest.mark.parametrize(("kind", "prefix"), [("kinect", "K"), ("vicon", "V")])
def test_originals_are_as_they_were_decoded(
    shared: Path, tmp_path: Path, kind: str, prefix: str, movement: str
) -> None:
    archive = shared / "kinect" / "uiprmd_kinect22_vicon39.npz"
    paths = unpacked(shared, tmp_path, f"{kind}_*__{movement}_*.gz")
    assert len(paths) == 6
    for path in paths:
        if "angles" in path.name and kind == "vicon":
            assert "no row that names columns" in refused(path).what
            continue
        expected = decoded(archive, prefix, path)
        np.testing.assert_allclose(read(path).recording.points, expected, atol=0.0501)
