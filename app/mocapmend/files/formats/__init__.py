"""Recordings of every format that the program reads, and those that it writes; no Qt.

A reader is a function from a path to a `Source` that raises `MocapmendError` and nothing else.
"""

from mocapmend.files.formats.table import FORMATS, Format, read_recording
from mocapmend.files.formats.write_csv import write_csv
from mocapmend.files.formats.write_npz import write_npz
from mocapmend.files.formats.write_trc import write_trc

__all__ = ["FORMATS", "Format", "read_recording", "write_csv", "write_npz", "write_trc"]
