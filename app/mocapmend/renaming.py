"""Labels that users give to markers: which are possible, and which points have none. No Qt."""

import unicodedata
from collections.abc import Sequence

from mocapmend.errors import MocapmendError
from mocapmend.names import short_names, subject_of
from mocapmend_algorithms.names import is_meaningful, is_unlabelled

MOST_BYTES = 255
"""Of a label: more cannot be said in a C3D file."""
MANY = 5
"""Points without a label, from which on the user is told what can be done about them."""


def checked_label(text: str) -> str:
    """Return a label without blanks at its ends.

    Raises
    ------
    MocapmendError
        If no marker can be called so.
    """
    label = text.strip()
    if not label:
        raise MocapmendError("A marker needs a name.", todo="Type one.")
    if any(unicodedata.category(sign) in {"Cc", "Zl", "Zp"} for sign in label):
        raise MocapmendError("A name must not have line breaks or other control characters.")
    size = len(label.encode("utf-8", "replace"))
    if size > MOST_BYTES:
        raise MocapmendError(
            f"This name is too long: it takes {size} bytes, and a C3D file has room for "
            f"{MOST_BYTES}."
        )
    return label


def full_label(labels: Sequence[str], typed: str) -> str:
    """Return the label that is meant by a name as people read it: with the subject that all have.

    Parameters
    ----------
    labels : sequence of str
        Of all markers, as the file has them.
    typed : str
        The name.
    """
    subject = subject_of(labels) if short_names(labels) != tuple(labels) else ""
    return f"{subject}:{typed}" if subject and ":" not in typed else typed


def without_label(labels: Sequence[str]) -> list[int]:
    """Return the points that are called as programs call what nobody has named."""
    return [
        point
        for point, label in enumerate(labels)
        if is_unlabelled(label) or not is_meaningful(label)
    ]


def hints(labels: Sequence[str]) -> tuple[str, ...]:
    """Return what there is to say about points without a label, as sentences."""
    count = len(without_label(labels))
    if count < min(MANY, max(1, len(labels))):
        return ()
    sentence = (
        f"{count} of {len(labels)} points have no label. “Label from recordings…” in the Edit menu "
        "finds out which markers they are."
    )
    return (sentence,)
