"""Real files: the bundled ones, and the shared ones with the figures of their manifest."""

import hashlib
import json
import re
import subprocess
import sys
import warnings
from dataclasses import dataclass
from importlib.util import find_spec
from pathlib import Path

import c3d
import numpy as np
import pytest

from mocapmend.errors import MocapmendError
from mocapmend.files import (
    C3DFile,
    Claim,
    RepairRecord,
    SampleRun,
    check_files,
    read_c3d,
    save_patched,
)
from mocapmend.files.c3d_group import NAME
from mocapmend.files.c3d_head import leading_blocks, remove_group
from mocapmend.files.c3d_samples import marked_missing, point_words, read_blocks, unmarked_missing
from mocapmend.files.c3d_target import plan
from mocapmend.files.provenance import Provenance
from mocapmend.files.second_reader import REFUSALS
from mocapmend_algorithms import find_gaps

SHARED = Path(__file__).resolve().parents[3] / "shared" / "data"
SAMPLES = Path(__file__).resolve().parents[2] / "resources" / "mocapmend_resources" / "samples"
KINDS = {"INTEL": "Intel", "DEC": "DEC", "MIPS": "MIPS"}


@dataclass(frozen=True)
class Row:
    """What the manifest says of a file."""

    path: Path
    kind: str
    frames: int
    rate: float
    points: int
    markers: int | None
    unit: str
    missing: float
    gaps: str
    analog: int
    plates: str
    events: int | None


def manifest() -> list[Row]:
    """Parse the tables of the manifest; none without the shared folder."""
    rows = []
    folder = ""
    table = SHARED / "MANIFEST.md"
    for line in table.read_text("utf-8").splitlines() if table.is_file() else ():
        if line.startswith("## "):
            folder = line.split()[1].strip("/")
        cells = [cell.strip() for cell in line.split("|")[1:-1]]
        if len(cells) != 13 or not cells[0].lower().endswith(".c3d") or cells[3] == "-":
            continue
        points = re.fullmatch(r"(\d+) \((\d+|-)\)", cells[6])
        rest = re.match(r"A(\d+) FP(\S+) ev(\d+|-)", cells[11])
        assert points and rest, line
        rows.append(
            Row(
                SHARED / folder / cells[0], cells[3], int(cells[4]), float(cells[5]),
                int(points[1]), None if points[2] == "-" else int(points[2]), cells[7],
                float(cells[8]), cells[9], int(rest[1]), rest[2],
                None if rest[3] == "-" else int(rest[3]),
            )
        )  # fmt: skip
    return rows


ROWS = manifest()
FILES = [*sorted(SAMPLES.glob("*.c3d")), *(row.path for row in ROWS)]
INTEGERS = [row.path for row in ROWS if row.kind.endswith("int") and row.missing > 0]
each_row = pytest.mark.parametrize("row", ROWS, ids=lambda row: row.path.stem)
each_file = pytest.mark.parametrize("path", FILES, ids=lambda path: path.stem)


def stored_words(file: C3DFile) -> np.ndarray:
    """Return what is stored of all points, model outputs included, shape (frames, points, 4)."""
    layout = file.layout
    words = np.zeros((layout.frames, layout.points, 4), np.float32 if layout.is_float else np.int16)
    with file.path.open("rb", buffering=0) as stream:
        for first, block in read_blocks(stream, layout, ""):
            words[first : first + len(block)] = point_words(block, layout)
    return words


@np.errstate(all="ignore")
def missing_of_all_points(file: C3DFile) -> np.ndarray:
    """Whether each stored point is missing, model outputs included as in the manifest."""
    words = stored_words(file)
    marked = marked_missing(words[..., 3])
    return marked | unmarked_missing(words, marked)


def fourth_words(file: C3DFile) -> np.ndarray:
    """Return the fourth words as signed numbers: cameras in the high byte, residual in the low."""
    return stored_words(file)[..., 3].astype(np.int16)


