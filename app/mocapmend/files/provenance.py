"""What was repaired in a file, by which program, and from which input: the repair record.

It has no times in it: the same edits of the same file give the same bytes.
"""

import json
import math
import re
from collections.abc import Mapping, Sequence
from dataclasses import asdict, dataclass, field
from typing import Any

from mocapmend import __version__

PROGRAM = f"mocapmend {__version__}"
FORMAT = 1
MOST_REPAIRS = 1_000_000
DIGITS = 4
"""Significant digits of an expected error: more would mean nothing."""
LARGEST_FRAME = 2**53
LONGEST_TEXT = 1000
HASH = re.compile("[0-9a-f]{64}")

_KINDS: Mapping[str, tuple[type, ...]] = {
    "marker": (str,),
    "point": (int,),
    "first_frame": (int,),
    "last_frame": (int,),
    "method": (str,),
    "parameters": (dict,),
    "donors": (list,),
    "expected_error_mm": (int, float, type(None)),
    "r90_mm": (int, float, type(None)),
}
SCALARS = (str, int, float, type(None))


@dataclass(frozen=True)
class RepairRecord:
    """A run of one marker that was missing and is filled.

    Attributes
    ----------
    marker : str
        Its label.
    point : int
        The stored point, counted from 1 as in POINT:LABELS.
    first_frame, last_frame : int
        As the file counts frames.
    method : str
        Method id.
    parameters : dict
        The method's parameters; lists of names are tuples.
    donors : tuple of str
        Labels of the markers that the repair was computed from.
    expected_error_mm, r90_mm : float
        Expected 3-D RMS error, and the median radius of the 90 % band; NaN where unknown.
    """

    marker: str
    point: int
    first_frame: int
    last_frame: int
    method: str
    parameters: Mapping[str, Any] = field(default_factory=dict)
    donors: tuple[str, ...] = ()
    expected_error_mm: float = math.nan
    r90_mm: float = math.nan

    @property
    def frames(self) -> int:
        """Number of frames."""
        return self.last_frame - self.first_frame + 1

    def rows(self, first_frame: int) -> tuple[int, int]:
        """Return start and stop of its frames in a recording that begins with a frame."""
        return self.first_frame - first_frame, self.last_frame - first_frame + 1

    def as_json(self) -> dict[str, Any]:
        """Return the record for a JSON document; None stands for what is not known."""
        return asdict(self) | {
            "donors": list(self.donors),
            "expected_error_mm": _rounded(self.expected_error_mm),
            "r90_mm": _rounded(self.r90_mm),
        }

    @classmethod
    def from_json(cls, data: object) -> "RepairRecord":
        """Make a record of what a JSON document has of it; keys that are unknown are left out.

        Raises
        ------
        ValueError
            If it is none.
        """
        if not isinstance(data, dict):
            raise ValueError("a repair is not an object")
        values = {}
        for key, kinds in _KINDS.items():
            if key not in data or isinstance(data[key], bool) or not isinstance(data[key], kinds):
                raise ValueError(f"the repair's {key!r} is missing or of another kind")
            values[key] = data[key]
        if not all(map(_is_plain, values.values())):
            raise ValueError("a number or a text of a repair is too large")
        if not all(isinstance(donor, str) and _is_plain(donor) for donor in values["donors"]):
            raise ValueError("a donor is not a label")
        values["parameters"] = {k: _parameter(v) for k, v in values["parameters"].items()}
        for key in ("expected_error_mm", "r90_mm"):
            values[key] = math.nan if values[key] is None else float(values[key])
        return cls(**values | {"donors": tuple(values["donors"])})


def _parameter(value: object) -> object:
    """Return a parameter as it was before it was written: JSON has no tuples."""
    parts = value if isinstance(value, list) else [value]
    kinds = str if isinstance(value, list) else SCALARS
    if not all(isinstance(part, kinds) and _is_plain(part) for part in parts):
        raise ValueError("a parameter is neither a number nor a text, nor a list of texts")
    return tuple(value) if isinstance(value, list) else value


