"""The good files from which damaged ones are made."""

from collections.abc import Iterator
from dataclasses import dataclass, replace
from importlib.resources import as_file, files
from pathlib import Path
from tempfile import TemporaryDirectory

from mocapmend import engine
from mocapmend.bench.encodings import transcode
from mocapmend.bench.small_files import BESIDE, SMALL_FILES
from mocapmend.bench.synthetic import write_recording
from mocapmend.bench.trial import fill_gaps
from mocapmend.errors import MocapmendError
from mocapmend.files import Layout, read_c3d
from mocapmend.files.c3d_header import BLOCK
from mocapmend.files.c3d_numbers import Processor
from mocapmend.files.formats import FORMATS
from mocapmend.files.records import NEVER_FILLED
from mocapmend_algorithms import Gap, no_progress

KEPT_FRAMES = 24
KEPT_BYTES = 1 << 16
LARGEST_ARCHIVE = 1 << 18


@dataclass(frozen=True)
class Seed:
    """A good file.

    Attributes
    ----------
    name, kind, suffix : str
        What it is; results are counted by kind.
    raw : bytes
        The file.
    head : int
        Bytes before its samples.
    beside : tuple of (str, bytes)
        Suffix and content of files that must lie beside it.
    """

    name: str
    kind: str
    suffix: str
    raw: bytes
    head: int
    beside: tuple[tuple[str, bytes], ...] = ()


def all_seeds(data: Path | None = None) -> list[Seed]:
    """Return the bundled samples, synthetic files of all formats, and the files in a folder.

    Raises
    ------
    MocapmendError
        If there is no such folder.
    """
    found = [*_bundled(), *_synthetic(), *_small()]
    return found + (list(_of_folder(data)) if data else [])


def _bundled() -> Iterator[Seed]:
    with as_file(files("mocapmend_resources") / "samples") as folder:
        for path in sorted(folder.glob("*.c3d")):
            yield _c3d_seed(path)


def _synthetic() -> Iterator[Seed]:
    """Yield a complete recording in the six encodings."""
    with TemporaryDirectory(prefix="mocapmend-bench-") as folder:
        path = Path(folder) / "synthetic.c3d"
        write_recording(path, frames=100, markers=6, analog=3, analog_per_frame=2, gaps=4)
        raw, layout = path.read_bytes(), read_c3d(path).layout
        for processor in Processor:
            for is_float in (True, False):
                made = transcode(raw, layout, processor, is_float=is_float)
                path.write_bytes(made)
                yield _c3d_seed(path, frames=layout.frames)
        path.write_bytes(raw)
        yield _repaired(path)


def _repaired(path: Path) -> Seed:
    """Fill the gaps of a file but the last, which is kept open: the copy has a record of that."""
    source = read_c3d(path)
    out = path.with_name("repaired.c3d")
    filled = fill_gaps(source)
    last = filled.runs[-1]
    gap = Gap(last.marker, last.start, last.start + len(last.values))
    kept = engine.kept_gap(source, gap, never=True, reason=NEVER_FILLED)
    changes = engine.Changes(filled.runs[:-1], filled.repairs[:-1], (kept,))
    engine.export(source, changes, out, False, False, no_progress)  # noqa: FBT003
    return replace(_c3d_seed(out, source.recording.frames), kind="C3D with a repair record")


def _small() -> Iterator[Seed]:
    known = _suffixes()
    for kind, suffix, make in SMALL_FILES:
        if suffix in known:
            beside = tuple((end, make_it()) for end, make_it in BESIDE.get(suffix, ()))
            raw = make()
            yield Seed(f"small{suffix}", kind, suffix, raw, len(raw) // 4, beside)


def _of_folder(folder: Path) -> Iterator[Seed]:
    if not folder.is_dir():
        raise MocapmendError("There is no such folder.", str(folder), "Check its name.")
    known = _suffixes()
    for path in sorted(folder.rglob("*")):
        suffix = path.suffix.lower()
        if suffix not in known or not path.is_file() or not path.stat().st_size:
            continue
        if suffix == ".c3d":
            yield _c3d_seed(path)
        elif suffix != ".npz" or path.stat().st_size <= LARGEST_ARCHIVE:
            yield _other_seed(path, suffix)


def _c3d_seed(path: Path, frames: int = KEPT_FRAMES) -> Seed:
    """Take the first frames of a file, or its first bytes where it has none or is unreadable."""
    try:
        layout = read_c3d(path).layout
    except MocapmendError:
        raw = path.read_bytes()[:KEPT_BYTES]
        return Seed(path.name, "C3D, unreadable", ".c3d", raw, BLOCK)
    kept = max(1, min(frames, (KEPT_BYTES - layout.data_start) // max(1, layout.frame_bytes)))
    # What follows the last frame is kept where all frames are.
    stop = layout.data_start + kept * layout.frame_bytes if layout.frames > kept else KEPT_BYTES
    return Seed(path.name, _encoding(layout), ".c3d", path.read_bytes()[:stop], layout.data_start)


def _other_seed(path: Path, suffix: str) -> Seed:
    """Take the first lines of a file; an archive as it is."""
    raw = path.read_bytes()
    if suffix != ".npz" and len(raw) > KEPT_BYTES:
        raw = raw[: raw.rfind(b"\n", 0, KEPT_BYTES) + 1]
    beside = [
        (end, other.read_bytes())
        for end, _ in BESIDE.get(suffix, ())
        for other in sorted(path.parent.glob(f"*{end}"))[:1]
    ]
    return Seed(path.name, suffix[1:].upper(), suffix, raw, len(raw) // 4, tuple(beside))


def _encoding(layout: Layout) -> str:
    return f"C3D, {layout.processor.name} {'float' if layout.is_float else 'integer'}"


def _suffixes() -> set[str]:
    return {suffix for item in FORMATS for suffix in item.suffixes}