@each_row
def test_figures_of_the_manifest(row: Row) -> None:
    file = read_c3d(row.path)
    recording, layout = file.recording, file.layout
    kind = f"{KINDS[layout.processor.name]} {'float' if layout.is_float else 'int'}"
    assert (kind, layout.frames) == (row.kind, row.frames)
    assert recording.rate == pytest.approx(row.rate, abs=0.006)
    assert layout.points == row.points
    assert recording.markers == (row.points if row.markers is None else row.markers)
    # "mete" is what is left of "metres" in four letters.
    assert recording.unit == {"": "mm", "mete": "m"}.get(row.unit, row.unit)
    share = missing_of_all_points(file).mean() if layout.frames and layout.points else 0.0
    assert 100 * share == pytest.approx(row.missing, abs=0.051)
    if row.gaps != "-":
        gaps = find_gaps(recording.present)
        interior = [gap.length for gap in gaps if gap.kind(recording.frames) == "interior"]
        assert f"{len(interior)}/{max(interior, default=0)}" == row.gaps
    assert layout.channels * layout.analog_samples == row.analog
    # "2t4" are two plates of type 4; "-" is a file without such a group.
    types = "".join(sorted({f"t{plate.type}" for plate in file.force_plates}))
    assert f"{len(file.force_plates)}{types}" == row.plates.replace("-", "0")
    assert any(key.startswith("FORCE_PLATFORM:") for key in layout.parameters) == (
        row.plates != "-"
    )
    assert len(file.events) == (row.events or 0) or row.events is None


@pytest.mark.parametrize(
    ("name", "missing"),
    [("btk_FunctionalStatic", 20_960), ("ktk_kinematics_tennis_serve_nan", 145)],
)
def test_known_numbers_of_missing_samples(name: str, missing: int, shared: Path) -> None:
    recording = read_c3d(shared / "c3d" / f"{name}.c3d").recording
    assert np.count_nonzero(~recording.present) == missing


def test_six_encodings_of_one_recording(shared: Path) -> None:
    files = [read_c3d(shared / "c3d" / f"btk_Eb015{kind}.c3d") for kind in
             ("pi", "pr", "si", "sr", "vi", "vr")]  # fmt: skip
    first = files[0]
    assert [event.label for event in first.events] == ["RIC", "RHS", "RTO"]
    for file in files[1:]:
        assert file.recording.points.tobytes() == first.recording.points.tobytes()
        np.testing.assert_array_equal(file.residuals, first.residuals)
        np.testing.assert_array_equal(fourth_words(file), fourth_words(first))
        np.testing.assert_array_equal(file.read_analog(), first.read_analog())
        assert file.recording.labels == first.recording.labels
        assert file.analog_labels == first.analog_labels
        assert file.events == first.events
        for one, other in zip(file.force_plates, first.force_plates, strict=True):
            assert (one.type, one.channels) == (other.type, other.channels)
            np.testing.assert_array_equal(one.corners, other.corners)


def test_traps_of_single_files(shared: Path) -> None:
    folder = shared / "c3d"
    with pytest.raises(MocapmendError, match="empty"):
        read_c3d(folder / "btk_Empty.c3d")
    optotrak = read_c3d(folder / "ezc3d_Optotrak.c3d")
    assert optotrak.truncated
    assert any("1149 frames, but only 29" in text for text in optotrak.warnings)
    # With POINT:SCALE instead of the header's scale these shoulders were 57 cm high.
    adult = read_c3d(folder / "btk_MACsample.c3d").recording
    shoulder = adult.points[:, adult.labels.index("RSHO"), 2]
    assert 1400 < np.nanmean(shoulder) < 1550
    # Qualisys says -Z of data that have Z up.
    assert read_c3d(folder / "ktk_Qualisys.c3d").recording.up == "+z"
    assert read_c3d(folder / "btk_standing.C3D").recording.up == "+y"
    # MotionMonitor: the header counts the samples of a frame for channels.
    assert read_c3d(folder / "btk_FP1.C3D").layout.channels == 12
    # More than 255 points and channels.
    many = read_c3d(folder / "mzoo_HC030A22.c3d")
    assert len(many.layout.parameters.texts("POINT:LABELS")) >= many.layout.points == 296
    assert not any(label.startswith("point ") for label in many.recording.labels)
    shadow = read_c3d(folder / "ktk_many_analogs.c3d")
    assert len(shadow.analog_labels) == 922
    assert not any(label.startswith("channel ") for label in shadow.analog_labels)
    subject = read_c3d(shared / "cmu_markers" / "cmu_02_01.c3d").recording
    assert all(label.startswith("TakeoMonday:") for label in subject.labels)
    # EVa states type 2 with the matrices of type 4; here the second plate was not recorded.
    for name, text in (("btk_type-2a", "calibration matrix"), ("btk_shd01", "analog channels")):
        assert any(text in warning for warning in read_c3d(folder / f"{name}.c3d").warnings)
    for name in ("btk_1123x01EMG", "ezc3d_Kistler", "ktk_C3DRotationExample", "btk_Analysis"):
        file = read_c3d(folder / f"{name}.c3d")
        assert file.recording.markers == 0
        assert any("nothing to repair" in text for text in file.warnings)


