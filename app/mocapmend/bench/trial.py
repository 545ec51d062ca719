"""One file, read and repaired as the program would, and what that took.

What the program imports late is imported here: no file shall pay for that.
"""

import time
import traceback
import tracemalloc
import warnings
from collections.abc import Callable
from dataclasses import dataclass, replace
from pathlib import Path
from types import TracebackType
from typing import Literal

import c3d  # noqa: F401
import scipy.interpolate  # noqa: F401

from mocapmend import engine
from mocapmend.errors import MocapmendError
from mocapmend.files import C3DFile, Source
from mocapmend_algorithms import no_progress
from mocapmend_algorithms.fill import registry
from mocapmend_algorithms.fill.limits import Limits

SLOW_S = 2.0
MOST_EXTRA_MB = 200.0
"""Above the size of the file."""
METHOD = registry.method("cubic")
MOST_GAPS = 200
"""Noise in place of samples makes gaps by the thousand; so many take time in a good file too."""


@dataclass(frozen=True)
class Outcome:
    """What became of a file.

    Attributes
    ----------
    result : str
        "opened", "refused" (with our error) or "failed".
    detail : str
        Of a refusal, the message; of a failure, the traceback or what else went wrong.
    seconds : float
        How long it took; 0 where the process did not live to tell it.
    extra_mb : float
        The most memory that was allocated for it, less the size of the file.
    """

    result: Literal["opened", "refused", "failed"]
    detail: str = ""
    seconds: float = 0.0
    extra_mb: float = 0.0

    @property
    def fault(self) -> str:
        """What the program did wrong, in a line; empty if nothing."""
        if self.result == "failed":
            return self.detail.strip().rpartition("\n")[2]
        if self.seconds > SLOW_S:
            return f"slow: {self.seconds:.1f} s"
        if self.extra_mb > MOST_EXTRA_MB:
            return f"large: {self.extra_mb:.0f} MB more than the file"
        return ""


class Meter:
    """Measures the most memory that is held, in the blocks that it is the context of.

    What numpy allocates counts too, touched or not. Code runs five times slower in these blocks.

    Parameters
    ----------
    on : bool
        Whether it measures.

    Attributes
    ----------
    peak : int
        Bytes, together with what earlier blocks have left behind.
    """

    def __init__(self, *, on: bool = True) -> None:
        self.peak = 0
        self._left = 0
        self._on = on

    def __enter__(self) -> None:
        if self._on:
            tracemalloc.start()

    def __exit__(
        self,
        kind: type[BaseException] | None,
        error: BaseException | None,
        trace: TracebackType | None,
    ) -> None:
        left, peak = tracemalloc.get_traced_memory()
        tracemalloc.stop()
        self.peak = max(self.peak, self._left + peak)
        self._left += left


Use = Callable[[Path, Meter], None]


def use_file(path: Path, meter: Meter) -> None:
    """Open a file, read its analog data, fill up to 200 gaps, and export the repaired copy.

    That a file cannot be saved is no fault, but that a proof fails is one, and so is a copy that
    does not open. The fill is not metered: it only sees what was opened.

    Raises
    ------
    MocapmendError
        If it cannot be opened.
    """
    with meter:
        source, _ = engine.load(path, no_progress)
        if isinstance(source, C3DFile):
            source.read_analog()
    changes = fill_gaps(source)
    out = path.with_name("repaired.c3d")
    with meter:
        try:
            # Among the proofs is `check_files`.
            engine.export(source, changes, out, False, True, no_progress)  # noqa: FBT003
        except MocapmendError as error:
            if "report this" in error.todo:
                raise AssertionError(f"a proof failed: {error}") from error
            return
        try:
            engine.load(out, no_progress)
        except MocapmendError as error:
            raise AssertionError(f"the copy does not open: {error}") from error


def fill_gaps(source: Source) -> engine.Changes:
    """Fill gaps of a recording within the default limits."""
    gaps = source.open_gaps()[:MOST_GAPS]
    params = METHOD.params()
    filled = engine.fill(source.measured, gaps, METHOD.id, params, Limits(), no_progress)
    return engine.changes_of(source, filled, METHOD.id, params)


def attempt(path: Path, use: Use = use_file) -> Outcome:
    """Use a file and measure what that takes; a warning counts as an error.

    Parameters
    ----------
    path : Path
        The file.
    use : callable
        What is done with it.

    Returns
    -------
    Outcome
        What became of it. What is slow gets a second chance without the meter, which slows it,
        and because the machine may be busy.
    """
    outcome = _attempt(path, use, Meter())
    if outcome.seconds > SLOW_S:
        again = _attempt(path, use, Meter(on=False))
        return replace(outcome, seconds=min(outcome.seconds, again.seconds))
    return outcome


def _attempt(path: Path, use: Use, meter: Meter) -> Outcome:
    detail = ""
    result: Literal["opened", "refused", "failed"] = "opened"
    start = time.perf_counter()
    with warnings.catch_warnings():
        warnings.simplefilter("error")
        try:
            use(path, meter)
        except MocapmendError as error:
            result, detail = "refused", str(error)
        except Exception:  # noqa: BLE001 - any of them is what is looked for
            result, detail = "failed", traceback.format_exc()
    seconds = time.perf_counter() - start
    return Outcome(result, detail, seconds, (meter.peak - path.stat().st_size) / 1e6)
