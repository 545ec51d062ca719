"""The repair record as a parameter group of a C3D file.

Repairs and gaps that are kept open are one line of JSON each, so that every program that shows
parameters shows them; a line that is too long for a row continues in the next one.
"""

import json
from collections.abc import Iterable, Iterator

from mocapmend.files.c3d_header import BLOCK
from mocapmend.files.c3d_numbers import Processor
from mocapmend.files.c3d_parameters import Parameters
from mocapmend.files.c3d_section import group_record, integer_record, text_record, text_records
from mocapmend.files.corrections import KINDS, Corrections
from mocapmend.files.provenance import FORMAT, Provenance, hashes
from mocapmend.files.records import Recorded, kept_gaps, line, repair_records
from mocapmend.files.refinement import refinement

NAME = "MOCAPMEND"
ABOUT = "Repairs by mocapmend: one JSON object each; points are counted from 1"
LONGEST_ROW = 255
PADDING = "PADDING"
REFINED = "REFINED"
LEAST_PADDING = len(text_record(1, f"{PADDING}2", [b" "], Processor.INTEL))


def encode_group(provenance: Provenance, number: int, processor: Processor) -> bytes:
    """Encode the group with all its parameters, filled up to whole blocks.

    Parameters
    ----------
    provenance : Provenance
        The record.
    number : int
        A group number that is free.
    processor : Processor
        The file's number format.
    """
    inputs = [item.encode("ascii") for item in provenance.inputs]
    parts = [
        group_record(number, NAME, processor, ABOUT),
        integer_record(number, "FORMAT", FORMAT, processor),
        integer_record(number, "CONVERTED", int(provenance.converted), processor),
        text_record(number, "PROGRAM", provenance.program.encode("ascii"), processor),
        *text_records(number, "INPUTS", inputs, processor),
        *text_records(number, "REPAIRS", _rows(provenance.repairs), processor),
    ]
    if provenance.kept_open:
        parts += text_records(number, "KEPT_OPEN", _rows(provenance.kept_open), processor)
    if provenance.refined is not None:
        parts += text_records(number, REFINED, _rows([provenance.refined]), processor)
    for kind, entries in provenance.corrections.lists():
        parts += text_records(number, kind.upper(), _rows(entries), processor)
    raw = b"".join(parts)
    return raw + b"".join(_padding(-len(raw) % BLOCK, number, processor))


def decode_group(parameters: Parameters) -> Provenance | None:
    """Decode the group of a file, None where it has none.

    Raises
    ------
    ValueError
        If it is damaged, or of a later format.
    """
    stated = parameters.number(f"{NAME}:FORMAT")
    if stated is None:
        return None
    if stated != FORMAT:
        raise ValueError(f"it has format {stated:g}, and this version reads {FORMAT}")
    return Provenance(
        repairs=repair_records(_objects(parameters, "REPAIRS")),
        inputs=hashes(parameters.texts(f"{NAME}:INPUTS")),
        converted=parameters.number(f"{NAME}:CONVERTED") == 1,
        program=parameters.text(f"{NAME}:PROGRAM"),
        kept_open=kept_gaps(_objects(parameters, "KEPT_OPEN")),
        corrections=Corrections.from_lists(
            {kind: _objects(parameters, kind.upper()) for kind in KINDS}
        ),
        refined=next(map(refinement, _objects(parameters, REFINED)), None),
    )


def _rows(entries: Iterable[Recorded]) -> list[bytes]:
    """Cut lines of JSON; spaces are escaped, because rows lose those at their end."""
    lines = [line(entry).replace(" ", "\\u0020").encode("ascii") for entry in entries]
    return [
        raw[start : start + LONGEST_ROW]
        for raw in lines
        for start in range(0, len(raw), LONGEST_ROW)
    ]


def _objects(parameters: Parameters, name: str) -> list[object]:
    """Return the JSON values of a parameter that `_rows` has cut."""
    text, decoder = "".join(parameters.texts(f"{NAME}:{name}")), json.JSONDecoder()
    items, at = [], 0
    while at < len(text):
        try:
            item, at = decoder.raw_decode(text, at)
        except (ValueError, RecursionError):
            raise ValueError("it is not written in JSON") from None
        items.append(item)
    return items


def _padding(length: int, number: int, processor: Processor) -> Iterator[bytes]:
    """Yield records of a total length, or of a block more where it is too short for one."""
    if 0 < length < LEAST_PADDING:
        length += BLOCK
    first = length if length < 2 * LEAST_PADDING else length // 2
    for name, size in ((PADDING, first), (f"{PADDING}2", length - first)):
        if size:
            empty = len(text_record(number, name, [b" "], processor)) - 1
            yield text_record(number, name, [b" " * (size - empty)], processor)
