"""Recordings of every format that the program reads; no Qt.

A reader is a function from a path to a `Source` that raises `MocapmendError` and nothing else.
"""

from mocapmend.files.formats.table import FORMATS, Format, read_recording

__all__ = ["FORMATS", "Format", "read_recording"]
