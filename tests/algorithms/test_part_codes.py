"""W18 as printed: rows of a part, its training, and what is recovered from it."""

from dataclasses import replace

import numpy as np
import pytest
from joint_samples import NAMES, walker

from mocapmend_algorithms import Cancelled, no_progress
from mocapmend_algorithms.sparse.body import TRIPLES, find_body
from mocapmend_algorithms.sparse.bone_space import with_lengths
from mocapmend_algorithms.sparse.part_codes import recover
from mocapmend_algorithms.sparse.part_rows import SPAN, PartRows
from mocapmend_algorithms.sparse.part_training import (
    LOST_SHARE,
    PartSettings,
    assemble_part,
    standard_lengths,
    train_part,
)
from mocapmend_algorithms.sparse.part_training import _masks as masks

SETTINGS = PartSettings(atoms=60, rounds=3)
FRAMES, LEARNED = 260, 200
REGIONS = {
    "arm": ("lhumerus", "lradius", "lwrist"),
    "leg": ("lhipjoint", "lfemur", "ltibia", "lfoot", "ltoes"),
    "leg and root": ("root", "lhipjoint", "lfemur", "ltibia", "lfoot", "ltoes"),
    "anchor": ("thorax", "lclavicle", "lhumerus"),
    "trunk": ("root", "lowerback", "upperback"),
}
EVERY_PART = pytest.mark.parametrize("at", range(5))


@pytest.fixture(scope="module")
def walk():
    """Places of a walk in mm, and its body."""
    recording = walker(FRAMES)
    return recording.points * recording.mm, find_body(recording, recording.present)


@pytest.fixture(scope="module")
def trained(walk):
    points, body = walk
    return [train_part([points[:LEARNED]], body, at, SETTINGS, no_progress) for at in range(5)]


@pytest.fixture(scope="module")
def dictionaries(walk, trained):
    points, body = walk
    return {
        at: assemble_part([points[:LEARNED]], body, at, state.dictionary)
        for at, state in enumerate(trained)
    }


def at_names(names):
    return [NAMES.index(name) for name in names]


def lose(points, names, start=150, stop=240):
    seen = np.ones(points.shape[:2], dtype=bool)
    seen[start:stop, at_names(names)] = False
    return seen


def blind(points, seen):
    """Make sure that nobody looks at what is not seen."""
    return np.where(seen[..., None], points, 1e9)


def error(points, found, seen):
    return float(np.sqrt(np.mean(np.sum((found - points)[~seen] ** 2, axis=1))))


# --- rows ------------------------------------------------------------------------------------


@EVERY_PART
def test_a_part_has_the_bones_of_its_triple_and_its_anchor(walk, at):
    points, body = walk
    rows = PartRows.of(body, at, body.edge_lengths)
    triple = {marker for other in TRIPLES[at] for marker in body.parts[other].tolist()}
    bones = rows.pairs[rows.standard > 0]
    assert set(bones[:, 0].tolist()) == triple - {NAMES.index("root")}
    assert (bones[:, 1] == body.parents[bones[:, 0]]).all()
    away = np.linalg.norm(points[0, bones[:, 0]] - points[0, bones[:, 1]], axis=1)
    np.testing.assert_allclose(rows.standard[rows.standard > 0], away)
    anchors = rows.pairs[rows.standard == 0].tolist()
    arm = [[NAMES.index("thorax"), NAMES.index("root")]]
    assert anchors == (arm if at in (1, 2) else [])
    own = set(rows.pairs[rows.own, 0].tolist())
    assert own == set(body.parts[at].tolist()) - {NAMES.index("root")}


def test_rows_are_windows_of_six_frames_of_child_minus_parent(walk):
    points, body = walk
    rows = PartRows.of(body, 0, body.edge_lengths)
    places = np.array([10, 50])
    away = rows.differences(points, places).reshape(6, len(rows.pairs), 3, 2)
    child, parent = rows.pairs[4]
    for at, place in enumerate(places):
        frames = place + np.array(SPAN.offsets)
        np.testing.assert_array_equal(
            away[:, 4, :, at], points[frames, child] - points[frames, parent]
        )


