"""Cases and trials with known figures."""

import json
from collections.abc import Sequence
from pathlib import Path
from typing import Any

import numpy as np

from mocapmend.bench.gaps.cases import Case
from mocapmend.bench.gaps.trials import Trial
from mocapmend_algorithms import Gap

TITS, SPLINE, RIGID = "Tits 2018 MocapRecovery", "cubic spline", "3-donor rigid body"


def entry(name: str = "P3_a_0", **changes: Any) -> dict[str, Any]:
    """Return a case as a case file has it."""
    made = {
        "case": name,
        "protocol": "P3",
        "recording": "a",
        "file": "a.npz",
        "rate": 100.0,
        "frames": 40,
        "markers": 3,
        "gaps": [[0, 10, 13]],
        "peers": {TITS: {"rmse_mm": 10.0, "mean_mm": 9.0, "seconds": 1.0}},
    }
    return made | changes


def write_cases(path: Path, *entries: Any) -> Path:
    """Write a case file."""
    path.parent.mkdir(parents=True, exist_ok=True)
    path.write_text(json.dumps(entries))
    return path


def case(
    name: str, family: str = "P3", recording: str = "a", length: int = 10, **peers: float
) -> Case:
    """Return a case with one gap; peers by the names `tits`, `spline`, `rigid`, `prototype`."""
    names = {"tits": TITS, "spline": SPLINE, "rigid": RIGID}
    figures = {names.get(peer, peer): error for peer, error in peers.items()}
    gaps = (Gap(0, 5, 5 + length),)
    return Case(name, family, recording, f"{recording}.npz", 100.0, 500, 3, gaps, figures)


def trial(
    of: Case,
    method: str,
    errors: Sequence[float],
    r90: Sequence[float] | None = None,
    left_open: int = 0,
    seconds: float = 1.0,
) -> Trial:
    """Return a trial; without radii, they are 1 mm."""
    radii = np.ones(len(errors)) if r90 is None else np.array(r90, float)
    samples = len(errors) + left_open
    return Trial(of, method, samples, np.array(errors, float), radii, seconds)
