"""Training sets that parameters name: found, complained of, written down, and found again."""

import json
import os
import pickle
from pathlib import Path

import numpy as np
import pytest
from c3d_synthetic import Synthetic, encode, walk
from recording_samples import NO_LIMITS
from taught import TaughtParams, install, ship, write_set

from mocapmend import engine, recipe, replaying, training
from mocapmend.errors import MocapmendError
from mocapmend.files import Source, read_c3d, read_recording
from mocapmend.files.records import line
from mocapmend_algorithms import find_gaps, no_progress
from mocapmend_algorithms.sparse.training_set import TrainingSetError
from mocapmend_resources import training as shipped


@pytest.fixture(autouse=True)
def _places(tmp_path: Path, monkeypatch: pytest.MonkeyPatch) -> None:
    install(monkeypatch)
    ship(tmp_path / "shipped", monkeypatch)
    monkeypatch.chdir(tmp_path)


@pytest.fixture
def source(tmp_path: Path) -> Source:
    """Return a recording with a gap of M001."""
    points, fourth = walk(), np.zeros(walk().shape[:2])
    fourth[10:15, 0] = -1
    points[10:15, 0] = 0
    (tmp_path / "holed.c3d").write_bytes(encode(Synthetic(points, fourth=fourth)))
    return read_c3d(tmp_path / "holed.c3d")


def filled(source: Source, name: str, *, how: str = "fill") -> np.ndarray:
    gaps = find_gaps(source.measured.present)
    params = TaughtParams(name)
    if how == "preview":
        result = engine.fill_gap(source.measured, gaps[0], "taught", params, no_progress)
    else:
        result = engine.fill(source.measured, gaps, "taught", params, NO_LIMITS, no_progress)
    return result.patches[0].values


def mean_of(source: Source) -> np.ndarray:
    points = source.measured.points
    return points[~np.isnan(points).any(axis=(1, 2))].mean(axis=0)[0]


# --- finding ---------------------------------------------------------------------------------


@pytest.mark.parametrize("how", ["fill", "preview"])
def test_a_method_gets_the_path_of_what_was_named(source: Source, tmp_path: Path, how: str) -> None:
    write_set(shipped.FOLDER / "walks.npz", source.measured)
    write_set(tmp_path / "walks", source.measured, shift=1000)
    mean = mean_of(source)
    assert not filled(source, "", how=how).any()
    for name, shift in (("walks", 0), ("./walks", 1000), (str(tmp_path / "walks"), 1000)):
        expected = np.tile(mean + shift, (5, 1))
        np.testing.assert_allclose(filled(source, name, how=how), expected, rtol=1e-5)


def test_what_ships_is_listed_by_name(tmp_path: Path, source: Source) -> None:
    assert shipped.names() == ()
    for name in ("b", "a"):
        write_set(shipped.FOLDER / f"{name}.npz", source.measured)
    assert shipped.names() == ("a", "b")
    assert shipped.path_of("a") == tmp_path / "shipped" / "a.npz"
    with pytest.raises(KeyError, match="nothing called 'c'"):
        shipped.path_of("c")
    assert training.path_of("../shipped/a") == Path("../shipped/a")


def test_all_that_ships_can_be_read(monkeypatch: pytest.MonkeyPatch) -> None:
    monkeypatch.undo()
    for name in shipped.names():
        assert training.path_of(name).is_file()


# --- complaints ------------------------------------------------------------------------------


@pytest.mark.parametrize("how", ["fill", "preview"])
@pytest.mark.parametrize(
    ("name", "what"),
    [
        ("nowhere.npz", "There is no such training set."),
        ("holed.c3d", "This is not a training set of mocapmend, or it is damaged."),
        ("shipped", "This is not a file."),
        ("a\0b", "This is not a training set of mocapmend, or it is damaged."),
        ("x" * 500, "This is not a training set of mocapmend, or it is damaged."),
        ("x" * 2000, "The name of the training set is too long"),
        ("others.npz", "The training set is of other markers: 1 of its 2 are not in"),
    ],
)
def test_complaints_are_sentences_about_the_file(
    source: Source, name: str, what: str, how: str
) -> None:
    write_set(shipped.FOLDER / "walks.npz", source.measured)
    known = source.measured
    others = type(known)(known.points[:, :2], ("M001", "Z"), known.rate)
    write_set(Path("others.npz"), others)
    with pytest.raises(MocapmendError) as raised:
        filled(source, name, how=how)
    error = raised.value
    assert error.what.startswith(what)
    assert error.what.endswith(".")
    assert error.where[:50] == name[:50]
    assert len(name) > 1000 or error.todo.endswith("that ships with the program: walks.")
    assert str(pickle.loads(pickle.dumps(error))) == str(error), "it comes back from a worker"


