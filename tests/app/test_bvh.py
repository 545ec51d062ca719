"""BVH files: the grammar, where the joints are, and what the format leaves to be assumed."""

from collections.abc import Callable
from pathlib import Path

import numpy as np
import pytest
from hypothesis import given
from hypothesis import strategies as st
from joints_synthetic import FloatArray, Node, bvh_positions, bvh_text

from mocapmend import engine
from mocapmend.errors import MocapmendError
from mocapmend.files import Source
from mocapmend.files.formats.assumed import body_unit
from mocapmend.files.formats.bvh import read_bvh
from mocapmend.files.formats.kinematics import BLOCK_SAMPLES, Joint
from mocapmend.views.main_window import MainWindow
from mocapmend_algorithms import no_progress
from mocapmend_algorithms.skeleton import match_template
from mocapmend_resources import skeletons as templates

ALL = ("Xposition", "Yposition", "Zposition", "Zrotation", "Xrotation", "Yrotation")
TURNS = ALL[3:]
ARM = [
    Node("Hips", -1, (0.0, 95.0, 0.0), ALL),
    Node("Arm", 0, (0.0, 50.0, 0.0), TURNS),
    Node("", 1, (60.0, 0.0, 0.0), end=True),
    Node("Leg", 0, (10.0, 0.0, 0.0), ()),
    Node("", 3, (0.0, -90.0, 0.0), end=True),
]
POSES = np.array([
    [1.0, 95.0, 2.0, 0, 0, 0, 0, 0, 0],
    [1.0, 95.0, 2.0, 90, 0, 0, 0, 0, 90],
    [1.0, 96.0, 2.0, 90, 90, 0, 0, 0, 0],
])  # fmt: skip
TEXT = bvh_text(ARM, POSES)
CMU = 2.54 / 0.45
SIZES = [(1, "cm", 1), (10, "mm", 1), (0.01, "m", 1), (1 / 2.54, "in", 1), (1 / CMU, "cm", CMU)]
"""What a body in centimetres is multiplied by, the unit to be found and the factor to it."""


@pytest.fixture
def read(tmp_path: Path) -> Callable[[str | bytes], Source]:
    """Return a function that reads a text as a BVH file."""

    def from_text(text: str | bytes) -> Source:
        path = tmp_path / "file.bvh"
        path.write_bytes(text.encode() if isinstance(text, str) else text)
        return read_bvh(path)

    return from_text


Read = Callable[[str | bytes], Source]


def test_poses_that_are_known_by_hand(read: Read) -> None:
    source = read(TEXT)
    recording = source.recording
    assert recording.labels == ("Hips", "Arm", "Arm end", "Leg", "Leg end")
    assert source.bones == ((0, 1), (1, 2), (0, 3), (3, 4))
    assert (source.kind, recording.rate, recording.unit, recording.up) == ("BVH", 100, "cm", "+y")
    assert (source.frames_promised, source.truncated) == (3, False)
    expected = [
        [[1, 95, 2], [1, 145, 2], [61, 145, 2], [11, 95, 2], [11, 5, 2]],
        # The hips roll up to the left: the spine lies along -x; the arm then swings to the back.
        [[1, 95, 2], [-49, 95, 2], [-49, 95, -58], [1, 105, 2], [91, 105, 2]],
        # Then about the rolled x axis (up): the spine points back along -z, z comes round to x.
        [[1, 96, 2], [1, 96, 52], [1, 156, 52], [1, 106, 2], [1, 106, -88]],
    ]
    np.testing.assert_allclose(recording.points, expected, atol=1e-12)


@pytest.mark.parametrize(
    "change",
    [
        lambda text: text.replace("\n", "\r\n"),
        lambda text: text.replace("\n", "\r"),
        lambda text: text.replace("\t", "      ").replace(" ", "  "),
        lambda text: text.replace(" ", "\t"),
        lambda text: (
            text.lower().replace("hips", "Hips").replace("arm", "Arm").replace("leg", "Leg")
        ),
        lambda text: text.replace("\n{", " {").replace("\n\t{", "{"),
        lambda text: "\ufeff" + text,
        lambda text: "\n\n" + text.replace("\n", "\n\n \n") + "\n\n",
        lambda text: text.rstrip("\n"),
        lambda text: text.replace("Frames:", "Frames :").replace("Frame Time:", "FRAME TIME:\t"),
        lambda text: text.replace("Frames: 3\nFrame Time: 0.01", "Frame Time: 0.01\nFrames: 3"),
        lambda text: text.replace("95.0", "9.5e+1"),
        lambda text: text.replace("End Site", "End Site of a name"),
    ],
)
def test_the_ways_to_write_the_same(change: Callable[[str], str], read: Read) -> None:
    plain, other = read(TEXT), read(change(TEXT))
    assert other.recording.labels == plain.recording.labels
    assert other.bones == plain.bones
    assert other.warnings == plain.warnings
    assert other.recording.rate == plain.recording.rate
    assert np.array_equal(other.recording.points, plain.recording.points)


