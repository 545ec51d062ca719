"""The functions that the window and the command line share."""

import pickle
from dataclasses import replace
from pathlib import Path

import numpy as np
import pytest
from c3d_synthetic import Synthetic, encode, walk

from mocapmend import engine, exporting
from mocapmend.errors import MocapmendError
from mocapmend.files import CheckReport, Provenance, Source, Stamp, read_c3d
from mocapmend.shared_memory import block_of
from mocapmend_algorithms import Cancelled, Recording, find_gaps, no_progress
from mocapmend_algorithms.fill.limits import Limits
from mocapmend_algorithms.fill.registry import METHODS

NO_LIMITS = Limits(max_error_mm=float("inf"))


@pytest.fixture
def holed(tmp_path: Path) -> Path:
    """Write a small recording: gaps of M001, frames 10-14, and of M003, frames 0-3 (from 0)."""
    points = walk()
    fourth = np.zeros(points.shape[:2])
    for rows, marker in ((slice(10, 15), 0), (slice(0, 4), 2)):
        fourth[rows, marker] = -1
        points[rows, marker] = 0
    path = tmp_path / "holed.c3d"
    path.write_bytes(encode(Synthetic(points, fourth=fourth)))
    return path


@pytest.mark.parametrize(
    ("name", "source"),
    [
        ("gait_plug_in_gait", "template"),
        ("sprint_basketball", "distances"),
        ("walk_cmu_02_01", "template"),
    ],
)
def test_load_finds_the_skeleton(samples: Path, name: str, source: str) -> None:
    shares: list[float] = []
    loaded, skeleton = engine.load(samples / f"{name}.c3d", shares.append)
    assert skeleton.source == source
    assert {end for bone in skeleton.bones for end in bone} <= set(range(loaded.recording.markers))
    assert shares == sorted(shares)
    assert shares[-1] == 1.0


@pytest.mark.parametrize("shape", [(0, 0, 3), (5, 0, 3), (0, 4, 3), (5, 4, 3)])
def test_nothing_seen_has_no_skeleton(shape: tuple[int, int, int]) -> None:
    empty = Recording(np.full(shape, np.nan), tuple("ABCD"[: shape[1]]), 100.0)
    source = Source(path=Path("empty"), kind="test", recording=empty, stamp=Stamp(0, 0))
    assert engine.find_skeleton(source, no_progress).source == "none"


def test_automatic_is_no_worse_than_a_curve_where_donors_say_nothing(gait: Path) -> None:
    # Ghosts: fragments that move like no marker. Their short gaps were left to the donors once.
    recording = engine.load(gait, no_progress)[0].recording
    ghosts = [
        gap
        for gap in find_gaps(recording.present)
        if recording.labels[gap.marker].startswith("*") and gap.length <= 0.5 * recording.rate
    ]
    expected = {
        name: {
            patch.gap: patch.expected_error
            for patch in METHODS[name]
            .function(recording, ghosts, METHODS[name].params(), no_progress)
            .patches
        }
        for name in ("auto", "cubic")
    }
    compared = expected["auto"].keys() & expected["cubic"].keys()
    assert len(compared) > 30
    assert all(expected["auto"][gap] <= 4.01 * expected["cubic"][gap] for gap in compared)


@pytest.mark.parametrize("method", METHODS)
def test_a_preview_ignores_the_limits_and_equals_the_fill(holed: Path, method: str) -> None:
    recording = read_c3d(holed).recording
    gap = find_gaps(recording.present)[0]
    params = METHODS[method].params(**({"period": 0.15} if method == "cyclic" else {}))
    (preview,) = engine.fill_gap(recording, gap, method, params, no_progress).patches
    closed = engine.fill(recording, [gap], method, params, Limits(max_gap=0), no_progress)
    opened = engine.fill(recording, [gap], method, params, NO_LIMITS, no_progress)
    assert closed.patches == ()
    assert [entry.gap for entry in closed.unfilled] == [gap]
    assert np.array_equal(opened.patches[0].values, preview.values)


