"""Reading C3D files that are written here: every encoding, every way to store 'missing'."""

from dataclasses import replace
from pathlib import Path

import numpy as np
import pytest
from c3d_synthetic import ENCODINGS, Machine, Synthetic, encode, walk
from hypothesis import given
from hypothesis import strategies as st

from mocapmend.errors import MocapmendError
from mocapmend.files import C3DFile, read_c3d
from mocapmend.files.c3d_parameters import decode_text


def opened(spec: Synthetic, folder: Path) -> C3DFile:
    path = folder / "written.c3d"
    path.write_bytes(encode(spec))
    return read_c3d(path)


@pytest.mark.parametrize(("machine", "is_float"), ENCODINGS)
def test_every_encoding_reads_the_same(machine: Machine, is_float: bool, tmp_path: Path) -> None:
    points = walk()
    fourth = np.full(points.shape[:2], 0x0305)
    fourth[3:6, 1] = -1
    analog = np.arange(40 * 2 * 3).reshape(40, 2, 3) - 100.0
    scales: dict[str, object] = {
        "ANALOG:GEN_SCALE": [2.0],
        "ANALOG:SCALE": [1.0, 0.5, 0.25],
        "ANALOG:OFFSET": [0, 10, -10],
        "ANALOG:LABELS": ["Fx", "Fy"],
        "ANALOG:UNITS": ["N", "", "Nmm"],
    }
    spec = Synthetic(points, machine, is_float, 0.125, fourth, analog, parameters=scales)
    file = opened(spec, tmp_path)
    recording = file.recording
    expected = points.copy()
    expected[3:6, 1] = np.nan
    np.testing.assert_array_equal(recording.points, expected)
    residuals = np.full(points.shape[:2], 5 * 0.125)
    residuals[3:6, 1] = np.nan
    np.testing.assert_allclose(file.residuals, residuals)
    assert recording.labels == ("M001", "M002", "M003", "M004", "M005")
    assert (recording.rate, recording.unit, recording.up, recording.first_frame) == (
        100.0, "mm", "+z", 1,
    )  # fmt: skip
    assert file.analog_labels == ("Fx", "Fy", "channel 3")
    assert file.analog_units == ("N", "", "Nmm")
    assert file.analog_rate == 200.0
    flat = analog.reshape(-1, 3)
    np.testing.assert_allclose(file.read_analog(), (flat - [0, 10, -10]) * [2.0, 1.0, 0.5])
    assert file.warnings == ()
    assert not file.truncated


@pytest.mark.parametrize(("machine", "is_float"), ENCODINGS)
@pytest.mark.parametrize("kind", ["-1 and zeros", "-32768", "-1 with coordinates", "zeros"])
def test_missing_in_every_encoding(
    kind: str, machine: Machine, is_float: bool, tmp_path: Path
) -> None:
    points = walk()
    fourth = np.zeros(points.shape[:2])
    fourth[10:15, 2] = {"-1 and zeros": -1, "-32768": -32768, "-1 with coordinates": -1}.get(
        kind, 0
    )
    if "zeros" in kind:
        points[10:15, 2] = 0
    file = opened(Synthetic(points, machine, is_float, 0.125, fourth), tmp_path)
    missing = np.zeros(points.shape[:2], bool)
    missing[10:15, 2] = True
    np.testing.assert_array_equal(~file.recording.present, missing)
    np.testing.assert_array_equal(np.isnan(file.residuals), missing)
    assert any("5 samples are exactly (0, 0, 0)" in text for text in file.warnings) == (
        kind == "zeros"
    )


@pytest.mark.parametrize("machine", ["intel", "dec", "mips"])
def test_missing_that_only_floats_can_say(machine: Machine, tmp_path: Path) -> None:
    points = walk()
    fourth = np.zeros(points.shape[:2])
    points[0:3, 0] = 0
    fourth[0:3, 0] = 65535.0
    if machine != "dec":
        points[5, 1, 2] = np.nan
        points[6, 1] = np.inf
    file = opened(Synthetic(points, machine, True, 0.1, fourth), tmp_path)
    missing = np.isnan(points).any(axis=2) | np.isinf(points).any(axis=2)
    missing[0:3, 0] = True
    np.testing.assert_array_equal(~file.recording.present, missing)
    assert np.isfinite(file.recording.points[file.recording.present]).all()


