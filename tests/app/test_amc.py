"""AMC motions with their ASF skeletons: where the bones are, and what belongs to what."""

from collections.abc import Callable
from dataclasses import replace
from pathlib import Path

import numpy as np
import pytest
from hypothesis import given
from hypothesis import strategies as st
from joints_synthetic import Bone, FloatArray, amc_positions, amc_text, asf_text

from mocapmend import engine
from mocapmend.errors import MocapmendError
from mocapmend.files import Source
from mocapmend.files.formats import read_recording
from mocapmend.files.formats.amc import read_amc
from mocapmend.views.main_window import MainWindow
from mocapmend_algorithms import no_progress

CM = 2.54 / 0.45
ROOT_ORDER = "TX TY TZ RX RY RZ"
LEG = [
    Bone("hip", -1, (1.0, 0.0, 0.0), 2.0),
    Bone("femur", 0, (0.0, -1.0, 0.0), 7.0, (0.0, 0.0, 90.0), dof=("rx", "ry", "rz")),
    Bone("tibia", 1, (0.0, -1.0, 0.0), 8.0, dof=("rx",)),
    Bone("back", -1, (0.0, 1.0, 0.0), 5.0, dof=("rz", "rx")),
]
ROOT = np.array([[1.0, 16, 3, 0, 0, 0], [1, 16, 3, 0, 0, 0], [1, 16, 3, 90, 0, 90]])
MOTION = [
    np.empty((3, 0)),
    np.array([[0.0, 0, 0], [0, 90, 0], [0, 0, 0]]),
    np.array([[0.0], [90], [0]]),
    np.array([[0.0, 0], [90, 90], [0, 0]]),
]
ASF = asf_text(LEG)
AMC = amc_text(LEG, ROOT, MOTION, first=7)


def write(folder: Path, amc: str = AMC, asf: str = ASF) -> Path:
    (folder / "35.asf").write_text(asf)
    (folder / "35_01.amc").write_text(amc)
    return folder / "35_01.amc"


def test_poses_that_are_known_by_hand(tmp_path: Path) -> None:
    source = read_amc(write(tmp_path))
    recording = source.recording
    assert recording.labels == ("root", "hip", "femur", "tibia", "back")
    assert source.bones == ((0, 1), (1, 2), (2, 3), (0, 4))
    assert (source.kind, recording.rate, recording.unit, recording.up) == (
        "ASF/AMC",
        120,
        "cm",
        "+y",
    )
    assert (recording.first_frame, source.truncated) == (7, False)
    expected = [
        [[1, 16, 3], [3, 16, 3], [3, 9, 3], [3, 1, 3], [1, 21, 3]],
        # The axis of the femur is rolled about z by 90 degrees, so that its y is the world's -x:
        # down goes to +z. The tibia turns back about x: down stays down.
        # The back turns about z, then about the fixed x: up goes to -x and stays there.
        [[1, 16, 3], [3, 16, 3], [3, 16, 10], [3, 8, 10], [-4, 16, 3]],
        # The root turns about x, then about the fixed z: up goes to z and stays there; the hip
        # stays at x, then goes to y.
        [[1, 16, 3], [1, 18, 3], [1, 18, -4], [1, 18, -12], [1, 16, 8]],
    ]
    np.testing.assert_allclose(recording.points / CM, expected, atol=1e-12)


def test_the_order_of_the_angles_of_a_bone(tmp_path: Path) -> None:
    swapped = [*LEG[:3], replace(LEG[3], dof=("rx", "rz"))]
    points = read_amc(write(tmp_path, asf=asf_text(swapped))).recording.points / CM
    # About x first: up goes to z, and stays there.
    np.testing.assert_allclose(points[1, 4], [1, 16, 3 + 5], atol=1e-12)


@st.composite
def motions(draw: st.DrawFn) -> tuple[list[Bone], str, FloatArray, list[FloatArray]]:
    """Draw a tree of bones with any axes and degrees of freedom, and its motion."""
    angle = st.floats(-180, 180)
    bones: list[Bone] = []
    for number in range(draw(st.integers(1, 7))):
        vector = np.add(draw(st.tuples(*(st.floats(-1, 1) for _ in range(3)))), [0, 0, 1.5])
        x, y, z = (vector / np.linalg.norm(vector)).tolist()
        dof = draw(st.permutations(("rx", "ry", "rz")))[: draw(st.integers(0, 3))]
        bones.append(
            Bone(
                f"bone{number}",
                draw(st.sampled_from([number - 1, number - 1, -1])),
                (x, y, z),
                draw(st.floats(0, 10)),
                draw(st.tuples(angle, angle, angle)),
                "".join(draw(st.permutations("XYZ"))),
                tuple(dof),
            )
        )
    order = " ".join([*draw(st.permutations(ROOT_ORDER.split()))])
    rng = np.random.default_rng(draw(st.integers(0, 2**32 - 1)))
    frames = draw(st.integers(1, 4))
    root = rng.uniform(-100, 100, (frames, 6))
    return bones, order, root, [rng.uniform(-400, 400, (frames, len(b.dof))) for b in bones]


