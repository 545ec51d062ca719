"""What packages without Qt say is in the catalogue, and found again there."""

import ast
from collections import Counter
from collections.abc import Iterator
from dataclasses import fields, replace
from itertools import count, product
from pathlib import Path
from typing import Literal, get_args, get_origin, get_type_hints

import numpy as np
import pytest
from PySide6.QtCore import QCoreApplication
from refine_networks import copying, write_kinect22, write_network

from mocapmend import training
from mocapmend.bench.hunt import Plan
from mocapmend.bench.seeds import all_seeds
from mocapmend.engine import Changes, export, load, smooth
from mocapmend.errors import MocapmendError
from mocapmend.files import check_files, read_recording
from mocapmend.refine.card import CAUTION, NEW_PEOPLE, card_rows
from mocapmend.refine.measuring import FILTERED, NETWORK, RIDGE
from mocapmend.refine.models import load_model
from mocapmend.refine.profiles import profile_named, profiles
from mocapmend.refine.running import refine_file
from mocapmend.report import refining_text
from mocapmend.views.catalogue.detectors import DETECTORS as DETECTOR_TEXTS
from mocapmend.views.catalogue.methods import METHODS as METHOD_TEXTS
from mocapmend.views.catalogue.qt import QT
from mocapmend.views.catalogue.segments import SEGMENTS
from mocapmend.views.catalogue.smoothing import SMOOTHERS as SMOOTHER_TEXTS
from mocapmend.views.engine_texts import (
    SENTENCES,
    error_text,
    find,
    method_name,
    segment_name,
    shown,
)
from mocapmend.views.model_card import WORDS
from mocapmend.views.suspect_texts import REST
from mocapmend_algorithms import Gap, Recording, find_gaps, no_progress
from mocapmend_algorithms.fill.limits import Limits, fill_within
from mocapmend_algorithms.fill.registry import FAMILIES, METHODS
from mocapmend_algorithms.problems import detect
from mocapmend_algorithms.problems.registry import DETECTORS
from mocapmend_algorithms.refine.refining import RefineParams
from mocapmend_algorithms.smooth.registry import SMOOTHERS
from mocapmend_algorithms.sparse.training_set import TrainingSetError, read_training_set
from mocapmend_resources.skeletons import load as templates

ROOT = Path(__file__).resolve().parent.parent.parent
SPOKEN = (
    *sorted((ROOT / "app/mocapmend/files").rglob("*.py")),
    *sorted((ROOT / "app/mocapmend/journal").rglob("*.py")),
    *(
        ROOT / f"app/mocapmend/{name}.py"
        for name in (
            *("engine", "jobs", "label_templates", "plan", "recipe", "recipe_plan"),
            *("replaying", "training", "user_templates", "companion"),
            *("refine/apart", "refine/card", "refine/models", "refine/running"),
        )
    ),
    ROOT / "app/mocapmend/report/writing.py",
    ROOT / "app/mocapmend/views/recovery.py",
    ROOT / "algorithms/mocapmend_algorithms/zip_arrays.py",
)
"""Modules whose sentences reach the window."""
COMPOSED = {
    "7 in 7.",
    "7 measured sample7 7; the repair record lists them.",
    "7 of 7 7 are not in the file any more7.",
    "7 sample7 changed places between markers; the repair record lists them.",
    "Marker 7: 77, the first at frame 7.",
    "Samples 7 are taken as missing: 7.",
    "The file holds no 3D markers7.",
    "The file holds no markers7.",
    "The file holds no trajectories7.",
    "The file states 7; 7 is assumed from the size of its numbers.",
    ", or one that ships with the program: 7.",
}
"""Made of parts: the catalogue has what they can become."""


def sentences() -> Iterator[tuple[str, str]]:
    """Yield place and text of every whole sentence in the source, with 7 where it changes."""
    for path in SPOKEN:
        tree = ast.parse(path.read_text(encoding="utf-8"))
        inner = {id(node.value) for node in ast.walk(tree) if isinstance(node, ast.Expr)}
        for node in ast.walk(tree):
            if isinstance(node, ast.JoinedStr):
                inner |= {id(part) for part in ast.walk(node) if part is not node}
        for node in ast.walk(tree):
            if id(node) not in inner:
                for text in _variants(node):
                    if " " in text and text.endswith(".") and not text[0].islower():
                        yield f"{path.name}:{getattr(node, 'lineno', 0)}", text


