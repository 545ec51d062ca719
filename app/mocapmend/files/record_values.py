"""The values of JSON objects in repair records, made sure: records come from damaged files too."""

import math
from collections.abc import Callable, Collection, Mapping
from typing import Any, TypeVar

MOST_ENTRIES = 1_000_000
DIGITS = 4
"""Significant digits of an expected error: more would mean nothing."""
LARGEST_FRAME = 2**53
LONGEST_TEXT = 1000
SCALARS = (str, int, float, type(None))

Kinds = Mapping[str, tuple[type, ...]]
Entry = TypeVar("Entry")


def entries_of(data: object, read: Callable[[object], Entry], without: str) -> tuple[Entry, ...]:
    """Read the entries of a JSON list.

    Raises
    ------
    ValueError
        If it is none (with the text `without`), or if `read` raises it.
    """
    if not isinstance(data, list) or len(data) > MOST_ENTRIES:
        raise ValueError(without)
    return tuple(map(read, data))


def values_of(data: object, kinds: Kinds, what: str, long: Collection[str] = ()) -> dict[str, Any]:
    """Return what a JSON object has under some keys, of which some may be long.

    Raises
    ------
    ValueError
        If it is none, or if a value is missing, of another kind, or too large.
    """
    if not isinstance(data, dict):
        raise ValueError(f"{what} is not an object")
    wrong = _wrong_key(data, kinds)
    if wrong is not None:
        raise ValueError(f"{wrong!r} of {what} is missing or of another kind")
    values = {key: data[key] for key in kinds}
    if not all(is_plain(value) for key, value in values.items() if key not in long):
        raise ValueError(f"a number or a text of {what} is too large")
    return values


def _wrong_key(data: Mapping[str, object], kinds: Kinds) -> str | None:
    """Return the first key that is missing or of another kind."""
    for key, allowed in kinds.items():
        value = data.get(key)
        a_bool = isinstance(value, bool) and bool not in allowed
        if key not in data or a_bool or not isinstance(value, allowed):
            return key
    return None


def parameter(value: object, listed: tuple[type, ...] = (str,)) -> object:
    """Return a parameter as it was before it was written: JSON has no tuples.

    Raises
    ------
    ValueError
        If it is neither a number nor a text, nor a list of texts, or of what `listed` says.
    """
    parts = value if isinstance(value, list) else [value]
    kinds = listed if isinstance(value, list) else SCALARS
    if not all(isinstance(part, kinds) and is_plain(part) for part in parts):
        raise ValueError("a parameter is neither a number nor a text, nor a list of texts")
    return tuple(value) if isinstance(value, list) else value


def is_plain(value: object) -> bool:
    """Say whether a value is none of those that a damaged file has and a program trips over."""
    if isinstance(value, (int, float)):
        return abs(value) <= LARGEST_FRAME
    return not isinstance(value, str) or len(value) <= LONGEST_TEXT


def rounded(value: float) -> float | None:
    """Return an error with few digits; None where it is unknown."""
    return float(f"{value:.{DIGITS}g}") if math.isfinite(value) else None
