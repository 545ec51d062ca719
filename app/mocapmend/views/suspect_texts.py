"""What is said of runs of bad samples, in the user's language."""

import math
from collections.abc import Sequence

from PySide6.QtCore import QCoreApplication

from mocapmend.doubts import BY_HAND
from mocapmend.problem_list import GAP
from mocapmend.suspects import LABELS
from mocapmend.translate import QT_TRANSLATE_NOOP
from mocapmend.unsure_labels import UNSURE
from mocapmend.views.engine_texts import detector_name, detector_text, shown
from mocapmend_algorithms import Recording
from mocapmend_algorithms.problems import BadRun
from mocapmend_algorithms.problems.registry import DETECTORS

translate = QCoreApplication.translate
REST = "; the rest is explained otherwise."
"""What follows the reason of a run of which a part belongs to another one."""

_KINDS = {
    GAP: QT_TRANSLATE_NOOP("Suspects", "Gap"),
    "spikes": QT_TRANSLATE_NOOP("Suspects", "Spike"),
    "swaps": QT_TRANSLATE_NOOP("Suspects", "Swap"),
    "fragments": QT_TRANSLATE_NOOP("Suspects", "Fragment"),
    "tails": QT_TRANSLATE_NOOP("Suspects", "Ragged"),
    "frozen": QT_TRANSLATE_NOOP("Suspects", "Frozen"),
    "bone-breaks": QT_TRANSLATE_NOOP("Suspects", "Bone"),
    "far": QT_TRANSLATE_NOOP("Suspects", "Far"),
    "reflections": QT_TRANSLATE_NOOP("Suspects", "Double"),
    UNSURE: QT_TRANSLATE_NOOP("Suspects", "Label?"),
    LABELS: QT_TRANSLATE_NOOP("Suspects", "Label"),
    BY_HAND: QT_TRANSLATE_NOOP("Suspects", "By hand"),
}
"""What one of them is called where there is little room."""


_NAMES = {
    "spikes": QT_TRANSLATE_NOOP("Suspects", "Spike"),
    "swaps": QT_TRANSLATE_NOOP("Suspects", "Swapped labels"),
    "fragments": QT_TRANSLATE_NOOP("Suspects", "Fragment or ghost"),
    "tails": QT_TRANSLATE_NOOP("Suspects", "Ragged end"),
    "frozen": QT_TRANSLATE_NOOP("Suspects", "Frozen samples"),
    "bone-breaks": QT_TRANSLATE_NOOP("Suspects", "Broken bone"),
    "far": QT_TRANSLATE_NOOP("Suspects", "Far from the body"),
    "reflections": QT_TRANSLATE_NOOP("Suspects", "Coinciding points"),
    UNSURE: QT_TRANSLATE_NOOP("Suspects", "Unsure label"),
    LABELS: QT_TRANSLATE_NOOP("Suspects", "Of no label"),
    BY_HAND: QT_TRANSLATE_NOOP("Suspects", "Set aside by hand"),
}
"""What one of them is called where there is room."""


def kind_text(kind: str) -> str:
    """Return what a gap, or a bad run of a kind, is called; the id of one that is not known."""
    known = _KINDS.get(kind)
    return kind if known is None else translate("Suspects", known)


def kinds_text(kind: str) -> str:
    """Return what the bad runs of a kind are called together, in whole words."""
    if kind == UNSURE:
        return translate("Suspects", "Labels to review")
    return detector_name(kind) if kind in DETECTORS else kind_text(kind)


def help_text(kind: str) -> str:
    """Return what the bad runs of a kind are; empty where there is no more to say."""
    if kind == UNSURE:
        return translate(
            "Suspects",
            "Proposed labels that are too unsure to be given: accept or reject each. Error: how "
            "unsure they are, times the distance to the nearest other point.",
        )
    return detector_text(DETECTORS[kind].help) if kind in DETECTORS else ""


def reason_text(run: BadRun) -> str:
    """Return why a run is held for bad."""
    whole = run.reason.removesuffix(REST)
    if whole == run.reason:
        return shown(run.reason)
    return shown(f"{whole}.") + " " + translate("Suspects", "The rest is explained otherwise.")


def markers_text(run: BadRun, names: Sequence[str]) -> str:
    """Return the marker of a run, or both where samples are in each other's place."""
    if run.other is None or run.kind not in ("swaps", "fragments"):
        return names[run.marker]
    return f"{names[run.marker]} ↔ {names[run.other]}"


def title_text(run: BadRun, names: Sequence[str]) -> str:
    """Return what a run is and of which marker."""
    text, name = translate("Suspects", "{0}: {1}"), _NAMES.get(run.kind, run.kind)
    return text.format(translate("Suspects", name), markers_text(run, names))


def deviation_text(run: BadRun, recording: Recording) -> str:
    """Return how far a run is off; empty where nobody knows, and for labels."""
    if run.kind == UNSURE or math.isnan(run.deviation):
        return ""
    off = f"{run.deviation * recording.mm:.1f}"
    return translate("Suspects", "{0} mm off").format(off)


def score_text(run: BadRun) -> str:
    """Return how sure it is that a run is bad; empty where nobody has said it."""
    if math.isnan(run.score):
        return ""
    return translate("Suspects", "{0} % sure").format(f"{100.0 * run.score:.0f}")
