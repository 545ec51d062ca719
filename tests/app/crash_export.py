"""A program that is killed while it exports: FOLDER RECORDING, in which "out.c3d" is replaced.

Each attempt is a fork that ends by SIGKILL before some line of the code that writes, or by a timer
at any moment. Prints a line for each: "killed" or "done", what became of the file ("old", "new" or
"broken"), and the names of other files.
"""

import hashlib
import math
import os
import random
import signal
import sys
import time
from collections.abc import Callable
from pathlib import Path
from types import FrameType

from mocapmend import engine
from mocapmend.files import read_recording
from mocapmend_algorithms import find_gaps, no_progress
from mocapmend_algorithms.fill.interpolate import LinearParams
from mocapmend_algorithms.fill.limits import Limits

LINES = 100
TIMES = 60
CODE = ("atomic.py", "c3d_patch.py")


def main() -> None:
    folder, recording = map(Path, sys.argv[1:])
    out = folder / "out.c3d"
    source = read_recording(recording)
    way = ("linear", LinearParams())
    gaps = find_gaps(source.recording.present)
    result = engine.fill(source.recording, gaps, *way, Limits(99, math.inf), no_progress)
    changes = engine.changes_of(source, result, *way)

    def save() -> None:
        engine.export(source, changes, out, False, False, no_progress)

    started = time.monotonic()
    save()
    duration = time.monotonic() - started
    old, new = recording.read_bytes(), hashlib.sha256(out.read_bytes()).digest()
    lines = count_lines(save)
    luck = random.Random(5)
    places = sorted({*luck.sample(range(lines), min(lines, LINES)), *range(lines - 25, lines)})
    attempts: list[Callable[[], object]] = [lambda at=at: die_at_line(at) for at in places]
    for _ in range(TIMES):
        moment = luck.uniform(0.0, 1.1 * duration)
        attempts.append(lambda moment=moment: signal.setitimer(signal.ITIMER_REAL, moment))
    for prepare in attempts:
        out.write_bytes(old)
        child = os.fork()
        if not child:
            prepare()
            save()
            os._exit(0)
        _, status = os.waitpid(child, 0)
        now = out.read_bytes()
        is_new = hashlib.sha256(now).digest() == new
        state = "old" if now == old else "new" if is_new else "broken"
        others = sorted(path.name for path in folder.iterdir() if path != out)
        how = "killed" if os.WIFSIGNALED(status) else "done"
        print(how, state, *others, flush=True)  # noqa: T201 - the test reads it
        for name in others:
            (folder / name).unlink()


def count_lines(save: Callable[[], None]) -> int:
    """Return how many lines of the code are run."""
    seen = [0]

    def count(_: FrameType) -> None:
        seen[0] += 1

    trace_lines(count)
    save()
    sys.settrace(None)
    return seen[0]


def die_at_line(number: int) -> None:
    """Kill this process before a line of the code that writes, counted from 0."""
    left = [number]

    def count(_: FrameType) -> None:
        if not left[0]:
            os.kill(os.getpid(), signal.SIGKILL)
        left[0] -= 1

    trace_lines(count)


def trace_lines(call: Callable[[FrameType], None]) -> None:
    def local(frame: FrameType, event: str, _: object) -> object:
        if event == "line":
            call(frame)
        return local

    def enter(frame: FrameType, _event: str, _: object) -> object:
        return local if frame.f_code.co_filename.endswith(CODE) else None

    sys.settrace(enter)


if __name__ == "__main__":
    main()
