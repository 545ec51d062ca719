"""The methods paragraph of a paper, built of the report's figures alone. English, as papers are."""

import re
from collections import Counter
from collections.abc import Sequence
from dataclasses import dataclass, fields, is_dataclass
from math import isnan
from statistics import median

from mocapmend import __version__
from mocapmend.report import put_right_text, refining_text
from mocapmend.report.model import About, RepairRow, Report
from mocapmend.report.sources import SOURCES
from mocapmend.wording import count, was
from mocapmend_algorithms.fill.registry import METHODS
from mocapmend_algorithms.params import write_words

MOST_REASONS = 4
MOST_SETTINGS = 6
KINDS = (
    (re.compile(r"the expected error of .* is above"), "the expected error is above the limit"),
    (re.compile(r"\d+ frames? \(.*\) is longer than the"), "the gap is longer than the limit"),
    (
        re.compile(r"the marker is never seen (before|after) frame"),
        "the marker is not seen on both sides of the gap",
    ),
    (re.compile(r"its error could not be estimated"), "the error could not be estimated"),
)
"""Reasons that differ in their numbers alone, and what is common to them."""


@dataclass(frozen=True)
class Methods:
    """What a paper says about the repairs.

    Attributes
    ----------
    paragraph : str
        One paragraph; numbers in brackets refer to the references.
    references : tuple of str
        From number 1.
    """

    paragraph: str
    references: tuple[str, ...] = ()

    @property
    def text(self) -> str:
        """Paragraph and references as plain text, ready to paste."""
        listed = (f"[{number}] {text}" for number, text in enumerate(self.references, 1))
        return "\n".join((self.paragraph, *listed))


def describe(report: Report, about: About) -> Methods:
    """Say in a paragraph what was repaired, how, and how well.

    Parameters
    ----------
    report : Report
        The figures.
    about : About
        File, limits, earlier repairs and proofs.
    """
    used = Counter(row.method for row in report.repairs)
    references: list[str] = []
    for method in used:
        source = SOURCES.get(method)
        references += [r for r in (source.references if source else ()) if r not in references]
    sentences = (
        _facts(report, about),
        refining_text.sentence(about.refining) if about.refining else "",
        put_right_text.renamed(about.put_right),
        put_right_text.exchanged(about.put_right),
        put_right_text.set_aside(about.put_right),
        _filled(report, about, used, references),
        _settings(about),
        _earlier(report, about),
        _lengths(report),
        _errors(report.repairs),
        f"Limits: {about.limits}." if about.limits else "",
        _left_open(report),
        put_right_text.smoothed(report, about.put_right, references),
        _untouched(report, about),
        f"Check of the written file: {about.proof[0]}" if about.proof else "",
    )
    return Methods(" ".join(filter(None, sentences)), tuple(references))


def method_text(method: str, params: object) -> str:
    """Name a method with those of its parameters that differ from their defaults.

    Parameters
    ----------
    method : str
        Method id.
    params : object
        The method's parameter dataclass. Of earlier repairs there is only a mapping, in which
        defaults cannot be told from what was chosen: it is left out.
    """
    chosen = [
        f"{field.name}={_written(value)}"
        for field in (fields(params) if is_dataclass(params) else ())
        if (value := getattr(params, field.name)) != field.default
    ]
    return method + (f" ({', '.join(chosen)})" if chosen else "")


def _written(value: object) -> str:
    """Return a parameter's value as the command line takes it."""
    return write_words(value) if isinstance(value, tuple) else str(value)


def _facts(report: Report, about: About) -> str:
    samples = report.frames * len(report.labels)
    share = 100 * report.missing_before / max(samples, 1)
    gaps = sum(row.gaps_before for row in report.markers)
    done = "repaired" if len(report.repairs) > about.earlier or about.put_right else "examined"
    return (
        f"The recording {about.file} ({count(len(report.labels), 'marker')}, "
        f"{count(report.frames, 'frame')} at {report.rate:g} Hz, "
        f"{report.frames / report.rate:.2f} s) was {done} with mocapmend {__version__}. "
        f"Before, {count(report.missing_before, 'sample')} ({_percent(share)} of all) "
        f"{was(report.missing_before)} missing, in {count(gaps, 'gap')}."
    )


