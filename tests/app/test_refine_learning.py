"""Training for the profiles that ship: the 25 joints of Kinect v2 and their 59 too."""

from dataclasses import replace
from pathlib import Path

import numpy as np
import pytest
from refine_files import write_pairs

from mocapmend.errors import MocapmendError
from mocapmend.refine.learning import Course, learn
from mocapmend.refine.measuring import errors_over
from mocapmend.refine.pair_lists import read_pairs
from mocapmend.refine.profiles import profile_named, profiles
from mocapmend_algorithms import no_progress
from mocapmend_algorithms.refine.refining import refined_poses
from mocapmend_algorithms.refine.train.drawing import NO_CHANGES
from mocapmend_algorithms.refine.train.settings import Settings


def test_markers_that_no_reference_shows_cannot_be_learnt(tmp_path: Path) -> None:
    pytest.importorskip("torch", reason="PyTorch is not installed")
    profile = profile_named("kinect22-pig39")
    (pair,) = read_pairs(write_pairs(tmp_path, profile, 1), profile, no_progress)
    markers = pair.markers.copy()
    markers[:, 4] = np.nan
    course = Course(profile, Settings(stacks=1, width=4, first_width=4), tmp_path / "state")
    with pytest.raises(MocapmendError, match="shows these markers: C7"):
        learn(course, [replace(pair, markers=markers)], no_progress, resume=False)


@pytest.mark.parametrize("name", list(profiles()))
def test_a_tiny_pair_is_learnt_by_heart(tmp_path: Path, name: str) -> None:
    pytest.importorskip("torch", reason="PyTorch is not installed")
    profile = profile_named(name)
    pairs = read_pairs(write_pairs(tmp_path, profile, 1), profile, no_progress)
    # The joints are noisy, the markers are not.
    rng = np.random.default_rng(0)
    pairs = [
        replace(pair, joints=pair.joints + rng.normal(0, 30, pair.joints.shape)) for pair in pairs
    ]
    settings = Settings(
        stacks=1, width=24, first_width=24, latent=0.0, bones=0.1, smoothness=1.0, rounds=200,
        step=1e-2, changes=NO_CHANGES,
    )  # fmt: skip
    course = Course(profile, settings, tmp_path / "state")
    model = learn(course, pairs, no_progress, resume=False)
    made = errors_over(pairs, lambda j: refined_poses(j, model, 60, no_progress), profile)
    motion = np.mean([np.var(pair.markers, axis=0).mean() for pair in pairs])
    assert made.position < 0.05 * motion
    assert model.profile.id == name