def test_names_with_spaces_and_colons_and_repeated_ones(read: Read) -> None:
    source = read(TEXT.replace("Leg", "Arm").replace("Hips", "Ann: the  Hips"))
    assert source.recording.labels == ("Ann: the Hips", "Arm", "Arm end", "Arm", "Arm end")
    assert "2 joints have the label of another joint." in source.warnings


def test_several_roots(read: Read) -> None:
    text = bvh_text([*ARM, Node("Stick", -1, (0.0, 0.0, 0.0), ALL[:3])], np.ones((2, 12)))
    source = read(text)
    assert source.bones == ((0, 1), (1, 2), (0, 3), (3, 4))
    assert source.recording.points[1, 5].tolist() == [1, 1, 1]


@st.composite
def skeletons(draw: st.DrawFn) -> tuple[list[Node], FloatArray]:
    """Draw a tree whose joints have any channels in any order, and its motion."""
    length = st.floats(-10, 10)
    # A long stick, so that the skeleton is the size of a person in centimetres.
    nodes = [Node("root", -1, (0.0, 0.0, 0.0), ALL), Node("", 0, (0.0, 130.0, 0.0), end=True)]
    for number in range(draw(st.integers(1, 7))):
        inner = [i for i, node in enumerate(nodes) if not node.end]
        # Files are written depth first: only the joints of the last branch can carry another.
        branch = [i for i in inner if i in _ancestors(nodes, inner[-1])]
        parent = draw(st.sampled_from(branch))
        turns = draw(st.permutations(TURNS))[: draw(st.integers(0, 3))]
        shifts = draw(st.permutations(ALL[:3]))[: draw(st.sampled_from([0, 0, 0, 1, 3]))]
        channels = draw(st.permutations([*turns, *shifts]))
        offset = (draw(length), draw(length), draw(length))
        nodes.append(Node(f"joint {number}", parent, offset, tuple(channels)))
        if draw(st.booleans()):
            end = (draw(length), draw(length), draw(length))
            nodes.append(Node("", len(nodes) - 1, end, end=True))
    seed = draw(st.integers(0, 2**32 - 1))
    channels_in_all = sum(len(node.channels) for node in nodes)
    values = np.random.default_rng(seed).uniform(
        -400, 400, (draw(st.integers(1, 4)), channels_in_all)
    )
    return nodes, values


def _ancestors(nodes: list[Node], index: int) -> set[int]:
    found = set()
    while index >= 0:
        found.add(index)
        index = nodes[index].parent
    return found


@given(skeletons())
def test_the_joints_are_where_a_second_implementation_puts_them(
    tmp_path_factory: pytest.TempPathFactory, drawn: tuple[list[Node], FloatArray]
) -> None:
    nodes, values = drawn
    path = tmp_path_factory.mktemp("bvh") / "file.bvh"
    path.write_text(bvh_text(nodes, values))
    source = read_bvh(path)
    points = source.recording.points
    # Shifted joints make the size, and so the unit that is guessed, anything.
    scale = CMU if any("converted" in text for text in source.warnings) else 1.0
    expected = bvh_positions(nodes, values)
    np.testing.assert_allclose(points / scale, expected, rtol=1e-12, atol=1e-9)
    for parent, joint in source.bones:
        if not any("position" in channel for channel in nodes[joint].channels):
            lengths = np.linalg.norm(points[:, joint] - points[:, parent], axis=1) / scale
            np.testing.assert_allclose(lengths, np.linalg.norm(nodes[joint].offset), atol=1e-9)