@pytest.mark.parametrize(
    ("name", "first"),
    [
        ("ktk_sprintbasket", 0), ("ezc3d_read_NOTworking2", 0), ("btk_FunctionalWalk", 480),
        ("btk_FunctionalStatic", 16), ("biobuddy_static_lower_body", 1153),
    ],
)  # fmt: skip
def test_known_first_frames(name: str, first: int, shared: Path) -> None:
    assert read_c3d(shared / "c3d" / f"{name}.c3d").recording.first_frame == first


@each_file
def test_events_lie_in_the_recording(path: Path) -> None:
    file = read_c3d(path)
    assert all(0 <= event.frame <= file.recording.frames for event in file.events)


def test_events_count_from_frame_1(samples: Path, shared: Path) -> None:
    # Counted from the first stored frame, all of them would lie outside.
    gait = read_c3d(samples / "gait_plug_in_gait.c3d")
    assert {(event.label, event.context) for event in gait.events} == {
        (label, side) for label in ("Foot Strike", "Foot Off") for side in ("Left", "Right")
    }
    assert all(abs(event.frame - round(event.frame)) < 0.001 for event in gait.events)
    walk = read_c3d(shared / "c3d" / "btk_FunctionalWalk.c3d")
    for file in (gait, walk):
        assert all(0 <= event.frame < file.recording.frames for event in file.events)


@pytest.mark.parametrize(
    ("name", "oddities"),
    [
        ("MoCapTools_static_01", []),
        ("opensim_walking5", []),
        ("btk_MACsample", ["scale (0.0551136) and POINT:SCALE (0.0215412)", "12 points have"]),
        ("btk_badParameterOffset", ["scale (-1) and POINT:SCALE (-0.01) differ; -0.01 is used"]),
        ("btk_Dance", ["(POINT:FRAMES 500, the header 499); 499 is used"]),
        ("btk_PiG_Motion-FlatFoot-One", ["more than once, and the first is used: PROCESSING:BODY"]),
        ("btk_parameterOverflow", ["10706 samples are exactly (0, 0, 0)"]),
        ("ktk_kinematics_tennis_serve_nan", ["145 samples are", "+z is a guess"]),
        ("ktk_duplicate_labels", ["26 points have the label of another"]),
        ("ktk_Qualisys", ["says that -z points up"]),
    ],
)
def test_what_is_odd_about_a_file_is_said(name: str, oddities: list[str], shared: Path) -> None:
    found = read_c3d(shared / "c3d" / f"{name}.c3d").warnings
    assert len(found) == len(oddities)
    for warning, text in zip(found, oddities, strict=True):
        assert text in warning


def test_bundled_samples(samples: Path) -> None:
    found = {}
    for path in samples.glob("*.c3d"):
        file = read_c3d(path)
        recording = file.recording
        shape = (recording.frames, recording.markers, recording.rate, recording.unit)
        missing = int(np.count_nonzero(~recording.present))
        found[path.stem] = (*shape, missing, len(file.events))
    assert found["gait_plug_in_gait"] == (293, 56, 100.0, "mm", 802, 12)
    assert found["sprint_basketball"] == (3678, 26, 120.0, "m", 37_068, 0)
    assert found["walk_cmu_02_01"] == (343, 41, 120.0, "mm", 0, 0)


