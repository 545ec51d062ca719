"""What the timeline says in words: its tooltips, and what a screen reader is told."""

import numpy as np
from PySide6.QtCore import QCoreApplication

from mocapmend.document import Document
from mocapmend.edits import Smoothed
from mocapmend.files import Event
from mocapmend.state import OPEN
from mocapmend.views.engine_texts import smoother_name
from mocapmend.views.event_lane import name_of, whole_frame
from mocapmend.views.suspect_texts import reason_text, score_text, title_text
from mocapmend.viewstate import ViewState
from mocapmend_algorithms import Gap
from mocapmend_algorithms.problems import BadRun

translate = QCoreApplication.translate


def lane_tip(
    document: Document, marker: int, gap: Gap | None, *, on_lane: bool, frame: float = -1.0
) -> str:
    """Return the tooltip of a place on a marker's lane, or of its name."""
    original, label = document.original, document.original.labels[marker]
    if gap is None:
        for run, made in document.smoothed.items():
            if run.marker == marker and run.start <= frame < run.stop:
                return _smoothed_tip(document, run, made)
        text = translate("TimelineTexts", "{0}: measured here") if on_lane else "{0}"
        return text.format(label)
    first, last = gap.start + original.first_frame, gap.stop - 1 + original.first_frame
    if gap in document.repairs:
        text = translate("TimelineTexts", "{0}: repaired, frames {1} to {2}")
        return text.format(label, first, last)
    text = translate("TimelineTexts", "{0}: missing from frame {1} to {2}, {3} frames ({4} ms)")
    return text.format(label, first, last, gap.length, round(1000.0 * gap.length / original.rate))


def suspect_tip(document: Document, run: BadRun) -> str:
    """Return the tooltip of bad samples."""
    original = document.original
    first, last = run.start + original.first_frame, run.stop - 1 + original.first_frame
    text = translate("TimelineTexts", "{0}, frames {1} to {2}")
    text = text.format(title_text(run, document.labels), first, last)
    return "\n".join(filter(None, (text, score_text(run), reason_text(run))))


def _smoothed_tip(document: Document, run: Gap, made: Smoothed) -> str:
    original = document.original
    text = translate("TimelineTexts", "{0}: smoothed, frames {1} to {2} ({3}, moved by {4} mm RMS)")
    return text.format(
        original.labels[run.marker],
        run.start + original.first_frame,
        run.stop - 1 + original.first_frame,
        smoother_name(made.method),
        f"{made.rms * original.mm:.2f}",
    )


def event_tip(document: Document, event: Event) -> str:
    """Return the tooltip of an event."""
    original = document.original
    return translate("TimelineTexts", "{0}, frame {1}, {2} s").format(
        name_of(event),
        whole_frame(event) + original.first_frame,
        f"{event.frame / original.rate:.2f}",
    )


def description(document: Document, view: ViewState) -> str:
    """Return what is under the playhead, in sentences."""
    original, frame = document.original, view.frame
    if not original.frames:
        return translate("TimelineTexts", "The recording has no frames.")
    missing = int(np.count_nonzero(np.isin(document.state[frame], OPEN)))
    sentences = [
        translate("TimelineTexts", "Frame {0}, {1} s: {2} of {3} markers are missing.").format(
            frame + original.first_frame,
            f"{frame / original.rate:.2f}",
            missing,
            original.markers,
        )
    ]
    if view.gap is not None:
        tip = lane_tip(document, view.gap.marker, view.gap, on_lane=True)
        sentences.append(translate("TimelineTexts", "Current gap: {0}.").format(tip))
    if view.suspect is not None:
        tip = suspect_tip(document, view.suspect).replace("\n", ". ")
        sentences.append(translate("TimelineTexts", "Current problem: {0}").format(tip))
    if view.span is not None:
        sentences.append(
            translate("TimelineTexts", "Selected: frames {0} to {1}.").format(
                view.span[0] + original.first_frame, view.span[1] - 1 + original.first_frame
            )
        )
    return " ".join(sentences)