def test_a_long_motion_is_placed_as_its_parts(read: Read) -> None:
    rng = np.random.default_rng(1)
    chain = [Node("root", -1, (0.0, 0.0, 0.0), ALL)]
    chain += [Node(f"j{i}", i, (0.0, 1.0, 0.0), ("Xrotation",)) for i in range(150)]
    values = rng.uniform(-5, 5, (6000, 156)).round(3)
    assert values.shape[0] * 151 > 2 * BLOCK_SAMPLES
    points = read(bvh_text(chain, values)).recording.points
    assert points.shape == (6000, 151, 3)
    angles = np.deg2rad(values[:, 6:])
    # After the root, all turns are about its x axis: the sum of the angles says where.
    total = np.concatenate([np.zeros((6000, 1)), np.cumsum(angles, axis=1)], axis=1)[:, :150]
    along = points[:, 1:] - points[:, :1]
    unit = np.linalg.norm(points[:, 1] - points[:, 0], axis=1)[0]
    length = np.hypot(np.cumsum(np.cos(total), axis=1), np.cumsum(np.sin(total), axis=1))
    np.testing.assert_allclose(np.linalg.norm(along, axis=2), length * unit, rtol=1e-9, atol=1e-7)


@pytest.mark.parametrize(
    ("stated", "rate"),
    [
        ("0.0083333", 120), ("0.008333", 120), ("0.0083", 120), (".033333", 30), ("0.0333", 30),
        ("0.033", 30), ("0.0333667", 29.97), ("0.0166", 60), ("0.016667", 60), ("0.04", 25),
        ("0.05", 20), ("0.01", 100), ("1e-2", 100), ("0.0125", 80), ("0.002", 500), ("1", 1),
    ],
)  # fmt: skip
def test_the_rate_that_a_frame_time_means(stated: str, rate: float, read: Read) -> None:
    source = read(TEXT.replace("0.01", stated))
    assert source.recording.rate == pytest.approx(rate, rel=1e-12)
    assert not [text for text in source.warnings if "frame time" in text]


def test_a_rate_that_is_in_doubt(read: Read) -> None:
    source = read(TEXT.replace("0.01", "0.008"))
    assert source.recording.rate == 125
    assert source.warnings[0] == (
        "The frame time 0.008 s may be a rounded 1/120 s; 125 Hz is used."
    )


@pytest.mark.parametrize("stated", ["0", "-0.01", "nan", "inf", "1e-300", "1e300", "soon", "0x1"])
def test_a_frame_time_that_is_none(stated: str, read: Read) -> None:
    source = read(TEXT.replace("0.01", stated))
    assert source.recording.rate == 120
    assert "The file states no usable frame time; 120 Hz is assumed." in source.warnings


@pytest.mark.parametrize(
    ("scale", "unit", "factor"),
    [
        (1, "cm", 1),
        (10, "mm", 1),
        (0.01, "m", 1),
        (1 / 2.54, "in", 1),
        (0.45 / 2.54, "cm", 2.54 / 0.45),
    ],
)
def test_the_unit_is_guessed_from_the_size(
    scale: float, unit: str, factor: float, read: Read
) -> None:
    plain = read(TEXT).recording.points
    nodes = [
        Node(n.name, n.parent, tuple(scale * x for x in n.offset), n.channels, n.end)  # type: ignore[arg-type]
        for n in ARM
    ]
    values = POSES.copy()
    values[:, :3] *= scale
    source = read(bvh_text(nodes, values))
    assert source.recording.unit == unit
    np.testing.assert_allclose(source.recording.points, plain * scale * factor, atol=1e-9)
    said = "1/0.45 inch" if factor != 1 else f"{unit} is assumed"
    assert [text for text in source.warnings if "no length unit" in text and said in text]


def test_the_unit_of_real_bodies_of_any_pose(shared: Path) -> None:
    for path in sorted((shared / "cmu_joints").glob("*.npz"))[::6]:
        with np.load(path) as file:
            points, parents = file["pos"].astype(np.float64), file["parents"].tolist()
        joints = [Joint(label="", parent=parent) for parent in parents]
        for scale, unit, factor in SIZES:
            assert body_unit(points * scale, joints, []) == (unit, pytest.approx(factor)), path