def test_points_on_an_axis_are_not_missing(tmp_path: Path) -> None:
    points = walk()
    points[:, 0, 0] = 0
    points[:, 1, :2] = 0
    points[3, 2] = 5, -5, 0
    for is_float in (True, False):
        assert opened(Synthetic(points, is_float=is_float), tmp_path).recording.present.all()


def test_first_frame_and_length_beyond_16_bits(tmp_path: Path) -> None:
    points = walk(70_000, 2)
    file = opened(Synthetic(points, first_frame=70_001), tmp_path)
    assert file.recording.first_frame == 70_001
    assert file.recording.frames == 70_000
    np.testing.assert_array_equal(file.recording.points[-1], points[-1])
    assert file.warnings == ()


@pytest.mark.parametrize("first", [0, 1, 148, 480, 1368])
def test_first_frame(first: int, tmp_path: Path) -> None:
    for kept in ({}, {"TRIAL:ACTUAL_START_FIELD": None, "TRIAL:ACTUAL_END_FIELD": None}):
        spec = Synthetic(walk(), first_frame=first, parameters=kept)
        file = opened(spec, tmp_path)
        assert (file.recording.first_frame, file.recording.frames) == (first, 40)


NO_TRIAL = {"TRIAL:ACTUAL_START_FIELD": None, "TRIAL:ACTUAL_END_FIELD": None}


@pytest.mark.parametrize(
    ("parameters", "header"),
    [
        (NO_TRIAL | {"POINT:LONG_FRAMES": [70_000.0]}, {5: 65_535}),
        # Words of 16 bits that wrapped round.
        ({"POINT:FRAMES": [70_000 % 65_536]}, {5: 70_000 % 65_536}),
        (NO_TRIAL | {"POINT:FRAMES": [70_000.0]}, {5: 65_535}),
    ],
)
def test_every_way_to_say_how_long_a_long_recording_is(
    parameters: dict[str, object], header: dict[int, int], tmp_path: Path
) -> None:
    points = walk(70_000, 1)
    file = opened(Synthetic(points, parameters=parameters, header=header), tmp_path)
    np.testing.assert_array_equal(file.recording.points, points)
    assert (file.recording.first_frame, file.warnings) == (1, ())


@pytest.mark.parametrize(
    ("start", "end", "first"), [([20, 0], [59, 0], 20), ([0, 65_535], [46, 0], 7)]
)
def test_first_frames_that_disagree(
    start: list[int], end: list[int], first: int, tmp_path: Path
) -> None:
    parameters = {"TRIAL:ACTUAL_START_FIELD": start, "TRIAL:ACTUAL_END_FIELD": end}
    file = opened(Synthetic(walk(), first_frame=7, parameters=parameters), tmp_path)
    assert file.recording.first_frame == first
    assert len(file.warnings) == 1
    assert "first frame" in file.warnings[0]
    np.testing.assert_array_equal(file.recording.points, walk())


def test_many_labels_and_channels(tmp_path: Path) -> None:
    labels = [f"Subjekt Müller:Füße{i:03}" for i in range(300)]
    analog = np.zeros((4, 1, 300))
    file = opened(Synthetic(walk(4, 300), labels=labels, analog=analog), tmp_path)
    assert file.recording.labels == tuple(labels)
    assert len(file.analog_labels) == 300


def test_too_few_and_repeated_labels(tmp_path: Path) -> None:
    file = opened(Synthetic(walk(), labels=["A", "A", "", "*1"]), tmp_path)
    assert file.recording.labels == ("A", "A", "point 3", "*1", "point 5")
    assert any("names 4 of its 5 points" in text for text in file.warnings)
    assert any("1 point has the label of another" in text for text in file.warnings)


def test_more_labels_than_points(tmp_path: Path) -> None:
    parameters = {"POINT:LABELS": list("ABCDEFGHI")}
    assert opened(Synthetic(walk(), parameters=parameters), tmp_path).recording.labels == tuple(
        "ABCDE"
    )


@given(st.binary(max_size=40))
def test_any_bytes_are_some_text(raw: bytes) -> None:
    assert decode_text(raw) == decode_text(raw.ljust(60))


def test_latin_1_labels() -> None:
    assert decode_text("Füße".encode("latin-1") + b"  \0\0") == "Füße"


