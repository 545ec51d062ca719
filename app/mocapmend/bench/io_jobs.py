"""What `bench io` measures: each job runs in a process of its own and prints what it took.

A job is a generator. It yields once when all is imported and ready, which starts the clock, and
again with the name of each step that it has done.
"""

import json
import os
import shutil
import sys
import time
import warnings
from collections.abc import Callable, Iterator
from dataclasses import asdict, dataclass
from pathlib import Path
from typing import TYPE_CHECKING, Any

import numpy as np

from mocapmend.bench.memory import peak_mb

if TYPE_CHECKING:
    from mocapmend.files import C3DFile, RepairRecord, SampleRun

RECORDING = "large.c3d"
VALUE = 123.456
"""All coordinates of the samples that are repaired."""


@dataclass(frozen=True)
class Work:
    """The recording in a folder, and the gap that is repaired.

    Attributes
    ----------
    folder : str
        Where the recording is and copies go.
    marker, start, stop : int
        The gap.
    """

    folder: str
    marker: int
    start: int
    stop: int

    @property
    def path(self) -> Path:
        """The recording."""
        return Path(self.folder) / RECORDING

    def out(self, name: str) -> Path:
        """Return where a copy goes, which is not there yet."""
        path = Path(self.folder) / f"{name}.c3d"
        path.unlink(missing_ok=True)
        return path

    def values(self) -> np.ndarray:
        """Return the repaired samples."""
        return np.full((self.stop - self.start, 3), VALUE)


@dataclass(frozen=True)
class Step:
    """What a step took.

    Attributes
    ----------
    seconds : float
        Of the step alone.
    extra_mb : float or None
        The most memory so far above that before the first step.
    """

    seconds: float
    extra_mb: float | None


def measure(job: Iterator[None]) -> list[Step]:
    """Run a job."""
    next(job)
    idle = peak_mb()
    steps = []
    start = time.perf_counter()
    for _ in job:
        seconds = time.perf_counter() - start
        peak = peak_mb()
        steps.append(Step(seconds, None if peak is None or idle is None else peak - idle))
        start = time.perf_counter()
    return steps


def numpy_read(work: Work) -> Iterator[None]:
    """Read the bytes and do nothing with them."""
    yield
    whole = np.fromfile(work.path, np.float32)
    yield
    del whole


def copy(work: Work) -> Iterator[None]:
    """Do the least that a safe save has to do."""
    out = work.out("copy")
    yield
    shutil.copyfile(work.path, out)
    with out.open("rb+") as file:
        os.fsync(file.fileno())
        while file.read(1 << 22):
            pass
    yield


def own_read(work: Work) -> Iterator[None]:
    """Read points and residuals, then analog."""
    from mocapmend.files import read_c3d

    yield
    source = read_c3d(work.path)
    yield
    analog = source.read_analog()
    yield
    del analog


def own_save(work: Work) -> Iterator[None]:
    """Read, then save a repair with its record, read back and compared."""
    from mocapmend.files import read_c3d, save_patched

    out = work.out("own")
    yield
    source = read_c3d(work.path)
    yield
    save_patched(source, [_run(work)], out, repairs=[_record(source, work)])
    yield


def own_export(work: Work) -> Iterator[None]:
    """Save a repair with all proofs."""
    import c3d  # noqa: F401 - the proofs import it late

    from mocapmend import engine
    from mocapmend.files import read_c3d
    from mocapmend_algorithms import no_progress

    out = work.out("own")
    source = read_c3d(work.path)
    changes = engine.Changes((_run(work),), (_record(source, work),))
    yield
    engine.export(source, changes, out, False, False, no_progress)  # noqa: FBT003
    yield


def _run(work: Work) -> "SampleRun":
    from mocapmend.files import SampleRun

    return SampleRun(work.marker, work.start, work.values())


def _record(source: "C3DFile", work: Work) -> "RepairRecord":
    from mocapmend.files import RepairRecord

    first = source.recording.first_frame
    return RepairRecord(
        marker=source.recording.labels[work.marker],
        point=source.stored_points[work.marker] + 1,
        first_frame=first + work.start,
        last_frame=first + work.stop - 1,
        method="constant",
    )


def c3d_read(work: Work) -> Iterator[None]:
    """Read with c3d into arrays made beforehand, frame by frame."""
    import c3d

    yield
    with work.path.open("rb") as stream:
        reader = c3d.Reader(stream)
        frames = reader.last_frame - reader.first_frame + 1
        points = np.empty((frames, reader.point_used, 5), np.float32)
        analog = np.empty((frames, reader.analog_used, reader.analog_per_frame))
        for at, (_, frame_points, frame_analog) in enumerate(reader.read_frames(copy=False)):
            points[at] = frame_points
            analog[at] = frame_analog
    yield


def c3d_save(work: Work) -> Iterator[None]:
    """Read with c3d, repair and write, as its manual shows."""
    import c3d

    out = work.out("c3d")
    yield
    with work.path.open("rb") as stream:
        reader = c3d.Reader(stream)
        writer = reader.to_writer("copy_metadata")
        for at, (_, points, analog) in enumerate(reader.read_frames()):
            if work.start <= at < work.stop:
                points[work.marker] = (VALUE, VALUE, VALUE, 0, 0)
            writer.add_frames((points, analog))
    with out.open("wb") as target:
        writer.write(target)
    yield


def ezc3d_read_and_save(work: Work) -> Iterator[None]:
    """Read with ezc3d, then repair and write."""
    import ezc3d

    out = work.out("ezc3d")
    yield
    file: Any = ezc3d.c3d(str(work.path))
    yield
    file["data"]["points"][:3, work.marker, work.start : work.stop] = VALUE
    file["data"]["meta_points"]["residuals"][:, work.marker, work.start : work.stop] = 0.0
    file.write(str(out))
    yield


JOBS: dict[str, Callable[[Work], Iterator[None]]] = {
    "numpy": numpy_read,
    "copy": copy,
    "own read": own_read,
    "c3d read": c3d_read,
    "ezc3d": ezc3d_read_and_save,
    "own save": own_save,
    "c3d save": c3d_save,
    "own export": own_export,
}


def main() -> None:
    """Run the job that the arguments name and print its steps as JSON."""
    name, work = sys.argv[1], Work(**json.loads(sys.argv[2]))
    warnings.simplefilter("ignore")
    sys.stdout.write(json.dumps([asdict(step) for step in measure(JOBS[name](work))]))


if __name__ == "__main__":
    main()