def _variants(node: ast.AST) -> list[str]:
    """Return the texts that a literal or an f-string can be."""
    if isinstance(node, ast.Constant) and isinstance(node.value, str):
        return [node.value]
    parts = [_part(part) for part in node.values] if isinstance(node, ast.JoinedStr) else []
    return ["".join(chosen) for chosen in product(*parts)] if parts else []


def _part(part: ast.expr) -> list[str]:
    if isinstance(part, ast.Constant):
        return [str(part.value)]
    value = part.value if isinstance(part, ast.FormattedValue) else None
    if isinstance(value, ast.IfExp):
        chosen = (value.body, value.orelse)
        if all(isinstance(each, ast.Constant) for each in chosen):
            return [str(each.value) for each in chosen if isinstance(each, ast.Constant)]
    return ["7"]


def _texts_of(params: type) -> set[str]:
    """Return the labels, helps and choices of a parameter class."""
    found, hints = set(), get_type_hints(params)
    for entry in fields(params):
        found |= {entry.metadata["label"], entry.metadata["help"]}
        for hint in (hints[entry.name], *get_args(hints[entry.name])):
            found |= set(get_args(hint)) if get_origin(hint) is Literal else set()
    return found


def test_catalogue_of_methods_is_what_the_table_has() -> None:
    wanted: list[str] = [*FAMILIES]
    for method in METHODS.values():
        wanted += [method.label, method.help, *_texts_of(method.params)]
    assert set(METHOD_TEXTS) == set(wanted)
    assert Counter(METHOD_TEXTS).most_common(1)[0][1] == 1


def test_catalogue_of_detectors_is_what_the_table_has() -> None:
    wanted = [text for each in DETECTORS.values() for text in (each.label, each.help)]
    assert set(DETECTOR_TEXTS) == set(wanted)
    assert Counter(DETECTOR_TEXTS).most_common(1)[0][1] == 1


def test_catalogue_of_smoothing_methods_is_what_their_table_has() -> None:
    wanted = {text for each in SMOOTHERS.values() for text in (each.label, each.help)}
    for smoother in SMOOTHERS.values():
        wanted |= _texts_of(smoother.params)
    assert set(SMOOTHER_TEXTS) == wanted - set(METHOD_TEXTS)
    assert Counter(SMOOTHER_TEXTS).most_common(1)[0][1] == 1


def test_catalogue_lists_each_sentence_once_with_numbered_places() -> None:
    assert Counter(SENTENCES).most_common(1)[0][1] == 1
    for text in SENTENCES:
        numbers = count()
        while "{" in text:
            place = f"{{{next(numbers)}}}"
            assert place in text
            text = text.replace(place, "", 1)


def test_every_sentence_of_the_source_is_in_the_catalogue() -> None:
    missing = {text: place for place, text in sentences() if find(text) is None}
    assert {text: missing[text] for text in set(missing) - COMPOSED} == {}
    assert set(missing) >= COMPOSED, "no longer said, or listed now"


def test_every_sentence_is_found_with_its_own_parts() -> None:
    for text in SENTENCES:
        filled = text.format(*"987654")
        found = find(filled)
        assert found is not None
        assert found[0].format(*found[1]) == filled


def test_damaged_files_say_what_the_catalogue_has(tmp_path: Path) -> None:
    plan, unknown, known = Plan(all_seeds(), seed=3), set(), set()
    for number in range(600):
        folder = tmp_path / str(number)
        folder.mkdir()
        try:
            path = plan.write(number, folder)
            said = list(load(path, no_progress)[0].warnings)
        except MocapmendError as error:
            said = [error.what, error.todo]
        for text in filter(None, said):
            found = find(text)
            unknown |= set() if found else {text}
            known |= {found[0]} if found else set()
    assert unknown == set()
    assert len(known) > 40


def reasons(recording: Recording, gaps: list[Gap], *, quick: bool) -> set[str]:
    """Return why methods leave gaps open, with limits that little passes and without any."""
    said = set()
    for method in METHODS.values():
        if quick and method.family in ("Low rank", "Sparse"):
            continue
        for limits in (Limits(), Limits(max_gap=3), Limits(max_error_mm=0.01)):
            result = fill_within(recording, gaps, method, method.params(), limits, no_progress)
            said |= {entry.reason for entry in result.unfilled}
    return said