def test_model_outputs_are_no_markers(tmp_path: Path) -> None:
    parameters = {
        "POINT:ANGLES": ["LKnee", "RKnee"],
        "POINT:TYPE_GROUPS": ["ANGLES", "ANGLE", "BONES", "BONE"],
        "POINT:BONES": ["Pelvis"],
    }
    labels = ["LASI", "LKnee", "RASI", "Ann:Pelvis", "Ann:SACR"]
    points = walk()
    file = opened(Synthetic(points, labels=labels, parameters=parameters), tmp_path)
    assert file.recording.labels == ("LASI", "RASI", "Ann:SACR")
    assert file.marker_points == (0, 2, 4)
    assert file.model_outputs == ("LKnee", "Ann:Pelvis")
    np.testing.assert_array_equal(file.recording.points, points[:, [0, 2, 4]])


@pytest.mark.parametrize(
    ("stated", "unit"),
    [("mm", "mm"), ("mm  ", "mm"), ("mete", "m"), ("M", "m"), ("cm", "cm"), ("inches", "in")],
)
def test_units(stated: str, unit: str, tmp_path: Path) -> None:
    file = opened(Synthetic(walk(), parameters={"POINT:UNITS": stated}), tmp_path)
    assert file.recording.unit == unit
    assert file.warnings == ()


@pytest.mark.parametrize(("factor", "unit"), [(1.0, "mm"), (0.001, "m")])
@pytest.mark.parametrize("stated", [None, "volt"])
def test_a_guessed_unit_is_said(
    stated: str | None, factor: float, unit: str, tmp_path: Path
) -> None:
    parameters = {"POINT:UNITS": stated}
    file = opened(Synthetic(walk() * factor, parameters=parameters), tmp_path)
    assert file.recording.unit == unit
    assert any(f"{unit} is assumed" in text for text in file.warnings)


@pytest.mark.parametrize("screen", ["+X", "+Y", "-Y", "+Z", "-Z"])
def test_up_axis_of_the_file(screen: str, tmp_path: Path) -> None:
    points = walk()
    if screen[0] == "-":
        points[..., "XYZ".index(screen[1])] *= -1
    file = opened(Synthetic(points, parameters={"POINT:Y_SCREEN": screen}), tmp_path)
    assert file.recording.up == screen.lower()
    assert file.warnings == ()


def test_up_axis_that_would_put_the_markers_below_the_floor(tmp_path: Path) -> None:
    file = opened(Synthetic(walk(), parameters={"POINT:Y_SCREEN": "-Z"}), tmp_path)
    assert file.recording.up == "+z"
    assert any("below the floor" in text for text in file.warnings)


@pytest.mark.parametrize("up", ["+y", "+z", "-z"])
def test_guessed_up_axis(up: str, tmp_path: Path) -> None:
    rng = np.random.default_rng(3)
    frames = np.linspace(-2000, 2000, 200)[:, None]
    heights = np.linspace(20, 1700, 20)
    across = rng.uniform(-250, 250, (2, 20))
    tall = np.broadcast_to(heights, (200, 20)) * (-1 if up[0] == "-" else 1)
    axes = {"+y": (0, 2, 1), "+z": (0, 1, 2), "-z": (0, 1, 2)}[up]
    points = np.empty((200, 20, 3))
    for axis, values in zip(axes, (across[0] + frames, across[1] + 0 * frames, tall), strict=True):
        points[..., axis] = values
    file = opened(Synthetic(points, parameters={"POINT:Y_SCREEN": None}), tmp_path)
    assert file.recording.up == up
    assert any(f"{up} is a guess" in text for text in file.warnings)


def test_events(tmp_path: Path) -> None:
    parameters = {
        "EVENT:USED": [2],
        "EVENT:LABELS": ["Foot Off", "Foot Strike"],
        "EVENT:CONTEXTS": ["Left", "Right"],
        "EVENT:TIMES": [1.0, 0.5, 0.0, 1.0],
    }
    headers = [("HS", 1.002), ("TO", 0.8)]
    spec = Synthetic(walk(), first_frame=50, parameters=parameters, events=headers)
    events = opened(spec, tmp_path).events
    # Times count from frame 1; the header's HS repeats the Foot Strike.
    assert [(e.label, e.context, round(e.frame, 3), round(e.time, 3)) for e in events] == [
        ("TO", "", 31.0, 0.8),
        ("Foot Strike", "Right", 51.0, 1.0),
        ("Foot Off", "Left", 6001.0, 60.5),
    ]


