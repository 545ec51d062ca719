"""Joints of a Kinect v2 in text files without a header, as KERAAL and KIMORE have them."""

import random
from collections.abc import Callable
from itertools import accumulate, product
from pathlib import Path

import numpy as np
import pytest
from hypothesis import given
from hypothesis import strategies as st
from kinect_samples import FloatArray, led_by, person, rows, with_orientations, with_states

from mocapmend.errors import MocapmendError
from mocapmend.files import Source, read_recording
from mocapmend.files.formats.kinect_times import timing_of
from mocapmend.views.engine_texts import find
from mocapmend_resources import skeletons

TICKS = 635_502_990_154_371_873
ASSUMED = "The file states no frame rate; 30 Hz is assumed."
LEFT_OUT = "The orientations of the joints are left out."
NO_KINECT = "no row that names columns of markers"
FILES = {
    "positions": person(),
    "states": with_states(person()),
    "orientations": with_orientations(person()),
}


def read(path: Path, text: str) -> Source:
    """Write a file and read it; what is said of it is in the catalogue."""
    path.write_text(text)
    source = read_recording(path)
    assert [said for said in source.warnings if find(said) is None] == []
    return source


def refused(path: Path, text: str) -> str:
    """Write a file that cannot be read; return what is said."""
    path.write_text(text)
    with pytest.raises(MocapmendError) as caught:
        read_recording(path)
    assert caught.value.where == str(path)
    assert find(caught.value.what) is not None
    assert find(caught.value.todo) is not None
    return caught.value.what


# --- positions -----------------------------------------------------------------------------------


@pytest.mark.parametrize("separator", [",", " ", ";", "\t", ", "])
@pytest.mark.parametrize("trailing", [False, True])
@pytest.mark.parametrize("kind", FILES)
def test_joints_are_read(kind: str, separator: str, trailing: bool, tmp_path: Path) -> None:
    end = separator if trailing else ""
    source = read(tmp_path / "walk.txt", rows(FILES[kind], separator, end))
    recording = source.recording
    template = skeletons.read("kinect_v2_25")
    assert source.kind == "Kinect v2"
    np.testing.assert_array_equal(recording.points, person())
    assert recording.labels == template.required
    named = {(recording.labels[a], recording.labels[b]) for a, b in source.bones}
    assert named == set(template.bones)
    assert (recording.unit, recording.up, recording.rate) == ("m", "+y", 30.0)
    assert source.warnings == ((LEFT_OUT, ASSUMED) if kind == "orientations" else (ASSUMED,))


@pytest.mark.parametrize("separator", [";", "\t", " "])
def test_commas_may_be_decimal(separator: str, tmp_path: Path) -> None:
    text = rows(person(), separator).replace(".", ",")
    np.testing.assert_array_equal(read(tmp_path / "a.txt", text).recording.points, person())


@pytest.mark.parametrize(("unit", "per_metre"), [("cm", 100.0), ("mm", 1000.0)])
def test_other_units_are_told_by_the_size_of_the_person(
    unit: str, per_metre: float, tmp_path: Path
) -> None:
    source = read(tmp_path / "walk.csv", rows(np.round(per_metre * person(), 3)))
    assert source.recording.unit == unit
    assert f"The file states no length unit; {unit} is assumed" in source.warnings[0]
    points = source.recording.points * source.recording.mm
    np.testing.assert_allclose(points, 1000 * person(), atol=0.01)


def test_what_is_missing(tmp_path: Path) -> None:
    points = person()
    points[3, 7] = 0
    points[4, 8, 1] = np.nan
    points[5, 9, 2] = 1e200
    source = read(tmp_path / "walk.csv", rows(points))
    missing = ~source.recording.present
    assert [tuple(at) for at in np.argwhere(missing)] == [(3, 7), (4, 8), (5, 9)]
    assert len(source.warnings) == 4


def test_states_of_tracking(tmp_path: Path) -> None:
    states = np.full((40, 25), 2.0)
    states[5:10, 7] = 0
    states[20:32, 15] = 1
    source = read(tmp_path / "walk.csv", rows(with_states(person(), states)))
    expected = person()
    expected[5:10, 7] = np.nan
    np.testing.assert_array_equal(source.recording.points, expected)
    assert source.warnings == (
        "Samples that the Kinect did not track are taken as missing: 5.",
        "Samples that the Kinect did not see but inferred are kept as they are: 12 of 1000.",
        ASSUMED,
    )


def test_unknown_states_decide_nothing(tmp_path: Path) -> None:
    states = np.full((80, 25), 2.0)
    states[70:, 3] = 7
    states[70:, 4] = np.nan
    source = read(tmp_path / "walk.csv", rows(with_states(person(80), states)))
    assert source.recording.present.all()
    assert "Samples whose state of tracking is unknown are kept as they are: 20." in source.warnings


def test_legs_under_a_table_do_not_matter(tmp_path: Path) -> None:
    states = np.full((40, 25), 2.0)
    states[:, [13, 14, 15, 17, 18, 19]] = 0
    source = read(tmp_path / "walk.csv", rows(with_states(person(), states)))
    assert source.recording.present.sum() == 40 * 19


