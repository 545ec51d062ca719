"""BVH, ASF and AMC files that cannot be read or only in part: one clear message, nothing else."""

import random
import tracemalloc
from collections.abc import Callable
from pathlib import Path

import numpy as np
import pytest
from test_amc import AMC, ASF
from test_bvh import TEXT as BVH

from mocapmend.errors import MocapmendError
from mocapmend.files import Source
from mocapmend.files.formats import read_recording

MUTANTS = 250
MEGABYTE = 1_000_000
HEAD = "HIERARCHY\nROOT a\n{\nOFFSET 0 0 0\nCHANNELS 1 Xposition\n"
NEST = 100_000


def read(
    folder: Path, *, bvh: str | bytes = "", asf: str | bytes = ASF, amc: str | bytes = ""
) -> Source:
    """Write the files and read the first one that is given."""
    for name, text in (("x.bvh", bvh), ("x.asf", asf), ("x.amc", amc)):
        (folder / name).write_bytes(text.encode() if isinstance(text, str) else text)
    return read_recording(folder / ("x.bvh" if bvh else "x.amc" if amc else "x.asf"))


def refused(caught: pytest.ExceptionInfo[MocapmendError], folder: Path) -> str:
    assert Path(caught.value.where).parent == folder
    assert caught.value.todo
    assert caught.value.what.endswith(".")
    assert len(caught.value.what) < 400
    return caught.value.what


@pytest.mark.parametrize(
    ("text", "message"),
    [
        ("\x00" * 5000, "not a BVH file"),
        ("PK\x03\x04" * 500, "not a BVH file"),
        ("HIERARCHYS\n" + BVH[10:], "not a BVH file"),
        (BVH[: BVH.index("MOTION")], "ends before its motion"),
        (BVH[: BVH.index("Frames")], "ends before its first frame"),
        (BVH.replace("}", "", 1), "ends before joint Hips is closed"),
        (BVH.replace("}\n", "}\n}\n", 1).replace("MOTION", "}\nMOTION"), "outside of its joints"),
        (BVH.replace("{", "", 1), "lacks an opening brace|unknown word|outside"),
        (BVH.replace("ROOT Hips", "Hips"), "'Hips' outside of its joints"),
        (BVH.replace("ROOT Hips", "ROOT " + "x" * 500), "name that is too long"),
        (BVH.replace("ROOT Hips", "ROOT " + "x " * 500), "lacks an opening brace"),
        (BVH.replace("OFFSET", "OFFSETS", 1), "unknown word 'OFFSETS'"),
        (BVH.replace("0.0 95.0 0.0", "0.0 95.0"), "offset of joint Hips is no three numbers"),
        (BVH.replace("0.0 95.0 0.0", "0.0 95.0 nan"), "offset of joint Hips is no three numbers"),
        (BVH.replace("0.0 95.0 0.0", "0.0 1e308 0"), "offset of joint Hips is no three numbers"),
        (BVH.replace("Xposition", "Xscale"), "unknown channel 'Xscale'"),
        (BVH.replace("CHANNELS 6", "CHANNELS 5"), "unknown word 'Yrotation'"),
        (BVH.replace("CHANNELS 6", "CHANNELS 10000000"), "how many channels"),
        (BVH.replace("CHANNELS 6", "CHANNELS -1"), "how many channels"),
        (BVH.replace("CHANNELS 6", "CHANNELS"), "how many channels"),
        (BVH.replace("CHANNELS 3", "CHANNELS 4"), "unknown channel"),
        ("HIERARCHY\nEnd Site\n{\n}\nMOTION\n", "End Site outside"),
        ("HIERARCHY\nMOTION\nFrames: 1\nFrame Time: 1\n1\n", "has no joints"),
        (BVH.replace("90.0 90.0", "90.0", 1) + "1 2 3\n", "Frame 3 does not consist of 9 numbers"),
        (BVH.replace("96.0", "9x6") + "\n1 2", "Frame 3 does not consist of 9 numbers"),
        (BVH.replace("95.0 2.0 90.0", "95.0 2.0 90.0 7"), "Frame 2 does not consist of 9 numbers"),
    ],
)
def test_what_is_no_bvh_file(text: str, message: str, tmp_path: Path) -> None:
    with pytest.raises(MocapmendError, match=message) as caught:
        read(tmp_path, bvh=text)
    refused(caught, tmp_path)