@pytest.mark.parametrize("machine", ["dec", "mips"])
def test_header_events_of_other_processors(machine: Machine, tmp_path: Path) -> None:
    events = opened(Synthetic(walk(), machine, events=[("HS", 0.25)]), tmp_path).events
    assert [(e.label, e.frame) for e in events] == [("HS", 25.0)]


@pytest.mark.parametrize(
    ("parameters", "header", "frames"),
    [
        ({"POINT:FRAMES": [500]}, {}, 40),
        ({"TRIAL:ACTUAL_END_FIELD": [9999, 0]}, {}, 40),
        ({"TRIAL:ACTUAL_END_FIELD": [0, 0]}, {}, 40),
        ({"TRIAL:ACTUAL_START_FIELD": None, "POINT:FRAMES": [30]}, {}, 30),
        ({"POINT:LONG_FRAMES": [40.0]}, {5: 7}, 40),
        ({}, {5: 65535}, 40),
    ],
)
def test_frame_counts_that_disagree(
    parameters: dict[str, object], header: dict[int, int], frames: int, tmp_path: Path
) -> None:
    spec = Synthetic(walk(40, 200), parameters=parameters, header=header)
    file = opened(spec, tmp_path)
    assert file.recording.frames == frames
    assert not file.truncated
    assert any("different numbers of frames" in text for text in file.warnings) == (
        header != {5: 65535} and parameters != {"TRIAL:ACTUAL_END_FIELD": [0, 0]}
    )


def test_a_wrong_analog_count_of_the_header(tmp_path: Path) -> None:
    spec = Synthetic(walk(), analog=np.ones((40, 10, 12)), header={3: 12})
    file = opened(spec, tmp_path)
    np.testing.assert_array_equal(file.recording.points, spec.points)
    assert file.layout.channels == 12
    assert any("disagree on the numbers" in text for text in file.warnings)


def test_data_start_from_the_parameter_or_from_nowhere(tmp_path: Path) -> None:
    spec = Synthetic(walk(), header={9: 0})
    assert any("POINT:DATA_START" in text for text in opened(spec, tmp_path).warnings)
    nowhere = replace(spec, parameters={"POINT:DATA_START": None})
    file = opened(nowhere, tmp_path)
    np.testing.assert_array_equal(file.recording.points, spec.points)
    assert any("does not say where its data begin" in text for text in file.warnings)


def test_a_data_start_of_0_means_nothing(tmp_path: Path) -> None:
    file = opened(Synthetic(walk(), parameters={"POINT:DATA_START": [0, 0]}), tmp_path)
    np.testing.assert_array_equal(file.recording.points, walk())
    assert file.warnings == ()


def test_scale_and_rate_that_disagree(tmp_path: Path) -> None:
    points = walk()
    parameters = {"POINT:SCALE": [0.5], "POINT:RATE": [50.0]}
    file = opened(Synthetic(points, is_float=False, scale=0.125, parameters=parameters), tmp_path)
    np.testing.assert_array_equal(file.recording.points, points)
    assert file.recording.rate == 50.0
    assert len(file.warnings) == 2
    floats = opened(Synthetic(points, parameters={"POINT:SCALE": [-0.5]}), tmp_path)
    assert floats.layout.scale == 0.5


def test_nothing_about_rate_and_scale(tmp_path: Path) -> None:
    parameters: dict[str, object] = dict.fromkeys(["POINT:SCALE", "POINT:RATE", "POINT:FRAMES"])
    file = opened(Synthetic(walk(), parameters=parameters, rate=0.0, scale=0.0), tmp_path)
    assert file.recording.rate == 100.0
    assert len(file.warnings) == 2


def test_parameters_at_another_block(tmp_path: Path) -> None:
    spec = Synthetic(walk())
    blocks = encode(spec)[514]
    raw = encode(replace(spec, header={9: 4 + blocks}))
    moved = bytearray(raw[:512] + bytes(1024) + raw[512:])
    moved[0] = 4
    path = tmp_path / "moved.c3d"
    path.write_bytes(moved)
    np.testing.assert_array_equal(read_c3d(path).recording.points, spec.points)