# --- what is no Kinect ---------------------------------------------------------------------------


@pytest.mark.parametrize("columns", [1, 2, 3, 66, 72, 74, 77, 99, 102, 117, 150, 174, 177, 200])
def test_tables_of_other_widths_are_refused_as_ever(columns: int, tmp_path: Path) -> None:
    table = np.resize(person(), (40, columns))
    assert NO_KINECT in refused(tmp_path / "table.csv", rows(table))


@pytest.mark.parametrize("columns", [66, 75, 76, 100, 101, 117, 175, 176])
@pytest.mark.parametrize("size", [1e-3, 0.3, 0.5, 1.0, 10.0, 300.0, 1000.0, 1e200])
def test_numbers_that_show_nobody_are_refused_as_ever(
    columns: int, size: float, tmp_path: Path
) -> None:
    rng = np.random.default_rng(columns)
    tables = [
        size * rng.random((30, columns)),
        size * rng.normal(size=(30, columns)).cumsum(axis=0),
        np.full((30, columns), size),
        size * np.arange(30.0 * columns).reshape(30, columns),
        np.round(2 * rng.random((30, columns))),
        np.zeros((30, columns)),
    ]
    for table in tables:
        assert NO_KINECT in refused(tmp_path / "table.csv", rows(table))


def test_orientations_alone_are_refused_as_ever(tmp_path: Path) -> None:
    turned = with_orientations(person())[..., 3:]
    assert NO_KINECT in refused(tmp_path / "JointOrientation1.csv", rows(turned))


def test_the_joints_in_another_order_are_refused_as_ever(tmp_path: Path) -> None:
    assert NO_KINECT in refused(tmp_path / "table.csv", rows(person()[:, ::-1]))


def test_a_table_with_a_header_is_read_by_its_header(tmp_path: Path) -> None:
    head = ",".join(f"M{i}_{axis}" for i in range(25) for axis in "xyz")
    source = read(tmp_path / "walk.csv", f"{head}\n{rows(person())}")
    assert source.kind == "CSV"
    assert source.recording.labels[0] == "M0"


# --- lines that are not as they should be --------------------------------------------------------


