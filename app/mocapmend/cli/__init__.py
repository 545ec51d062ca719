"""The command line: the same engine as the window, without Qt."""

from mocapmend.cli.dispatch import main

__all__ = ["main"]
