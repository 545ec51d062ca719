"""What a repaired copy of a C3D file will look like: its head, its numbers, its layout."""

from collections.abc import Mapping
from dataclasses import dataclass, replace
from io import BytesIO

import numpy as np

from mocapmend.errors import MocapmendError
from mocapmend.files import c3d_group, c3d_head, c3d_rename
from mocapmend.files.c3d_header import BLOCK
from mocapmend.files.c3d_layout import Layout, read_layout
from mocapmend.files.c3d_reader import C3DFile
from mocapmend.files.corrections import changed_labels
from mocapmend.files.opening import open_file
from mocapmend.files.provenance import Provenance


@dataclass(frozen=True, eq=False)
class Target:
    """The plan of a copy.

    Attributes
    ----------
    head : bytes
        What goes before the frames.
    layout : Layout
        Of the copy.
    padding : int
        Bytes after the end of the source that fill the last block.
    to_float : bool
        Whether integers become floats.
    record : str
        Where the repair record goes: "group", "sidecar", or "" without one.
    """

    head: bytes
    layout: Layout
    padding: int
    to_float: bool
    record: str


def plan(
    source: C3DFile,
    provenance: Provenance | None,
    *,
    to_float: bool,
) -> Target:
    """Plan a copy.

    Parameters
    ----------
    source : C3DFile
        The file as it was read.
    provenance : Provenance or None
        The repair record; its hashes may still be missing, if they are as long as those to come.
    to_float : bool
        Whether its integers become floats.

    Raises
    ------
    MocapmendError
        If integers shall become floats, or points get other labels, but the structure of the file
        does not allow it.
    """
    layout = source.layout
    head = _read_head(source)
    padding = 0
    if to_float:
        floats = c3d_head.as_floats(head, layout)
        added = layout.frames * layout.frame_bytes
        # Whatever follows the data may be found by its block; but bytes that are added to a file
        # that ends too early could be taken for a frame.
        padding = 0 if source.truncated else -added % BLOCK
        found = None if floats is None else _read(floats, layout, layout.size + added + padding)
        if floats is None or found is None or not _same(layout, found, 0):
            raise _cannot_convert(source)
        head, layout = floats, found
    head, layout = _with_labels(source, provenance, head, layout)
    target = Target(head, layout, padding, to_float, "")
    if provenance is source.provenance:
        return replace(target, record=_place(provenance, layout))
    former = c3d_head.leading_blocks(head, layout, c3d_group.NAME)
    if provenance is None or provenance.says_nothing:
        return _without_group(target, former) or target
    return _with_group(target, provenance, former) or replace(
        _without_group(target, former) or target, record="sidecar"
    )


def _with_labels(
    source: C3DFile, provenance: Provenance | None, head: bytes, layout: Layout
) -> tuple[bytes, Layout]:
    """Give points the labels that the repair record of the copy says."""
    renamed = [() if p is None else p.corrections.renamed for p in (source.provenance, provenance)]
    labels = changed_labels(*renamed)
    if not labels:
        return head, layout
    changed = c3d_rename.renamed(head, layout, labels)
    if changed is not None:
        blocks = (len(changed) - len(head)) // BLOCK
        found = _read(changed, layout, layout.size + len(changed) - len(head))
        if found is not None and _same(layout, found, blocks, labels=labels):
            return changed, found
    first = min(labels)
    raise MocapmendError(
        f"The parameters of this file have no room for the label {labels[first]!r}.",
        str(source.path),
        "Choose shorter labels, or save it as another format.",
    )


def _read_head(source: C3DFile) -> bytes:
    """Read what lies before the frames."""
    with open_file(source.path) as (stream, _):
        return stream.read(source.layout.data_start)


def _place(provenance: Provenance | None, layout: Layout) -> str:
    if provenance is None:
        return ""
    return "group" if _has_group(layout) else "sidecar"


def _has_group(layout: Layout) -> bool:
    return f"{c3d_group.NAME}:FORMAT" in layout.parameters


def _with_group(target: Target, provenance: Provenance, former: int) -> Target | None:
    """Put the record into the file, in place of a former one; None where that is not safe."""
    if former == 0 and _has_group(target.layout):
        # Another program has moved the former record: it stays, and the new one goes elsewhere.
        return None
    bare = _without_group(target, former) if former else target
    if bare is None:
        return None
    number = c3d_head.free_group(bare.head, bare.layout)
    if number is None:
        return None
    records = c3d_group.encode_group(provenance, number, bare.layout.processor)
    head = c3d_head.insert_group(bare.head, bare.layout, records)
    return _moved(bare, head, len(records) // BLOCK)


def _without_group(target: Target, former: int) -> Target | None:
    if not former:
        return None
    head = c3d_head.remove_group(target.head, target.layout, former)
    return _moved(target, head, -former)


def _moved(target: Target, head: bytes | None, blocks: int) -> Target | None:
    """Read a new head, and make sure that it says the same but for the blocks added."""
    if head is None:
        return None
    layout = _read(head, target.layout, target.layout.size + blocks * BLOCK)
    if layout is None or not _same(target.layout, layout, blocks):
        return None
    return replace(target, head=head, layout=layout, record="group" if blocks > 0 else "")


def _read(head: bytes, layout: Layout, size: int) -> Layout | None:
    try:
        return read_layout(BytesIO(head), size, "")
    except MocapmendError:
        return None


def _same(
    before: Layout, after: Layout, blocks: int, labels: Mapping[int, str] | None = None
) -> bool:
    """Say whether two heads mean the same, but for our group and the numbers that moved.

    Where there are new labels, these have to be there.
    """
    moved = after.data_start - before.data_start == blocks * BLOCK
    kept = [_kept(layout) for layout in (before, after)]
    if labels is not None:
        if _labels(after) != {**_labels(before), **labels}:
            return False
        kept = [{k: v for k, v in of.items() if not c3d_rename.is_label(k)} for of in kept]
    return moved and kept[0] == kept[1] and _facts(before) == _facts(after)


def _labels(layout: Layout) -> dict[int, str]:
    return dict(enumerate(layout.parameters.texts(c3d_rename.LABELS)))


def _kept(layout: Layout) -> dict[str, tuple[int, tuple[int, ...], bytes]]:
    """Return the parameters that stay as they are."""
    return {
        name: (item.kind, item.dimensions, item.raw)
        for name, item in layout.parameters.items()
        if not name.startswith(f"{c3d_group.NAME}:")
        and not name.endswith(":DATA_START")
        and name != "POINT:SCALE"
    }


def _facts(layout: Layout) -> tuple[object, ...]:
    return (
        layout.processor,
        np.float32(layout.scale),
        layout.points,
        layout.channels,
        layout.analog_samples,
        layout.frames,
        layout.frames_promised,
        layout.rate,
        layout.first_frame,
    )


def _cannot_convert(source: C3DFile) -> MocapmendError:
    return MocapmendError(
        "A repair does not fit into the integers of this file, and its structure does not allow "
        "to convert them to floats.",
        str(source.path),
        "Leave this sample out, or fill it in another way.",
    )
