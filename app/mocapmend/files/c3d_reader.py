"""Reading C3D files: every processor, integers and floats, every way to store 'missing'."""

import os
import stat
from collections.abc import Iterator
from contextlib import contextmanager
from dataclasses import dataclass
from io import FileIO
from pathlib import Path

import numpy as np
from numpy.typing import NDArray

from mocapmend.errors import MocapmendError
from mocapmend.files.c3d_header import BLOCK
from mocapmend.files.c3d_labels import (
    Event,
    analog_labels,
    model_points,
    point_labels,
    read_events,
)
from mocapmend.files.c3d_layout import ANOTHER_FILE, Layout, cannot_read, read_layout
from mocapmend.files.c3d_samples import (
    coordinates,
    marked_missing,
    point_words,
    read_analog_samples,
    read_blocks,
    residual_steps,
    unmarked_missing,
)
from mocapmend.files.c3d_space import length_unit, up_axis
from mocapmend_algorithms.recording import Recording


@dataclass(frozen=True)
class Stamp:
    """Size in bytes and time of change of a file when it was read."""

    size: int
    mtime_ns: int


@dataclass(frozen=True, eq=False)
class C3DFile:
    """A C3D file as it was read.

    Attributes
    ----------
    path : Path
        Where it was.
    layout : Layout
        Where its samples are and how they are stored.
    recording : Recording
        The markers; model outputs are kept apart.
    marker_points : tuple of int
        The stored point of each marker of the recording.
    residuals : ndarray, shape (frames, markers), float32
        Residuals in the recording's unit, NaN where the marker is missing.
    model_outputs : tuple of str
        Labels of the stored points that are not markers.
    events : tuple of Event
        Ordered by time.
    analog_labels : tuple of str
        One per analog channel.
    analog_rate : float
        Analog samples per second (Hz), 0 without analog.
    warnings : tuple of str
        What was odd and what was assumed, as sentences.
    truncated : bool
        Whether the file holds fewer frames than it says.
    stamp : Stamp
        To notice that the file was changed since.
    """

    path: Path
    layout: Layout
    recording: Recording
    marker_points: tuple[int, ...]
    residuals: NDArray[np.float32]
    model_outputs: tuple[str, ...]
    events: tuple[Event, ...]
    analog_labels: tuple[str, ...]
    analog_rate: float
    warnings: tuple[str, ...]
    truncated: bool
    stamp: Stamp

    @np.errstate(all="ignore")
    def read_analog(self) -> NDArray[np.float64]:
        """Read the analog data from the file, shape (samples, channels), in their units.

        Raises
        ------
        MocapmendError
            If the file is not there any more, or not as it was.
        """
        parameters = self.layout.parameters
        channels = self.layout.channels
        unsigned = parameters.text("ANALOG:FORMAT").upper() == "UNSIGNED"
        offset = parameters.numbers("ANALOG:OFFSET", unsigned=unsigned)[:channels]
        scale = parameters.numbers("ANALOG:SCALE")[:channels]
        general = parameters.number("ANALOG:GEN_SCALE")
        with open_c3d(self.path) as (stream, stamp):
            if stamp != self.stamp:
                raise changed_on_disk(self.path)
            values = read_analog_samples(stream, self.layout, str(self.path), unsigned=unsigned)
        values[:, : len(offset)] -= offset
        values[:, : len(scale)] *= scale
        values *= 1.0 if general is None else general
        return values


def changed_on_disk(path: Path) -> MocapmendError:
    """Return the error for a file that is not as it was when it was read."""
    return MocapmendError(
        "The original was changed since it was opened.",
        str(path),
        "Put the former file back under this name to save the repairs, or open it again.",
    )