def _is_plain(value: object) -> bool:
    """Say whether a value is none of those that a damaged file has and a program trips over."""
    if isinstance(value, (int, float)):
        return abs(value) <= LARGEST_FRAME
    return not isinstance(value, str) or len(value) <= LONGEST_TEXT


@dataclass(frozen=True)
class Provenance:
    """The repair record of a file.

    Attributes
    ----------
    repairs : tuple of RepairRecord
        Ordered by point and frame.
    inputs : tuple of str
        SHA-256 of the file that was repaired, the original first where it was repaired again.
    converted : bool
        Whether its integers were converted to floats on the way.
    program : str
        The program that wrote it, with its version.
    """

    repairs: tuple[RepairRecord, ...]
    inputs: tuple[str, ...]
    converted: bool = False
    program: str = PROGRAM


def line(record: RepairRecord) -> str:
    """Return a record as one line of ASCII."""
    return json.dumps(record.as_json(), separators=(",", ":"), allow_nan=False)


def _rounded(value: float) -> float | None:
    return float(f"{value:.{DIGITS}g}") if math.isfinite(value) else None


# --- the sidecar -----------------------------------------------------------------------------


def encode_sidecar(provenance: Provenance, output_sha256: str) -> bytes:
    """Encode the record as a JSON file that belongs to the file with a given SHA-256."""
    head = {
        "mocapmend_provenance": FORMAT,
        "program": provenance.program,
        "inputs": list(provenance.inputs),
        "converted": provenance.converted,
        "output_sha256": output_sha256,
    }
    return encode_document(head, "repairs", [record.as_json() for record in provenance.repairs])


def encode_document(head: Mapping[str, Any], key: str, items: Sequence[object]) -> bytes:
    """Encode a JSON object whose last key is a list, with one line per item."""
    rows = ",\n".join("  " + json.dumps(item, allow_nan=False) for item in items)
    start = json.dumps(head, indent=1, allow_nan=False).removesuffix("\n}")
    return f'{start},\n "{key}": [\n{rows}\n ]\n}}\n'.encode("ascii")


def decode_sidecar(raw: bytes) -> tuple[Provenance, str]:
    """Decode a sidecar: the record, and the SHA-256 of the file that it belongs to.

    Raises
    ------
    ValueError
        If it is not one, or of a later format.
    """
    data = decode_document(raw, "mocapmend_provenance")
    repairs = records(data.get("repairs"))
    output = data.get("output_sha256")
    if not isinstance(output, str):
        raise ValueError("it does not say which file it belongs to")
    inputs = hashes(data.get("inputs"))
    converted, program = data.get("converted") is True, program_name(data.get("program"))
    return Provenance(repairs, inputs, converted, program), output


def hashes(data: object) -> tuple[str, ...]:
    """Return the hashes of files that a list holds.

    Raises
    ------
    ValueError
        If it is none.
    """
    if not isinstance(data, Sequence) or not all(
        isinstance(item, str) and HASH.fullmatch(item) for item in data
    ):
        raise ValueError("it does not say which file was repaired")
    return tuple(data)


def program_name(data: object) -> str:
    """Return what people read about the program that wrote a record, whatever is there."""
    return data[:LONGEST_TEXT] if isinstance(data, str) else "an unknown program"


def decode_document(raw: bytes, key: str) -> dict[str, Any]:
    """Decode a JSON object whose format is stated under a key.

    Raises
    ------
    ValueError
        If it is none, or of a later format.
    """
    try:
        data = json.loads(raw)
    except (ValueError, RecursionError, MemoryError):
        raise ValueError("it is not a JSON document") from None
    if not isinstance(data, dict) or key not in data:
        raise ValueError(f"it has no {key!r}")
    if data[key] != FORMAT:
        raise ValueError(f"it is not of format {FORMAT}, which this version reads")
    return data


def records(data: object) -> tuple[RepairRecord, ...]:
    """Make records of a JSON list.

    Raises
    ------
    ValueError
        If it is none, or one of them is not a record.
    """
    if not isinstance(data, list) or len(data) > MOST_REPAIRS:
        raise ValueError("it has no list of repairs")
    return tuple(map(RepairRecord.from_json, data))
