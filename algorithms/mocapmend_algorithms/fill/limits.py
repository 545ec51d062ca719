"""Which gaps a method is allowed to fill: no guess passes for a repair unnoticed."""

import math
from collections.abc import Sequence
from dataclasses import dataclass
from typing import Any

from mocapmend_algorithms.fill.contract import FillResult, Patch, Unfilled
from mocapmend_algorithms.fill.hiding import fill_hiding
from mocapmend_algorithms.fill.registry import Method
from mocapmend_algorithms.gaps import Gap
from mocapmend_algorithms.progress import Progress
from mocapmend_algorithms.recording import Recording

DEFAULT_SECONDS = 0.2
DEFAULT_ERROR_MM = 20.0
INTERPOLATIONS = ("constant", "linear", "cubic", "pchip", "woltring")


@dataclass(frozen=True)
class Limits:
    """What the user allows.

    With neither, gaps longer than 0.2 s stay open where the method interpolates, and gaps with an
    expected error above 20 mm. Where the error could not be estimated, only gaps of up to 0.2 s are
    filled, and only by methods that interpolate. One limit given replaces these guards.

    Attributes
    ----------
    max_gap : int, optional
        Longer gaps stay open, in frames; 0 fills none.
    max_error_mm : float, optional
        Gaps with a larger expected 3-D RMS error stay open, and those whose error could not be
        estimated as above; infinity fills all that the method can.
    """

    max_gap: int | None = None
    max_error_mm: float | None = None

    @property
    def default(self) -> bool:
        """Whether the user gave none."""
        return self.max_gap is None and self.max_error_mm is None

    @property
    def error_mm(self) -> float:
        """Expected error above which a gap stays open."""
        if self.default:
            return DEFAULT_ERROR_MM
        return math.inf if self.max_error_mm is None else self.max_error_mm

    def frames(self, method: Method, rate: float) -> int | None:
        """Length above which a gap is not even computed; None where there is no such limit."""
        if self.max_gap is not None:
            return self.max_gap
        if self.default and method.id in INTERPOLATIONS:
            return default_frames(rate)
        return None


def default_frames(rate: float) -> int:
    """Return how many frames fit into 0.2 s."""
    return math.floor(DEFAULT_SECONDS * rate * (1 + 1e-9))


def fill_within(
    recording: Recording,
    gaps: Sequence[Gap],
    method: Method,
    params: Any,
    limits: Limits,
    progress: Progress,
) -> FillResult:
    """Fill the gaps that a method can fill within the user's limits.

    Parameters
    ----------
    recording : Recording
        Not changed.
    gaps : sequence of Gap
        The gaps to fill.
    method : Method
        How.
    params : object
        An instance of `method.params`.
    limits : Limits
        Gaps that are too long are not computed; those that turn out too uncertain are dropped.
    progress : Progress
        Handed to the method.

    Returns
    -------
    FillResult
        Every gap is in `patches` or, with the reason, in `unfilled`, in the order given.
    """
    reasons = _too_long(recording, gaps, method, params, limits)
    allowed = [gap for gap in gaps if gap not in reasons]
    filled = fill_hiding(recording, allowed, method.function, params, progress)
    return hold_to(recording, gaps, filled, method, params, limits)


def hold_to(
    recording: Recording,
    gaps: Sequence[Gap],
    filled: FillResult,
    method: Method,
    params: Any,
    limits: Limits,
) -> FillResult:
    """Drop from a method's result what the user's limits do not allow.

    Parameters
    ----------
    recording, gaps, method, params, limits
        As of `fill_within`.
    filled : FillResult
        What the method makes of the gaps; it may lack those that are too long.

    Returns
    -------
    FillResult
        As of `fill_within`.
    """
    left_open = {
        gap: Unfilled(gap, reason)
        for gap, reason in _too_long(recording, gaps, method, params, limits).items()
    }
    for patch in filled.patches:
        if patch.gap not in left_open and (reason := _doubt(patch, method, limits, recording)):
            left_open[patch.gap] = Unfilled(patch.gap, reason)
    left_open |= {unfilled.gap: unfilled for unfilled in filled.unfilled}
    return FillResult(
        tuple(patch for patch in filled.patches if patch.gap not in left_open),
        tuple(left_open[gap] for gap in gaps if gap in left_open),
        filled.notes,
    )


def _too_long(
    recording: Recording, gaps: Sequence[Gap], method: Method, params: Any, limits: Limits
) -> dict[Gap, str]:
    """Return the gaps that are not even computed, with the reasons."""
    limit = limits.frames(method, recording.rate)
    if limit is None:
        return {}
    return {
        gap: _length_reason(gap, limit, limits, recording.rate)
        for gap in gaps
        if gap.length > limit and _concerns(gap, method, params, recording)
    }


def _concerns(gap: Gap, method: Method, params: Any, recording: Recording) -> bool:
    # A gap at an edge that the method leaves open anyway: its own reason says more.
    return method.reaches_edges(params) or gap.kind(recording.frames) == "interior"


def _doubt(patch: Patch, method: Method, limits: Limits, recording: Recording) -> str:
    error, most = patch.expected_error * recording.mm, limits.error_mm
    if error > most:
        text, limit = _millimetres(error, most)
        return f"the expected error of {text} is above the{_default(limits)} limit of {limit}"
    wanted = limits.default or limits.max_error_mm is not None
    if not math.isnan(error) or not wanted or math.isinf(most):
        return ""
    if method.id not in INTERPOLATIONS:
        # A short interpolation stays near its edges; a model may end up anywhere.
        return "its error could not be estimated: there is nothing like it to test this method on"
    allowed = default_frames(recording.rate)
    if patch.gap.length <= allowed:
        return ""
    return (
        f"its error could not be estimated, and {_duration(patch.gap.length, recording.rate)} "
        f"is longer than the {_duration(allowed, recording.rate)} allowed in that case"
    )


def _length_reason(gap: Gap, limit: int, limits: Limits, rate: float) -> str:
    return (
        f"{_duration(gap.length, rate)} is longer than the{_default(limits)} "
        f"limit of {_duration(limit, rate)}"
    )


def _default(limits: Limits) -> str:
    return " default" if limits.default else ""


def _duration(frames: int, rate: float) -> str:
    ms = 1000 * frames / rate
    text = f"{ms:.0f}" if ms >= 10 or ms == round(ms) else f"{ms:.1f}"
    return f"{frames} frame{'' if frames == 1 else 's'} ({text} ms)"


def _millimetres(error: float, limit: float) -> tuple[str, str]:
    """Write two lengths with as many decimals as it takes to tell them apart."""
    for decimals in range(4):
        texts = f"{error:.{decimals}f} mm", f"{limit:.{decimals}f} mm"
        if texts[0] != texts[1]:
            return texts
    return f"{error:g} mm", f"{limit:g} mm"