BODY = [
    ("Hips", -1, (0, 95, 0)), ("Chest", 0, (0, 30, 0)), ("Head", 1, (0, 30, 0)),
    ("LArm", 1, (15, 20, 0)), ("LElbow", 3, (28, 0, 0)), ("LHand", 4, (26, 0, 0)),
    ("RArm", 1, (-15, 20, 0)), ("RElbow", 6, (-28, 0, 0)), ("RHand", 7, (-26, 0, 0)),
    ("LLeg", 0, (9, -5, 0)), ("LKnee", 9, (0, -42, 0)), ("LFoot", 10, (0, -42, 3)),
    ("RLeg", 0, (-9, -5, 0)), ("RKnee", 12, (0, -42, 0)), ("RFoot", 13, (0, -42, 3)),
]  # fmt: skip


@pytest.mark.parametrize("up", ["+y", "+z"])
def test_the_axis_that_points_up(up: str, read: Read) -> None:
    def turned(x: float, y: float, z: float) -> tuple[float, float, float]:
        return (x, y, z) if up == "+y" else (x, -z, y)

    nodes = [
        Node(name, parent, turned(*map(float, offset)), ALL if parent < 0 else ())
        for name, parent, offset in BODY
    ]
    walk = np.zeros((50, 6))
    walk[:, :3] = [turned(0.1 * i, 95, 3.0 * i) for i in range(50)]
    source = read(bvh_text(nodes, walk))
    assert source.recording.up == up
    assert f"The file does not say which axis points up; {up} is assumed." in source.warnings


def test_a_file_without_motion_shows_the_rest_pose(read: Read) -> None:
    expected = [[0, 95, 0], [0, 145, 0], [60, 145, 0], [10, 95, 0], [10, 5, 0]]
    for text in (
        bvh_text(ARM, POSES[:0]),
        TEXT.replace(" 6 " + " ".join(ALL), " 0 ").replace(" 3 " + " ".join(TURNS), " 0"),
    ):
        source = read(text)
        assert source.recording.points.tolist() == [expected]
        assert not source.truncated
        assert source.warnings[-3].startswith("The file holds no motion")


def test_a_truncated_file_opens_with_exact_counts(read: Read) -> None:
    whole = read(TEXT).recording.points
    start = TEXT.index("Frame Time: 0.01\n") + len("Frame Time: 0.01\n")
    rows = TEXT[start:].splitlines(keepends=True)
    ends = start + np.cumsum([len(row) for row in rows])
    for stop in range(start, len(TEXT)):
        # A row counts when its line end is there, too: else its last digits may be lost.
        there = int((ends <= stop).sum())
        if not there:
            with pytest.raises(MocapmendError, match="ends before its first frame"):
                read(TEXT[:stop])
            continue
        source = read(TEXT[:stop])
        frames = source.recording.frames
        # Only for the last row, no missing frame tells that digits are lost.
        assert frames == there or (there == 2 and stop > len(TEXT) - len("0.0\n"))
        assert source.truncated == (frames < 3)
        assert source.frames_promised == 3
        if source.truncated:
            assert [text for text in source.warnings if f"only {frames} are there" in text]
            assert np.array_equal(source.recording.points, whole[:frames])


def test_more_frames_than_promised_are_all_read(read: Read) -> None:
    source = read(TEXT.replace("Frames: 3", "Frames: 2"))
    assert source.recording.frames == 3
    assert not source.truncated
    assert "The file says that it holds 2 frames, but 3 are there; all are read." in source.warnings
    source = read(TEXT.replace("Frames: 3\n", ""))
    assert (source.recording.frames, source.truncated) == (3, False)
    assert "The file does not say how many frames it holds." in source.warnings


@pytest.mark.parametrize("value", ["nan", "inf", "-1e999", "1e308", "1e13"])
def test_values_that_are_none_make_joints_missing(value: str, read: Read) -> None:
    values = bvh_text(ARM, POSES).splitlines()
    values[-2] = f"1 {value} 2 90 0 0 0 0 0"
    recording = read("\n".join(values) + "\n").recording
    assert recording.present.tolist() == [[True] * 5, [False] * 5, [True] * 5]
    values[-2] = f"1 95 2 90 0 0 {value if value[0] in 'ni' else 'nan'} 0 0"
    source = read("\n".join(values) + "\n")
    assert source.recording.present[1].tolist() == [True, True, False, True, True]
    assert source.warnings[0].startswith("1 samples depend on values")


