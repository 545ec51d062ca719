"""Sticks from label sets and from distances."""

import re

import numpy as np
import pytest
from synthetic import record

from mocapmend_algorithms import no_progress
from mocapmend_algorithms.skeleton import (
    Segment,
    Template,
    match_template,
    measure_distances,
    parse_template,
    segments_from_distances,
    skeleton_from_distances,
)
from mocapmend_algorithms.skeleton.distances import MOST_MARKERS
from mocapmend_resources.skeletons import load

TEMPLATES = load()
CMU = next(t for t in TEMPLATES if t.name == "CMU, 41 markers")
JOINTS = next(t for t in TEMPLATES if t.name == "CMU, 31 joints")
SPORTS = next(t for t in TEMPLATES if t.name.startswith("Qualisys"))
FULL = next(t for t in TEMPLATES if t.name.endswith("full body"))
LOWER = next(t for t in TEMPLATES if t.name.endswith("lower body"))
TINY = Template(
    "Tiny", ("A", "B", "C", "D", "E"), (("A", "B"), ("B", "X"), ("D", "E")), {"Echo": "E"}
)


def rigid_body(size, frames, rng):
    """A cloud of markers that turns and wanders as one; shape (frames, size, 3)."""
    body = rng.normal(0, 80, (size, 3))
    angle = np.cumsum(rng.normal(0, 0.05, frames))
    turn = np.zeros((frames, 3, 3))
    turn[:, 0, 0] = turn[:, 1, 1] = np.cos(angle)
    turn[:, 1, 0], turn[:, 0, 1] = np.sin(angle), -np.sin(angle)
    turn[:, 2, 2] = 1
    return body @ turn.transpose(0, 2, 1) + np.cumsum(rng.normal(0, 8, (frames, 1, 3)), axis=0)


def joined(bones, markers):
    """Whether the bones join these markers to one piece."""
    piece = {markers[0]}
    for _ in markers:
        piece |= {end for bone in bones if piece & set(bone) for end in bone}
    return piece == set(markers)


@pytest.mark.parametrize(
    ("template", "markers"),
    [(CMU, 41), (JOINTS, 31), (FULL, 34), (LOWER, 16), (SPORTS, 35)],
    ids=lambda x: str(x)[:20],
)
def test_shipped_templates_recognise_themselves_and_join_everything(template, markers):
    assert len(template.required) == len(set(template.required)) == markers
    labels = [f"Matt:{label.lower()}" for label in template.required]
    skeleton = match_template(labels, TEMPLATES)
    assert skeleton.name == template.name
    assert skeleton.source == "template"
    assert joined(skeleton.bones, range(markers))
    assert [part.name for part in skeleton.segments] == list(template.segments)
    inside = [marker for part in skeleton.segments for marker in part.markers]
    assert len(inside) == len(set(inside))
    assert len(set(map(frozenset, skeleton.bones))) == len(skeleton.bones)


def test_shipped_templates_are_the_same_left_and_right():
    def mirrored(label):
        if label[1:] in paired:
            return "RLrl"["LRlr".index(label[0])] + label[1:]
        return re.sub("(?<=Waist)[LR]", lambda side: "RL"["LR".index(side[0])], label)

    for template in TEMPLATES:
        labels = {label for bone in template.bones for label in bone}
        paired = {label[1:] for label in labels if label[0] in "Ll"}
        paired &= {label[1:] for label in labels if label[0] in "Rr"}
        bones = {frozenset(bone) for bone in template.bones}
        bones = {bone for bone in bones if not bone & {"RBAC", "RBAK"}}
        paired -= {"BAC", "BAK"}
        assert bones == {frozenset(map(mirrored, bone)) for bone in bones}


def test_four_fifths_of_the_labels_are_enough():
    assert match_template(["A", "B", "C"], [TINY]) is None
    skeleton = match_template(["q", "E", " d ", "a", "B"], [TINY])
    assert skeleton.bones == ((3, 4), (2, 1))


def test_aliases_and_optional_labels():
    skeleton = match_template(["A", "B", "D", "ECHO", "x"], [TINY])
    assert skeleton.bones == ((0, 1), (1, 4), (2, 3))


def test_the_larger_set_wins():
    both = list(dict.fromkeys(FULL.required + LOWER.required))
    assert match_template(both, [LOWER, FULL]).name == FULL.name
    assert match_template(LOWER.required, [FULL, LOWER]).name == LOWER.name
    same = Template("Same", TINY.required, ())
    assert match_template("ABCDE", [TINY, same]).name == "Tiny"


def test_each_subject_gets_its_sticks():
    labels = [f"{who}:{label}" for who in ("Ann", "Bob") for label in "ABCDE"]
    assert match_template([*labels, "*10"], [TINY]).bones == ((0, 1), (3, 4), (5, 6), (8, 9))


@pytest.mark.shared
def test_real_label_sets(shared):
    names = np.load(shared / "cmu_markers" / "132_32.npz")["names"].tolist()
    skeleton = match_template(names, TEMPLATES)
    assert skeleton.name == CMU.name
    assert joined(skeleton.bones, range(41))


GOOD = {"name": "x", "required": ["A", "B"], "chains": [["A", "B"]]}


