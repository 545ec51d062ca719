"""Which recordings the detectors are tuned on, and which they are judged on."""

from dataclasses import replace
from functools import lru_cache
from pathlib import Path

from mocapmend.files import read_recording
from mocapmend_algorithms import Recording

TRAIN = (
    "cmu_markers/132_32.npz",
    "cmu_markers/135_07.npz",
    "cmu_markers/143_22.npz",
    "cmu_markers/mr_HDM_mm_01-02_03_120.c3d",
    "c3d/ezc3d_Vicon.c3d",
    "c3d/ktk_Qualisys.c3d",
    "c3d/ktk_sprintbasket.c3d",
    "c3d/btk_Eb015pr.c3d",
    "c3d/bzoo_Left_handed_shooter_stick_and_puck_top_right001.c3d",
    "c3d/btk_PiG_Motion3_FF_N18.c3d",
    "cmu_joints/01_01.npz",
    "cmu_joints/06_10.npz",
)
"""The thresholds of the detectors were chosen on errors put into these. Never move one to the other
list.
"""
VALIDATION = (
    "cmu_markers/127_07.npz",
    "cmu_markers/132_43.npz",
    "cmu_markers/141_16.npz",
    "cmu_markers/mr_85_02.c3d",
    "c3d/biobuddy_right_knee.c3d",
    "c3d/opensim_walking5.c3d",
    "c3d/ktk_kinematics_tennis_serve_nan.c3d",
    "c3d/btk_mocap36.c3d",
    "c3d/btk_FunctionalWalk.c3d",
    "c3d/mzoo_HC030A22.c3d",
    "c3d/ktk_c3d_sample.c3d",
    "cmu_joints/05_02.npz",
    "cmu_joints/11_01.npz",
    "cmu_joints/49_18.npz",
)
"""The targets are judged on these. No threshold was chosen on errors put into them, but that spikes
below 15 mm are left alone by default; what is found in them as they are was looked at by eye.
"""
HALVES = {"train": TRAIN, "validation": VALIDATION}
CLEAN = (
    "cmu_markers/mr_85_02.c3d",
    "cmu_markers/132_32.npz",
    "cmu_markers/132_43.npz",
    "cmu_markers/143_22.npz",
)
"""Listed as clean: what is found there counts as a false alarm."""
KNOWN = (
    "cmu_markers/mr_135_02.c3d",
    "c3d/bzoo_Wrist_Shot_Top_Left_009kin_fit.c3d",
    "cmu_joints/05_06.npz",
    "cmu_joints/05_18.npz",
    "cmu_markers/cmu_02_01.c3d",
)
"""With real errors, or jittery."""
UNLABELLED = "*"


@lru_cache(maxsize=64)
def load(data: Path, name: str) -> Recording:
    """Read a recording without the markers that are not labelled or never seen.

    Raises
    ------
    MocapmendError
        If it cannot be read.
    """
    recording = read_recording(data / name).measured
    kept = [
        marker
        for marker, label in enumerate(recording.labels)
        if not label.startswith(UNLABELLED) and recording.present[:, marker].any()
    ]
    labels = tuple(recording.labels[marker] for marker in kept)
    return replace(recording, points=recording.points[:, kept], labels=labels)
