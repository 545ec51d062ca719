"""Pairs of recordings that a user has made: a table of which belong together."""

import csv
import io
from dataclasses import replace
from pathlib import Path

from mocapmend.errors import MocapmendError
from mocapmend.files import read_recording
from mocapmend.files.opening import read_whole
from mocapmend.files.uiprmd import is_packed, read_packed
from mocapmend_algorithms.progress import Progress
from mocapmend_algorithms.refine.preparing import RefineError
from mocapmend_algorithms.refine.profile import Profile
from mocapmend_algorithms.refine.train.pairs import Pair, make_pair

LARGEST_LIST = 16 << 20
NEEDED = ("recording", "reference")
NUMBERED = ("performer", "movement", "repetition")
HELP = (
    "A list is a CSV file with the columns recording and reference, and, where they are to be held "
    "out, performer, movement and repetition (whole numbers)."
)


def read_pairs(path: Path, profile: Profile, progress: Progress) -> list[Pair]:
    """Read the pairs that a file holds or lists.

    Parameters
    ----------
    path : Path
        A CSV list, or the packed pairs of UI-PRMD.
    profile : Profile
        Whose joints they have.
    progress : Progress
        Called after each pair.

    Raises
    ------
    MocapmendError
        If one of them cannot be read or does not fit the profile.
    """
    if is_packed(path):
        return read_packed(path, profile)
    rows = _rows(path)
    pairs = []
    for number, row in enumerate(rows):
        recording, reference = (path.parent / row[name] for name in NEEDED)
        sources = [read_recording(one).measured for one in (recording, reference)]
        try:
            who = [_number(row.get(name, ""), path, number) for name in NUMBERED]
            pair = make_pair(sources[0], sources[1], profile)
            pairs.append(replace(pair, performer=who[0], movement=who[1], repetition=who[2]))
        except RefineError as error:
            raise MocapmendError(
                f"This pair cannot be used: {error}.",
                f"{recording}, {reference}",
                "Leave it out, or choose another profile.",
            ) from error
        progress((number + 1) / len(rows))
    return pairs


def _rows(path: Path) -> list[dict[str, str]]:
    try:
        text = read_whole(path, LARGEST_LIST).decode("utf-8-sig")
        table = csv.DictReader(io.StringIO(text), skipinitialspace=True)
        rows = [{k: v for k, v in row.items() if k and isinstance(v, str)} for row in table]
    except (ValueError, csv.Error) as error:
        raise MocapmendError("This is no list of pairs.", str(path), HELP) from error
    lacking = [name for name in NEEDED if any(not row.get(name, "").strip() for row in rows)]
    if not rows or lacking:
        what = f"a line lacks its {lacking[0]}" if lacking else "it lists nothing"
        raise MocapmendError(f"This is no list of pairs: {what}.", str(path), HELP)
    return rows


def _number(text: str, path: Path, row: int) -> int:
    if not text.strip():
        return 0
    try:
        return int(text)
    except ValueError:
        raise MocapmendError(
            f"Pair {row + 1} has {text[:20]!r} where a whole number is expected.", str(path), HELP
        ) from None
