"""Stick templates of known label sets, one TOML file each."""

import tomllib
from importlib.resources import files

from mocapmend_algorithms.skeleton import Template, parse_template

SUFFIX = ".toml"


def load() -> tuple[Template, ...]:
    """Read all templates that ship with the program.

    Returns
    -------
    tuple of Template
        In the order of their file names.
    """
    names = sorted(file.name for file in files(__name__).iterdir())
    return tuple(named(name.removesuffix(SUFFIX)) for name in names if name.endswith(SUFFIX))


def named(name: str) -> Template:
    """Read the template of a file, by its name without the ending.

    Raises
    ------
    FileNotFoundError
        If there is none.
    """
    text = files(__name__).joinpath(f"{name}{SUFFIX}").read_text("utf-8")
    return parse_template(tomllib.loads(text))
