"""Reading and saving, each run beside plain numpy and a plain copy of the same file."""

import os
import shutil
import tempfile
import time
import tracemalloc
from collections.abc import Callable
from pathlib import Path

import numpy as np

from mocapmend import engine
from mocapmend.bench.synthetic import write_recording
from mocapmend.bench.table import Row, Table
from mocapmend.files import SampleRun, read_c3d, save_patched
from mocapmend_algorithms import find_gaps, no_progress

MARKERS = 60
ANALOG = 16


def run(*, frames: int, runs: int) -> Table:
    """Measure on a synthetic recording: 60 markers, 16 analog channels at ten times the rate."""
    with tempfile.TemporaryDirectory(prefix="mocapmend-bench-") as folder:
        path = Path(folder) / "large.c3d"
        write_recording(path, frames=frames, markers=MARKERS, analog=ANALOG, gaps=200)
        size = path.stat().st_size
        table = Table(f"Input and output, a C3D file of {size / 1e6:.0f} MB ({frames} frames)")
        copy, saved = Path(folder) / "copy.c3d", Path(folder) / "saved.c3d"
        source = read_c3d(path)
        gap = find_gaps(source.recording.present)[0]
        edits = [SampleRun(gap.marker, gap.start, np.full((gap.length, 3), 123.456))]
        changes = engine.Changes(tuple(edits), ())

        def read_all() -> None:
            read_c3d(path).read_analog()

        plain, points, everything = _times(
            runs, lambda: np.fromfile(path, np.float32), lambda: read_c3d(path), read_all
        )
        copied, patched, proved = _times(
            runs,
            lambda: _copy(path, copy),
            lambda: _save(source, edits, saved),
            lambda: engine.export(source, changes, saved, False, False, no_progress),  # noqa: FBT003
        )
        table.rows += [
            Row("plain read (np.fromfile)", _median(plain), "s"),
            Row("read, points", _median(points), "s", "plain read", _ratio(points, plain), "<= 3"),
            Row("read, points and analog", _median(everything), "s", "plain read",
                _ratio(everything, plain)),
            Row("copy, fsync, read back", _median(copied), "s"),
            Row("save a repair, verified", _median(patched), "s", "copy", _ratio(patched, copied),
                "<= 3"),
            Row("export with all proofs, the c3d library's reading among them",
                _median(proved), "s", "copy", _ratio(proved, copied)),
            _memory("extra memory, read points", lambda: read_c3d(path)),
            _memory("extra memory, save", lambda: _save(source, edits, saved)),
        ]  # fmt: skip
    return table


def _copy(path: Path, copy: Path) -> None:
    """Do the least that a safe save has to do."""
    copy.unlink(missing_ok=True)
    shutil.copyfile(path, copy)
    with copy.open("rb+") as file:
        os.fsync(file.fileno())
        while file.read(1 << 22):
            pass


def _save(source: object, edits: list[SampleRun], saved: Path) -> None:
    saved.unlink(missing_ok=True)
    save_patched(source, edits, saved)  # type: ignore[arg-type]


def _times(runs: int, *calls: Callable[[], object]) -> list[list[float]]:
    """Time the calls in turn, after a round that is not counted: what drifts hits all alike."""
    seconds: list[list[float]] = [[] for _ in calls]
    for counted in range(-1, runs):
        for call, times in zip(calls, seconds, strict=True):
            start = time.perf_counter()
            call()
            if counted >= 0:
                times.append(time.perf_counter() - start)
    return seconds


def _memory(what: str, call: Callable[[], object]) -> Row:
    tracemalloc.start()
    kept = call()
    peak = tracemalloc.get_traced_memory()[1]
    tracemalloc.stop()
    del kept
    return Row(what, peak / 1e6, "MB", "limit 500 MB", peak / 500e6, "<= 1")


def _median(values: list[float]) -> float:
    return float(np.median(values))


def _ratio(values: list[float], to: list[float]) -> float:
    return float(np.median(np.array(values) / np.array(to)))