@each_file
def test_the_c3d_library_reads_the_same(path: Path) -> None:
    file = read_c3d(path)
    with warnings.catch_warnings(), path.open("rb") as stream:
        warnings.simplefilter("ignore")
        try:
            reader = c3d.Reader(stream)
            read = [(points, analog.T) for _, points, analog in reader.read_frames()]
            labels = [str(label).strip(" \0") for label in reader.point_labels]
        except REFUSALS as error:
            pytest.skip(f"the c3d library refuses it: {error!r}")
    recording, layout = file.recording, file.layout
    assert len(read) == layout.frames
    assert reader.first_frame == recording.first_frame
    assert reader.point_rate == pytest.approx(recording.rate)
    shown = [labels[i] for i in file.marker_points if i < len(labels)]
    assert [one for one, other in zip(recording.labels, shown, strict=False) if other] == [
        label for label in shown if label
    ]
    theirs = np.array([points for points, _ in read]).reshape(layout.frames, layout.points, 5)[
        :, list(file.marker_points)
    ]
    present = recording.present
    # It takes 65535.0 and exact zeros for valid samples; what it calls missing we do too.
    assert not (present & (theirs[..., 3] < 0)).any()
    extra = ~present & (theirs[..., 3] >= 0)
    assert (theirs[extra][:, :3] == 0).all()
    np.testing.assert_array_equal(recording.points[present], theirs[present][:, :3])
    np.testing.assert_allclose(file.residuals[present], theirs[present][:, 3], rtol=1e-6)
    # Of one file the library finds no group but POINT, and so no scales.
    if layout.channels and "ANALOG" in reader:
        analog = np.concatenate([analog for _, analog in read])
        np.testing.assert_array_equal(file.read_analog(), analog)


EZC3D = """
import ezc3d, json, numpy, sys
for number, path in enumerate(sys.argv[2:]):
    try:
        file = ezc3d.c3d(path)
    except (OSError, RuntimeError, ValueError):
        continue
    labels = {group: file["parameters"][group].get("LABELS", {"value": []})["value"]
              for group in ("POINT", "ANALOG")}
    numpy.savez(
        f"{sys.argv[1]}/{number}.npz",
        points=file["data"]["points"].transpose(2, 1, 0)[..., :3],
        analog=file["data"]["analogs"][0].T,
        labels=json.dumps(labels),
    )
"""
SMALL = [path for path in FILES if path.exists() and path.stat().st_size < 400_000]
"""It is slow."""
MISREAD_BY_EZC3D = {"btk_standing"}
"""Files that state no frame rate among their parameters."""
OFFSETS_OF_EZC3D = {"btk_Analysis", "btk_shd01"}
"""It takes a negative offset for a positive one; the c3d library agrees with us."""


@pytest.fixture(scope="module")
def ezc3d_results(tmp_path_factory: pytest.TempPathFactory) -> Path:
    """Return a folder of what ezc3d reads in each file that it does not refuse."""
    if find_spec("ezc3d") is None:
        pytest.skip("ezc3d is not installed")
    folder = tmp_path_factory.mktemp("ezc3d")
    # In a process of its own: it may crash.
    command = [sys.executable, "-c", EZC3D, folder, *SMALL]
    subprocess.run(list(map(str, command)), check=True, capture_output=True)
    return folder


@pytest.mark.parametrize("path", SMALL, ids=lambda path: path.stem)
def test_ezc3d_reads_the_same(path: Path, ezc3d_results: Path) -> None:
    result = ezc3d_results / f"{SMALL.index(path)}.npz"
    if path.stem in MISREAD_BY_EZC3D or not result.is_file():
        pytest.skip("ezc3d refuses it or misreads it")
    theirs = np.load(result)
    file = read_c3d(path)
    recording, layout = file.recording, file.layout
    labels = json.loads(str(theirs["labels"]))
    if recording.frames and recording.markers:
        markers = list(file.marker_points)
        named = [labels["POINT"][i] for i in markers if i < len(labels["POINT"])]
        assert [label.strip() for label in named] == list(recording.labels[: len(named)])
        points = theirs["points"][:, markers][recording.present]
        # We scale integers as 32-bit floats, like the c3d library.
        np.testing.assert_allclose(points, recording.points[recording.present], rtol=2e-7)
    if layout.channels and path.stem not in OFFSETS_OF_EZC3D:
        np.testing.assert_allclose(file.read_analog(), theirs["analog"], rtol=1e-12)
        stated = [label.strip() for label in labels["ANALOG"]][: layout.channels]
        assert [label for label in file.analog_labels[: len(stated)] if label in stated] == [
            label for label in stated if label
        ]


