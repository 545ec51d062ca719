"""What markers are called: where people read it, and where other labels have come. No Qt."""

from collections import Counter
from collections.abc import Mapping, Sequence
from dataclasses import is_dataclass, replace
from typing import Any

from mocapmend_algorithms.names import is_unlabelled


def short_names(labels: Sequence[str]) -> tuple[str, ...]:
    """Return labels without the subject that all of them name, as in "Matt:LASI".

    Points that nobody has named, as "*12", need not name it.

    Parameters
    ----------
    labels : sequence of str
        As the file has them.

    Returns
    -------
    tuple of str
        The same labels where they do not all begin with one subject.
    """
    subject = subject_of(labels)
    if not subject:
        return tuple(labels)
    short = tuple(label.removeprefix(f"{subject}:") for label in labels)
    return short if len(set(short)) == len(set(labels)) else tuple(labels)


def subject_of(labels: Sequence[str]) -> str:
    """Return the subject that all labels name which say what a point is; "" if there is none."""
    subjects = {label.partition(":")[0] for label in labels if ":" in label}
    named = all(":" in label or is_unlabelled(label) for label in labels)
    return subjects.pop() if len(subjects) == 1 and named else ""


def new_names(before: Sequence[str], after: Sequence[str]) -> dict[str, str]:
    """Return what those markers are called now that are called otherwise.

    Parameters
    ----------
    before, after : sequence of str
        The labels of all markers.

    Returns
    -------
    dict of str to str
        New label by former one; without those that several markers had.
    """
    count = Counter(before)
    pairs = zip(before, after, strict=True)
    return {old: new for old, new in pairs if old != new and count[old] == 1}


def with_donors(params: Any, calls: Mapping[str, str]) -> Any:
    """Return a method's parameters with other names for the donors that they list.

    Parameters
    ----------
    params : object
        The parameter dataclass, or a mapping as repair records have it.
    calls : mapping of str to str
        New label by former one.

    Returns
    -------
    object
        The same object where nothing is called otherwise.
    """
    named = isinstance(params, Mapping)
    donors = params.get("donors") if named else getattr(params, "donors", None)
    if not isinstance(donors, list | tuple) or not any(label in calls for label in donors):
        return params
    new = tuple(calls.get(label, label) for label in donors)
    if named:
        return {**params, "donors": type(donors)(new)}
    assert is_dataclass(params) and not isinstance(params, type)
    return replace(params, donors=new)