@given(motions())
def test_the_bones_are_where_a_second_implementation_puts_them(
    tmp_path_factory: pytest.TempPathFactory,
    drawn: tuple[list[Bone], str, FloatArray, list[FloatArray]],
) -> None:
    bones, order, root, values = drawn
    path = write(
        tmp_path_factory.mktemp("amc"), amc_text(bones, root, values), asf_text(bones, order)
    )
    source = read_amc(path)
    points = source.recording.points / CM
    index = {label: i for i, label in enumerate(source.recording.labels)}
    at = [0, *(index[bone.name] for bone in bones)]
    np.testing.assert_allclose(points[:, at], amc_positions(bones, order, root, values), atol=1e-9)
    for parent, tip in source.bones:
        bone = bones[at.index(tip) - 1]
        assert at[bone.parent + 1] == parent
        lengths = np.linalg.norm(points[:, tip] - points[:, parent], axis=1)
        np.testing.assert_allclose(lengths, bone.length, atol=1e-9)


def test_radians_are_radians(tmp_path: Path) -> None:
    degrees = read_amc(write(tmp_path)).recording.points
    bones = [replace(bone, axis=tuple(np.deg2rad(bone.axis).tolist())) for bone in LEG]
    root = ROOT.copy()
    root[:, 3:] = np.deg2rad(root[:, 3:])
    asf = asf_text(bones).replace("angle deg", "angle rad")
    amc = amc_text(LEG, root, [np.deg2rad(values) for values in MOTION])
    for text in (amc.replace(":DEGREES\n", ""), amc.replace("DEGREES", "RADIANS")):
        points = read_amc(write(tmp_path, text, asf)).recording.points
        np.testing.assert_allclose(points, degrees, atol=1e-9)


def test_the_preset_place_of_the_root_is_added(tmp_path: Path) -> None:
    plain = read_amc(write(tmp_path)).recording.points
    moved = ASF.replace("position 0 0 0", "position 1 (2, 3)")
    points = read_amc(write(tmp_path, asf=moved)).recording.points
    np.testing.assert_allclose(points - plain, np.full_like(plain, CM) * [1, 2, 3], atol=1e-9)


def test_other_length_units(tmp_path: Path) -> None:
    plain = read_amc(write(tmp_path)).recording.points
    source = read_amc(write(tmp_path, asf=ASF.replace("length 0.45", "length 0.9")))
    np.testing.assert_allclose(source.recording.points, plain / 2)
    # Without a unit, or with one that cannot be, the size decides: this skeleton fits CMU's.
    for stated in ("", "length 1.0", "length 0", "length -1", "length 1e-320", "length 1e11"):
        source = read_amc(write(tmp_path, asf=ASF.replace("length 0.45", stated)))
        np.testing.assert_allclose(source.recording.points, plain)
        assert [text for text in source.warnings if "states no length unit; 1/0.45 inch" in text]


def test_a_skeleton_alone_shows_its_rest_pose(tmp_path: Path) -> None:
    write(tmp_path)
    source = read_recording(tmp_path / "35.asf")
    expected = [[0, 0, 0], [2, 0, 0], [2, -7, 0], [2, -15, 0], [0, 5, 0]]
    np.testing.assert_allclose(source.recording.points[0] / CM, expected, atol=1e-12)
    assert source.recording.frames == 1
    assert source.warnings[0].startswith("A skeleton file holds no motion")


