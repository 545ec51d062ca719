"""A recipe: the edits of one file as a small text file, to be made again with the same result.

A fill is written down as its gap, its method and the parameters of that, without the values: they
are computed again, from the measured samples alone, so that the order does not matter. These are
what remains when samples were exchanged and set aside, which comes first.
"""

from collections.abc import Collection, Sequence
from dataclasses import dataclass
from pathlib import Path
from typing import TypeVar

from mocapmend.errors import MocapmendError
from mocapmend.files import (
    NO_CORRECTIONS,
    Corrections,
    KeptGap,
    MovedRun,
    Renamed,
    RepairRecord,
    SetAside,
    SmoothedRun,
    Source,
)
from mocapmend.files.atomic import write_bytes
from mocapmend.files.opening import read_whole
from mocapmend.files.provenance import (
    PROGRAM,
    decode_document,
    encode_document,
    hashes,
    program_name,
)
from mocapmend.files.records import Recorded, kept_gaps, line, repair_records
from mocapmend.files.sidecar import hash_file
from mocapmend_algorithms import Progress, no_progress

KEY = "mocapmend_recipe"
MOST_BYTES = 50_000_000
CORRECTED = ("set_aside", "moved", "renamed")
"""Corrections that a recipe may take back."""
Entry = TypeVar("Entry", SetAside, MovedRun, Renamed)
EDITS = (
    "fill",
    "reopen",
    "keep open",
    "free",
    "set aside",
    "believe",
    "move",
    "move back",
    "smooth",
    "rename",
    "rename back",
)


@dataclass(frozen=True)
class Recipe:
    """The edits of a file.

    Attributes
    ----------
    input : str
        SHA-256 of the file that they were made in.
    fills : tuple of RepairRecord
        The gaps that are filled, and how.
    reopened : tuple of RepairRecord
        Repairs that the file had before, and that are missing samples again.
    kept_open : tuple of KeptGap
        Gaps that are kept open from now on.
    freed : tuple of KeptGap
        Gaps that the file kept open before, and that may be filled again.
    set_aside : tuple of SetAside
        Measured samples that count as missing from now on.
    believed : tuple of SetAside
        Those that the file set aside before, and that are measured samples again.
    moved : tuple of MovedRun
        Samples that are exchanged between markers from now on.
    moved_back : tuple of MovedRun
        Those that the file had exchanged before, and that are where they were stored.
    smoothed : tuple of SmoothedRun
        What is smoothed at last.
    renamed : tuple of Renamed
        Points that are called otherwise from now on.
    renamed_back : tuple of Renamed
        Those that the file had renamed before, and that have their first label again, or another.
    program : str
        The program that wrote the recipe, with its version.
    """

    input: str
    fills: tuple[RepairRecord, ...]
    reopened: tuple[RepairRecord, ...] = ()
    kept_open: tuple[KeptGap, ...] = ()
    freed: tuple[KeptGap, ...] = ()
    set_aside: tuple[SetAside, ...] = ()
    believed: tuple[SetAside, ...] = ()
    moved: tuple[MovedRun, ...] = ()
    moved_back: tuple[MovedRun, ...] = ()
    smoothed: tuple[SmoothedRun, ...] = ()
    renamed: tuple[Renamed, ...] = ()
    renamed_back: tuple[Renamed, ...] = ()
    program: str = PROGRAM

    @property
    def edits(self) -> tuple[tuple[Recorded, ...], ...]:
        """All edits of each kind, in the order of `EDITS`."""
        return (
            *(self.fills, self.reopened, self.kept_open, self.freed),
            *(self.set_aside, self.believed, self.moved, self.moved_back),
            *(self.smoothed, self.renamed, self.renamed_back),
        )