def some_runs(file: C3DFile) -> list[SampleRun]:
    """Return other values for 5 % of each marker's frames."""
    rng = np.random.default_rng(7)
    recording = file.recording
    count = max(recording.frames // 20, 1)
    runs = []
    for marker in range(recording.markers if recording.frames else 0):
        start = int(rng.integers(0, recording.frames - count + 1))
        values = np.nan_to_num(recording.points[start : start + count, marker], nan=10.0)
        values += rng.normal(size=values.shape) * 3 / recording.mm
        values[0] = np.nan
        # Integers close to the limit cannot grow.
        layout = file.layout
        limit = np.inf if layout.is_float else 32767 * layout.scale
        runs.append(SampleRun(marker, start, np.clip(values, -limit, limit)))
    return runs


@each_file
def test_save_and_check(path: Path, tmp_path: Path) -> None:
    file = read_c3d(path)
    out = tmp_path / "out.c3d"
    save_patched(file, [], out, accept_truncated=True)
    assert hashlib.sha256(out.read_bytes()).digest() == hashlib.sha256(path.read_bytes()).digest()
    runs = some_runs(file)
    saved = save_patched(file, runs, out, accept_truncated=True)
    assert saved.samples == sum(len(run.values) for run in runs)
    report = check_files(path, out)
    # These runs overwrite measured samples: the check finds them, and nothing outside of them.
    assert all(text.startswith("Marker ") for text in report.other_differences)
    found = {
        (run.point, frame)
        for run in report.changed
        for frame in range(run.first_frame, run.last_frame + 1)
    }
    first = file.recording.first_frame
    written = {
        (file.marker_points[run.marker], first + frame)
        for run in runs
        for frame in range(run.start, run.start + len(run.values))
    }
    assert found <= written
    assert bool(found) == bool(runs)
    assert "all else is the same" in (sentence := Claim.of(file, out, runs).confirm()) or (
        sentence.startswith("No second check")
    )
    again = read_c3d(out)
    touched = np.zeros(file.recording.present.shape, bool)
    for run in runs:
        touched[run.start : run.start + len(run.values), run.marker] = True
    np.testing.assert_array_equal(again.recording.points[~touched], file.recording.points[~touched])
    np.testing.assert_array_equal(again.residuals[~touched], file.residuals[~touched])


@each_file
def test_the_repair_record_fits_into_the_file(path: Path) -> None:
    source = read_c3d(path)
    records = tuple(RepairRecord("M", i, 1, 2, "cubic") for i in range(1, 40))
    target = plan(source, Provenance(records, ("0" * 64,)), to_float=False)
    assert target.record == "group"
    blocks = leading_blocks(target.head, target.layout, NAME)
    head = path.read_bytes()[: source.layout.data_start]
    assert remove_group(target.head, target.layout, blocks) == head


@pytest.mark.parametrize("path", INTEGERS, ids=lambda path: path.stem)
def test_integers_become_floats_that_decode_the_same(path: Path, tmp_path: Path) -> None:
    source = read_c3d(path)
    gap, first = find_gaps(source.recording.present)[0], source.recording.first_frame
    run = SampleRun(gap.marker, gap.start, np.full((gap.length, 3), 1e6))
    point = source.stored_points[gap.marker] + 1
    record = RepairRecord("M", point, first + gap.start, first + gap.stop - 1, "cubic")
    saved = save_patched(source, [run], tmp_path / "out.c3d", repairs=[record])
    assert saved.converted
    floats = read_c3d(saved.path)
    points = source.recording.points.copy()
    points[gap.start : gap.stop, gap.marker] = 1e6
    np.testing.assert_array_equal(floats.recording.points, points)
    present = source.recording.present
    np.testing.assert_array_equal(floats.residuals[present], source.residuals[present])
    np.testing.assert_array_equal(floats.read_analog(), source.read_analog())
    assert floats.events == source.events
    assert check_files(path, saved.path).passed
    Claim.of(source, saved.path, [run]).confirm()
