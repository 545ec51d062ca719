"""Reading recordings from .npz files of NumPy."""

import sys
from pathlib import Path
from typing import Any

import numpy as np
from numpy.typing import NDArray

from mocapmend.errors import MocapmendError
from mocapmend.files.formats.assemble import Stated, assemble
from mocapmend.files.formats.columns import MOST_MARKERS, clean_label
from mocapmend.files.formats.frames import LARGEST_FRAME, Frames, MissingRule
from mocapmend.files.opening import ANOTHER_FILE, Stamp, cannot_read, open_file, too_large
from mocapmend.files.source import Source
from mocapmend.files.space import AXES
from mocapmend_algorithms.zip_arrays import ArchiveError, ZipArrays

TODO = "Save pos (frames, markers, 3), fps, names, units and up with numpy.savez."


def read_npz(path: Path) -> Source:
    """Read a recording that numpy.savez or numpy.savez_compressed wrote.

    The arrays are `pos`, (frames, markers, 3) with NaN for missing samples; `fps`, frames per
    second; `names` of the markers; `units`, as "mm"; `up`, as "z"; `first_frame`; and `bones`,
    pairs of markers, or `parents`, for each marker another one, or -1. All but `pos` may be
    absent.

    Raises
    ------
    MocapmendError
        If it cannot be read; nothing else.
    """
    path = Path(path)
    with open_file(path) as (stream, stamp):
        try:
            return _source(ZipArrays(stream), path, stamp)
        except ArchiveError as error:
            raise MocapmendError(str(error), str(path), ANOTHER_FILE) from error
        except OSError as error:
            raise cannot_read(str(path), error) from error
        except MemoryError:
            raise too_large(str(path)) from None


@np.errstate(all="ignore")
def _source(arrays: ZipArrays, path: Path, stamp: Stamp) -> Source:
    warnings: list[str] = []
    points = _points(arrays, path)
    frames, markers, _ = points.shape
    rule = MissingRule(zeros=False)
    rule.apply(points)
    warnings += rule.sentences()
    up = _text(arrays, "up").lower()
    first = _number(arrays, "first_frame")
    stated = Stated(
        labels=_names(arrays, path, markers),
        rate=_number(arrays, "fps"),
        unit=_text(arrays, "units"),
        up=AXES.get(up if up[:1] in "+-" else f"+{up}"),
        first_frame=int(first) if abs(first) <= LARGEST_FRAME else 1,
    )
    nothing = np.full(frames, np.nan)
    return Source(
        path=path,
        kind="NumPy",
        recording=assemble(path, Frames(nothing, nothing, points), stated, warnings),
        stamp=stamp,
        bones=_bones(arrays, markers, warnings),
        warnings=tuple(warnings),
    )


def _points(arrays: ZipArrays, path: Path) -> NDArray[np.float64]:
    if "pos" not in arrays:
        raise MocapmendError("The file has no array “pos”.", str(path), TODO)
    stored = arrays.read("pos")
    if stored.ndim != 3 or stored.shape[2] != 3 or stored.dtype.kind not in "fiu":
        raise MocapmendError(
            f"“pos” must hold numbers, (frames, markers, 3), not {stored.dtype} {stored.shape}.",
            str(path),
            TODO,
        )
    if stored.shape[1] > MOST_MARKERS:
        raise MocapmendError(
            f"The file has {stored.shape[1]} markers; at most {MOST_MARKERS} can be read.",
            str(path),
            TODO,
        )
    return np.array(stored, np.float64, order="C")


def _names(arrays: ZipArrays, path: Path, markers: int) -> list[str]:
    if "names" not in arrays:
        return []
    names = arrays.read("names")
    if names.size != markers or names.dtype.kind not in "US":
        raise MocapmendError(
            f"“names” must hold one text for each of the {markers} markers, not "
            f"{names.dtype} {names.shape}.",
            str(path),
            TODO,
        )
    return _texts(names)


def _texts(array: NDArray[Any]) -> list[str]:
    if array.dtype.kind == "U" and not _are_characters(array):
        return [""] * array.size
    texts = array.ravel().tolist()
    if array.dtype.kind == "S":
        texts = [text.decode("utf-8", "replace") for text in texts]
    return [clean_label(text) for text in texts]


def _are_characters(array: NDArray[Any]) -> bool:
    """Whether a text array holds characters: damaged ones may hold any number."""
    if not array.nbytes:
        return True
    codes = np.ascontiguousarray(array.ravel()).view(array.dtype.str[0] + "u4")
    surrogates = (codes >= 0xD800) & (codes <= 0xDFFF)
    return not (surrogates | (codes > sys.maxunicode)).any()


def _text(arrays: ZipArrays, name: str) -> str:
    array = arrays.read(name) if name in arrays else np.empty(0)
    return _texts(array)[0] if array.size == 1 and array.dtype.kind in "US" else ""


def _number(arrays: ZipArrays, name: str) -> float:
    array = arrays.read(name) if name in arrays else np.empty(0)
    return float(array.ravel()[0]) if array.size == 1 and array.dtype.kind in "fiu" else np.nan


def _bones(arrays: ZipArrays, markers: int, warnings: list[str]) -> tuple[tuple[int, int], ...]:
    """Return the sticks between markers that the file names."""
    if "bones" in arrays:
        pairs = arrays.read("bones")
    elif "parents" in arrays:
        parents = arrays.read("parents").ravel()
        children = np.arange(len(parents), dtype=np.int64)
        if parents.dtype.kind not in "iu" or len(parents) != markers:
            warnings.append("The parents of the markers do not fit the markers; they are ignored.")
            return ()
        pairs = np.stack([parents.astype(np.int64), children], axis=1)[parents >= 0]
    else:
        return ()
    if not _are_bones(pairs, markers):
        warnings.append("The bones of the file do not fit its markers; they are ignored.")
        return ()
    return tuple((a, b) for a, b in pairs.tolist() if a != b)


def _are_bones(pairs: NDArray[Any], markers: int) -> bool:
    return (
        pairs.dtype.kind in "iu"
        and pairs.shape[1:] == (2,)
        and len(pairs) <= MOST_MARKERS
        and bool(((pairs >= 0) & (pairs < markers)).all())
    )
