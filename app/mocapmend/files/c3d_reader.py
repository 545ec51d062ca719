"""Reading C3D files: every processor, integers and floats, every way to store 'missing'."""

from collections.abc import Iterator, Sequence
from dataclasses import dataclass
from pathlib import Path

import numpy as np
from numpy.typing import NDArray

from mocapmend.files.c3d_force_plates import read_force_plates
from mocapmend.files.c3d_group import decode_group
from mocapmend.files.c3d_header import BLOCK
from mocapmend.files.c3d_labels import (
    analog_labels,
    analog_units,
    model_points,
    point_labels,
    read_events,
)
from mocapmend.files.c3d_layout import Layout, read_layout
from mocapmend.files.c3d_points import PLAIN, Points, Way
from mocapmend.files.c3d_samples import point_words, read_analog_samples, read_blocks
from mocapmend.files.c3d_space import up_axis
from mocapmend.files.opening import changed_on_disk, open_file, too_large
from mocapmend.files.provenance import Provenance
from mocapmend.files.repairs import with_repairs
from mocapmend.files.source import Source, truncation
from mocapmend.files.space import length_unit
from mocapmend_algorithms.gaps import Gap
from mocapmend_algorithms.recording import Recording


@dataclass(frozen=True, eq=False, kw_only=True)
class C3DFile(Source):
    """A C3D file as it was read; model outputs are kept apart from the markers.

    Attributes
    ----------
    layout : Layout
        Where its samples are and how they are stored.
    marker_points : tuple of int
        The stored point of each marker of the recording.
    residuals : ndarray, shape (frames, markers), float32
        Residuals in the recording's unit, NaN where the marker is missing.
    analog_units : tuple of str
        One per analog channel, as the file writes it; empty where it has none.
    """

    layout: Layout
    marker_points: tuple[int, ...]
    residuals: NDArray[np.float32]
    analog_units: tuple[str, ...] = ()

    @property
    def stored_points(self) -> tuple[int, ...]:
        """The stored point, from 0, that each marker is."""
        return self.marker_points

    @property
    def analog_unsigned(self) -> bool:
        """Whether integers of analog data have no sign."""
        return analog_unsigned(self.layout)

    @np.errstate(all="ignore")
    def read_analog(self, chosen: Sequence[int] | None = None) -> NDArray[np.float64]:
        """Read the analog data from the file, in their units.

        Parameters
        ----------
        chosen : sequence of int, optional
            The channels, from 0; all by default.

        Returns
        -------
        ndarray, shape (samples, channels)

        Raises
        ------
        MocapmendError
            If the file is not there any more, or not as it was.
        """
        parameters = self.layout.parameters
        channels = self.layout.channels
        unsigned = self.analog_unsigned
        offset = parameters.numbers("ANALOG:OFFSET", unsigned=unsigned)[:channels]
        scale = parameters.numbers("ANALOG:SCALE")[:channels]
        general = parameters.number("ANALOG:GEN_SCALE")

        def convert(samples: NDArray[np.float64]) -> None:
            samples[:, : len(offset)] -= offset
            samples[:, : len(scale)] *= scale
            samples *= 1.0 if general is None else general

        with open_file(self.path) as (stream, stamp):
            if stamp != self.stamp:
                raise changed_on_disk(self.path)
            return read_analog_samples(
                stream, self.layout, str(self.path), convert, unsigned=unsigned, chosen=chosen
            )

    @np.errstate(all="ignore")
    def read_fourth(self, runs: Sequence[Gap]) -> list[NDArray[np.float32]]:
        """Read the fourth words of some runs from the file.

        Returns
        -------
        list of ndarray, shape (frames of the run,)

        Raises
        ------
        MocapmendError
            If the file is not there any more, or not as it was.
        """
        words = []
        with open_file(self.path) as (stream, stamp):
            if stamp != self.stamp:
                raise changed_on_disk(self.path)
            for run in runs:
                point, own = self.marker_points[run.marker], np.empty(run.length, np.float32)
                for first, block in read_blocks(
                    stream, self.layout, str(self.path), run.start, run.stop
                ):
                    start = first - run.start
                    own[start : start + len(block)] = point_words(block, self.layout)[:, point, 3]
                words.append(own)
        return words


@np.errstate(all="ignore")
def read_c3d(path: Path, way: Way = PLAIN) -> C3DFile:
    """Read a C3D file.

    Parameters
    ----------
    path : Path
        Where it is.
    way : Way
        How its samples are read.

    Raises
    ------
    MocapmendError
        If it cannot be read; nothing else.
    """
    path = Path(path)
    with open_file(path) as (stream, stamp):
        layout = read_layout(stream, stamp.size, str(path))
        warnings = [*layout.warnings, *_about_size(layout)]
        labels = point_labels(layout, warnings)
        models = model_points(layout, labels)
        markers = tuple(i for i in range(layout.points) if i not in models)
    try:
        points = Points(path, layout, stamp, markers, way)
    except MemoryError:
        raise too_large(str(path)) from None
    if points.unmarked:
        warnings.append(
            f"{points.unmarked} samples are exactly (0, 0, 0) or not finite without a mark of "
            "missing; they are taken as missing."
        )
    force_plates = read_force_plates(layout, warnings)
    if not (markers and layout.frames):
        warnings.append("The file holds no marker data: there is nothing to repair.")
    stated = _repair_record(layout, warnings)
    source = C3DFile(
        path=path,
        kind="C3D",
        layout=layout,
        recording=Recording(
            points.coordinates,
            tuple(labels[i] for i in markers),
            layout.rate,
            unit=length_unit(points.coordinates, layout.parameters.text("POINT:UNITS"), warnings),
            up=up_axis(points.coordinates, layout.parameters, warnings),
            first_frame=layout.first_frame,
            seen=points.present,
        ),
        marker_points=markers,
        residuals=points.residuals,
        force_plates=force_plates,
        model_outputs=tuple(labels[i] for i in sorted(models)),
        events=read_events(layout),
        analog_labels=analog_labels(layout),
        analog_units=analog_units(layout),
        analog_rate=layout.analog_rate,
        warnings=tuple(warnings),
        frames_promised=layout.frames_promised,
        stamp=stamp,
    )
    return with_repairs(source, stated)


def analog_unsigned(layout: Layout) -> bool:
    """Say whether integers of analog data have no sign."""
    return layout.parameters.text("ANALOG:FORMAT").upper() == "UNSIGNED"


def _repair_record(layout: Layout, warnings: list[str]) -> Provenance | None:
    try:
        return decode_group(layout.parameters)
    except ValueError as error:
        warnings.append(f"The file's repair record cannot be used: {error}.")
        return None


def _about_size(layout: Layout) -> Iterator[str]:
    if layout.truncated:
        yield truncation(layout.frames_promised, layout.frames)
    left = layout.size - layout.data_stop
    # Up to two blocks may be padding.
    if left > 2 * BLOCK and layout.data_start > layout.parameters_start:
        yield f"{left} bytes follow the last frame; they are kept as they are."