def test_a_template_names_its_segments():
    parsed = parse_template({**GOOD, "optional": ["C"], "segments": {"arm": ["A", "C"]}})
    skeleton = match_template(["s:a", "s:b", "x"], [parsed])
    assert skeleton.segments == (Segment((0,), "arm"),)
    skeleton = match_template(["s:C", "s:b", "s:A"], [parsed])
    assert skeleton.segments == (Segment((0, 2), "arm"),)
    assert match_template(["a", "b"], [parse_template(GOOD)]).segments == ()


@pytest.mark.parametrize(
    ("change", "why"),
    [
        ({"chains": None}, "it has no chains of labels to join"),
        ({"chains": ["AB"]}, "a chain is not a list of labels"),
        ({"chains": [["A", 1]]}, "a chain has something else than a label: 1"),
        ({"name": " "}, "it has no name"),
        ({"name": 7}, "it has no name"),
        ({"required": []}, "it requires no labels"),
        ({"required": "A"}, "required is not a list of labels"),
        ({"optional": 3}, "optional is not a list of labels"),
        ({"chains": [["A", "X"], ["B", "W"]]}, "it uses labels that it does not list: W, X"),
        ({"aliases": {"Q": "C"}}, "it uses labels that it does not list: C"),
        ({"aliases": {"Q": ["A"]}}, "an alias has something else than a label: ['A']"),
        ({"aliases": ["Q"]}, "aliases is not a table"),
        ({"segments": {"arm": ["A", "Z"]}}, "it uses labels that it does not list: Z"),
        ({"segments": {"arm": "A"}}, "segment arm is not a list of labels"),
        ({"segments": {"arm": ["A"], "leg": ["B", "A"]}}, "it has labels in two segments: A"),
        ({"segment": {}, "bones": []}, "it has an unknown key: bones, segment"),
    ],
)
def test_broken_templates_are_refused(change, why):
    with pytest.raises(ValueError) as caught:
        parse_template({**GOOD, **change})
    assert str(caught.value) == why


def test_rigid_bodies_are_found_from_distances():
    rng = np.random.default_rng(0)
    points = np.concatenate([rigid_body(6, 900, rng) for _ in range(3)], axis=1)
    points += rng.normal(0, 0.5, points.shape)
    points[rng.random((900, 18)) < 0.3] = np.nan
    calls = []
    skeleton = skeleton_from_distances(record(points), calls.append)
    assert skeleton.source == "distances"
    assert {(a // 6, b // 6) for a, b in skeleton.bones} == {(0, 0), (1, 1), (2, 2)}
    assert [part.markers for part in skeleton.segments] == [
        tuple(range(6 * body, 6 * body + 6)) for body in range(3)
    ]
    for body in range(3):
        assert joined(skeleton.bones, range(6 * body, 6 * body + 6))
    assert calls == sorted(calls)
    assert calls[-1] == 1.0


def test_the_unit_does_not_matter():
    rng = np.random.default_rng(1)
    points = np.concatenate([rigid_body(6, 300, rng) * 3 for _ in range(2)], axis=1)
    points += rng.normal(0, 2, points.shape) * rng.uniform(0, 2, (12, 1))
    here = skeleton_from_distances(record(points), no_progress)
    there = skeleton_from_distances(record(points / 1000, unit="m"), no_progress)
    assert here == there


def test_markers_never_seen_get_no_bone():
    points = rigid_body(6, 200, np.random.default_rng(2))
    points[:, [1, 4]] = np.nan
    ends = {
        end for bone in skeleton_from_distances(record(points), no_progress).bones for end in bone
    }
    assert ends == {0, 2, 3, 5}


@pytest.mark.parametrize("shape", [(1, 3, 3), (5, 0, 3), (5, 1, 3)])
def test_nothing_to_join(shape):
    skeleton = skeleton_from_distances(record(np.full(shape, np.nan)), no_progress)
    assert skeleton.bones == ()
    assert skeleton.source == "none"


@pytest.mark.parametrize(("markers", "source"), [(12, "distances"), (MOST_MARKERS + 1, "none")])
def test_a_crowd_of_markers_is_not_measured_pair_by_pair(markers, source):
    points = rigid_body(markers, 20, np.random.default_rng(5))
    found = skeleton_from_distances(record(points), no_progress)
    assert found.source == source
    assert bool(found.bones) == (source == "distances")
    assert segments_from_distances(record(points), no_progress) == found.segments


def test_a_crowd_of_markers_is_refused_before_it_costs_memory():
    crowd = record(np.zeros((2, 65_535, 3)))
    with pytest.raises(ValueError, match="65535"):
        measure_distances(crowd, no_progress)


@pytest.mark.shared
def test_a_real_walk_has_the_sticks_of_a_body(shared):
    data = np.load(shared / "cmu_markers" / "132_43.npz")
    names = data["names"].tolist()
    skeleton = skeleton_from_distances(
        record(data["pos"].astype(np.float64), rate=120.0), no_progress
    )
    found = {frozenset((names[a], names[b])) for a, b in skeleton.bones}
    expected = ["LKNE LSHN", "RKNE RSHN", "LANK LHEE", "LELB LUPA", "LWRA LWRB", "NOSE LFHD"]
    assert found >= {frozenset(pair.split()) for pair in expected}
    assert len(skeleton.bones) < 3 * len(names)
