"""Samples exchanged and set aside: what the file becomes, what it tells, and the way back."""

from dataclasses import replace
from pathlib import Path

import numpy as np
import pytest
from c3d_synthetic import Synthetic, encode, walk
from hypothesis import HealthCheck, given, settings
from hypothesis import strategies as st
from numpy.typing import NDArray

from mocapmend import engine
from mocapmend.changes import Repaired, bare, earlier, filled, smoothed
from mocapmend.doubts import Doubt, Doubts
from mocapmend.errors import MocapmendError
from mocapmend.files import Source, check_files, read_recording
from mocapmend.files.c3d_reader import C3DFile, read_c3d
from mocapmend.layers import Layers
from mocapmend_algorithms import Gap, no_progress
from mocapmend_algorithms.corrections import Exchange
from mocapmend_algorithms.fill.registry import METHODS
from mocapmend_algorithms.smooth.registry import SMOOTHERS

FRAMES, MARKERS = 40, 4
SPIKE, SWAP = Doubt("spikes", "It leaps."), Exchange(0, 2, 8, 21)
LINEAR = METHODS["linear"].params()
MACHINES = ("intel", "dec", "mips")


def write(path: Path, machine: str = "intel", is_float: bool = True) -> C3DFile:
    """Write four markers and a model output, with gaps, residuals, cameras and analog data."""
    points = np.insert(walk(FRAMES, MARKERS), 1, 7.0, axis=1)
    fourth = np.arange(FRAMES * 5.0).reshape(FRAMES, 5) % 90
    for rows, point in ((slice(5, 11), 0), (slice(30, 33), 3), (slice(0, 3), 4)):
        points[rows, point] = 0.0
        fourth[rows, point] = -1.0
    spec = Synthetic(
        points,
        machine=machine,
        is_float=is_float,
        scale=0.125,
        fourth=fourth,
        analog=np.arange(FRAMES * 2 * 3.0).reshape(FRAMES, 2, 3),
        first_frame=101,
        labels=["A", "Angle", "B", "C", "D"],
        parameters={"POINT:ANGLES": ["Angle"]},
    )
    path.write_bytes(encode(spec))
    return read_c3d(path)


def fill_all(layers: Layers) -> Repaired:
    """Fill what straight lines can."""
    gaps = [gap for gap in layers.open_gaps() if gap not in layers.kept_open]
    result = engine.fill_anyway(layers.recording, gaps, "linear", LINEAR, no_progress)
    return filled(earlier(layers), result, "linear", LINEAR)


def export(source: Source, made: Repaired, out: Path) -> engine.Exported:
    return engine.export(source, made.changes(), out, False, False, no_progress)


def bare_of(source: Source) -> Repaired:
    """Return a recording in which two markers have changed places."""
    return bare(Layers.of(source).corrected([SWAP], {}))


def near(one: NDArray[np.float64], other: NDArray[np.float64]) -> bool:
    """Say whether coordinates are equal but for the steps of the integers."""
    return np.allclose(one, other, rtol=0.0, atol=0.063, equal_nan=True)


def same(one: NDArray[np.float64], other: NDArray[np.float64]) -> bool:
    return np.array_equal(one, other, equal_nan=True)


@pytest.mark.parametrize("is_float", [True, False])
@pytest.mark.parametrize("machine", MACHINES)
def test_there_and_back(tmp_path: Path, machine: str, is_float: bool) -> None:
    source = write(tmp_path / "in.c3d", machine, is_float)
    before = Layers.of(source)
    layers = before.corrected([SWAP], {Gap(2, 12, 14): SPIKE, Gap(1, 20, 21): SPIKE})
    made = fill_all(layers)
    done = export(source, made, tmp_path / "out.c3d")
    assert done.check is not None
    assert done.check.passed
    assert any("26 samples changed places" in text for text in done.check.allowed)

    again = read_c3d(tmp_path / "out.c3d")
    assert near(again.recording.points, made.recording.points)
    assert same(again.measured.points, layers.recording.points)
    assert same(again.as_stored.points, source.recording.points)
    assert Layers.of(again).set_aside == layers.set_aside
    assert Layers.of(again).moves == layers.moves

    export(again, bare(Layers(again)), tmp_path / "back.c3d")
    assert (tmp_path / "back.c3d").read_bytes() == (tmp_path / "in.c3d").read_bytes()


def test_samples_keep_their_residuals_and_cameras(tmp_path: Path) -> None:
    source = write(tmp_path / "in.c3d")
    export(source, fill_all(Layers.of(source).corrected([SWAP], {})), tmp_path / "out.c3d")
    again = read_c3d(tmp_path / "out.c3d")
    whole = [Gap(marker, 8, 21) for marker in (0, 2)]
    first, second = source.read_fourth(whole)
    there, back = again.read_fourth(whole)
    kept = ~np.isnan(source.recording.points[8:21, [2, 0], 0])
    assert np.array_equal(there[kept[:, 0]], second[kept[:, 0]])
    assert np.array_equal(back[kept[:, 1]], first[kept[:, 1]])


def test_what_is_set_aside_and_not_filled_is_missing(tmp_path: Path) -> None:
    source = write(tmp_path / "in.c3d")
    layers = Layers.of(source).corrected([], {Gap(3, 37, 40): SPIKE})
    export(source, fill_all(layers), tmp_path / "out.c3d")
    again = read_c3d(tmp_path / "out.c3d")
    assert not again.recording.present[37:, 3].any()
    assert list(again.set_aside) == [Gap(3, 37, 40)]
    assert same(again.as_stored.points, source.recording.points)