@pytest.mark.parametrize("kind", FILES)
def test_a_last_line_that_is_cut_is_left_out(kind: str, tmp_path: Path) -> None:
    text = rows(FILES[kind])
    source = read(tmp_path / "walk.csv", text[: -len(text) // 80])
    np.testing.assert_array_equal(source.recording.points, person()[:39])
    assert source.warnings[0] == "The last line is cut off; it is left out."


@pytest.mark.parametrize("at", [9, 70])
@pytest.mark.parametrize(
    ("change", "message"),
    [
        (lambda line: line[: len(line) // 2], "Line {} has {} numbers, but the first line has 100"),
        (lambda line: f"{line},1.0", "Line {} has {} numbers, but the first line has 100"),
        (lambda line: line.replace("2.0", "two", 1), "Line {} has “two” where a number belongs"),
        (lambda line: line.replace("2.0", "1_0", 1), "Line {} has “1_0” where a number belongs"),
        (lambda _: "# pause", "Line {} has {} numbers, but the first line has 100"),
    ],
)
def test_a_bad_line_is_named(
    change: Callable[[str], str], message: str, at: int, tmp_path: Path
) -> None:
    lines = rows(with_states(person(80))).split("\n")
    lines[at] = change(lines[at])
    count = len(lines[at].split(","))
    said = refused(tmp_path / "walk.csv", "\n".join(lines))
    assert said == message.format(at + 1, count) + "."


def test_blank_lines_are_no_frames(tmp_path: Path) -> None:
    text = rows(person(), " ").replace("\n", "\r\n\r\n")
    np.testing.assert_array_equal(read(tmp_path / "a.txt", text).recording.points, person())


# --- numbers and times of frames -----------------------------------------------------------------


def numbered(kind: str) -> FloatArray:
    """Return the steps of frames 0-9, 13-39, in units of a kind."""
    frames = np.concatenate([np.arange(10), np.arange(13, 40)]).astype(float)
    return {
        "frames": frames + 5,
        "s": np.round(7 + frames / 30, 4),
        "ms": np.round(1000 * frames / 30),
        "100 ns": TICKS + np.round(1e7 * frames / 30),
    }[kind]


@pytest.mark.parametrize(
    ("unit", "beside"),
    [("frames", False), *product(["s", "ms", "100 ns"], [False, True])],
)
@pytest.mark.parametrize("kind", FILES)
def test_dropped_frames_are_frames_without_joints(
    kind: str, unit: str, beside: bool, tmp_path: Path
) -> None:
    there = [*range(10), *range(13, 40)]
    column = numbered(unit)
    values, path = FILES[kind][there], tmp_path / "JointPosition1_2.csv"
    if beside:
        times = "".join(f"{time!r},\n" for time in column.tolist())
        (tmp_path / "TimeStamp1_2.csv").write_text(times)
    else:
        values = led_by(column, values)
    source = read(path, rows(values))
    expected = person()
    expected[10:13] = np.nan
    np.testing.assert_array_equal(source.recording.points, expected)
    assert source.recording.rate == 30.0
    assert source.recording.first_frame == (5 if unit == "frames" else 1)
    name = "TimeStamp1_2.csv" if beside else path.name
    rate = ASSUMED if unit == "frames" else f"The times in {name} say 30 Hz."
    assert set(source.warnings) - {LEFT_OUT} == {
        rate,
        "Frames that the file leaves out are taken as frames without markers: 3.",
    }


def test_a_rate_that_is_not_a_kinects_is_believed(tmp_path: Path) -> None:
    source = read(tmp_path / "a.txt", rows(led_by(np.arange(40) / 15, person()), " "))
    assert source.recording.rate == pytest.approx(15.0)


def test_late_frames_are_not_dropped_frames(tmp_path: Path) -> None:
    times = np.arange(40) / 30
    times[20] += 0.9 / 30
    source = read(tmp_path / "walk.csv", rows(led_by(times, person())))
    np.testing.assert_array_equal(source.recording.points, person())
    assert source.warnings[-1] == (
        "2 of 39 steps from frame to frame are more than a quarter longer or shorter than 33.3 ms; "
        "the frames are taken as evenly spaced."
    )


@pytest.mark.parametrize(
    "times",
    [
        "".join(f"{0.1 * i}e99\n" for i in range(40)),
        "".join(f"{i}\n" for i in range(40)),
        "".join("6.35503E+17\n" for _ in range(40)),
        "".join(f"12:00:{i}\n" for i in range(40)),
        "\x00\x01\x02",
        "",
        "1.0\n",
        "nan\n" * 40,
    ],
)
def test_times_that_are_none_are_not_used(times: str, tmp_path: Path) -> None:
    (tmp_path / "TimeStamp7.csv").write_text(times)
    source = read(tmp_path / "JointPosition7.csv", rows(with_states(person())))
    assert source.warnings == ("The times in TimeStamp7.csv cannot be used.", ASSUMED)
    np.testing.assert_array_equal(source.recording.points, person())


def test_times_of_other_frames_give_the_rate_alone(tmp_path: Path) -> None:
    times = "".join(f"{1000 * i / 25}\n" for i in range(50))
    (tmp_path / "TimeStamp7.csv").write_text(times)
    source = read(tmp_path / "JointPosition7.csv", rows(with_states(person())))
    assert source.recording.rate == 25.0
    assert source.recording.frames == 40
    assert source.warnings[-1] == (
        "TimeStamp7.csv has 50 times for 40 frames; only the frame rate is taken from it."
    )


@pytest.mark.parametrize("column", [np.full(40, 3.0), np.arange(40)[::-1], np.arange(40) * 1e9])
def test_a_first_column_that_is_no_time_makes_it_no_kinect(
    column: FloatArray, tmp_path: Path
) -> None:
    assert NO_KINECT in refused(tmp_path / "walk.csv", rows(led_by(column, person())))


@given(
    st.lists(st.sampled_from([1, 1, 1, 1, 2, 3, 5]), min_size=5, max_size=60),
    st.floats(10, 60),
    st.sampled_from([1.0, 1e3, 1e7]),
    st.randoms(use_true_random=False),
)
def test_times_with_a_little_jitter_give_frames_and_rate(
    steps: list[int], rate: float, units: float, rng: random.Random
) -> None:
    # Most steps are one frame.
    steps = [1] * (len(steps) + 1) + steps
    frames = np.array([0, *accumulate(steps)], float)
    jitter = np.array([rng.uniform(-0.04, 0.04) for _ in frames])
    timing = timing_of((frames + jitter) * units / rate)
    assert timing is not None
    np.testing.assert_array_equal(timing.numbers, frames + 1)
    assert timing.rate == pytest.approx(rate, rel=0.05)
    assert timing.uneven == 0


# --- real files ----------------------------------------------------------------------------------


def test_files_of_keraal(shared: Path) -> None:
    paths = sorted((shared / "kinect" / "keraal_samples").glob("*Kinect*.txt"))
    assert len(paths) == 3
    for path in paths:
        source = read_recording(path)
        points = np.loadtxt(path).reshape(-1, 25, 7)[..., :3]
        assert (source.kind, source.recording.unit) == ("Kinect v2", "m")
        np.testing.assert_array_equal(source.recording.points, points)
        assert source.warnings == (LEFT_OUT, ASSUMED)
        bones = np.array(source.bones)
        lengths = np.linalg.norm(points[:, bones[:, 0]] - points[:, bones[:, 1]], axis=2)
        assert np.median(lengths, axis=0).max() < 0.5
        other = path.with_name(path.name.replace("Kinect", "Vicon"))
        with pytest.raises(MocapmendError, match=NO_KINECT):
            read_recording(other)
