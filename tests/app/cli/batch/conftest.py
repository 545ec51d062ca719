"""A folder of recordings, a plan, and a batch that needs no processes."""

from collections.abc import Callable
from pathlib import Path
from typing import Any

import pytest
from batch_trials import InTurn, write_trial

from mocapmend.cli import batch
from mocapmend.plan import Plan, write_plan
from mocapmend.prospects import Way

Json = Callable[..., tuple[int, Any]]
Run = Callable[..., tuple[int, Any]]


@pytest.fixture
def plan(tmp_path: Path) -> Path:
    """Write a plan that fills all gaps but the leading ones."""
    path = tmp_path / "plan.json"
    write_plan(Plan(Way.default("linear")), path)
    return path


@pytest.fixture
def trials(tmp_path: Path) -> Path:
    """Write four recordings, two of them of the same name in different folders."""
    folder = tmp_path / "trials"
    for seed, name in enumerate(("b.c3d", "a 1.C3D", "s1/b.c3d", "s ö/deep/b.c3d")):
        write_trial(folder / name, seed)
    return folder


@pytest.fixture
def out(tmp_path: Path) -> Path:
    """Return where the copies shall go."""
    return tmp_path / "out"


@pytest.fixture
def in_turn(monkeypatch: pytest.MonkeyPatch) -> None:
    """Let a batch be done in this process."""
    monkeypatch.setattr(batch, "Local", InTurn)


@pytest.fixture
def run(run_json: Json, trials: Path, plan: Path, out: Path, in_turn: None) -> Run:
    """Return a function that does the batch of `trials` and returns its JSON."""

    def do(*more: object) -> tuple[int, Any]:
        return run_json("batch", trials, "--plan", plan, "-o", out, "--recursive", *more)

    return do
