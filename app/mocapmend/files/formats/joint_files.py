"""What the readers of joints in text files share."""

import re
from collections.abc import Iterator
from pathlib import Path

import numpy as np
from numpy.typing import NDArray

from mocapmend.files.opening import Stamp, cannot_read, open_file

LONGEST_SKELETON = 4_000_000
"""Bytes; the longest real ones have a tenth of it."""
LINE = re.compile(rb"[^\r\n]+")


def read_bytes(path: Path) -> tuple[bytes, Stamp]:
    """Read a whole file.

    Raises
    ------
    MocapmendError
        If it cannot be read, or does not fit into memory.
    """
    with open_file(path) as (stream, stamp):
        try:
            return stream.read(), stamp
        except OSError as error:
            raise cannot_read(str(path), error) from error


def text_of(raw: bytes) -> str:
    """Decode a skeleton, whose names may be in any encoding."""
    return raw.decode("utf-8", errors="replace").removeprefix("\ufeff")


def lines_of(raw: bytes, start: int = 0) -> Iterator[bytes]:
    """Yield the lines that are not blank, one at a time so that no list of them fills memory."""
    for found in LINE.finditer(raw, start):
        line = found.group()
        if not line.isspace():
            yield line


def about_samples(
    points: NDArray[np.float64], labels: tuple[str, ...], warnings: list[str]
) -> None:
    """Warn of missing samples and repeated labels."""
    missing = int(np.isnan(points[:, :, 0]).sum())
    if missing:
        warnings.append(
            f"{missing} samples depend on values that are no numbers or far too large; they are "
            "taken as missing."
        )
    repeated = len(labels) - len(set(labels))
    if repeated:
        warnings.append(
            "1 joint has the label of another joint."
            if repeated == 1
            else f"{repeated} joints have the label of another joint."
        )