def unlisted(said: set[str]) -> set[str]:
    """Return what is not in the catalogue."""
    return {reason for reason in said if find(reason) is None}


def test_reasons_on_real_gaps_are_in_the_catalogue(samples: Path) -> None:
    recording = read_recording(samples / "gait_plug_in_gait.c3d").recording
    gaps = find_gaps(recording.present)
    said = reasons(recording, [*gaps[:8], *gaps[-4:]], quick=True)
    assert unlisted(said) == set()
    assert len({find(reason) for reason in said}) > 5


def test_reasons_of_bad_samples_are_in_the_catalogue(samples: Path, spoilt_walk: Path) -> None:
    said = set()
    for path in (spoilt_walk, *sorted(samples.glob("*.c3d"))):
        source, skeleton = load(path, no_progress)
        recording = source.measured
        if not (recording.frames > 158 and recording.markers > 15):
            continue
        points = recording.points.copy()
        # Frozen for a while, twice in one place, far away.
        points[150:158, 12] = points[150, 12]
        points[40:60, 14] = points[40:60, 15] + 0.1 / recording.mm
        points[60:62, 13] += 9000.0 / recording.mm
        found = detect(recording.with_points(points), skeleton, None, no_progress)
        said |= {run.reason.removesuffix(REST).removesuffix(".") + "." for run in found}
    assert unlisted(said) == set()
    assert len({find(reason) for reason in said}) > 6


def moving(frames: int, markers: int) -> np.ndarray:
    """Return points that move smoothly, in no cycles."""
    time = np.linspace(0.0, 1.0, frames)[:, None, None]
    place = np.arange(markers)[None, :, None]
    axis = np.arange(3)[None, None, :]
    return 1000.0 + 100.0 * place + 50.0 * np.sin((3 + axis) * time**2 + place)


@pytest.mark.parametrize(
    ("frames", "markers", "hidden"),
    [
        (40, 1, slice(10, 20)),
        (40, 1, slice(0, 10)),
        (40, 1, slice(30, 40)),
        (40, 1, slice(0, 40)),
        (4, 2, slice(1, 3)),
        (3, 6, slice(1, 3)),
        (12, 2, slice(2, 10)),
        (40, 6, slice(1, 39)),
        (200, 3, slice(50, 150)),
        (200, 6, slice(0, 100)),
    ],
)
def test_reasons_on_poor_recordings_are_in_the_catalogue(
    frames: int, markers: int, hidden: slice
) -> None:
    points = moving(frames, markers)
    points[hidden, 0] = np.nan
    labels = tuple(f"M{i}" for i in range(markers))
    recording = Recording(points, rate=100.0, labels=labels, unit="mm")
    said = reasons(recording, find_gaps(recording.present), quick=False)
    assert said
    assert unlisted(said) == set()


def test_reasons_about_chosen_donors_and_edges_are_in_the_catalogue() -> None:
    points = moving(100, 7)
    points[40:50, 0] = np.nan
    points[45:60, 1] = np.nan
    points[39, 2] = np.nan
    points[:10, 3] = np.nan
    recording = Recording(points, rate=100.0, labels=tuple("ABCDEFF"), unit="mm")
    gaps = find_gaps(recording.present)
    said = set()
    for method in METHODS.values():
        names = {entry.name for entry in fields(method.params)}
        choices = [("donors", (donor,)) for donor in "ABCEFX"] + [("edges", "leave")]
        for name, value in choices:
            if name in names:
                params = replace(method.params(), **{name: value})
                found = fill_within(recording, gaps, method, params, Limits(), no_progress)
                said |= {entry.reason for entry in found.unfilled}
    assert unlisted(said) == set()
    templates = {found[0] for found in map(find, said) if found is not None}
    assert {
        "there is no marker {0} to take as a donor",
        "{0} markers are called {1}: it cannot be a donor",
        "{0} cannot be its own donor",
        "the donor {0} is missing in the gap too",
        "the donor {0} is missing at an edge of the gap",
        "it takes {0} donors and was given {1}",
    } <= templates


