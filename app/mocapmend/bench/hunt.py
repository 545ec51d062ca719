"""Damaged files by the thousand, in worker processes that may hang or crash."""

import multiprocessing
import random
import time
from collections.abc import Iterator, Sequence
from dataclasses import dataclass
from multiprocessing.connection import Connection, wait
from pathlib import Path
from tempfile import TemporaryDirectory

from mocapmend.bench.mutate import Damage, mutate, mutate_member
from mocapmend.bench.seeds import Seed
from mocapmend.bench.trial import Outcome, Use, attempt, use_file

WORKERS = 2
PATIENCE_S = 20.0
INSIDE = 0.8
"""The share of archives of which a member is damaged."""
CONTEXT = multiprocessing.get_context("spawn")


@dataclass(frozen=True)
class Plan:
    """Which damaged files are tried; number and plan say everything about a file.

    Attributes
    ----------
    seeds : sequence of Seed
        The good files, which take turns.
    seed : int
        Of the random numbers.
    use : callable
        What is done with a file.
    """

    seeds: Sequence[Seed]
    seed: int
    use: Use = use_file

    def origin(self, number: int) -> Seed:
        """Return the good file from which one is made."""
        return self.seeds[number % len(self.seeds)]

    def content(self, number: int) -> bytes:
        """Return the damaged file of a number, the same on every machine."""
        rng = random.Random(f"{self.seed} {number}")  # noqa: S311 - nothing secret
        origin = self.origin(number)
        damage = Damage(rng, origin.head, rng.choice(self.seeds).raw)
        # A checksum guards an archive: damage to its bytes alone would never reach the reader.
        inside = origin.suffix == ".npz" and rng.random() < INSIDE
        return (mutate_member if inside else mutate)(origin.raw, damage)

    def write(self, number: int, folder: Path) -> Path:
        """Write the damaged file, and what must lie beside it."""
        origin = self.origin(number)
        path = folder / f"mutant{origin.suffix}"
        path.write_bytes(self.content(number))
        for suffix, raw in origin.beside:
            path.with_suffix(suffix).write_bytes(raw)
        return path

    def attempt(self, number: int, folder: Path) -> Outcome:
        """Try the damaged file of a number."""
        path = self.write(number, folder)
        try:
            return attempt(path, self.use)
        finally:
            for each in folder.iterdir():
                each.unlink()


def hunt(
    plan: Plan, mutants: int, *, patience_s: float = PATIENCE_S
) -> Iterator[tuple[int, Outcome]]:
    """Try damaged files in two processes.

    Parameters
    ----------
    plan : Plan
        Which files.
    mutants : int
        How many.
    patience_s : float
        After how long a process is killed (s).

    Yields
    ------
    number : int
        The file, in no order.
    outcome : Outcome
        What became of it.
    """
    numbers = iter(range(mutants))
    with TemporaryDirectory(prefix="mocapmend-bench-", ignore_cleanup_errors=True) as folder:
        workers = [_Worker(plan, Path(folder)) for _ in range(min(WORKERS, mutants))]
        try:
            busy = [worker for worker in workers if worker.give(next(numbers, None))]
            while busy:
                wait([worker.pipe for worker in busy], _time_left(busy, patience_s))
                for worker in list(busy):
                    outcome = worker.outcome(patience_s)
                    if outcome is not None:
                        yield worker.number, outcome
                        if not worker.give(next(numbers, None)):
                            busy.remove(worker)
        finally:
            for worker in workers:
                worker.stop()


def _time_left(workers: Sequence["_Worker"], patience_s: float) -> float:
    first = min(worker.started for worker in workers)
    return max(0.0, first + patience_s - time.monotonic())


class _Worker:
    """A process that tries one file after the other, and is replaced when it hangs or dies."""

    def __init__(self, plan: Plan, folder: Path) -> None:
        self._plan = plan
        self._folder = folder
        self._start()

    def _start(self) -> None:
        self.pipe, theirs = CONTEXT.Pipe()
        self._process = CONTEXT.Process(
            target=_serve, args=(theirs, self._plan, self._folder), daemon=True
        )
        self._process.start()
        theirs.close()
        # Starting takes a second or two, which is nobody's fault.
        self.pipe.recv()

    def give(self, number: int | None) -> bool:
        """Let it try a file; say whether there was one."""
        if number is None:
            return False
        self.number = number
        self.started = time.monotonic()
        self.pipe.send(number)
        return True

    def outcome(self, patience_s: float) -> Outcome | None:
        """Return what became of the file, None while it is being tried."""
        if self.pipe.poll():
            try:
                outcome: Outcome = self.pipe.recv()
            except EOFError:
                self._process.join()
                failed = f"the process ended with exit code {self._process.exitcode}"
                self._start()
                return Outcome("failed", failed)
            return outcome
        if time.monotonic() - self.started < patience_s:
            return None
        self.stop()
        self._start()
        return Outcome("failed", f"no answer after {patience_s:g} s", patience_s)

    def stop(self) -> None:
        """End the process, whatever it is doing."""
        self._process.kill()
        self._process.join()
        self.pipe.close()


def _serve(pipe: Connection, plan: Plan, folder: Path) -> None:
    """Try the files whose numbers arrive."""
    with TemporaryDirectory(dir=folder, ignore_cleanup_errors=True) as own:
        pipe.send("ready")
        while True:
            try:
                number: int = pipe.recv()
            except EOFError:
                return
            pipe.send(plan.attempt(number, Path(own)))