def test_a_record_that_declares_more_than_it_has(tmp_path: Path) -> None:
    raw = bytearray(encode(Synthetic(walk())))
    # The link of UNITS is kept, but it declares a text of 200 characters.
    at = raw.index(b"UNITS") + 7
    assert raw[at : at + 4] == b"\xff\x01\x02m"
    raw[at + 2] = 200
    path = tmp_path / "declared.c3d"
    path.write_bytes(raw)
    file = read_c3d(path)
    assert file.recording.labels[0] == "M001"
    assert file.recording.up == "+z"


def test_parameters_outside_of_their_section(tmp_path: Path) -> None:
    spec = Synthetic(walk(40, 200), labels=[f"Long label {i:03}" for i in range(200)])
    raw = bytearray(encode(spec))
    assert raw[514] > 4
    raw[514] = 1
    path = tmp_path / "overflow.c3d"
    path.write_bytes(raw)
    file = read_c3d(path)
    assert file.recording.labels == tuple(spec.labels or ())
    np.testing.assert_array_equal(file.recording.points, spec.points)
    assert file.warnings == ()


def test_a_description_without_its_length(tmp_path: Path) -> None:
    # OptiTrack 1 leaves the byte out behind the labels, and links to the record before.
    raw = bytearray(encode(Synthetic(walk(), labels=["One", "Two", "Three", "Four", "Five"])))
    at = raw.index(b"LABELS") + 6
    stop = at + raw[at]
    assert raw[stop - 1] == 0
    raw[at] -= 1
    section = raw[512 : 512 * (1 + raw[514])]
    del section[stop - 1 - 512]
    raw[512 : 512 + len(section) + 1] = section + b"\0"
    path = tmp_path / "described.c3d"
    path.write_bytes(raw)
    file = read_c3d(path)
    assert file.recording.labels == ("One", "Two", "Three", "Four", "Five")
    assert (file.recording.unit, file.recording.up, file.warnings) == ("mm", "+z", ())


def test_a_repeated_parameter_is_said(tmp_path: Path) -> None:
    raw = bytearray(encode(Synthetic(walk(), parameters={"POINT:UNITX": "m "})))
    at = raw.index(b"UNITX")
    raw[at : at + 5] = b"UNITS"
    path = tmp_path / "repeated.c3d"
    path.write_bytes(raw)
    file = read_c3d(path)
    assert file.recording.unit == "mm"
    assert any("POINT:UNITS" in text for text in file.warnings)


def test_analog_only(tmp_path: Path) -> None:
    analog = np.arange(60.0).reshape(10, 2, 3)
    file = opened(Synthetic(np.zeros((10, 0, 3)), analog=analog), tmp_path)
    assert file.recording.points.shape == (10, 0, 3)
    np.testing.assert_array_equal(file.read_analog(), analog.reshape(-1, 3))
    assert any("nothing to repair" in text for text in file.warnings)


@pytest.mark.parametrize("machine", ["intel", "mips"])
def test_unsigned_analog(machine: Machine, tmp_path: Path) -> None:
    analog = np.array([0, 1, 32767, 32768, 65535.0]).reshape(5, 1, 1)
    parameters = {"ANALOG:FORMAT": "UNSIGNED", "ANALOG:OFFSET": [32768]}
    spec = Synthetic(walk(5), machine, False, 0.125, analog=analog, parameters=parameters)
    np.testing.assert_array_equal(
        opened(spec, tmp_path).read_analog(), analog.reshape(-1, 1) - 32768
    )


def test_offsets_and_scales_of_some_channels(tmp_path: Path) -> None:
    analog = np.arange(40 * 3.0).reshape(40, 1, 3)
    parameters = {"ANALOG:OFFSET": [0.5], "ANALOG:SCALE": [2.0, 4.0], "ANALOG:GEN_SCALE": [-1.0]}
    file = opened(Synthetic(walk(), analog=analog, parameters=parameters), tmp_path)
    expected = -(analog[:, 0] - [0.5, 0, 0]) * [2.0, 4.0, 1.0]
    np.testing.assert_array_equal(file.read_analog(), expected)
    assert file.analog_units == ("", "", "")


def test_analog_data_are_read_when_they_are_asked_for(tmp_path: Path) -> None:
    file = opened(Synthetic(walk(), analog=np.ones((40, 1, 3))), tmp_path)
    file.path.unlink()
    assert file.analog_rate == 100.0
    with pytest.raises(MocapmendError, match="no such file"):
        file.read_analog()