@pytest.mark.parametrize("name", sorted(SMOOTHERS))
def test_what_smoothers_refuse_is_in_the_catalogue(name: str) -> None:
    recording = Recording(moving(60, 2), ("A", "B"), 100.0, unit="mm")
    kind = SMOOTHERS[name].params
    wrong = {
        "cutoff_hz": (50.0, 1e-3),
        "order": (0, 3),
        "window_ms": (10.0,),
        "noise_mm": (-1.0,),
    }
    names = {entry.name for entry in fields(kind)} & set(wrong)
    told = []
    choices = [{key: value} for key in names for value in wrong[key]]
    for chosen in [*choices, {"cutoff_hz": 6.0, "noise_mm": 1.0}]:
        if set(chosen) <= names:
            try:
                smooth(recording, [Gap(0, 0, 60)], name, kind(**chosen), no_progress)
            except MocapmendError as error:
                told.append(error)
    assert told
    for error in told:
        template, parts = find(error.what)
        assert template == "This cannot be smoothed: {0}."
        assert find(parts[0]) is not None, parts[0]
        assert find(error.todo) is not None


def test_why_stretches_are_not_smoothed_is_in_the_catalogue() -> None:
    points = moving(60, 3)
    points[1:, 0] = np.nan
    points[3:, 1] = np.nan
    points[:, 2] = np.nan
    recording = Recording(points, ("A", "B", "C"), 100.0, unit="mm")
    runs = [Gap(marker, 0, 60) for marker in range(3)]
    for name, smoother in SMOOTHERS.items():
        made = smooth(recording, runs, name, smoother.params(), no_progress)
        assert len(made.untouched) == 3
        assert unlisted({entry.reason for entry in made.untouched}) == set()


def test_complaints_about_training_sets_are_in_the_catalogue(tmp_path: Path) -> None:
    (tmp_path / "broken.npz").write_bytes(b"PK")
    for path in (tmp_path / "none.npz", tmp_path, tmp_path / "broken.npz"):
        with pytest.raises(TrainingSetError) as caught:
            read_training_set(path)
        complaint = training.complaint(caught.value, str(path))
        assert find(complaint.what) is not None
        assert find(complaint.todo) is not None


def test_complaints_about_networks_are_in_the_catalogue(tmp_path: Path) -> None:
    (tmp_path / "broken.npz").write_bytes(b"PK")
    other = write_network(tmp_path / "other.npz")
    for path in (tmp_path / "none.npz", tmp_path, tmp_path / "broken.npz"):
        with pytest.raises(MocapmendError) as caught:
            load_model(str(path))
        assert find(caught.value.what) is not None
    joints = write_kinect22(tmp_path)
    source = read_recording(joints)
    points = source.recording.points.copy()
    points[1:, 4] = np.nan
    labels = source.recording.labels
    far = source.recording.points.copy()
    far[3, 4] = 1e6
    twice = replace(source.recording, labels=(labels[1], *labels[1:-1], labels[0]))
    for changed in (
        source.recording.with_points(points),
        source.recording.with_points(points[:1]),
        source.recording.with_points(far),
        replace(source.recording, rate=1e-3),
        replace(source.recording, labels=profile_named("kinect25-neuron59").inputs[:22]),
        replace(source.recording, labels=tuple(f"M{k}" for k in range(22))),
        twice,
    ):
        wrong = replace(source, recording=changed)
        with pytest.raises(MocapmendError) as caught:
            out = tmp_path / "o.c3d"
            refine_file(wrong, str(other), RefineParams(), out, None, (), False, no_progress)
        assert find(caught.value.what) is not None, caught.value.what
        assert find(caught.value.todo) is not None


def test_cards_are_in_the_catalogue() -> None:
    said = {CAUTION, NEW_PEOPLE, *(each.name for each in profiles().values())}
    said |= {refining_text.NONE_MEASURED, refining_text.NO_REFERENCE, refining_text.MEANINGS}
    for skip, perceptual in product((False, True), repeat=2):
        made = copying()
        shape = replace(made.shape, skip=skip, perceptual=perceptual)
        rows = dict(card_rows(replace(made, shape=shape)))
        assert set(rows) <= set(WORDS)
        said |= {rows["Trained on"], rows["Network"]}
    assert unlisted(said) == set()
    plain = dict(card_rows(replace(copying(), card={})))
    assert {plain[name] for name in ("About", "Held out", "Made by")} <= set(WORDS)
    assert {NETWORK, FILTERED, RIDGE} <= set(WORDS)


