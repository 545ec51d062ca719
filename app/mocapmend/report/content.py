"""What a report says, part by part, for all of its forms: the same content in HTML and PDF."""

from collections.abc import Iterator
from dataclasses import dataclass
from typing import ClassVar

from mocapmend import __version__
from mocapmend.report import charts, put_right_text, refining_text, tables
from mocapmend.report.facts import facts
from mocapmend.report.methods import describe
from mocapmend.report.model import About, Report
from mocapmend.report.put_right import PutRight
from mocapmend.report.tables import Table
from mocapmend.wording import count
from mocapmend_algorithms.metrics import SuccessCurves

KINDS = (
    ("instantaneous", "Tracked now"),
    ("running_mean", "Tracked so far (running mean)"),
    ("survival", "Never lost since the first frame"),
)


@dataclass(frozen=True)
class Text:
    """A paragraph; what only explains is dimmed."""

    kind: ClassVar = "text"
    text: str
    dim: bool = False


@dataclass(frozen=True)
class Pairs:
    """Names and what they stand for."""

    kind: ClassVar = "pairs"
    rows: tuple[tuple[str, str], ...]


@dataclass(frozen=True)
class Bullets:
    """A list of sentences."""

    kind: ClassVar = "bullets"
    items: tuple[str, ...]
    warning: bool = False


@dataclass(frozen=True)
class Figures:
    """Charts beside each other, with their key; bands mark what was repaired."""

    kind: ClassVar = "figures"
    charts: tuple[charts.Chart, ...]
    bands: bool = False


Part = Text | Pairs | Bullets | Figures | Table


@dataclass(frozen=True)
class Section:
    """A heading and what is under it."""

    anchor: str
    title: str
    parts: tuple[Part, ...]


@dataclass(frozen=True)
class Content:
    """A report, ready to be laid out.

    Attributes
    ----------
    title, subtitle : str
        The recording, and what this is.
    head : tuple
        The facts before the first heading.
    sections : tuple of Section
        In order.
    """

    title: str
    subtitle: str
    head: tuple[Part, ...]
    sections: tuple[Section, ...]


def contents(report: Report, about: About) -> Content:
    """Lay down what a report says; the same for the same input."""
    sections = (
        Section("warnings", "Warnings about the file", tuple(_warnings(about))),
        Section("methods", "Methods paragraph", tuple(_methods(report, about))),
        Section("refinement", "Refinement", tuple(_refinement(about))),
        Section("success", "Tracking success", tuple(_success(report))),
        Section("bones", "Bone lengths", tuple(_bones(report))),
        Section("markers", "Markers", tuple(_markers(report))),
        Section("bad", "Bad samples", tuple(_bad(about.put_right))),
        Section("names", "Renamed markers", tuple(_names(about.put_right))),
        Section("repairs", "Repairs", tuple(_repairs(report))),
        Section("open", "Gaps left open", tuple(_open(report))),
        Section("smoothing", "Smoothing", tuple(_smoothing(report, about.put_right))),
        Section("history", "History of edits", tuple(_history(report, about))),
        Section("check", "Check of the written file", tuple(_check(about))),
    )
    return Content(
        about.file,
        f"Repair report, mocapmend {__version__}",
        (Pairs(tuple(facts(report, about))),),
        tuple(section for section in sections if section.parts),
    )


def _warnings(about: About) -> Iterator[Part]:
    if about.warnings:
        yield Bullets(about.warnings, warning=True)


def _methods(report: Report, about: About) -> Iterator[Part]:
    methods = describe(report, about)
    yield Text("Ready to paste; all of it follows from the figures below.", dim=True)
    yield Text(methods.paragraph)
    if methods.references:
        yield Bullets(tuple(f"[{n}] {text}" for n, text in enumerate(methods.references, 1)))


def _refinement(about: About) -> Iterator[Part]:
    done = about.refining
    if done is None:
        return
    yield Bullets(refining_text.cautions(done), warning=True)
    yield Pairs(refining_text.facts(done))
    if done.judged is not None:
        yield refining_text.errors(done.judged)
        yield refining_text.distances(done.judged)