def recipe_of(
    source: Source,
    repairs: Sequence[RepairRecord],
    kept_open: Sequence[KeptGap] = (),
    corrections: Corrections = NO_CORRECTIONS,
) -> Recipe:
    """Return the recipe that makes the given repairs of a file out of the ones that it has.

    So it does with the gaps that are kept open, and with what is exchanged and set aside.

    Raises
    ------
    MocapmendError
        If the file cannot be read.
    """
    kept = set(map(line, source.repairs))
    wanted = {item.place for item in repairs}
    ordered = sorted(repairs, key=lambda item: item.place)
    open_before = set(source.kept_open.values())
    open_after = sorted(kept_open, key=lambda item: item.place)
    still_open = {item.place for item in open_after}
    former = NO_CORRECTIONS if source.provenance is None else source.provenance.corrections
    return Recipe(
        input=hash_file(source.path),
        fills=tuple(item for item in ordered if line(item) not in kept),
        reopened=tuple(item for item in source.repairs if item.place not in wanted),
        kept_open=tuple(item for item in open_after if item not in open_before),
        freed=tuple(item for item in source.kept_open.values() if item.place not in still_open),
        set_aside=_without(corrections.set_aside, former.set_aside),
        believed=_without(former.set_aside, corrections.set_aside),
        moved=_without(corrections.moved, former.moved),
        moved_back=_without(former.moved, corrections.moved),
        smoothed=tuple(item for item in corrections.smoothed if item not in former.smoothed),
        renamed=_without(corrections.renamed, former.renamed),
        renamed_back=_without(former.renamed, corrections.renamed),
    )


def _without(some: Sequence[Entry], others: Collection[Entry]) -> tuple[Entry, ...]:
    known = set(others)
    return tuple(item for item in some if item not in known)


def write_recipe(
    source: Source,
    repairs: Sequence[RepairRecord],
    path: Path,
    progress: Progress = no_progress,
    *,
    kept_open: Sequence[KeptGap] = (),
    corrections: Corrections = NO_CORRECTIONS,
) -> None:
    """Write a recipe, see `recipe_of`; a file of that name is replaced.

    Raises
    ------
    MocapmendError
        If it cannot be written.
    """
    recipe = recipe_of(source, repairs, kept_open, corrections)
    head = {KEY: 1, "program": recipe.program, "input_sha256": recipe.input}
    parts = zip(EDITS, recipe.edits, strict=True)
    edits = [{"do": word, **item.as_json()} for word, items in parts for item in items]
    data = encode_document(head, "edits", edits)
    write_bytes(path, data)
    progress(1.0)


def read_recipe(path: Path) -> Recipe:
    """Read a recipe.

    Raises
    ------
    MocapmendError
        If it is not one.
    """
    try:
        return _decode(read_whole(path, MOST_BYTES))
    except ValueError as error:
        raise _no_recipe(path, str(error)) from None


def _decode(raw: bytes) -> Recipe:
    data = decode_document(raw, KEY)
    edits = data.get("edits")
    if not isinstance(edits, list) or not all(isinstance(edit, dict) for edit in edits):
        raise ValueError("it has no list of edits")
    if not all(edit.get("do") in EDITS for edit in edits):
        raise ValueError("it asks for something that is no edit of a gap")
    (made_for,) = hashes([data.get("input_sha256")])
    of_kind = {word: [edit for edit in edits if edit["do"] == word] for word in EDITS}
    new, former = (
        Corrections.from_lists(
            {name: of_kind[word] for name, word in zip(CORRECTED, words, strict=True)}
        )
        for words in (("set aside", "move", "rename"), ("believe", "move back", "rename back"))
    )
    return Recipe(
        made_for,
        repair_records(of_kind["fill"]),
        repair_records(of_kind["reopen"]),
        kept_gaps(of_kind["keep open"]),
        kept_gaps(of_kind["free"]),
        *(new.set_aside, former.set_aside, new.moved, former.moved),
        Corrections.from_lists({"smoothed": of_kind["smooth"]}).smoothed,
        *(new.renamed, former.renamed),
        program_name(data.get("program")),
    )


def _no_recipe(path: Path, why: str) -> MocapmendError:
    return MocapmendError(
        f"This is not a recipe: {why}.", str(path), "Choose a file that was saved as a recipe."
    )