def test_a_job_can_carry_everything_to_a_worker_and_back(holed: Path) -> None:
    recording = read_c3d(holed).recording
    for function in (engine.load, engine.fill, engine.fill_gap, engine.export):
        assert pickle.loads(pickle.dumps(function)) is function
    gaps = find_gaps(recording.present)
    params = METHODS["cubic"].params()
    result = engine.fill(recording, gaps, "cubic", params, NO_LIMITS, no_progress)
    back = pickle.loads(pickle.dumps(result))
    assert [patch.gap for patch in back.patches] == [patch.gap for patch in result.patches]


def export(holed: Path, out: Path, *, replace_source: bool = False) -> engine.Exported:
    source = read_c3d(holed)
    gaps = find_gaps(source.recording.present)
    params = METHODS["linear"].params()
    result = engine.fill(source.recording, gaps, "linear", params, NO_LIMITS, no_progress)
    changes = engine.changes_of(source, result, "linear", params)
    return engine.export(source, changes, out, replace_source, False, no_progress)


def test_an_export_holds_the_repairs_and_their_proofs(holed: Path, tmp_path: Path) -> None:
    out = tmp_path / "out.c3d"
    done = export(holed, out)
    assert done.saved.samples == 5
    assert done.check.passed
    assert [(run.label, run.first_frame, run.last_frame) for run in done.check.changed] == [
        ("M001", 11, 15)
    ]
    assert "5" in done.second_reader
    before, after = read_c3d(holed).recording, read_c3d(out).recording
    ends = before.points[[9, 15], 0]
    share = np.arange(1, 6)[:, None] / 6
    line = ends[0] + share * (ends[1] - ends[0])
    np.testing.assert_allclose(after.points[10:15, 0], line, rtol=1e-6)
    kept = before.present
    assert np.array_equal(after.points[kept], before.points[kept])
    assert not after.present[:4, 2].any()


def test_repaired_is_what_the_file_will_hold(holed: Path) -> None:
    before = read_c3d(holed).recording
    params = METHODS["linear"].params()
    gaps = find_gaps(before.present)
    result = engine.fill(before, gaps, "linear", params, NO_LIMITS, no_progress)
    after = engine.repaired(before, result)
    assert [gap.marker for gap in find_gaps(after.present)] == [2]
    assert np.array_equal(after.points[before.present], before.points[before.present])
    assert not before.present[10:15, 0].any()


def test_replacing_the_source_is_proved_like_any_export(holed: Path) -> None:
    with pytest.raises(MocapmendError):
        export(holed, holed)
    done = export(holed, holed, replace_source=True)
    assert done.check.passed
    assert done.check.changed_samples == 5
    assert read_c3d(holed).recording.present[10:15, 0].all()


def test_a_failed_proof_leaves_no_file(
    holed: Path, tmp_path: Path, monkeypatch: pytest.MonkeyPatch
) -> None:
    real = exporting.check_files

    def pessimist(original: Path, repaired: Path, record: Provenance | None) -> CheckReport:
        return replace(real(original, repaired, record), other_differences=("7 bytes differ.",))

    monkeypatch.setattr(exporting, "check_files", pessimist)
    with pytest.raises(MocapmendError, match="7 bytes differ"):
        export(holed, tmp_path / "out.c3d")
    assert [path.name for path in tmp_path.iterdir()] == ["holed.c3d"]
    content = holed.read_bytes()
    with pytest.raises(MocapmendError, match="7 bytes differ"):
        export(holed, holed, replace_source=True)
    assert holed.read_bytes() == content


def test_a_cancelled_export_leaves_no_file(holed: Path, tmp_path: Path) -> None:
    def cancel(share: float) -> None:
        if share > 0.5:
            raise Cancelled

    with pytest.raises(Cancelled):
        engine.export(
            read_c3d(holed), engine.Changes((), ()), tmp_path / "out.c3d", False, False, cancel
        )
    assert [path.name for path in tmp_path.iterdir()] == ["holed.c3d"]


def test_a_recording_to_be_shown_is_in_shared_memory_and_the_same(gait: Path) -> None:
    expected, _ = engine.load(gait, no_progress)
    source, skeleton, states = engine.load_to_show(gait, no_progress)
    assert block_of(source.recording.points) is not None
    assert source.recording.points.tobytes() == expected.recording.points.tobytes()
    assert source.warnings == expected.warnings
    assert states.gaps == find_gaps(source.recording.present)
    assert skeleton is None
    found = engine.search_skeleton(source.recording, no_progress)
    assert found == engine.find_skeleton(source, no_progress)
