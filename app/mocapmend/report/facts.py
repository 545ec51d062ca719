"""The facts at the head of a report."""

from collections.abc import Iterator

from mocapmend.report.model import About, Report
from mocapmend.report.put_right import PutRight
from mocapmend.wording import count


def facts(report: Report, about: About) -> Iterator[tuple[str, str]]:
    """Yield what the head says: names, and what they stand for."""
    first, frames = report.first_frame, report.frames
    span = f" ({first} – {first + frames - 1} as the file counts them)" if frames else ""
    yield "Frames", f"{frames}{span}, {report.rate:g} Hz, {frames / report.rate:.2f} s"
    yield "Markers", str(len(report.labels))
    yield "Method", ", ".join(about.methods) or "none"
    if about.limits:
        yield "Limits", about.limits
    # What was set aside and then filled was not missing before; what is filled without a record is
    # in no list.
    filled = max(
        sum(row.filled for row in report.markers), sum(row.gap.length for row in report.repairs)
    )
    earlier = (
        f" ({about.earlier} of the gaps had been repaired in the file before)"
        if about.earlier
        else ""
    )
    yield "Repaired", f"{count(len(report.repairs), 'gap')}, {count(filled, 'sample')}{earlier}"
    yield from _put_right(about.put_right)
    unfilled = sum(row.unfilled for row in report.markers)
    yield "Left open", f"{count(len(report.open_gaps), 'gap')}, {count(unfilled, 'sample')}"


def _put_right(done: PutRight) -> Iterator[tuple[str, str]]:
    if done.aside:
        counts = (f"{row.problem}: {row.samples}" for row in done.aside)
        samples = sum(row.samples for row in done.aside)
        yield "Set aside", f"{count(samples, 'sample')} ({', '.join(counts)})"
    if done.moved_runs:
        samples, markers = done.moved_samples, done.moved_markers
        yield "Exchanged", f"{count(samples, 'sample')} of {count(markers, 'marker')}"
    if done.smoothed:
        methods = ", ".join(dict.fromkeys(row.method for row in done.smoothed))
        yield "Smoothed", f"{count(done.smoothed_markers, 'marker')} ({methods})"
    if done.renamed:
        yield "Renamed", count(len(done.renamed), "marker")