def test_a_pair_is_seen_where_both_its_ends_are(walk):
    points, body = walk
    rows = PartRows.of(body, 1, body.edge_lengths)
    seen = lose(points, ["lradius"], 100, 101)
    place = np.array([100])
    shown = rows.seen(seen, place).reshape(6, len(rows.pairs))
    hidden = np.zeros_like(shown)
    hidden[SPAN.offsets.index(0)] = (rows.pairs == NAMES.index("lradius")).any(axis=1)
    assert hidden.sum() == 2
    np.testing.assert_array_equal(shown, ~hidden)


def test_standard_lengths_are_the_mean_over_motions_whatever_their_length(walk):
    points, body = walk
    found = standard_lengths([points[:50], 2 * points], body)
    np.testing.assert_allclose(found, 1.5 * body.edge_lengths)


# --- training --------------------------------------------------------------------------------


@EVERY_PART
def test_objectives_never_rise_and_atoms_are_short(trained, dictionaries, at):
    state, dictionary = trained[at], dictionaries[at]
    objectives = np.array(state.objectives)
    assert objectives.size > 1
    assert (np.diff(objectives) <= 0).all()
    assert objectives[-1] < 0.05 * objectives[0]
    assert dictionary.atoms.shape[1] == SETTINGS.atoms
    assert (np.linalg.norm(dictionary.atoms, axis=0) <= 1 + 1e-5).all()


def test_training_goes_on_from_an_earlier_state(walk):
    points, body = walk
    few = PartSettings(atoms=20, rounds=2)
    once = train_part([points[:80]], body, 3, replace(few, rounds=1), no_progress)
    again = train_part([points[:80]], body, 3, replace(few, rounds=1), no_progress, once)
    whole = train_part([points[:80]], body, 3, few, no_progress)
    assert again.objectives == whole.objectives
    assert len(whole.objectives) == 3
    np.testing.assert_array_equal(again.dictionary, whole.dictionary)


def test_motions_shorter_than_a_window_teach_lengths_alone(walk):
    points, body = walk
    few = PartSettings(atoms=10, rounds=1)
    with_crumb = train_part([points[:60], points[:3]], body, 3, few, no_progress)
    without = train_part([points[:60]], body, 3, few, no_progress)
    assert with_crumb.weights.shape == without.weights.shape


def test_progress_rises_and_training_may_be_cancelled(walk):
    points, body = walk
    few, told = PartSettings(atoms=10, rounds=2), []
    train_part([points[:60]], body, 3, few, told.append)
    assert told == sorted(told)
    assert told[-1] == 1.0

    def cancel(fraction):
        if fraction > 0.3:
            raise Cancelled

    with pytest.raises(Cancelled):
        train_part([points[:60]], body, 3, few, cancel)


@EVERY_PART
def test_masks_hide_three_or_six_neighbours_in_two_fifths_of_the_windows(walk, at):
    _, body = walk
    rows = PartRows.of(body, at, body.edge_lengths)
    seen = masks(rows, body, 2000, np.random.default_rng(3))
    frames = seen.reshape(len(SPAN.offsets), len(rows.pairs), -1)
    assert (frames == frames[0]).all()
    touched = ~frames[0].all(axis=0)
    assert abs(touched.mean() - LOST_SHARE) < 0.04
    inside = np.unique(rows.pairs)
    counts = []
    for column in np.flatnonzero(touched)[:300]:
        gone = rows.pairs[~frames[0][:, column]]
        # Whoever is in no pair that is seen is hidden; the hidden ones hang together by bones.
        shown = np.unique(rows.pairs[frames[0][:, column]])
        hidden = np.setdiff1d(inside, shown)
        counts.append(hidden.size)
        reached, before = {int(np.bincount(gone.ravel()).argmax())}, 0
        while len(reached) != before:
            before = len(reached)
            reached |= {
                marker
                for edge in body.edges.tolist()
                if reached & set(edge)
                for marker in edge
                if marker in hidden
            }
        assert reached >= set(hidden.tolist())
    # A marker whose neighbours are all hidden counts too: there may be more, but not fewer.
    assert min(counts) == 3
    assert 0.4 < np.mean(np.array(counts) >= 6) < 0.7
    assert np.mean(np.isin(counts, [3, 6])) > 0.4


# --- recovery --------------------------------------------------------------------------------


