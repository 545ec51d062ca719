"""What was repaired in a file, by which program, and from which input: the repair record.

It has no times in it: the same edits of the same file give the same bytes.
"""

import json
import re
from collections.abc import Mapping, Sequence
from dataclasses import dataclass
from typing import Any

from mocapmend import __version__
from mocapmend.files.corrections import NO_CORRECTIONS, Corrections
from mocapmend.files.record_values import LONGEST_TEXT
from mocapmend.files.records import KeptGap, RepairRecord, kept_gaps, repair_records
from mocapmend.files.refinement import Refinement, refinement

PROGRAM = f"mocapmend {__version__}"
FORMAT = 1
HASH = re.compile("[0-9a-f]{64}")


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
    kept_open : tuple of KeptGap
        Gaps that the user keeps open, ordered as the repairs. They are no repairs.
    corrections : Corrections
        What was put right besides filling gaps.
    refined : Refinement or None
        How a network has made the markers, where it has.
    """

    repairs: tuple[RepairRecord, ...]
    inputs: tuple[str, ...]
    converted: bool = False
    program: str = PROGRAM
    kept_open: tuple[KeptGap, ...] = ()
    corrections: Corrections = NO_CORRECTIONS
    refined: Refinement | None = None

    @property
    def says_nothing(self) -> bool:
        """Whether a file can do without it."""
        entries = self.repairs or self.kept_open or self.corrections
        return not (entries or self.converted or self.refined)


# --- the sidecar -----------------------------------------------------------------------------


def encode_sidecar(provenance: Provenance, output_sha256: str) -> bytes:
    """Encode the record as a JSON file that belongs to the file with a given SHA-256."""
    head: dict[str, Any] = {
        "mocapmend_provenance": FORMAT,
        "program": provenance.program,
        "inputs": list(provenance.inputs),
        "converted": provenance.converted,
        "output_sha256": output_sha256,
    }
    if provenance.kept_open:
        head["kept_open"] = [gap.as_json() for gap in provenance.kept_open]
    if provenance.refined is not None:
        head["refined"] = provenance.refined.as_json()
    for kind, entries in provenance.corrections.lists():
        head[kind] = [entry.as_json() for entry in entries]
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
    repairs, kept = repair_records(data.get("repairs")), kept_gaps(data.get("kept_open", []))
    output = data.get("output_sha256")
    if not isinstance(output, str):
        raise ValueError("it does not say which file it belongs to")
    inputs = hashes(data.get("inputs"))
    converted, program = data.get("converted") is True, program_name(data.get("program"))
    corrections = Corrections.from_lists(data)
    refined = None if "refined" not in data else refinement(data["refined"])
    return Provenance(repairs, inputs, converted, program, kept, corrections, refined), output


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