@pytest.mark.parametrize(
    ("text", "message"),
    [
        (b"\xff\xfe\x00" * 4000, "no ASF skeleton"),
        (ASF[: ASF.index(":bonedata")], "no ASF skeleton"),
        (ASF[: ASF.index("name femur")], "ends within a bone"),
        (ASF[: ASF.index(":hierarchy")], "does not join back to the root"),
        (ASF.replace(" name femur", ""), "bone without a name"),
        (ASF.replace(" name femur", " name hip"), "two bones hip"),
        (ASF.replace(" name femur", " name root"), "two bones root"),
        (ASF.replace(" hip femur\n", " hip femur\n tibia femur\n"), "two parents of femur"),
        (ASF.replace(" hip femur\n", " hip femur femur\n"), "two parents of femur"),
        (ASF.replace(" root hip back", " root back\n tibia hip"), "does not join femur"),
        (ASF.replace(" root hip back", " root hip back root"), "two parents of root"),
        (ASF.replace(" hip femur", " hip femurs"), "unknown bone 'femurs'"),
        (ASF.replace(" hip femur", " hips femur"), "unknown bone 'hips'"),
        (ASF.replace("direction 1.0 0.0 0.0", "direction 1.0 0.0"), "hip has no usable direction"),
        (ASF.replace("direction 1.0", "direction one"), "hip has no usable direction"),
        (ASF.replace("length 2.0", "length nan"), "hip has no usable length"),
        (ASF.replace("length 2.0", "length 1e308"), "hip has no usable length"),
        (ASF.replace("length 2.0", ""), "hip has no usable length"),
        (ASF.replace("length 0.45", "length inf"), "The skeleton has no usable length"),
        (ASF.replace("axis 0.0 0.0 90.0", "axis 0 0"), "femur has no usable axis"),
        (ASF.replace("90.0 XYZ", "90.0 XYW"), "femur has the unknown order of axes 'XYW'"),
        (ASF.replace("axis XYZ", "axis Q"), "root has the unknown order of axes 'Q'"),
        (ASF.replace("dof rx ry rz", "dof rx ry rw"), "unknown degrees of freedom of femur"),
        (ASF.replace("dof rx ry rz", "dof" + " rx" * 9), "unknown degrees of freedom of femur"),
        (ASF.replace("position 0 0 0", "position 0 0"), "root has no usable position"),
        (":bonedata\n" + "begin\nname x\nend\n" * 2, "two bones x"),
        (ASF + " " * 5 * MEGABYTE, "too long"),
    ],
)
def test_what_is_no_skeleton(text: str | bytes, message: str, tmp_path: Path) -> None:
    for amc in ("", AMC):
        with pytest.raises(MocapmendError, match=message) as caught:
            read(tmp_path, asf=text, amc=amc)
        refused(caught, tmp_path)
        assert caught.value.where == str(tmp_path / "x.asf")


@pytest.mark.parametrize(
    ("text", "message"),
    [
        (b"\xff\xfe\x00" * 4000, "no AMC motion|ends before its first frame"),
        ("root 1 2 3 4 5 6\n" + AMC, "no AMC motion"),
        (":FULLY-SPECIFIED\n:DEGREES\n", "ends before its first frame"),
        (AMC[: AMC.index("root")], "ends before its first frame"),
        (AMC.replace("femur", "finger"), "Frame 7 has the bone 'finger', which the skeleton lacks"),
        (AMC.replace("tibia 90.0", "tibia 90.0 1"), "Frame 8 has no 1 values of the bone tibia"),
        (AMC.replace("tibia 90.0", "tibia"), "Frame 8 has no 1 values of the bone tibia"),
        (AMC.replace("tibia 90.0", "tibia ninety"), "Frame 8 has no 1 values of the bone tibia"),
        (AMC.replace("tibia 90.0", "back 1 2"), "Frame 8 has two bones back"),
        (AMC.replace("tibia 90.0\n", ""), "Frame 8 does not have the bones of the first frame"),
        (AMC.replace("\n8\n", "\n8\n8\n"), "Frame 8 does not have the bones of the first frame"),
    ],
)
def test_what_is_no_motion(text: str | bytes, message: str, tmp_path: Path) -> None:
    with pytest.raises(MocapmendError, match=message) as caught:
        read(tmp_path, amc=text)
    refused(caught, tmp_path)
    assert caught.value.where == str(tmp_path / "x.amc")