def test_the_record_goes_beside_the_file_where_it_is_too_long(tmp_path: Path) -> None:
    source = write(tmp_path / "in.c3d")
    doubts = {Gap(1, row, row + 1): Doubt("spikes", "long " * 190) for row in range(1, 39)}
    done = export(source, fill_all(Layers.of(source).corrected([], doubts)), tmp_path / "out.c3d")
    again = read_c3d(tmp_path / "out.c3d")
    assert same(again.as_stored.points, source.recording.points)
    assert done.saved.record in {"group", "sidecar"}


@pytest.mark.parametrize("end", ["c3d", "trc", "csv", "npz"])
def test_other_formats_tell_it_too(tmp_path: Path, end: str) -> None:
    source = write(tmp_path / "in.c3d")
    table = tmp_path / "table.npz"
    engine.export(source, engine.Changes((), ()), table, False, False, no_progress)
    read = read_recording(table)
    made = fill_all(Layers.of(read).corrected([SWAP], {Gap(2, 12, 14): SPIKE}))
    out = tmp_path / f"out.{end}"
    export(read, made, out)
    again = read_recording(out)
    assert np.allclose(again.recording.points, made.recording.points, atol=1e-3, equal_nan=True)
    assert np.allclose(again.as_stored.points, read.recording.points, atol=1e-3, equal_nan=True)
    assert Layers.of(again).set_aside == made.layers.set_aside


def test_smoothing_is_in_the_record(tmp_path: Path) -> None:
    source = write(tmp_path / "in.c3d")
    made = fill_all(Layers.of(source))
    smoother = SMOOTHERS["butterworth"]
    result = smoother.function(made.recording, [Gap(1, 5, 35)], smoother.params(), no_progress)
    assert result.runs
    after = smoothed(made, result)
    done = export(source, after, tmp_path / "out.c3d")
    assert done.check is not None
    assert any("were smoothed" in text for text in done.check.allowed)
    again = read_c3d(tmp_path / "out.c3d")
    ((run, entry),) = again.smoothed.items()
    assert run == Gap(1, 5, 35)
    assert entry.method == "butterworth"
    assert 0 < entry.rms_change_mm < 20
    assert np.allclose(again.recording.points, after.recording.points, atol=1e-4, equal_nan=True)


# --- the check ---------------------------------------------------------------------------------


def test_the_check_finds_what_the_record_does_not_say(tmp_path: Path) -> None:
    source = write(tmp_path / "in.c3d")
    made = fill_all(Layers.of(source).corrected([SWAP], {Gap(2, 12, 14): SPIKE}))
    export(source, made, tmp_path / "out.c3d")
    raw = bytearray((tmp_path / "out.c3d").read_bytes())
    layout = read_c3d(tmp_path / "out.c3d").layout
    # A swapped sample of marker 2, at frame 18 from 0, which nobody set aside.
    at = layout.data_start + 18 * layout.frame_bytes + source.marker_points[2] * layout.slot
    raw[at] ^= 1
    (tmp_path / "wrong.c3d").write_bytes(raw)
    found = check_files(tmp_path / "in.c3d", tmp_path / "wrong.c3d")
    assert not found.passed
    assert any("Marker C: 1 sample differs although measured" in s for s in found.other_differences)


def test_the_check_compares_what_was_measured(tmp_path: Path) -> None:
    source = write(tmp_path / "in.c3d")
    made = fill_all(Layers.of(source).corrected([], {Gap(2, 12, 14): SPIKE}))
    changes = made.changes()
    (entry,) = changes.corrections.set_aside
    samples = entry.samples
    samples[0, 1] += 1.0
    lie = replace(entry, original=type(entry).encoded(samples))
    corrections = replace(changes.corrections, set_aside=(lie,))
    with pytest.raises(MocapmendError, match="were not measured as the repair record says"):
        wrong = replace(changes, corrections=corrections)
        engine.export(source, wrong, tmp_path / "out.c3d", False, False, no_progress)
    assert not (tmp_path / "out.c3d").exists()


# --- any corrections ---------------------------------------------------------------------------


@st.composite
def steps(draw: st.DrawFn) -> tuple[list[Exchange], Doubts]:
    def span() -> tuple[int, int]:
        start = draw(st.integers(0, FRAMES - 1))
        return start, draw(st.integers(start + 1, FRAMES))

    pairs = st.permutations(range(MARKERS))
    exchanges = [Exchange(*draw(pairs)[:2], *span()) for _ in range(draw(st.integers(0, 4)))]
    doubts = {
        Gap(draw(st.integers(0, MARKERS - 1)), *span()): Doubt("by hand", f"{k}")
        for k in range(draw(st.integers(0, 3)))
    }
    return exchanges, doubts


@settings(suppress_health_check=[HealthCheck.function_scoped_fixture], max_examples=25)
@given(first=steps(), second=steps())
def test_repaired_again_and_again(
    tmp_path: Path, first: tuple[list[Exchange], Doubts], second: tuple[list[Exchange], Doubts]
) -> None:
    """A repaired file is repaired once more, and then all is taken back."""
    source = write(tmp_path / "in.c3d")
    for path, given_steps in (("one.c3d", first), ("two.c3d", second)):
        layers = Layers.of(source).corrected(*given_steps)
        made = fill_all(layers)
        export(source, made, tmp_path / path)
        source = read_c3d(tmp_path / path)
        assert near(source.recording.points, made.recording.points)
        assert same(source.measured.points, layers.recording.points)
        assert not source.warnings
    original = read_c3d(tmp_path / "in.c3d")
    assert same(source.as_stored.points, original.recording.points)
    export(source, bare(Layers(source)), tmp_path / "back.c3d")
    assert (tmp_path / "back.c3d").read_bytes() == (tmp_path / "in.c3d").read_bytes()
