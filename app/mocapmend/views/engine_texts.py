"""Texts of packages without Qt, in the user's language.

Those packages speak English, in whole sentences with numbers and names in them. The catalogue lists
the sentences with {0}, {1}, ... where they change. What it does not list is shown as it is.
"""

import re
from functools import cache, lru_cache

from PySide6.QtCore import QCoreApplication

from mocapmend.errors import MocapmendError
from mocapmend.views.catalogue.checks import CHECKS, SEPARATOR
from mocapmend.views.catalogue.corrections import CORRECTIONS
from mocapmend.views.catalogue.errors import ERRORS
from mocapmend.views.catalogue.labels import LABELS
from mocapmend.views.catalogue.reasons import REASONS
from mocapmend.views.catalogue.refining import REFINEMENT
from mocapmend.views.catalogue.smoothing import SMOOTHING
from mocapmend.views.catalogue.warnings import WARNINGS
from mocapmend_algorithms.fill.registry import method_label
from mocapmend_algorithms.smooth.registry import smoother_label

SENTENCES = (
    *REASONS,
    *WARNINGS,
    *ERRORS,
    *CHECKS,
    *CORRECTIONS,
    *SMOOTHING,
    *LABELS,
    *REFINEMENT,
)
_PLACE = re.compile(r"\{\d\}")
_METHOD_LAST = {"fill {0} gaps ({1})", "fill {0} ({1})"}
"""Sentences whose last part is a method's id; a marker may be called like one."""
_DETECTOR_LAST = {"fix {0} problems ({1})", "fix {0} ({1})"}
"""Sentences whose last part is a detector's id."""
_SMOOTHER_LAST = {"smooth {0} markers ({1})", "smooth {0} ({1})"}


def method_text(text: str) -> str:
    """Return a label, a help or a choice of the table of methods in the user's language."""
    return QCoreApplication.translate("Methods", text) if text else ""


def method_name(method_id: str) -> str:
    """Return a method's label in the user's language; the id of one that is not known."""
    return method_text(method_label(method_id))


def detector_text(text: str) -> str:
    """Return a label or a help of the table of detectors in the user's language."""
    return QCoreApplication.translate("Detectors", text)


def detector_name(detector_id: str) -> str:
    """Return a detector's label in the user's language; the id of one that is not known."""
    # Not at the top: the window starts without it.
    from mocapmend_algorithms.problems.registry import DETECTORS

    known = DETECTORS.get(detector_id)
    return detector_id if known is None else detector_text(known.label)


def smoother_name(smoother_id: str) -> str:
    """Return a smoothing method's label in the user's language, as `method_name`."""
    return method_text(smoother_label(smoother_id))


def segment_name(name: str) -> str:
    """Return a segment's name in the user's language; one of the user's own templates as it is."""
    return QCoreApplication.translate("Segments", name) if name else ""


def shown(text: str) -> str:
    """Return a sentence of a package without Qt in the user's language.

    Parameters
    ----------
    text : str
        A reason, a warning, the name of an edit, or part of an error.

    Returns
    -------
    str
        The translation, with the changing parts put in; the text itself if it is in no catalogue.
    """
    found = find(text) if text else None
    if found is None:
        return text
    template, parts = found
    translated = QCoreApplication.translate("Sentences", template)
    if template in _METHOD_LAST:
        return translated.format(*parts[:-1], method_name(parts[-1]))
    if template in _DETECTOR_LAST:
        return translated.format(*parts[:-1], detector_name(parts[-1]))
    if template in _SMOOTHER_LAST:
        return translated.format(*parts[:-1], smoother_name(parts[-1]))
    return translated.format(*map(_shown_part, parts)) if parts else translated


def error_text(error: MocapmendError) -> str:
    """Return an error in one line in the user's language."""
    place = f"{error.where}: " if error.where else ""
    return place + " ".join(shown(part) for part in (error.what, error.todo) if part)


@lru_cache(maxsize=4096)
def find(text: str) -> tuple[str, tuple[str, ...]] | None:
    """Return the sentence of the catalogue that fits a text, and the parts that change in it."""
    for template, start, end in _templates():
        # Patterns take long to make: only those are made that may fit.
        may_fit = text.startswith(start) and text.endswith(end)
        if may_fit and (match := _pattern(template).fullmatch(text)):
            return template, match.groups()
    return None


def _shown_part(part: str) -> str:
    """Translate a part that is a sentence itself, or a list of such."""
    if find(part) is not None:
        return shown(part)
    pieces = part.split(", ")
    translated = [shown(piece) for piece in pieces]
    if translated == pieces:
        return part
    return QCoreApplication.translate("Sentences", SEPARATOR).join(translated)


@cache
def _templates() -> tuple[tuple[str, str, str], ...]:
    """Return all sentences, the most fixed first, with what comes before and after all places."""
    fixed = sorted(SENTENCES, key=lambda text: len(_PLACE.sub("", text)), reverse=True)
    pieces = [_PLACE.split(text) for text in fixed]
    return tuple((text, some[0], some[-1]) for text, some in zip(fixed, pieces, strict=True))


@cache
def _pattern(template: str) -> re.Pattern[str]:
    """Make a pattern of which group k is what {k} stands for."""
    pieces = re.split(r"(\{\d\})", template)
    return re.compile(
        "".join("(.+?)" if _PLACE.fullmatch(piece) else re.escape(piece) for piece in pieces),
        re.DOTALL,
    )
