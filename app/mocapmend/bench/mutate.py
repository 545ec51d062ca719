"""Damage: what happens to files on broken disks, in bad transfers and in buggy programs."""

import random
from collections.abc import Callable
from dataclasses import dataclass, replace
from io import BytesIO
from zipfile import ZipFile, ZipInfo

BLOCK = 512
MOST_CHANGES = 4
ARRAY_HEAD = 128
"""Bytes before the numbers of an array that numpy stores."""
BYTES = b"\x00\x01\x7f\x80\xff"
WORDS = (b"\x00\x00", b"\xff\x7f", b"\x7f\xff", b"\x00\x80", b"\x80\x00", b"\xff\xff")
FLOATS = (
    b"\xff\xff\x7f\x7f", b"\x7f\x7f\xff\xff", b"\x00\x00\xc0\x7f", b"\x7f\xc0\x00\x00",
    b"\x00\x00\x80\x7f", b"\x01\x00\x00\x00", b"\x00\x00\x00\x80", b"\xff\xff\xff\xff",
)  # fmt: skip
"""The largest number, not a number, infinity, the smallest, -0: in both byte orders."""
TEXTS = (b"", b"-1", b"0", b"1e308", b"-1e-320", b"nan", b"inf", b"99999999999", b"x", b"\n", b",")
LENGTHS = (1, 2, 3, 4, 16, 511, 512, 4096)


@dataclass(frozen=True)
class Damage:
    """What the mutations of one file need.

    Attributes
    ----------
    rng : Random
        Chooses everything.
    head : int
        Bytes before the samples.
    donor : bytes
        Another file.
    """

    rng: random.Random
    head: int
    donor: bytes

    def place(self, raw: bytearray) -> int:
        """Choose a byte: in the first block, before the samples or anywhere, a third each."""
        zone = self.rng.choice((BLOCK, self.head, len(raw)))
        return self.rng.randrange(max(1, min(zone, len(raw))))

    def piece(self, raw: bytes | bytearray) -> bytes:
        """Choose a piece of a file, whole blocks of it now and then."""
        start = self.rng.randrange(max(1, len(raw)))
        if self.rng.random() < 0.3:
            start -= start % BLOCK
        return bytes(raw[start : start + self.rng.choice(LENGTHS)])


Mutation = Callable[[bytearray, Damage], None]


def flip_bits(raw: bytearray, damage: Damage) -> None:
    """Flip some bits."""
    for _ in range(damage.rng.choice((1, 1, 3, 20))):
        raw[damage.place(raw)] ^= 1 << damage.rng.randrange(8)


def set_bytes(raw: bytearray, damage: Damage) -> None:
    """Set some bytes to the ends of their range."""
    for _ in range(damage.rng.choice((1, 1, 4, 16))):
        raw[damage.place(raw)] = damage.rng.choice(BYTES)


def set_words(raw: bytearray, damage: Damage) -> None:
    """Set some 16-bit words to the ends of their range."""
    for _ in range(damage.rng.choice((1, 1, 3, 8))):
        _overwrite(raw, damage.place(raw) & ~1, damage.rng.choice(WORDS))


def set_floats(raw: bytearray, damage: Damage) -> None:
    """Set some floats to extreme values or to no number."""
    for _ in range(damage.rng.choice((1, 1, 3, 20))):
        _overwrite(raw, damage.place(raw) & ~3, damage.rng.choice(FLOATS))


def set_texts(raw: bytearray, damage: Damage) -> None:
    """Replace a word of a text; in a binary file, bytes between what looks like blanks."""
    at = damage.place(raw)
    stop = at
    while stop < len(raw) and chr(raw[stop]) not in " \t\r\n,;:" and stop < at + BLOCK:
        stop += 1
    raw[at:stop] = damage.rng.choice(TEXTS)


def truncate(raw: bytearray, damage: Damage) -> None:
    """Cut the end off."""
    del raw[damage.place(raw) :]


def delete(raw: bytearray, damage: Damage) -> None:
    """Cut a piece out."""
    at = damage.place(raw)
    del raw[at : at + damage.rng.choice(LENGTHS)]


def insert(raw: bytearray, damage: Damage) -> None:
    """Insert noise."""
    at = damage.place(raw)
    raw[at:at] = damage.rng.randbytes(damage.rng.choice(LENGTHS))


def duplicate(raw: bytearray, damage: Damage) -> None:
    """Insert a piece of the file a second time."""
    at = damage.place(raw)
    raw[at:at] = damage.piece(raw)


def move_over(raw: bytearray, damage: Damage) -> None:
    """Write a piece of the file over another place of it."""
    _overwrite(raw, damage.place(raw), damage.piece(raw))


def splice(raw: bytearray, damage: Damage) -> None:
    """Write a piece of another file over a place of this one, or put it between."""
    at, piece = damage.place(raw), damage.piece(damage.donor)
    if damage.rng.random() < 0.5:
        raw[at:at] = piece
    else:
        _overwrite(raw, at, piece)


def join(raw: bytearray, damage: Damage) -> None:
    """Put the rest of another file after the beginning of this one."""
    at = damage.place(raw)
    raw[at:] = damage.donor[at:]


MUTATIONS: tuple[Mutation, ...] = (
    flip_bits, set_bytes, set_words, set_floats, set_texts, truncate, delete, insert, duplicate,
    move_over, splice, join,
)  # fmt: skip


def mutate(raw: bytes, damage: Damage) -> bytes:
    """Return a damaged copy of a file.

    Parameters
    ----------
    raw : bytes
        The file.
    damage : Damage
        What the changes need.

    Returns
    -------
    bytes
        With one to four changes; the same for the same state of the random numbers.
    """
    changed = bytearray(raw)
    for _ in range(damage.rng.choice((1, 1, 2, MOST_CHANGES))):
        if changed:
            damage.rng.choice(MUTATIONS)(changed, damage)
    return bytes(changed)


def mutate_member(raw: bytes, damage: Damage) -> bytes:
    """Damage one of the files in an archive, whose checksums then fit again."""
    with ZipFile(BytesIO(raw)) as archive:
        members = {name: archive.read(name) for name in archive.namelist()}
    chosen = damage.rng.choice(sorted(members))
    members[chosen] = mutate(members[chosen], replace(damage, head=ARRAY_HEAD))
    changed = BytesIO()
    with ZipFile(changed, "w") as archive:
        for name, content in members.items():
            archive.writestr(ZipInfo(name), content)
    return changed.getvalue()


def _overwrite(raw: bytearray, at: int, piece: bytes) -> None:
    piece = piece[: max(0, len(raw) - at)]
    raw[at : at + len(piece)] = piece
