"""The axis that points up in a C3D file."""

import numpy as np
from numpy.typing import NDArray

from mocapmend.files.c3d_parameters import Parameters
from mocapmend.files.space import AXES, assumed_up, present_samples
from mocapmend_algorithms.recording import UpAxis

SOFTWARE = "mocapmend"
"""MANUFACTURER:SOFTWARE of the files that we write: their axes are meant as they stand."""


def up_axis(points: NDArray[np.float64], parameters: Parameters, warnings: list[str]) -> UpAxis:
    """Return the axis that points up.

    It is the axis that the file draws upwards on a screen. Qualisys writes -X and -Z there for
    data that have Z up, so a negative axis is turned round where all markers are on its positive
    side: they would be below the floor.
    """
    stated = AXES.get(parameters.text("POINT:Y_SCREEN").lower())
    if stated is None:
        return assumed_up(points, warnings)
    if parameters.text("MANUFACTURER:SOFTWARE") == SOFTWARE:
        return stated
    sample = present_samples(points)[..., "xyz".index(stated[1])]
    if stated[0] == "-" and sample.size and np.percentile(sample, 5) > 0:
        up = AXES["+" + stated[1]]
        warnings.append(
            f"The file says that {stated} points up, which would put the markers below the "
            f"floor; {up} is used."
        )
        return up
    return stated
