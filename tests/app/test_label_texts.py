"""What is said about names and labels is in the catalogue."""

import ast
from pathlib import Path

import numpy as np
import pytest

from mocapmend.bench.labels.scrambling import scramble
from mocapmend.files import read_c3d
from mocapmend.views.catalogue.labels import LABELS
from mocapmend.views.engine_texts import find, shown
from mocapmend_algorithms import Recording, no_progress
from mocapmend_algorithms.labelling import LabelModel, LabelParams, label
from mocapmend_algorithms.labelling.proposal import HAS_NAME, OTHER_NAME

ROOT = Path(__file__).resolve().parent.parent.parent
SPOKEN = ("renaming", "hand_labels")


def said_in(name: str) -> set[str]:
    """Return the sentences of a module, with 7 where they change."""
    tree = ast.parse((ROOT / f"app/mocapmend/{name}.py").read_text(encoding="utf-8"))
    said = set()
    for node in ast.walk(tree):
        if isinstance(node, ast.Call) and getattr(node.func, "id", "") == "MocapmendError":
            given = [*node.args, *(keyword.value for keyword in node.keywords)]
            said |= {text_of(each) for each in given}
        elif isinstance(node, ast.Assign) and getattr(node.targets[0], "id", "") == "sentence":
            said.add(text_of(node.value))
    return said


def text_of(node: ast.expr) -> str:
    if isinstance(node, ast.JoinedStr):
        return "".join(p.value if isinstance(p, ast.Constant) else "7" for p in node.values)
    assert isinstance(node, ast.Constant)
    return str(node.value)


@pytest.mark.parametrize("name", SPOKEN)
def test_sentences_about_names_are_in_the_catalogue(name: str) -> None:
    said = said_in(name)
    assert said
    assert {text for text in said if find(text) is None} == set()


@pytest.mark.parametrize(
    "text",
    [
        "rename A to B",
        "exchange the names of A and B",
        "label 12 pieces",
        "label *3 as A, frames 1 to 20",
    ],
)
def test_names_of_steps_are_in_the_catalogue(text: str) -> None:
    found = find(text)
    assert found is not None
    assert found[0] in LABELS


def reasons(recording: Recording, model: LabelModel) -> set[str]:
    found = label(recording, model, LabelParams(), no_progress)
    return {proposal.reason for proposal in found.proposals}


def test_reasons_of_proposals_are_in_the_catalogue(samples: Path) -> None:
    walk = read_c3d(samples / "walk_cmu_02_01.c3d").recording
    model = LabelModel.learn([walk], [], no_progress)
    noise = np.random.default_rng(1).normal(0.0, 15.0 / walk.mm, walk.points[:60].shape)
    said = set()
    for seed, points in enumerate((walk.points[:60], walk.points[60:120] + noise)):
        part = Recording(points, rate=walk.rate, labels=walk.labels, unit=walk.unit, up=walk.up)
        said |= reasons(scramble(part, seed, keep=0.2).recording, model)
    few = Recording(walk.points[:5, :2], rate=walk.rate, labels=("*1", "*2"), unit=walk.unit)
    said |= reasons(few, model)
    assert {text for text in said if find(text) is None} == set()
    templates = {found[0] for found in map(find, said) if found is not None}
    assert templates <= set(LABELS)
    assert len(templates) > 3


def functions() -> dict[str, ast.FunctionDef]:
    """Return the functions that say how sure labels are, and why."""
    path = ROOT / "algorithms/mocapmend_algorithms/labelling/confidence.py"
    tree = ast.parse(path.read_text(encoding="utf-8"))
    return {node.name: node for node in ast.walk(tree) if isinstance(node, ast.FunctionDef)}


def returned_by(*names: str) -> set[str]:
    """Return what some of these functions may say, with 7 where it changes."""
    nodes = (node for name in names for node in ast.walk(functions()[name]))
    return {text_of(node.value) for node in nodes if isinstance(node, ast.Return) and node.value}


def test_why_a_piece_has_no_label_is_in_the_catalogue() -> None:
    nodes = [node for node in ast.walk(functions()["_without"]) if isinstance(node, ast.Assign)]
    said = {text_of(each.value) for each in nodes if getattr(each.targets[0], "id", "") == "reason"}
    assert len(said) == 3
    assert {text for text in {*said, HAS_NAME, OTHER_NAME} if find(text) is None} == set()


def test_doubts_about_proposals_are_in_the_catalogue() -> None:
    doubts = returned_by("_other_label", "_other_order", "_poor_fit")
    places = returned_by("_where")
    assert len(doubts) == 5
    assert len(places) == 2
    for place in places:
        assert find(f"{place}; no other label fits nearly as well.") is not None
        for doubt in doubts:
            found = find(f"{place}, but {doubt}.")
            assert found is not None
            assert found[1][-1] == doubt
            assert find(doubt) is not None


def test_nothing_to_learn_from_is_in_the_catalogue() -> None:
    nameless = Recording(np.zeros((5, 2, 3)), rate=100.0, labels=("*1", "*2"), unit="mm")
    with pytest.raises(ValueError, match="named markers") as caught:
        LabelModel.learn([nameless], [], no_progress)
    assert find(str(caught.value)) is not None


@pytest.mark.usefixtures("chinese")
def test_labels_in_a_sentence_stay_as_they_are() -> None:
    assert "LFHD" in shown(
        "It is 3 mm from where the other markers put LFHD, but RFHD fits nearly as well."
    )
