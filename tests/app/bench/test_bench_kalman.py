"""`bench kalman`: its cases, curves and peers."""

import json
from pathlib import Path

import numpy as np
import pytest

from mocapmend.bench import kalman, kalman_cases, kalman_speed, main
from mocapmend.bench.kalman_cases import SEGMENTS, bundled, filled, make_case, of_folder
from mocapmend.bench.kalman_speed import DEFAULT, PEER, PEER_LOST, Line, Rates
from mocapmend.errors import MocapmendError
from mocapmend_algorithms import Gap, Recording

LABELS = tuple(dict.fromkeys(label for segment in SEGMENTS for label in segment))[:43]


def walking(frames: int = 650, labels: tuple[str, ...] = LABELS) -> Recording:
    """Return markers that move along straight lines."""
    rng = np.random.default_rng(0)
    start, velocity = rng.normal(0, 500, (2, len(labels), 3))
    points = start + velocity * np.arange(frames)[:, None, None] / 120
    return Recording(points, tuple(f"somebody:{label}" for label in labels), 120.0)


def test_a_case_loses_hip_and_knee_in_the_middle_frames() -> None:
    recording = walking()
    case = make_case("walk", recording, 600)
    assert case is not None
    np.testing.assert_array_equal(case.reference.points, recording.points[25:625])
    hip, knee = LABELS.index("RFWT"), LABELS.index("RKNE")
    assert set(case.gaps) == {Gap(hip, 160, 340), Gap(knee, 330, 510)}
    missing = np.isnan(case.raw.points[:, :, 0])
    assert missing.sum() == 360
    assert missing[160:340, hip].all()
    assert missing[330:510, knee].all()
    assert len(case.segments) == 11
    values = [
        (gap, recording.points[25 + gap.start : 25 + gap.stop, gap.marker]) for gap in case.gaps
    ]
    np.testing.assert_array_equal(filled(case, values).points, case.reference.points)


def test_recordings_that_do_not_suit_make_no_case() -> None:
    assert make_case("short", walking(500), 600) is None
    assert make_case("no knee", walking(labels=LABELS[:8]), 600) is None
    points = walking().points.copy()
    points[300, LABELS.index("RKNE")] = np.nan
    assert make_case("gap", walking().with_points(points), 600) is None


def test_segments_and_not_markers_are_counted() -> None:
    case = make_case("walk", walking(), 600)
    assert case is not None
    whole = kalman.success(case, case.reference)
    assert (whole.instantaneous == 1).all()
    share = kalman.success(case, case.raw).instantaneous
    assert (share[:160] == 1).all()
    # The hip marker belongs to pelvis and thigh, the knee marker to thigh and shank.
    np.testing.assert_allclose(share[160:330], 9 / 11)
    np.testing.assert_allclose(share[330:340], 8 / 11)
    np.testing.assert_allclose(share[340:510], 9 / 11)
    assert (share[510:] == 1).all()


def test_a_repair_that_is_too_far_off_or_jumps_is_not_tracked() -> None:
    case = make_case("walk", walking(), 600)
    assert case is not None
    truth = case.reference.points
    for offset, good in ((9.0, 1.0), (11.0, 0.0)):
        values = [
            (gap, truth[gap.start : gap.stop, gap.marker] + [offset, 0, 0]) for gap in case.gaps
        ]
        share = kalman.success(case, filled(case, values)).instantaneous
        assert share[250] == pytest.approx(1 if good else 9 / 11)


def test_folders_without_a_case_are_refused(tmp_path: Path) -> None:
    with pytest.raises(MocapmendError, match="There is no such folder"):
        of_folder(tmp_path / "nowhere")
    (tmp_path / "broken.c3d").write_bytes(b"no recording")
    (tmp_path / "notes.md").write_text("nothing")
    with pytest.raises(MocapmendError, match="No recording here"):
        of_folder(tmp_path)


def test_recordings_of_a_folder_are_found(tmp_path: Path) -> None:
    for name, rate in (("one", 120.0), ("slow", 60.0)):
        recording = walking()
        np.savez(
            tmp_path / f"{name}.npz",
            pos=recording.points,
            fps=rate,
            names=np.array(recording.labels),
        )
    cases = of_folder(tmp_path)
    assert [case.name for case in cases] == ["one.npz"]


def test_the_smoother_alone_and_filterpy_make_the_same() -> None:
    pytest.importorskip("filterpy")
    (case,) = bundled()
    for gap in case.gaps:
        short = Gap(gap.marker, gap.start, gap.start + 20)
        points = case.reference.points.copy()
        points[short.start : short.stop, short.marker] = np.nan
        raw = case.reference.with_points(points)
        alone = kalman_speed.smooth_alone(raw, short)
        peer = kalman_speed.filterpy_smooth(raw, short.marker)[short.start : short.stop]
        # filterpy sees all samples and does not meet the two beside the gap.
        moved = np.linalg.norm(
            raw.points[short.stop, gap.marker] - raw.points[short.start - 1, gap.marker]
        )
        assert np.abs(alone - peer).max() < 0.01 * moved


def test_ratios_are_medians_run_by_run_and_a_peer_may_be_absent() -> None:
    rates = Rates({DEFAULT: [100.0, 400.0, 900.0], PEER: [1.0, 2.0, 9.0]})
    row = rates.row(Line(DEFAULT, PEER, ">= 200"))
    assert (row.figure, row.ratio, row.target) == (400.0, 100.0, ">= 200")
    absent = rates.row(Line(PEER_LOST))
    assert (absent.figure, absent.note) == (None, "not installed")
    without = rates.row(Line(DEFAULT, PEER_LOST))
    assert (without.figure, without.ratio) == (400.0, None)
    paper = rates.row(Line(DEFAULT, "the paper's 30.5 frames/s"))
    assert paper.ratio == pytest.approx(400 / 30.5)


def test_the_command_prints_every_row(
    capsys: pytest.CaptureFixture[str], monkeypatch: pytest.MonkeyPatch
) -> None:
    monkeypatch.setattr(kalman_speed, "LEAST_SECONDS", 0.0)
    monkeypatch.setattr(kalman_speed, "find_spec", lambda name: None)
    assert main(["kalman", "--runs", "1", "--json"]) == 0
    document = json.loads(capsys.readouterr().out)
    figures = {row["what"]: row["figure"] for row in document["rows"]}
    assert kalman_cases.BUNDLED in document["title"]
    assert figures["segments tracked up to frame 600 of 600, reference"] == 100
    raw = figures["segments tracked up to frame 600 of 600, raw"]
    assert (
        85 < raw < figures[f"segments tracked up to frame 600 of 600, repaired, {kalman.DEFAULT}"]
    )
    assert figures["segments never lost, raw"] == pytest.approx(100 * 8 / 11)
    assert figures[f"RMSE, {kalman.DEFAULT}"] < figures[f"RMSE, {kalman.WORLD}"]
    assert figures[PEER] is None
    assert figures[DEFAULT] > 0