def nested_bvh(depth: int) -> str:
    joints = "JOINT b\n{\nOFFSET 0 1 0\n" * depth
    return f"{HEAD}{joints}{'}' * (depth + 1)}\nMOTION\nFrames: 1\nFrame Time: 0.01\n1\n"


def chain_asf(bones: int) -> str:
    bone = "begin\nname {}\ndirection 0 1 0\nlength 1\nend\n"
    links = "".join(f"{i} {i + 1}\n" for i in range(bones - 1))
    return f":bonedata\n{''.join(map(bone.format, range(bones)))}:hierarchy\nroot 0\n{links}"


def test_deep_skeletons_are_read(tmp_path: Path) -> None:
    assert read(tmp_path, bvh=nested_bvh(5000)).recording.points[0, -1].tolist() == [1, 5000, 0]
    points = read(tmp_path, asf=chain_asf(5000)).recording.points
    assert points[0, -1, 1] == pytest.approx(5000 * points[0, 1, 1])


MOTION = "}\nMOTION\nFrames: 1\nFrame Time: 0.01\n"
STATIC = f"{HEAD}{'End Site { OFFSET 0 0 0 }' * 9000}{MOTION}"
ROOT = "1\nroot 1 2 3 4 5 6\n"


def long(text: str) -> str:
    return text * (10 * MEGABYTE // len(text))


# Made when they are needed: together they are large.
HUGE: dict[str, tuple[Callable[[], dict[str, str]], str]] = {
    "depth": (lambda: {"bvh": nested_bvh(NEST)}, "more than 10000 joints"),
    "braces": (lambda: {"bvh": "HIERARCHY\n{" + "{" * 3 * MEGABYTE + "\nMOTION\n"}, "outside of"),
    "name": (lambda: {"bvh": f"HIERARCHY\nROOT {long('a')}\nMOTION\n"}, "too long"),
    "blanks": (lambda: {"bvh": "HIERARCHY\n" + long(" ")}, "ends before its motion"),
    "lines": (lambda: {"bvh": "HIERARCHY\n" + long("\n")}, "ends before its motion"),
    "row": (lambda: {"bvh": f"{HEAD}{MOTION}{long('1 ')}\n1\n"}, "Frame 1 does not consist of 1"),
    "number": (lambda: {"bvh": f"{HEAD}{MOTION}{long('1')}\n1\n"}, ""),
    "blank row": (lambda: {"bvh": f"{HEAD}{MOTION}{long(' ')}\n1\n"}, ""),
    "count": (lambda: {"bvh": f"{HEAD}{MOTION.replace('1', '9' * 5000, 1)}1\n"}, ""),
    "endless count": (lambda: {"bvh": f"{HEAD}{MOTION.replace('1', long('9'), 1)}1\n"}, ""),
    "still joints": (lambda: {"bvh": STATIC + "1\n" * 100_000}, "are too many for a file"),
    "bones": (lambda: {"asf": chain_asf(NEST)}, "more than 10000 bones|too long"),
    "still bones": (lambda: {"asf": chain_asf(9000), "amc": ROOT * 10_000}, "are too many for a"),
    "empty frames": (lambda: {"amc": "1\n" * MEGABYTE}, "does not have the bones"),
    "values": (lambda: {"amc": f"1\nroot {long('1 ')}\n2\n"}, "Frame 1 has no 6 values"),
    "comment": (lambda: {"amc": long("#")}, "ends before its first frame"),
    "frame number": (lambda: {"amc": long("9") + "\nroot 1 2 3 4 5 6\n"}, ""),
}


@pytest.mark.parametrize("name", HUGE)
def test_no_file_takes_far_more_memory_than_its_size(name: str, tmp_path: Path) -> None:
    make, message = HUGE[name]
    files = make()
    size = sum(map(len, files.values()))
    tracemalloc.start()
    try:
        if message:
            with pytest.raises(MocapmendError, match=message) as caught:
                read(tmp_path, **files)  # type: ignore[arg-type]
            refused(caught, tmp_path)
        else:
            source = read(tmp_path, **files)  # type: ignore[arg-type]
            assert source.recording.frames >= 1
            assert sum(map(len, source.warnings)) < 2000
        _, peak = tracemalloc.get_traced_memory()
    finally:
        tracemalloc.stop()
    assert peak < 6 * size + 100 * MEGABYTE


def flip(raw: bytearray, rng: random.Random) -> None:
    for _ in range(rng.choice([1, 3, 20])):
        raw[rng.randrange(len(raw))] ^= 1 << rng.randrange(8)


def cut(raw: bytearray, rng: random.Random) -> None:
    del raw[rng.randrange(len(raw)) :]


def cut_out(raw: bytearray, rng: random.Random) -> None:
    at = rng.randrange(len(raw))
    del raw[at : at + rng.choice([1, 2, 10, 100, 500])]


def splice(raw: bytearray, rng: random.Random) -> None:
    start, to = rng.randrange(len(raw)), rng.randrange(len(raw))
    raw[to:to] = raw[start : start + rng.choice([1, 4, 50, 300])]


def number(raw: bytearray, rng: random.Random) -> None:
    digits = [i for i, byte in enumerate(raw) if chr(byte).isdigit()]
    if digits:
        at = rng.choice(digits)
        raw[at : at + 1] = rng.choice([b"nan", b"inf", b"1e308", b"-", b"999999999999", b"1e-320"])


def word(raw: bytearray, rng: random.Random) -> None:
    words = bytes(raw).split(b" ")
    one, other = rng.randrange(len(words)), rng.randrange(len(words))
    words[one], words[other] = words[other], words[one]
    raw[:] = b" ".join(words)


MUTATIONS: list[Callable[[bytearray, random.Random], None]] = [
    flip, cut, cut_out, splice, number, word,
]  # fmt: skip


@pytest.mark.parametrize("kind", ["bvh", "asf", "amc"])
def test_mutants_open_or_are_refused(kind: str, tmp_path: Path) -> None:
    original = {"bvh": BVH, "asf": ASF, "amc": AMC}[kind].encode()
    rng = random.Random(kind)
    opened = 0
    for _ in range(MUTANTS):
        raw = bytearray(original)
        for mutate in rng.choices(MUTATIONS, k=rng.choice([1, 1, 2])):
            if raw:
                mutate(raw, rng)
        files: dict[str, str | bytes] = {"amc": AMC} if kind == "asf" else {}
        files[kind] = bytes(raw) or b" "
        try:
            source = read(tmp_path, **files)  # type: ignore[arg-type]
        except MocapmendError as error:
            assert error.what.endswith(".")
            continue
        opened += 1
        assert_sound(source)
    assert opened > MUTANTS // 8


def assert_sound(source: Source) -> None:
    recording = source.recording
    assert recording.points.shape[1] == len(recording.labels) > 0
    assert recording.frames > 0
    assert np.isfinite(recording.points[recording.present]).all()
    assert np.isnan(recording.points[~recording.present]).all()
    assert np.isfinite(recording.points[recording.present] ** 2).all()
    assert all(0 <= a < b < recording.markers for a, b in source.bones)
    assert all(label and label.isprintable() for label in recording.labels)
    assert all(text.endswith(".") for text in source.warnings)
    assert source.truncated == (recording.frames < source.frames_promised)
