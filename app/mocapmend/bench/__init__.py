"""`mocapmend bench`: the figures of the documentation, made again on this machine."""

from mocapmend.bench.command import main

__all__ = ["main"]