def _filled(report: Report, about: About, used: Counter[str], references: Sequence[str]) -> str:
    listed = sum(row.gap.length for row in report.repairs)
    # What was missing may be there because it was exchanged.
    others = sum(row.filled for row in report.markers) - listed - about.put_right.moved_samples
    text = "" if used or others > 0 else "No gap was filled."
    if used:
        ways = "; ".join(_way(method, n, references) for method, n in used.most_common())
        gaps = len(report.repairs)
        text = f"{count(gaps, 'gap')} ({count(listed, 'sample')}) {was(gaps)} filled: {ways}."
    if others > 0:
        text += f" {count(others, 'sample')} {was(others)} filled by a method that is not known."
    return text.strip()


def _settings(about: About) -> str:
    """Name the parameters that differ from the defaults, which the texts have in brackets."""
    chosen = [text for text in about.methods if "(" in text]
    if not chosen:
        return ""
    more = f"; and {len(chosen) - MOST_SETTINGS} more" * (len(chosen) > MOST_SETTINGS)
    return f"Parameters other than the defaults: {'; '.join(chosen[:MOST_SETTINGS])}{more}."


def _way(method: str, gaps: int, references: Sequence[str]) -> str:
    source = SOURCES.get(method)
    if source is None:
        return f"{gaps} by the method “{method}”"
    numbers = ", ".join(str(references.index(text) + 1) for text in source.references)
    return f"{gaps} by {source.phrase} (method “{method}”)" + f" [{numbers}]" * bool(numbers)


def _earlier(report: Report, about: About) -> str:
    if not about.earlier:
        return ""
    by = f" ({about.earlier_program})" if about.earlier_program else ""
    return (
        f"{about.earlier} of these gaps had been filled before this session, as the file's repair "
        f"record{by} says."
    )


def _lengths(report: Report) -> str:
    lengths = sorted(row.gap.length for row in report.repairs)
    if not lengths:
        return ""
    if lengths[0] == lengths[-1]:
        return f"All filled gaps were {_duration(lengths[0], report.rate)} long."
    shortest, longest = lengths[0], lengths[-1]
    return (
        f"The filled gaps were {shortest} to {longest} frames long "
        f"({_ms(shortest, report.rate)} to {_ms(longest, report.rate)} ms), with a median of "
        f"{_duration(median(lengths), report.rate)}."
    )


def _errors(repairs: Sequence[RepairRow]) -> str:
    known = [row for row in repairs if not isnan(row.expected_error_mm)]
    unknown = len(repairs) - len(known)
    if not known:
        return "The errors of the fills could not be estimated." if repairs else ""
    errors = [row.expected_error_mm for row in known]
    measured = (
        ", from stretches of the same recording that were hidden, filled in the same way and "
        "compared with what was measured,"
        if all(row.method in METHODS for row in known)
        else ""
    )
    text = (
        "The expected error of a fill (root mean square of the 3-D distance from the true "
        f"position){measured} was {_mm(median(errors))} mm in the median of the gaps and "
        f"{_mm(max(errors))} mm at most."
    )
    if unknown:
        text += f" For {count(unknown, 'gap')}, it could not be estimated."
    return text


def _left_open(report: Report) -> str:
    if not report.open_gaps:
        return "No gap was left open."
    samples = sum(row.gap.length for row in report.open_gaps)
    reasons = Counter(_kind(row.reason) for row in report.open_gaps).most_common()
    listed = [f"{reason} ({count(n, 'gap')})" for reason, n in reasons[:MOST_REASONS]]
    if others := sum(n for _, n in reasons[MOST_REASONS:]):
        listed.append(f"other reasons ({count(others, 'gap')})")
    return (
        f"{count(len(report.open_gaps), 'gap')} ({count(samples, 'sample')}) "
        f"{was(len(report.open_gaps))} left open: {'; '.join(listed)}."
    )


def _kind(reason: str) -> str:
    return next((text for pattern, text in KINDS if pattern.match(reason)), reason)


def _untouched(report: Report, about: About) -> str:
    kind = "measured" if about.refining is None else "computed"
    changed = f"{count(report.altered, f'{kind} sample')} {was(report.altered)} changed."
    if report.altered and about.put_right:
        return f"By all of this, {changed}"
    if report.altered:
        return f"Besides, {changed}"
    return f"No {kind} sample was changed."


def _duration(frames: float, rate: float) -> str:
    return f"{frames:g} {'frame' if frames == 1 else 'frames'} ({_ms(frames, rate)} ms)"


def _ms(frames: float, rate: float) -> str:
    return f"{1000 * frames / rate:.0f}"


def _mm(length: float) -> str:
    return f"{length:.1f}" if length >= 1 else f"{length:.2g}"


def _percent(share: float) -> str:
    return f"{share:.2g} %" if share < 1 else f"{share:.1f} %"