@contextmanager
def open_c3d(path: Path) -> Iterator[tuple[FileIO, Stamp]]:
    """Open a file for reading.

    Raises
    ------
    MocapmendError
        If it is missing, a folder, or may not or cannot be read.
    """
    try:
        mode = path.stat().st_mode
        # Opening a pipe or a device could wait for ever.
        if not (stat.S_ISREG(mode) or stat.S_ISDIR(mode)):
            raise MocapmendError("This is not an ordinary file.", str(path), ANOTHER_FILE)
        stream = path.open("rb", buffering=0)
    except (FileNotFoundError, NotADirectoryError, ValueError):
        raise MocapmendError(
            "There is no such file.", str(path), "Check the name and the folder."
        ) from None
    except IsADirectoryError:
        raise MocapmendError(
            "This is a folder, not a file.", str(path), "Choose a file in it."
        ) from None
    except PermissionError:
        raise MocapmendError(
            "You may not read this file.", str(path), "Change its permissions or copy it."
        ) from None
    except OSError as error:
        raise cannot_read(str(path), error) from error
    with stream:
        status = os.fstat(stream.fileno())
        yield stream, Stamp(status.st_size, status.st_mtime_ns)


@np.errstate(all="ignore")
def read_c3d(path: Path) -> C3DFile:
    """Read a C3D file.

    Raises
    ------
    MocapmendError
        If it cannot be read; nothing else.
    """
    path = Path(path)
    with open_c3d(path) as (stream, stamp):
        layout = read_layout(stream, stamp.size, str(path))
        warnings = [*layout.warnings, *_about_size(layout)]
        labels = point_labels(layout, warnings)
        models = model_points(layout, labels)
        markers = tuple(i for i in range(layout.points) if i not in models)
        try:
            points, residuals = _read_points(stream, layout, markers, str(path), warnings)
        except MemoryError:
            raise MocapmendError(
                "The recording does not fit into memory.", str(path), "Close other programs."
            ) from None
    if not (markers and layout.frames):
        warnings.append("The file holds no marker data: there is nothing to repair.")
    return C3DFile(
        path=path,
        layout=layout,
        recording=Recording(
            points,
            tuple(labels[i] for i in markers),
            layout.rate,
            unit=length_unit(points, layout.parameters, warnings),
            up=up_axis(points, layout.parameters, warnings),
            first_frame=layout.first_frame,
        ),
        marker_points=markers,
        residuals=residuals,
        model_outputs=tuple(labels[i] for i in sorted(models)),
        events=read_events(layout),
        analog_labels=analog_labels(layout),
        analog_rate=layout.analog_rate,
        warnings=tuple(warnings),
        truncated=layout.truncated,
        stamp=stamp,
    )


def _about_size(layout: Layout) -> Iterator[str]:
    if layout.truncated:
        yield (
            f"The file is truncated: it says that it holds {layout.frames_promised} frames, "
            f"but only {layout.frames} are there."
        )
    left = layout.size - layout.data_stop
    if left > BLOCK and layout.data_start > layout.parameters_start:
        yield f"{left} bytes follow the last frame; they are kept as they are."


def _read_points(
    stream: FileIO, layout: Layout, markers: tuple[int, ...], where: str, warnings: list[str]
) -> tuple[NDArray[np.float64], NDArray[np.float32]]:
    """Read the coordinates, shape (frames, markers, 3), and the residuals."""
    points = np.empty((layout.frames, len(markers), 3))
    residuals = np.empty((layout.frames, len(markers)), np.float32)
    chosen = _index(markers)
    unmarked = 0
    for first, block in read_blocks(stream, layout, where) if markers else ():
        words = point_words(block, layout)[:, chosen]
        here = points[first : first + len(block)]
        for axis in range(3):
            here[..., axis] = coordinates(words, layout, axis)
        fourth = np.ascontiguousarray(words[..., 3])
        missing = marked_missing(fourth)
        more = unmarked_missing(words, missing)
        unmarked += int(np.count_nonzero(more))
        missing |= more
        residual = residuals[first : first + len(block)]
        np.multiply(residual_steps(fourth), np.float32(layout.scale), out=residual)
        at = np.flatnonzero(missing)
        here.reshape(-1, 3)[at] = np.nan
        residual.reshape(-1)[at] = np.nan
    if unmarked:
        warnings.append(
            f"{unmarked} samples are exactly (0, 0, 0) or not finite without a mark of missing; "
            "they are taken as missing."
        )
    return points, residuals


def _index(markers: tuple[int, ...]) -> slice | list[int]:
    """Index the markers without a copy where they are neighbours."""
    if markers and markers[-1] - markers[0] == len(markers) - 1:
        return slice(markers[0], markers[-1] + 1)
    return list(markers)
