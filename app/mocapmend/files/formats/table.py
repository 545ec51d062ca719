"""The formats: the single source for the file dialog, reading and the documentation."""

from collections.abc import Callable
from dataclasses import dataclass
from pathlib import Path

from mocapmend.files.c3d_points import PLAIN, Way
from mocapmend.files.c3d_reader import read_c3d
from mocapmend.files.formats.amc import read_amc
from mocapmend.files.formats.bvh import read_bvh
from mocapmend.files.formats.delimited import read_delimited
from mocapmend.files.formats.npz import read_npz
from mocapmend.files.formats.trc import read_trc
from mocapmend.files.repairs import with_repairs
from mocapmend.files.source import Source


@dataclass(frozen=True)
class Format:
    """A format that the program reads.

    Attributes
    ----------
    label : str
        For the user.
    suffixes : tuple of str
        How the names of its files end, in lower case.
    read : callable
        Reads a file; raises `MocapmendError` and nothing else.
    """

    label: str
    suffixes: tuple[str, ...]
    read: Callable[[Path], Source]


FORMATS: tuple[Format, ...] = (
    Format("C3D", (".c3d",), read_c3d),
    Format("TRC", (".trc",), read_trc),
    Format(
        "CSV, Qualisys, Motive, Nexus, Kinect, UI-PRMD", (".csv", ".tsv", ".txt"), read_delimited
    ),
    Format("BVH", (".bvh",), read_bvh),
    Format("Acclaim ASF/AMC", (".amc", ".asf"), read_amc),
    Format("NumPy", (".npz",), read_npz),
)


def read_recording(path: Path, way: Way = PLAIN) -> Source:
    """Read a recording of any format, by the ending of its name; others are taken for C3D.

    Parameters
    ----------
    path : Path
        Where it is.
    way : Way
        How a C3D file is read; files of other formats are smaller and slower to read.

    Raises
    ------
    MocapmendError
        If it cannot be read; nothing else.
    """
    path = Path(path)
    suffix = path.suffix.lower()
    found = next((item for item in FORMATS if suffix in item.suffixes), FORMATS[0])
    if found is FORMATS[0]:
        return read_c3d(path, way)
    return with_repairs(found.read(path))