def test_findings_of_a_comparison_are_in_the_catalogue(
    repaired_gait: Path, gait: Path, tmp_path: Path
) -> None:
    raw = bytearray(repaired_gait.read_bytes())
    for place in range(2000, len(raw), 5000):
        raw[place] ^= 1
    broken = tmp_path / "broken.c3d"
    broken.write_bytes(raw)
    shorter = tmp_path / "shorter.c3d"
    shorter.write_bytes(gait.read_bytes()[:-600])
    for copy in (gait, repaired_gait, broken, shorter):
        found = check_files(gait, copy)
        said = {found.sentence, *found.allowed, *found.other_differences}
        assert unlisted(said) == set()


@pytest.mark.usefixtures("chinese")
class TestInChinese:
    def test_parts_are_put_in_and_translated_where_they_are_sentences(self) -> None:
        text = "12 frames (80 ms) is longer than the default limit of 7 frames (50 ms)"
        assert shown(text) == "12 帧 (80 ms) 超过默认限值 7 帧 (50 ms)"
        assert shown("fill LTIO (auto)") == "填补 LTIO (自动)"
        assert shown("fill linear (cubic)") == "填补 linear (三次样条)", "a marker of that name"
        assert shown("fill 3 gaps (auto)") == "填补 3 个缺失段 (自动)"
        assert shown("fix RELB, LWRA (swaps)") == "修正 RELB, LWRA (标签互换)"
        assert shown("fix 3 problems (spikes)") == "修正 3 个问题 (尖峰)"
        assert shown("set 7 samples of 3 markers aside") == "搁置 3 个标记点 的 7 个采样"
        reason = "For 2 frames A and B, 600 mm apart, each continue the other's trajectory."
        assert "2 帧" in shown(reason)
        assert shown("This is not a plan: it is too large.") == "这不是计划：它太大。"

    def test_lists_are_translated_one_by_one(self) -> None:
        text = shown("The new file has the markers alone, without analog data, residuals.")
        assert text == "新文件只有标记点，没有模拟数据、残差。"

    def test_what_is_not_listed_stays_as_it_is(self) -> None:
        assert shown("Nobody has said this before {0}.") == "Nobody has said this before {0}."
        assert shown("") == ""

    def test_braces_in_names_do_no_harm(self) -> None:
        assert shown("fill {0} ({1})") == "填补 {0} ({1})"
        assert shown("the donor {x} is missing in the gap too") == "参考标记点 {x} 在缺失段内也缺失"

    def test_errors_keep_their_place(self) -> None:
        error = MocapmendError("The file is empty.", "a.c3d", "Open it again.")
        assert error_text(error) == "a.c3d: 文件是空的。 请重新打开。"

    def test_methods_have_names(self) -> None:
        assert method_name("auto") == "自动"
        assert method_name("of another version") == "of another version"

    def test_segments_have_names(self) -> None:
        assert segment_name("left thigh") == "左大腿"
        assert segment_name("of my own") == "of my own"
        assert segment_name("") == ""

    def test_what_an_export_proves_is_told(self, gait: Path, tmp_path: Path) -> None:
        source, _ = load(gait, no_progress)
        for name in ("copy.c3d", "copy.csv"):
            exported = export(source, Changes((), ()), tmp_path / name, False, False, no_progress)
            said = set(exported.sentences)
            assert unlisted(said) == set()
            assert all(shown(text) != text for text in said)

    def test_texts_that_qt_lacks_are_ours(self) -> None:
        for text in QT:
            contexts = (
                "QFileDialog",
                "QAbstractFileIconProvider",
                "QFileSystemModel",
                "QKeySequenceEdit",
            )
            assert any(QCoreApplication.translate(each, text) != text for each in contexts)
        assert QCoreApplication.translate("QFileSystemModel", "Size") == "大小"


def test_segments_of_the_templates_are_in_the_catalogue() -> None:
    named = {name for template in templates() for name in template.segments}
    assert named == set(SEGMENTS)


def test_english_stays_english() -> None:
    text = "12 frames (80 ms) is longer than the default limit of 7 frames (50 ms)"
    assert shown(text) == text
    assert method_name("auto") == METHODS["auto"].label


def test_error_in_one_line_is_as_the_error_says_it() -> None:
    for error in (
        MocapmendError("The file is empty.", "a.c3d", "Open it again."),
        MocapmendError("The file is empty."),
    ):
        assert error_text(error) == str(error)
