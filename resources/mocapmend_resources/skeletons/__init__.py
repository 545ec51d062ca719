"""Stick templates of known label sets, one TOML file each."""

import tomllib
from importlib.resources import files

from mocapmend_algorithms.skeleton import Template, parse_template


def load() -> tuple[Template, ...]:
    """Read all templates that ship with the program.

    Returns
    -------
    tuple of Template
        In the order of their file names.
    """
    found = sorted(
        (file for file in files(__name__).iterdir() if file.name.endswith(".toml")),
        key=lambda file: file.name,
    )
    return tuple(parse_template(tomllib.loads(file.read_text("utf-8"))) for file in found)
