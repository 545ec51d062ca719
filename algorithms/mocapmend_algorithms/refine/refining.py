"""Refining a recording with a trained network (Y23, section 2.5)."""

from dataclasses import dataclass
from typing import Literal

import numpy as np

from mocapmend_algorithms.arrays import BoolArray, FloatArray
from mocapmend_algorithms.params import option
from mocapmend_algorithms.progress import Progress
from mocapmend_algorithms.recording import Recording
from mocapmend_algorithms.refine.calibrating import corrected
from mocapmend_algorithms.refine.mirroring import poses_of
from mocapmend_algorithms.refine.model import Model
from mocapmend_algorithms.refine.preparing import RATE, headings, prepare, turned
from mocapmend_algorithms.refine.windows import Windows
from mocapmend_algorithms.smooth.low_pass import low_pass

TOGETHER = 16
"""Windows that the network takes at once: few enough to stop soon, enough to be quick."""
ORDER = 4
"""Of the output filter, both passes together."""
LEAST_TO_FILTER = 2 * ORDER + 1
LOWEST_CUTOFF, HIGHEST_CUTOFF = 0.5, 29.0
"""Hz of that filter."""


@dataclass(frozen=True)
class RefineParams:
    """Parameters of `refine`."""

    stride: Literal["60", "1"] = option(
        "60",
        label="Stride",
        text="Frames by which the window of 120 moves on, at 60 frames per second. 60 keeps the "
        "middle 60 frames of each. 1 keeps the middle frame, as in the paper, and takes about "
        "sixty times as long.",
    )
    cutoff_hz: float | None = option(
        None,
        label="Output filter",
        text="Cut-off of a zero-lag low-pass filter that smooths the result; 6 Hz is usual. Off: "
        "the result is as the network makes it.",
        minimum=LOWEST_CUTOFF,
        maximum=HIGHEST_CUTOFF,
        unit="Hz",
    )


@dataclass(frozen=True, eq=False)
class Refined:
    """A refined recording.

    Attributes
    ----------
    recording : Recording
        The network's outputs in the place, axes, unit, rate and frames of the original.
    bridged : ndarray of bool, shape (frames, inputs)
        What was missing of the original and bridged before the network saw it.
    poses : ndarray, shape (frames at 60 per second, outputs, 3)
        In mm relative to the root, z up.
    """

    recording: Recording
    bridged: BoolArray
    poses: FloatArray


def refine(
    recording: Recording,
    model: Model,
    params: RefineParams,
    progress: Progress,
    offset: FloatArray | None = None,
    /,
) -> Refined:
    """Refine a recording: its joints become the markers or joints of the model's profile.

    Parameters
    ----------
    recording : Recording
        Not changed.
    model : Model
        The network.
    params : RefineParams
        How.
    progress : Progress
        Called after each few windows.
    offset : ndarray, shape (outputs, 3), optional
        A mean error in mm that is subtracted; see `calibrating`.

    Raises
    ------
    RefineError
        If the recording lacks joints that the network takes.
    ValueError
        If a parameter is impossible.
    """
    cutoff = params.cutoff_hz
    if cutoff is not None and not LOWEST_CUTOFF <= cutoff <= HIGHEST_CUTOFF:
        raise ValueError(
            f"cutoff_hz must be from {LOWEST_CUTOFF:g} to {HIGHEST_CUTOFF:g}, not {cutoff:g}"
        )
    prepared = prepare(recording, model.profile)
    poses = refined_poses(prepared.joints, model, int(params.stride), progress)
    if offset is not None:
        poses = corrected(prepared.joints, poses, offset, model.profile)
    if cutoff is not None:
        poses = filtered(poses, cutoff)
    points = np.ascontiguousarray(prepared.undone(poses))
    made = Recording(
        points,
        model.profile.outputs,
        recording.rate,
        unit=recording.unit,
        up=recording.up,
        first_frame=recording.first_frame,
    )
    return Refined(made, prepared.bridged, poses)


def refined_poses(joints: FloatArray, model: Model, stride: int, progress: Progress) -> FloatArray:
    """Refine prepared joints.

    Parameters
    ----------
    joints : ndarray, shape (frames, inputs, 3)
        As `Prepared.joints`.
    model : Model
        The network.
    stride : int
        Frames from window to window.
    progress : Progress
        Called after each few windows.

    Returns
    -------
    ndarray, shape (frames, outputs, 3)
    """
    windows = Windows.over(len(joints), stride)
    count = len(windows.starts)
    kept = []
    for start in range(0, count, TOGETHER):
        part = windows.slice(start, min(start + TOGETHER, count))
        seen = part.cut_out(joints)
        angles = headings(seen, model.profile)
        made = poses_of(model, turned(seen, -angles))
        kept.append(part.joined(turned(made, angles)))
        progress(min(start + TOGETHER, count) / count)
    return np.concatenate(kept)


def filtered(poses: FloatArray, cutoff: float) -> FloatArray:
    """Smooth poses, shape (frames, ...) at 60 per second, with a zero-lag filter (Hz)."""
    if len(poses) < LEAST_TO_FILTER:
        return poses
    columns = poses.reshape(len(poses), -1).T
    smooth = np.stack([low_pass(column, cutoff, RATE, ORDER) for column in columns], axis=1)
    return smooth.reshape(poses.shape)
