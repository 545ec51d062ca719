"""What the parameters of a method say about themselves, and how text becomes parameters.

A method's parameters are a frozen dataclass whose fields are made by `option`: forms, the command
line and the documentation are generated from them.
"""

import csv
import dataclasses
import types
from collections.abc import Mapping, Sequence
from typing import Any, Literal, Union, get_args, get_origin, get_type_hints

WORDS = {"true": True, "yes": True, "on": True, "1": True}
WORDS |= {"false": False, "no": False, "off": False, "0": False}
LARGEST = 1e300
"""Of all numbers: whole ones that are larger cannot be written as others are."""
AUTOMATIC = ("auto", "automatic", "none", "")
Words = tuple[str, ...]
"""The type of a parameter that lists names; see `parse_words` for its form as text."""


def option(
    default: Any,
    *,
    label: str,
    text: str,
    minimum: float | None = None,
    maximum: float | None = None,
    unit: str = "",
    training: bool = False,
) -> Any:
    """Make a dataclass field that describes itself.

    Parameters
    ----------
    default : int, float, bool, str, tuple of str or None
        The default; None and () mean that the program chooses.
    label, text : str
        A few words for a form, and a sentence of help.
    minimum, maximum : float, optional
        The values allowed, both included.
    unit : str
        Shown behind the value.
    training : bool
        Whether it names a training set; see `training_option`.

    Returns
    -------
    dataclasses.Field
        With metadata `label`, `help`, `min`, `max`, `unit` and `training`.
    """
    metadata = {"label": label, "help": text, "min": minimum, "max": maximum, "unit": unit}
    return dataclasses.field(default=default, metadata=metadata | {"training": training})


def training_option(text: str) -> Any:
    """Make a dataclass field that names a training set, by default none.

    Its value is the path of a file, or the name of one that ships with the program; the method gets
    a path. Empty means that the method learns from the recording itself.

    Parameters
    ----------
    text : str
        A sentence of help: what the method learns from it.

    Returns
    -------
    dataclasses.Field
        As of `option`.
    """
    return option("", label="Learn from", text=text, training=True)


def training_names(kind: type[Any]) -> tuple[str, ...]:
    """Return the names of a parameter class's fields that name training sets."""
    return tuple(f.name for f in dataclasses.fields(kind) if f.metadata.get("training"))


def parse(kind: type[Any], pairs: Mapping[str, str]) -> Any:
    """Make parameters from text, as the command line has it.

    Parameters
    ----------
    kind : type
        The dataclass of a method's parameters.
    pairs : mapping of str to str
        Name and value of the parameters that differ from their defaults.

    Returns
    -------
    object
        An instance of `kind`.

    Raises
    ------
    ValueError
        If a name is unknown, or a value is not of its type or outside its bounds.
    """
    fields = {f.name: f for f in dataclasses.fields(kind)}
    hints = get_type_hints(kind)
    values = {}
    for name, text in pairs.items():
        if name not in fields:
            known = ", ".join(fields) or "none"
            raise ValueError(f"there is no parameter {name!r}; the parameters are: {known}")
        values[name] = _value(name, text.strip(), hints[name])
        _check_bounds(name, values[name], fields[name].metadata)
    return kind(**values)


def restore(kind: type[Any], values: Mapping[str, Any]) -> Any:
    """Make parameters from what `dataclasses.asdict` or a JSON file has of them.

    Parameters
    ----------
    kind : type
        The dataclass of a method's parameters.
    values : mapping of str to object
        Name and value; those that are missing have their defaults.

    Returns
    -------
    object
        An instance of `kind`.

    Raises
    ------
    ValueError
        If a name is unknown, or a value is not of its type or outside its bounds.
    """
    lists = {name: tuple(map(str, v)) for name, v in values.items() if isinstance(v, list | tuple)}
    others = {name: v for name, v in values.items() if name not in lists}
    text = {name: "auto" if v is None else str(v) for name, v in others.items()}
    hints = get_type_hints(kind)
    for name in lists:
        if hints.get(name) != Words:
            raise ValueError(f"{name} must not be a list")
    return dataclasses.replace(parse(kind, text), **lists)


def parse_words(text: str) -> Words:
    """Return the names in a text, separated by commas, each once; none where it says so.

    A name that holds a comma itself stands in double quotes, as in a CSV file.
    """
    if text.strip().lower() in AUTOMATIC:
        return ()
    (names,) = csv.reader([" ".join(text.splitlines())], skipinitialspace=True)
    return tuple(dict.fromkeys(filter(None, map(str.strip, names))))


def write_words(names: Sequence[str]) -> str:
    """Return names as `parse_words` reads them."""
    return ", ".join(map(_quoted, names))


def _quoted(name: str) -> str:
    if "," not in name and not name.startswith('"'):
        return name
    doubled = name.replace('"', '""')
    return f'"{doubled}"'


def _value(name: str, text: str, hint: Any) -> Any:
    if hint == Words:
        return parse_words(text)
    if get_origin(hint) in (Union, types.UnionType):
        if text.lower() in AUTOMATIC:
            return None
        hint = next(part for part in get_args(hint) if part is not types.NoneType)
    if get_origin(hint) is Literal:
        choices = get_args(hint)
        if text not in choices:
            raise ValueError(f"{name} must be one of {', '.join(choices)}, not {text!r}")
        return text
    if hint is str:
        return text
    if hint is bool:
        if text.lower() not in WORDS:
            raise ValueError(f"{name} must be true or false, not {text!r}")
        return WORDS[text.lower()]
    return _number(name, text, hint)


def _number(name: str, text: str, hint: Any) -> int | float:
    what = "a whole number" if hint is int else "a number"
    try:
        number: int | float = int(text) if hint is int else float(text)
    except ValueError:
        raise ValueError(f"{name} must be {what}, not {text!r}") from None
    if not abs(number) <= LARGEST:
        raise ValueError(f"{name} must be {what}, not {text!r}")
    return number


def _check_bounds(name: str, value: Any, metadata: Mapping[str, Any]) -> None:
    if value is None or isinstance(value, str | bool | tuple):
        return
    unit = f" {metadata['unit']}" if metadata.get("unit") else ""
    if metadata.get("min") is not None and value < metadata["min"]:
        raise ValueError(f"{name} must be at least {metadata['min']:g}{unit}, not {value:g}")
    if metadata.get("max") is not None and value > metadata["max"]:
        raise ValueError(f"{name} must be at most {metadata['max']:g}{unit}, not {value:g}")