def test_the_real_file_of_a_suit(shared: Path) -> None:
    path = shared / "kinect" / "pn59" / "axisneuron_59joint_120fps.bvh"
    source, skeleton = engine.load(path, no_progress)
    recording = source.recording
    assert recording.points.shape == (2156, 59 + 13, 3)
    assert (recording.unit, recording.up, source.truncated) == ("cm", "+y", False)
    assert recording.rate == 125.0, "as the file states, whatever its name says"
    assert (skeleton.source, skeleton.bones) == ("file", source.bones)
    assert_axis_neuron(source)
    nodes, values = _parsed_again(path.read_text())
    some = slice(None, None, 97)
    np.testing.assert_allclose(
        recording.points[some], bvh_positions(nodes, values[some]), rtol=0, atol=1e-9
    )
    # The person stands on the floor, and no bone changes its length.
    assert 150 < np.ptp(recording.points[0, :, 1]) < 190
    ends = np.array(source.bones)
    lengths = np.linalg.norm(
        recording.points[:, ends[:, 1]] - recording.points[:, ends[:, 0]], axis=2
    )
    assert np.ptp(lengths, axis=0).max() < 1e-9


def test_a_suit_with_fingers(read: Read) -> None:
    template = templates.read("axis_neuron_59")
    parents = {joint: template.required.index(parent) for parent, joint in template.bones}
    nodes = [
        Node(label, parents.get(label, -1), (1.0 + i, 90.0 / (i + 1), -float(i)), ALL)
        for i, label in enumerate(template.required)
    ]
    tips = [i for i in range(59) if i not in parents.values()]
    nodes += [Node("", i, (1.0, 0.0, 0.0), end=True) for i in tips]
    # Every joint has six numbers, as Axis Neuron writes them.
    offsets = np.broadcast_to([node.offset for node in nodes[:59]], (4, 59, 3))
    turns = np.random.default_rng(6).normal(0, 10, (4, 59, 3))
    values = np.concatenate([offsets, turns], axis=2).reshape(4, -1)
    source = read(bvh_text(nodes, values, "0.008"))
    assert source.recording.rate == 125.0
    assert_axis_neuron(source)
    labels = source.recording.labels
    places = [labels.index(label) for label in template.required]
    expected = bvh_positions(nodes[:59], values)
    np.testing.assert_allclose(source.recording.points[:, places], expected, atol=1e-9)


def assert_axis_neuron(source: Source) -> None:
    """Compare joints, bones and what is known of them with the template."""
    template = templates.read("axis_neuron_59")
    labels = source.recording.labels
    assert [label for label in labels if not label.endswith(" end")] == list(template.required)
    named = {(labels[a], labels[b]) for a, b in source.bones}
    assert named == set(template.bones) | {
        (label.removesuffix(" end"), label) for label in labels if label.endswith(" end")
    }
    known = match_template(labels, templates.load())
    assert known is not None
    assert known.name == template.name
    assert {(labels[a], labels[b]) for a, b in known.bones} == set(template.bones)


def _parsed_again(text: str) -> tuple[list[Node], FloatArray]:
    """Parse a well-formed BVH file line by line."""
    nodes: list[Node] = []
    stack = [-1]
    lines = iter(text.split("\n"))
    for words in map(str.split, lines):
        if words[:1] in (["ROOT"], ["JOINT"], ["End"]):
            next(lines)
            _, *offset = next(lines).split()
            end = words[0] == "End"
            channels = [] if end else next(lines).split()[2:]
            x, y, z = map(float, offset)
            nodes.append(Node(words[1], stack[-1], (x, y, z), tuple(channels), end))
            stack.append(len(nodes) - 1)
        elif words == ["}"]:
            stack.pop()
        elif words[:2] == ["Frame", "Time:"]:
            break
    return nodes, np.array([line.split() for line in lines if line.strip()], dtype=float)


def test_the_window_opens_it(open_in: Callable[[Path], MainWindow], tmp_path: Path) -> None:
    path = tmp_path / "arm.bvh"
    path.write_text(TEXT)
    workspace = open_in(path).workspace
    assert workspace is not None
    assert workspace.document.source.kind == "BVH"
    assert workspace.document.original.labels[2] == "Arm end"
    assert workspace.document.skeleton.source == "file"
