"""Recordings of every format that the program reads, and those that it writes; no Qt.

A reader is a function from a path to a `Source` that raises `MocapmendError` and nothing else.
"""

from mocapmend.files.formats.export_csv import write_csv
from mocapmend.files.formats.export_npz import write_npz
from mocapmend.files.formats.export_trc import write_trc
from mocapmend.files.formats.table import FORMATS, Format, read_recording

__all__ = ["FORMATS", "Format", "read_recording", "write_csv", "write_npz", "write_trc"]
