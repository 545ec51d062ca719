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
    found = sorted(file.name for file in files(__name__).iterdir() if file.name.endswith(".toml"))
    return tuple(read(name.removesuffix(".toml")) for name in found)


def read(name: str) -> Template:
    """Read one template.

    Parameters
    ----------
    name : str
        Of its file, without the ending, as "kinect_v2_25".
    """
    text = (files(__name__) / f"{name}.toml").read_text("utf-8")
    return parse_template(tomllib.loads(text))