def test_without_a_file_the_complaint_stands_alone() -> None:
    error = training.complaint(TrainingSetError("no frame is complete"), "")
    assert str(error) == (
        "No frame is complete. Choose a file that “mocapmend train sparse” has written."
    )


# --- records and recipes ---------------------------------------------------------------------


def write_recipe(source: Source, name: str) -> Path:
    params = TaughtParams(name)
    gaps = find_gaps(source.measured.present)
    result = engine.fill(source.measured, gaps, "taught", params, NO_LIMITS, no_progress)
    changes = engine.changes_of(source, result, "taught", params)
    path = Path("recipe.json")
    recipe.write_recipe(source, changes.repairs, path)
    return path


def replay(source: Source, path: Path) -> engine.Changes:
    return replaying.replay(source, recipe.read_recipe(path), no_progress)


@pytest.mark.parametrize("name", ["walks", "mine.npz"])
def test_a_replay_learns_from_the_same_file(source: Source, name: str) -> None:
    write_set(shipped.FOLDER / "walks.npz", source.measured)
    write_set(Path("mine.npz"), source.measured, shift=5)
    path = write_recipe(source, name)
    (edit,) = json.loads(path.read_text())["edits"]
    assert edit["parameters"]["training"] == name, "no path of this machine"
    changes = replay(source, path)
    np.testing.assert_array_equal(changes.runs[0].values, filled(source, name))
    assert list(map(line, changes.repairs)) == list(map(line, recipe.read_recipe(path).fills))
    out = Path("out.c3d")
    engine.export(source, changes, out, False, False, no_progress)
    again = read_recording(out)
    assert list(map(line, again.repairs)) == list(map(line, changes.repairs))
    assert recipe.recipe_of(again, again.repairs).fills == ()


def test_a_replay_without_the_file_says_so(source: Source) -> None:
    mine = write_set(Path("mine.npz"), source.measured)
    path = write_recipe(source, "mine.npz")
    mine.unlink()
    with pytest.raises(MocapmendError, match="needs a training set that is not there") as raised:
        replay(source, path)
    assert raised.value.where == "mine.npz"


def test_a_replay_with_another_file_says_so(source: Source) -> None:
    mine = write_set(Path("mine.npz"), source.measured)
    path = write_recipe(source, "mine.npz")
    status = mine.stat()
    write_set(mine, source.measured, shift=1)
    os.utime(mine, ns=(status.st_atime_ns, status.st_mtime_ns + 10**9))
    with pytest.raises(MocapmendError, match="not the training set that the recipe was made with"):
        replay(source, path)


def test_a_recipe_that_names_no_digest_takes_what_is_there(source: Source) -> None:
    write_set(Path("mine.npz"), source.measured)
    path = write_recipe(source, "mine.npz")
    content = json.loads(path.read_text())
    del content["edits"][0]["parameters"]["training_sha256"]
    path.write_text(json.dumps(content))
    assert len(replay(source, path).runs) == 1


@pytest.mark.parametrize("name", ["x" * 900, "a\0b", "holed.c3d/x", "/dev/zero", "."])
def test_a_recipe_with_an_impossible_name_is_refused(source: Source, name: str) -> None:
    write_set(Path("mine.npz"), source.measured)
    path = write_recipe(source, "mine.npz")
    content = json.loads(path.read_text())
    content["edits"][0]["parameters"]["training"] = name
    path.write_text(json.dumps(content))
    with pytest.raises(MocapmendError, match="not there"):
        replay(source, path)


def test_a_record_of_a_file_that_has_gone_has_no_digest(source: Source) -> None:
    assert training.digests(TaughtParams("nowhere.npz")) == {}
    assert training.digests(TaughtParams()) == {}
