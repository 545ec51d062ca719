"""A plan as a small file, to repair any recording alike: detectors, a method, limits, smoothing."""

import json
import math
from dataclasses import asdict, dataclass
from pathlib import Path
from typing import Any, NamedTuple

from mocapmend.errors import MocapmendError
from mocapmend.files.atomic import write_bytes
from mocapmend.files.opening import read_whole
from mocapmend.files.provenance import PROGRAM, decode_document
from mocapmend.prospects import Way
from mocapmend_algorithms.fill import registry
from mocapmend_algorithms.fill.limits import Limits
from mocapmend_algorithms.problems import registry as detectors
from mocapmend_algorithms.smooth import registry as smoothers

KEY = "mocapmend_plan"
MOST_BYTES = 1_000_000


class Smoothing(NamedTuple):
    """A smoothing method with its parameters."""

    method: str
    params: Any

    @classmethod
    def default(cls, method: str) -> "Smoothing":
        """Return a method with the parameters that it has by itself."""
        return cls(method, smoothers.smoother(method).params())


@dataclass(frozen=True)
class Plan:
    """What to do with a recording.

    Attributes
    ----------
    way : Way
        The method and its parameters.
    max_gap_ms : float or None
        Longer gaps stay open; None for no such limit. In time, since rates differ.
    max_error_mm : float
        Gaps with a larger expected error stay open; infinity fills all that the method can.
    fix : tuple of str
        Detectors, by id: what they find is put right before gaps are filled.
    smooth : Smoothing or None
        How all markers are smoothed after that; None for no smoothing.
    """

    way: Way
    max_gap_ms: float | None = None
    max_error_mm: float = math.inf
    fix: tuple[str, ...] = ()
    smooth: Smoothing | None = None

    def limits(self, rate: float) -> Limits:
        """Return the limits for a recording of `rate` frames per second (Hz)."""
        longest = None
        if self.max_gap_ms is not None:
            longest = math.floor(self.max_gap_ms * rate / 1000.0 + 1e-6)
        return Limits(longest, self.max_error_mm)


def write_plan(plan: Plan, path: Path) -> None:
    """Write a plan; a file of that name is replaced.

    Raises
    ------
    MocapmendError
        If it cannot be written.
    """
    document: dict[str, Any] = {
        KEY: 1,
        "program": PROGRAM,
        "method": plan.way.method,
        "parameters": asdict(plan.way.params),
        "max_gap_ms": plan.max_gap_ms,
        "max_error_mm": plan.max_error_mm if math.isfinite(plan.max_error_mm) else None,
    }
    # Versions of before know neither.
    if plan.fix:
        document["fix"] = list(plan.fix)
    if plan.smooth is not None:
        method, params = plan.smooth
        document["smooth"] = {"method": method, "parameters": asdict(params)}
    write_bytes(path, (json.dumps(document, indent=1) + "\n").encode("ascii"))


def read_plan(path: Path) -> Plan:
    """Read a plan.

    Raises
    ------
    MocapmendError
        If it is not one.
    """
    try:
        return _decode(decode_document(read_whole(path, MOST_BYTES), KEY))
    except (KeyError, ValueError) as error:
        raise _no_plan(path, str(error.args[0])) from None


def _decode(data: dict[str, Any]) -> Plan:
    name, parameters = data.get("method"), data.get("parameters")
    if not isinstance(name, str) or not isinstance(parameters, dict):
        raise ValueError("it has no method with parameters")
    method = registry.method(name)
    plain = {k: tuple(v) if isinstance(v, list) else v for k, v in parameters.items()}
    longest, error = _number(data, "max_gap_ms"), _number(data, "max_error_mm")
    way = Way(method.id, registry.restore_params(method, plain))
    fix = data.get("fix", [])
    if not isinstance(fix, list) or not all(isinstance(name, str) for name in fix):
        raise ValueError("its 'fix' is not a list of detectors")
    return Plan(
        way,
        longest,
        math.inf if error is None else error,
        tuple(each.id for each in detectors.chosen(fix)),
        _smoothing(data.get("smooth")),
    )


def _smoothing(data: object) -> Smoothing | None:
    if data is None:
        return None
    name = data.get("method") if isinstance(data, dict) else None
    parameters = data.get("parameters", {}) if isinstance(data, dict) else None
    if not isinstance(name, str) or not isinstance(parameters, dict):
        raise ValueError("its 'smooth' is no method with parameters")
    smoother = smoothers.smoother(name)
    plain = {k: tuple(v) if isinstance(v, list) else v for k, v in parameters.items()}
    return Smoothing(smoother.id, smoothers.restore_params(smoother, plain))


def _number(data: dict[str, Any], key: str) -> float | None:
    value = data.get(key)
    if value is None:
        return None
    known = isinstance(value, (int, float)) and not isinstance(value, bool)
    if not known or not math.isfinite(value) or value < 0:
        raise ValueError(f"its {key!r} is not a number from 0 upwards")
    return float(value)


def _no_plan(path: Path, why: str) -> MocapmendError:
    return MocapmendError(
        f"This is not a plan: {why}.", str(path), "Choose a file that was saved as a plan."
    )
