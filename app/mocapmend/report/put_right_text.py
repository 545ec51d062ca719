"""Sentences of the methods paragraph about what was put right besides filling gaps."""

from collections.abc import Sequence
from math import isnan
from statistics import median

from mocapmend.doubts import BY_HAND
from mocapmend.report.model import Report
from mocapmend.report.put_right import AsideRow, PutRight, SmoothRow
from mocapmend.report.sources import SMOOTHING
from mocapmend.wording import count, was

MOST_NAMED = 6


def set_aside(done: PutRight) -> str:
    """Say what was set aside, detector by detector."""
    if not done.aside:
        return ""
    samples = sum(row.samples for row in done.aside)
    runs = sum(row.runs for row in done.aside)
    listed = "; ".join(map(_aside, done.aside))
    return (
        f"{count(samples, 'measured sample')} in {count(runs, 'run')} {was(samples)} set aside as "
        f"bad and treated as missing: {listed}."
    )


def _aside(row: AsideRow) -> str:
    by = BY_HAND if row.problem == BY_HAND else f"by the detector “{row.problem}”"
    return f"{row.samples} {by} ({count(row.runs, 'run')})"


def exchanged(done: PutRight) -> str:
    """Say what was exchanged between markers."""
    if not done.moved_runs:
        return ""
    found = ", ".join(f"{count(number, 'case')} of “{kind}”" for kind, number in done.found_as)
    return (
        f"{count(done.moved_samples, 'sample')} of {count(done.moved_markers, 'marker')} "
        f"{was(done.moved_samples)} exchanged between markers, in {count(done.moved_runs, 'run')}"
        + (f" (found now: {found})" if found else "")
        + "."
    )


def renamed(done: PutRight) -> str:
    """Say which markers were renamed."""
    if not done.renamed:
        return ""
    number = len(done.renamed)
    pairs = ", ".join(f"{former} to {now}" for former, now in done.renamed[:MOST_NAMED])
    more = f" and {number - MOST_NAMED} more" if number > MOST_NAMED else ""
    return f"{count(number, 'marker')} {was(number)} renamed: {pairs}{more}."


def smoothed(report: Report, done: PutRight, references: list[str]) -> str:
    """Say what was smoothed and how; the work that it is taken from is added to the references."""
    alike: dict[tuple[object, ...], list[SmoothRow]] = {}
    for row in done.smoothed:
        alike.setdefault((row.method, row.chosen), []).append(row)
    return " ".join(_group(report, rows, references) for rows in alike.values())


def _group(report: Report, rows: Sequence[SmoothRow], references: list[str]) -> str:
    first = rows[0]
    source = SMOOTHING.get(first.method)
    phrase = f"the method “{first.method}”"
    if source is not None:
        references += [each for each in source.references if each not in references]
        cited = ", ".join(str(references.index(each) + 1) for each in source.references)
        phrase = f"{source.phrase} (method “{first.method}”) [{cited}]"
    if first.chosen:
        phrase += f" with {', '.join(first.chosen)}"
    markers = dict.fromkeys(report.labels[row.run.marker] for row in rows)
    named = f" ({', '.join(markers)})" if len(markers) <= MOST_NAMED else ""
    whole = all(row.run.length == report.frames for row in rows)
    stretches = "1 stretch" if len(rows) == 1 else f"{len(rows)} stretches"
    where = "over the whole recording" if whole else f"in {stretches}"
    gaps = {gap.gap.marker for gap in report.open_gaps}
    if any(row.run.marker in gaps for row in rows):
        where += ", except for stretches of too few samples between gaps,"
    choice = source.choice if source is not None and first.automatic else ""
    who = f"{count(len(markers), 'marker')}{named} {was(len(markers))}"
    sentences = (
        f"{who} smoothed {where} by {phrase}.",
        _cutoffs(rows, choice),
        _moved(rows),
    )
    return " ".join(filter(None, sentences))


def _cutoffs(rows: Sequence[SmoothRow], choice: str) -> str:
    known = [hz for row in rows for hz in row.cutoffs_hz]
    if not known:
        return ""
    by = f", chosen by {choice}" if choice else ""
    low, high = f"{min(known):.1f}", f"{max(known):.1f}"
    if low == high:
        return f"The cut-off frequency was {low} Hz{by}."
    return (
        f"The cut-off frequencies were {low} to {high} Hz, with a median of "
        f"{median(known):.1f} Hz{by}."
    )


def _moved(rows: Sequence[SmoothRow]) -> str:
    known = [row.rms_mm for row in rows if not isnan(row.rms_mm)]
    if not known:
        return ""
    if len(known) == 1:
        return f"It moved samples by {known[0]:.2g} mm (root mean square)."
    return (
        f"It moved samples by {median(known):.2g} mm (root mean square, median of the "
        f"trajectories), by {max(known):.2g} mm at most."
    )