@pytest.mark.parametrize("region", REGIONS)
def test_what_is_missing_is_told_better_than_by_the_mean(walk, dictionaries, region):
    points, body = walk
    seen = lose(points, REGIONS[region])
    found = recover(blind(points, seen), seen, body, dictionaries, no_progress)
    assert np.isfinite(found).all()
    np.testing.assert_array_equal(found[seen], points[seen])
    # By the mean posture of what is seen all the time, placed by the centre of the others.
    lost = at_names(REGIONS[region])
    others = np.setdiff1d(np.arange(31), lost)
    centred = points - points[:, others].mean(axis=1, keepdims=True)
    mean = centred[:150].mean(axis=0) + points[:, others].mean(axis=1, keepdims=True)
    assert error(points, found, seen) < 0.6 * error(points, mean, seen)


def test_only_the_parts_that_miss_something_are_asked(walk, dictionaries):
    points, body = walk
    seen = lose(points, REGIONS["arm"])
    every = recover(blind(points, seen), seen, body, dictionaries, no_progress)
    one = recover(blind(points, seen), seen, body, {1: dictionaries[1]}, no_progress)
    np.testing.assert_array_equal(every, one)


def test_a_complete_motion_stays_as_it_is(walk, dictionaries):
    points, body = walk
    seen = np.ones(points.shape[:2], dtype=bool)
    np.testing.assert_array_equal(recover(points, seen, body, dictionaries, no_progress), points)


@pytest.mark.parametrize("region", REGIONS)
def test_a_body_of_another_size_gets_its_own_lengths(walk, dictionaries, region):
    points, body = walk
    large = replace(body, lengths=1.5 * body.lengths)
    # The root keeps its place, all else is 1.5 times as far from it.
    grown = with_lengths(points, body, 1.5 * body.edge_lengths)
    seen = lose(points, REGIONS[region], 200, 240)
    small = recover(blind(points, seen), seen, body, dictionaries, no_progress)
    found = recover(blind(grown, seen), seen, large, dictionaries, no_progress)
    root = points[:, [0]]
    assert NAMES[0] == "root"
    # Rounding takes the steps of the codes elsewhere, by a few mm.
    assert error(1.5 * (small - root), found - root, seen) < 10


def test_frames_without_any_marker_stay_open(walk, dictionaries):
    points, body = walk
    seen = lose(points, NAMES, 100, 110)
    found = recover(blind(points, seen), seen, body, dictionaries, no_progress)
    assert np.isnan(found[100:110]).all()
    np.testing.assert_array_equal(found[:100], points[:100])


def test_a_motion_shorter_than_a_window_stays_open(walk, dictionaries):
    points, body = walk
    short = points[:4]
    seen = lose(short, ["lwrist"], 1, 3)
    found = recover(blind(short, seen), seen, body, dictionaries, no_progress)
    assert np.isnan(found[~seen]).all()
    np.testing.assert_array_equal(found[seen], short[seen])


def test_a_sign_that_is_contradicted_gives_nothing(walk, dictionaries):
    points, _ = walk
    part = dictionaries[1]
    places = SPAN.inside(0, 60)
    away = part.rows.differences(points, places)
    seen = np.ones((len(part.rows.pairs) * len(SPAN.offsets), places.size), dtype=bool)
    told = part.recover(away, seen, no_progress)
    assert (told * away >= 0).all()
    assert (told == 0).any()
    assert np.median(np.abs(told - away)) < 30
    # The coarse completion has all signs wrong, and nothing is seen that tells better.
    wrong = replace(part, mean=-part.mean, components=0 * part.components)
    blank = wrong.recover(np.full_like(away, 1e9), np.zeros_like(seen), no_progress)
    assert (blank * -part.mean[:, None] >= 0).all()


def test_recovery_tells_progress_and_may_be_cancelled(walk, dictionaries):
    points, body = walk
    seen = lose(points, REGIONS["anchor"], 150, 170)
    told = []
    recover(blind(points, seen), seen, body, dictionaries, told.append)
    assert told == sorted(told)
    assert told[-1] == 1.0

    def cancel(_):
        raise Cancelled

    with pytest.raises(Cancelled):
        recover(blind(points, seen), seen, body, dictionaries, cancel)