def _success(report: Report) -> Iterator[Part]:
    yield Text(
        "Share of the markers that are present and not known to be wrong. Markers never seen in "
        "the recording do not count.",
        dim=True,
    )
    if report.wrong_before:
        samples = max(report.frames * len(report.labels), 1)
        shares = (
            tables.percent(100 * number / samples)
            for number in (report.missing_before, report.wrong_before)
        )
        yield Text(
            "Before, {} % of all samples were missing, and {} % were there but wrong: they are "
            "set aside or exchanged since.".format(*shares)
        )
    yield Figures(tuple(_curves(report, "markers (%)", None)))
    if report.segment_success is not None:
        yield Text(
            f"The same for {count(report.segments, 'segment')}: markers that keep their "
            "distances to each other. A segment counts as tracked when all its markers are.",
            dim=True,
        )
        yield Figures(tuple(_curves(report, "segments (%)", report.segment_success)))


def _curves(
    report: Report, y_label: str, pair: tuple[SuccessCurves, SuccessCurves] | None
) -> Iterator[charts.Chart]:
    before, after = pair or (report.success_before, report.success_after)
    for kind, title in KINDS:
        old, new = 100 * getattr(before, kind), 100 * getattr(after, kind)
        yield charts.draw(title, y_label, report.rate, old, new, top=100.0)


def _bones(report: Report) -> Iterator[Part]:
    if not report.bones:
        yield Text("No pair of markers keeps its distance, so no bones could be measured.")
        return
    if not report.shown_bones:
        yield Text("No repair touches a bone.")
        return
    yield Text(
        f"Bones with the most repaired frames ({len(report.shown_bones)} of {len(report.bones)}). "
        "A bone is a pair of markers whose distance is nearly constant; a repair that bends its "
        "curve is doubtful. Smoothing alone does not count as a repair.",
        dim=True,
    )
    drawn = (
        charts.draw(
            report.bone_names[bone],
            f"length ({report.unit})",
            report.rate,
            report.lengths_before[:, column],
            report.lengths_after[:, column],
            changed=report.changed[:, column],
        )
        for column, bone in enumerate(report.shown_bones)
    )
    yield Figures(tuple(drawn), bands=True)
    yield Text("Spread of the length: standard deviation over mean.", dim=True)
    yield tables.bones(report)


def _markers(report: Report) -> Iterator[Part]:
    touched = [row for row in report.markers if row.gaps_before or row.gaps_after]
    if touched:
        yield tables.markers(report, touched)
    complete = len(report.markers) - len(touched)
    if complete:
        further = "further " if touched else ""
        yield Text(
            f"{complete} {further}{'marker is' if complete == 1 else 'markers are'} complete."
        )


def _bad(done: PutRight) -> Iterator[Part]:
    if done.aside:
        yield Text(
            "Measured samples that were set aside count as missing; what was measured is kept in "
            "the repair record.",
            dim=True,
        )
        yield tables.set_aside(done)
    if sentence := put_right_text.exchanged(done):
        yield Text(sentence)


def _names(done: PutRight) -> Iterator[Part]:
    if done.renamed:
        yield tables.names(done)


def _smoothing(report: Report, done: PutRight) -> Iterator[Part]:
    if done.smoothed:
        yield Text(
            "What was measured there is in the original file alone. Cut-off: of x, y and z, or of "
            "all three. RMS change: how far samples were moved, root mean square.",
            dim=True,
        )
        yield tables.smoothing(report, done)


def _repairs(report: Report) -> Iterator[Part]:
    if not report.repairs:
        yield Text("Nothing was repaired.")
        return
    yield Text(
        "Expected error: root mean square of the distance from the true position. 90 % radius: "
        "holds the true position with probability 0.9, median over the gap. A dash: could not be "
        "estimated.",
        dim=True,
    )
    yield tables.repairs(report)


def _open(report: Report) -> Iterator[Part]:
    yield tables.open_gaps(report) if report.open_gaps else Text("None.")


def _history(report: Report, about: About) -> Iterator[Part]:
    if about.earlier:
        by = f" ({about.earlier_program})" if about.earlier_program else ""
        yield Text(f"When the file was opened, it had {count(about.earlier, 'repair')}{by}.")
    if about.edits:
        yield tables.history(about)
    else:
        yield Text("No further edits." if about.earlier else "No edits.")


def _check(about: About) -> Iterator[Part]:
    if about.proof:
        yield Text("This was found when the written file was read back:")
        yield Bullets(about.proof)
    else:
        yield Text("This report was made without writing a recording, so no file was checked.")