@pytest.mark.parametrize(
    ("motion", "skeletons", "found"),
    [
        ("walk.amc", ["walk.asf", "other.asf"], "walk.asf"),
        ("Walk.AMC", ["WALK.ASF", "other.asf"], "WALK.ASF"),
        ("35_01.amc", ["35.asf", "36.asf"], "35.asf"),
        ("ann_walk_01.amc", ["ann.asf", "bob.asf"], "ann.asf"),
        ("ann_walk_01.amc", ["ann_walk.asf", "ann.asf"], "ann_walk.asf"),
        ("walk.amc", ["ann.asf"], "ann.asf"),
    ],
)
def test_the_skeleton_is_found(
    motion: str, skeletons: list[str], found: str, tmp_path: Path
) -> None:
    for name in skeletons:
        # Only the right one has the bones of the motion.
        (tmp_path / name).write_text(ASF if name == found else asf_text(LEG[:1]))
    (tmp_path / motion).write_text(AMC)
    source = read_recording(tmp_path / motion)
    assert source.recording.markers == 5
    told = [text for text in source.warnings if "the only one in the folder" in text]
    assert told == (
        ["The skeleton is ann.asf, the only one in the folder."] if len(skeletons) == 1 else []
    )


@pytest.mark.parametrize("skeletons", [[], ["ann.asf", "bob.asf"]])
def test_a_missing_skeleton(skeletons: list[str], tmp_path: Path) -> None:
    path = tmp_path / "35_01.amc"
    # Never a path that a file names.
    elsewhere = tmp_path / "elsewhere"
    elsewhere.mkdir()
    (elsewhere / "35.asf").write_text(ASF)
    path.write_text(f"#!OML:ASF {elsewhere / '35.asf'}\n" + AMC)
    for name in skeletons:
        (tmp_path / name).write_text(ASF)
    with pytest.raises(MocapmendError, match="is not beside it") as caught:
        read_amc(path)
    assert caught.value.where == str(path)


def test_a_truncated_motion_loses_its_last_frame(tmp_path: Path) -> None:
    whole = read_amc(write(tmp_path)).recording.points
    frames = [AMC.index(f"\n{number}\n") + 1 for number in (7, 8, 9)]
    for stop in range(frames[1], len(AMC)):
        expected = 1 if stop < frames[2] else 2
        source = read_amc(write(tmp_path, AMC[:stop]))
        # The last value of a frame may have lost digits without a sign of it.
        assert expected <= source.recording.frames <= expected + 1
        if source.recording.frames > expected:
            assert stop > (len(AMC) if expected == 2 else frames[2]) - len("root 90.0\n")
        lost = source.recording.frames == expected and stop not in frames
        assert lost == ("The last frame is incomplete and is left out." in source.warnings)
        assert np.array_equal(source.recording.points[:expected], whole[:expected])


def test_frames_that_are_left_out_are_told(tmp_path: Path) -> None:
    source = read_amc(write(tmp_path, AMC.replace("\n9\n", "\n11\n")))
    assert source.recording.frames == 3
    assert source.warnings[0].startswith("Frame 11 does not follow the frame before it")


def test_bones_without_values_do_not_turn(tmp_path: Path) -> None:
    amc = "\n".join(line for line in AMC.split("\n") if not line.startswith(("femur", "tibia")))
    source = read_amc(write(tmp_path, amc))
    np.testing.assert_allclose(source.recording.points[1, 3] / CM, [3, 1, 3])
    assert source.warnings[0] == "2 bones have no values in the motion and do not turn."


def test_bones_that_shift_are_drawn_with_a_fixed_length(tmp_path: Path) -> None:
    asf = ASF.replace("dof rx\n", "dof rx l\n")
    amc = "\n".join(line + " 3.5" if line.startswith("tibia") else line for line in AMC.split("\n"))
    plain = read_amc(write(tmp_path)).recording.points
    source = read_amc(write(tmp_path, amc, asf))
    assert np.array_equal(source.recording.points, plain)
    assert "Bones that shift or stretch are drawn with a fixed length." in source.warnings


@pytest.mark.parametrize("value", ["nan", "inf", "-1e999"])
def test_values_that_are_none_make_bones_missing(value: str, tmp_path: Path) -> None:
    amc = AMC.replace("femur 0.0 90.0 0.0", f"femur 0.0 {value} 0.0")
    source = read_amc(write(tmp_path, amc))
    assert source.recording.present.tolist() == [
        [True] * 5,
        [True, True, False, False, True],
        [True] * 5,
    ]
    assert source.warnings[0].startswith("2 samples depend on values")


def test_the_window_opens_it(open_in: Callable[[Path], MainWindow], tmp_path: Path) -> None:
    path = write(tmp_path)
    workspace = open_in(path).workspace
    assert workspace is not None
    source, skeleton = engine.load(path, no_progress)
    assert isinstance(source, Source)
    assert (skeleton.source, skeleton.bones) == ("file", source.bones)
    assert workspace.document.skeleton == skeleton
