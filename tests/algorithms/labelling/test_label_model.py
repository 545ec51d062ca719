"""What is learned of labelled recordings, and how it is kept."""

import json
from dataclasses import fields, replace

import numpy as np
import pytest
from body_samples import LABELS, body

from mocapmend_algorithms import Recording
from mocapmend_algorithms.labelling import LabelModel
from mocapmend_algorithms.labelling.likenesses import mirror_by_names, mirror_image


def same(one, other, within=0.006):
    assert one.labels == other.labels
    assert one.segments == other.segments
    for name in LabelModel.ARRAYS:
        np.testing.assert_allclose(getattr(one, name), getattr(other, name), atol=within)


def test_json_gives_the_same_model_back():
    trial = body(80)
    points = trial.points.copy()
    points[:40, 3] = np.nan
    points[40:, 5] = np.nan
    model = LabelModel.learn([trial.with_points(points)])
    assert np.isnan(model.length[3, 5])
    same(LabelModel.from_json(model.to_json()), model)


def test_a_document_holds_all_there_is():
    document = json.loads(LabelModel.learn([body(20)]).to_json())
    assert set(document) == {"schema", *(field.name for field in fields(LabelModel))}


@pytest.mark.parametrize("text", ["{}", "[]", "1", '{"schema": 2}', "not json", '{"schema": 1}'])
def test_another_document_is_refused(text):
    with pytest.raises(ValueError):
        LabelModel.from_json(text)
    document = json.loads(LabelModel.learn([body(20)]).to_json())
    for key, value in (("length", [[1.0]]), ("labels", ["A"] * len(LABELS)), ("segments", [[99]])):
        with pytest.raises(ValueError):
            LabelModel.from_json(json.dumps(document | {key: value}))


@pytest.mark.parametrize(
    ("key", "place", "value"),
    [
        ("shapes", (1, 0, 0), -1e308), ("poses", (0, 0, 1), None), ("length", (0, 1), -5.0),
        ("spread", (0, 1), -0.1), ("wander", (2,), -1.0), ("length", (0, 1), 1e30),
    ],
)  # fmt: skip
def test_a_document_that_was_damaged_is_refused(key, place, value):
    document = json.loads(LabelModel.learn([body(20)]).to_json())
    inner = document[key]
    for index in place[:-1]:
        inner = inner[index]
    inner[place[-1]] = value
    with pytest.raises(ValueError, match=f"^{key} has"):
        LabelModel.from_json(json.dumps(document))


def test_distances_are_those_of_the_body_in_mm():
    trial = body(noise=0.0)
    model = LabelModel.learn([replace(trial, points=trial.points / 1000.0, unit="m")])
    a, b, c = (LABELS.index(name) for name in ("LWRA", "LWRB", "RTOE"))
    assert model.length[a, b] == pytest.approx(np.hypot(75, 5), abs=1e-6)
    assert model.spread[a, b] == pytest.approx(0.0, abs=1e-6)
    assert model.spread[a, c] > 20.0
    pelvis = {LABELS.index(name) for name in ("LASI", "RASI", "LPSI", "RPSI")}
    assert any(pelvis <= set(part) for part in model.segments)
    own = [
        np.linalg.norm(model.shapes[k, k] - model.shapes[k, sorted(pelvis)], axis=1) for k in pelvis
    ]
    np.testing.assert_allclose(own, [model.length[k, sorted(pelvis)] for k in pelvis], rtol=0.05)
    assert model.wander.max() < 40.0


def test_a_larger_body_and_one_with_fewer_markers_add_to_the_first():
    trial, larger = body(100, noise=0.0), body(100, noise=0.0, scale=1.2)
    some = [k for k, name in enumerate(LABELS) if name != "T10"]
    fewer = replace(
        larger, points=larger.points[:, some], labels=tuple(f"Ann:{LABELS[k]}" for k in some)
    )
    model = LabelModel.learn([trial, fewer])
    assert model.labels == LABELS
    one = LabelModel.learn([trial])
    rigid = one.spread < 1e-6
    np.testing.assert_allclose(model.length[rigid], one.length[rigid], rtol=1e-6)


def test_a_template_s_segments_are_taken():
    model = LabelModel.learn([body(20)], [["LHEE", "LTOE", "LMT5", "NOT THERE"], ["NEITHER"]])
    assert model.segments == (tuple(LABELS.index(name) for name in ("LHEE", "LTOE", "LMT5")),)


def test_points_without_a_name_of_their_own_teach_nothing():
    trial = body(20)
    names = list(LABELS)
    names[0], names[1], names[2] = "*0", "U12", names[3]
    model = LabelModel.learn([replace(trial, labels=tuple(names))])
    assert model.labels == LABELS[4:]


def test_pieces_of_a_trajectory_with_the_same_label_teach_it():
    trial = body(40)
    points = np.concatenate([trial.points, trial.points[:, :1]], axis=1)
    points[20:, 0] = points[:20, -1] = np.nan
    parts = replace(trial, points=points, labels=(*LABELS, LABELS[0]))
    same(LabelModel.learn([parts]), LabelModel.learn([trial]))


@pytest.mark.parametrize("labels", [("A", "B", "C"), ("*0", "*1", "*2", "*3"), ()])
def test_too_little_to_learn_from(labels):
    points = np.random.default_rng(0).normal(size=(10, len(labels), 3))
    with pytest.raises(ValueError, match="at least 4"):
        LabelModel.learn([Recording(points, labels, 100.0)])
    with pytest.raises(ValueError, match="at least 4"):
        LabelModel.learn([])
    never = Recording(np.full((10, 5, 3), np.nan), tuple("ABCDE"), 100.0)
    with pytest.raises(ValueError, match="at least 4"):
        LabelModel.learn([never])


def test_left_and_right_by_names_and_by_distances():
    order = mirror_by_names(LABELS)
    names = {LABELS[k]: LABELS[other] for k, other in enumerate(order)}
    assert names["LANK"] == "RANK"
    assert names["RANK"] == "LANK"
    assert names["C7"] == "C7"
    assert names["RBAC"] == "RBAC"
    order = mirror_by_names(["Heel.L", "Heel.R", "left_knee", "right_knee", "Head"])
    assert order.tolist() == [1, 0, 3, 2, 4]
    rng = np.random.default_rng(0)
    left = rng.uniform((50, 0, 0), (400, 300, 1500), (12, 3))
    places = np.concatenate([left, left * (-1, 1, 1), [[0, 50, 900], [0, -60, 1200]]])
    length = np.linalg.norm(places[:, None] - places, axis=2)
    assert mirror_image(length).tolist() == [*range(12, 24), *range(12), 24, 25]
