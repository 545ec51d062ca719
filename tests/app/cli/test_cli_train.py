"""`mocapmend train sparse`: recordings in, a training set out, and nothing else touched."""

from collections.abc import Callable
from pathlib import Path
from typing import Any

import numpy as np
import pytest
from recording_samples import SOURCES, repair, write_sample
from taught import install, ship, write_set

from mocapmend import engine
from mocapmend.cli import main
from mocapmend.errors import MocapmendError
from mocapmend.files import read_recording
from mocapmend_algorithms import Recording, no_progress
from mocapmend_algorithms.sparse import training_set
from mocapmend_algorithms.sparse.training_set import TrainingSet, read_training_set

Json = Callable[..., tuple[int, Any]]
LABELS = ("A", "B", "C")


def save(path: Path, shift: float = 0.0, **changes: Any) -> Path:
    """Write a recording of 20 frames, 100 Hz, in mm."""
    points = shift + np.arange(180.0).reshape(20, 3, 3)
    content = {"pos": points, "fps": 100.0, "names": np.array(LABELS), "units": "mm", "up": "z"}
    np.savez(path, **content | changes)
    return path


def train(tmp_path: Path, *arguments: object) -> TrainingSet:
    out = tmp_path / "set.npz"
    assert main(["train", "sparse", *map(str, arguments), "-o", str(out)]) == 0
    return read_training_set(out)


# --- what goes in ----------------------------------------------------------------------------


@pytest.mark.parametrize("kind", SOURCES)
def test_recordings_of_any_format(run_json: Json, tmp_path: Path, kind: str) -> None:
    path, out = write_sample(tmp_path, kind), tmp_path / "set.npz"
    recording = read_recording(path).recording
    whole = recording.present.all(axis=1)
    code, made = run_json("train", "sparse", "--motion", path, "-o", out)
    assert code == 0
    assert [entry["file"] for entry in made["recordings"]] == [str(path)]
    assert made["recordings"][0]["frames"] == recording.frames
    assert made["frames"] == whole.sum()
    assert made["parts"] == 3
    written = read_training_set(out)
    assert made["markers"] == list(written.labels) == list(recording.labels)
    assert (made["rate_hz"], made["up_axis"]) == (recording.rate, recording.up)
    np.testing.assert_allclose(
        written.poses, recording.points[whole] * recording.mm, rtol=1e-6, atol=1e-3
    )


def test_folders_and_files_in_order_each_once(run_json: Json, tmp_path: Path) -> None:
    folder, out = tmp_path / "runs", tmp_path / "set.npz"
    folder.mkdir()
    (folder / "deeper").mkdir()
    save(folder / "deeper" / "no.npz")
    for number, name in enumerate("cab"):
        save(folder / f"{name}.npz", shift=number)
    (folder / "notes.txt").write_text("three runs")
    (folder / "notes.md").write_text("no recording at all")
    other = save(tmp_path / "z.npz", shift=9)
    twice = ["--motion", folder / "deeper" / ".." / "b.npz"]
    code, made = run_json("train", "sparse", "--motion", other, folder, *twice, "-o", out)
    assert code == 0
    assert [Path(entry["file"]).name for entry in made["recordings"]] == [
        "z.npz", "a.npz", "b.npz", "c.npz",
    ]  # fmt: skip
    assert [Path(entry["file"]).name for entry in made["skipped"]] == ["notes.txt"]
    assert made["about"] == "z.npz, a.npz, b.npz, c.npz"
    starts = read_training_set(out).poses[::20, 0, 0]
    np.testing.assert_array_equal(starts, [9, 1, 2, 0])


def test_earlier_repairs_are_not_learned(tmp_path: Path) -> None:
    path, out = write_sample(tmp_path, "c3d"), tmp_path / "repaired.c3d"
    before = train(tmp_path, "--motion", path)
    repair(path, out)
    assert read_recording(out).recording.present.all()
    after = train(tmp_path, "--motion", out, "--overwrite")
    np.testing.assert_array_equal(after.poses, before.poses)


def test_fragments_are_left_out_and_markers_can_be_chosen(tmp_path: Path) -> None:
    points = np.arange(180.0).reshape(20, 3, 3)
    points[5:, 2] = np.nan
    path = save(tmp_path / "a.npz", names=np.array(["Ann:A", "Ann:B", "*7"]), pos=points)
    assert train(tmp_path, "--motion", path).labels == ("A", "B")
    assert train(tmp_path, "--motion", path, "--overwrite").lengths == (20,)
    chosen = train(tmp_path, "--motion", path, "--overwrite", "--markers", "B, *7")
    assert (chosen.labels, chosen.lengths) == (("B", "*7"), (5,))


def test_rates_become_the_lowest_or_the_given_one(tmp_path: Path) -> None:
    paths = [save(tmp_path / "a.npz"), save(tmp_path / "b.npz", fps=50.0)]
    lowest = train(tmp_path, "--motion", *paths)
    assert (lowest.rate, lowest.lengths) == (50, (10, 20))
    given = train(tmp_path, "--motion", *paths, "--overwrite", "--rate", "25")
    assert (given.rate, given.lengths) == (25, (5, 10))


def test_the_same_recordings_give_the_same_bytes(tmp_path: Path) -> None:
    path, out = save(tmp_path / "a.npz"), tmp_path / "set.npz"
    train(tmp_path, "--motion", path)
    before = out.read_bytes()
    train(tmp_path, "--motion", path, "--overwrite")
    assert out.read_bytes() == before


def test_people_read_what_is_in_it(tmp_path: Path, capsys: pytest.CaptureFixture[str]) -> None:
    paths = [save(tmp_path / f"{number}.npz") for number in range(7)]
    made = train(tmp_path, "--motion", *paths)
    assert made.about == "0.npz, 1.npz, 2.npz, 3.npz, 4.npz and 2 more"
    printed = capsys.readouterr()
    assert printed.err == ""
    assert printed.out.splitlines() == [
        f"Training set: {tmp_path / 'set.npz'}",
        "Recordings:   7",
        "Frames:       140 in 7 unbroken parts, 100 Hz, 1.40 s",
        "Markers:      3",
    ]


def test_real_joints(shared: Path, tmp_path: Path) -> None:
    runs = sorted((shared / "cmu_joints").glob("09_0[2-4].npz"))
    made = train(tmp_path, "--motion", *runs)
    assert (len(made.labels), made.rate, made.up) == (31, 120, "+y")
    points = np.load(runs[0])["pos"]
    np.testing.assert_allclose(made.poses[: len(points)], 10.0 * points, rtol=1e-6)


# --- what is refused -------------------------------------------------------------------------


@pytest.mark.parametrize(
    ("arguments", "what"),
    [
        (["--motion", "a.npz", "-o", "set.c3d"], "ends with .npz"),
        (["--motion", "a.npz", "-o", "there.npz"], "already a file"),
        (["--motion", "a.npz", "-o", "no/set.npz"], "folder does not exist"),
        (["--motion", "a.npz", "-o", "a.npz", "--overwrite"], "one of the recordings"),
        (["--motion", ".", "-o", "a.npz", "--overwrite"], "one of the recordings"),
        (["--motion", "missing.npz", "-o", "set.npz"], "no such file"),
        (["--motion", "there.npz", "-o", "set.npz"], "no array “pos”"),
        (["--motion", "empty", "-o", "set.npz"], "no recording in this folder"),
        (["--motion", "texts", "-o", "set.npz"], "There is no recording to learn from."),
        (["--motion", "a.npz", "other.npz", "-o", "set.npz"], "no marker in common"),
        (["--motion", "hollow.npz", "-o", "set.npz"], "No frame of the recordings shows"),
        (["--motion", "far.npz", "-o", "set.npz"], "values that are no numbers"),
        (["--motion", "still.npz", "-o", "set.npz"], "would grow beyond what is believable"),
        (["--motion", "a.npz", "-o", "set.npz", "--markers", "A", "Z"], "one marker 'Z'"),
        (["--motion", "a.npz", "-o", "set.npz", "--markers", "Z"], "Not every recording has"),
    ],
)
def test_refusals_are_one_sentence_and_change_nothing(
    run_json: Json,
    arguments: list[str],
    what: str,
    tmp_path: Path,
    monkeypatch: pytest.MonkeyPatch,
) -> None:
    monkeypatch.chdir(tmp_path)
    (tmp_path / "empty").mkdir()
    (tmp_path / "texts").mkdir()
    (tmp_path / "texts" / "notes.txt").write_text("three runs")
    recording = read_recording(save(tmp_path / "a.npz")).recording
    write_set(tmp_path / "there.npz", recording)
    save(tmp_path / "other.npz", names=np.array(["X", "Y", "Z"]))
    save(tmp_path / "hollow.npz", pos=np.where(np.eye(3)[:, :, None] > 0, np.nan, np.ones(3)))
    save(tmp_path / "far.npz", pos=np.full((4, 3, 3), 1e37), units="m")
    save(tmp_path / "still.npz", pos=np.ones((9000, 3, 3)))
    monkeypatch.setattr(training_set, "FREE_BYTES", 300_000)
    before = {path: path.read_bytes() for path in tmp_path.rglob("*.*")}
    code, document = run_json("train", "sparse", *arguments)
    assert code == 1
    assert document["command"] == "train sparse"
    assert what in document["error"]["what"]
    assert {path: path.read_bytes() for path in tmp_path.rglob("*.*")} == before


@pytest.mark.parametrize(
    "arguments",
    [
        ["train"],
        ["train", "kinect2"],
        ["train", "sparse"],
        ["train", "sparse", "--motion", "a.npz"],
        ["train", "sparse", "-o", "set.npz"],
        ["train", "sparse", "--motion", "a.npz", "-o", "set.npz", "--rate", "0"],
        ["train", "sparse", "--motion", "a.npz", "-o", "set.npz", "--rate", "fast"],
    ],
)
def test_wrong_usage(arguments: list[str], capsys: pytest.CaptureFixture[str]) -> None:
    with pytest.raises(SystemExit) as stopped:
        main(arguments)
    assert stopped.value.code == 2
    assert capsys.readouterr().err.startswith("usage: mocapmend train")


@pytest.mark.parametrize("words", [["train", "--help"], ["train", "sparse", "--help"]])
def test_help(words: list[str], capsys: pytest.CaptureFixture[str]) -> None:
    with pytest.raises(SystemExit) as stopped:
        main(words)
    assert stopped.value.code == 0
    printed = capsys.readouterr().out
    assert "sparse" in printed
    assert "--motion" in printed or "PART --help" in printed


def test_a_training_set_in_the_folder_is_replaced_and_not_learned(
    run_json: Json, tmp_path: Path
) -> None:
    save(tmp_path / "a.npz")
    out = tmp_path / "set.npz"
    assert run_json("train", "sparse", "--motion", tmp_path, "-o", out)[0] == 0
    code, made = run_json("train", "sparse", "--motion", tmp_path, "-o", out, "--overwrite")
    assert code == 0
    assert [Path(entry["file"]).name for entry in made["recordings"]] == ["a.npz"]
    assert made["skipped"] == []


def test_a_training_from_nothing_is_refused() -> None:
    with pytest.raises(MocapmendError, match="no recording to learn from"):
        engine.train_sparse([], "", (), None, None, no_progress)


def test_progress_reaches_the_end() -> None:
    shares: list[float] = []
    recording = Recording(np.ones((4, 1, 3)), ("A",), 100.0)
    assert engine.train_sparse([recording], "one", (), None, None, shares.append).about == "one"
    assert shares == sorted(shares)
    assert shares[-1] == 1


# --- what is made of it ----------------------------------------------------------------------


def test_a_repair_learns_from_it(
    run_json: Json, tmp_path: Path, monkeypatch: pytest.MonkeyPatch
) -> None:
    install(monkeypatch)
    ship(tmp_path / "shipped", monkeypatch)
    monkeypatch.chdir(tmp_path)
    path = write_sample(tmp_path, "c3d")
    assert run_json("train", "sparse", "--motion", path, "-o", "set.npz")[0] == 0
    words = ("repair", path, "--method", "taught", "--max-error", "inf")
    more = ("-o", "out.c3d", "--recipe", "recipe.json", "--param", "training=set.npz")
    code, done = run_json(*words, *more)
    assert code == 0
    assert done["parameters"] == {"training": "set.npz"}
    assert run_json("replay", "recipe.json", path, "-o", "again.c3d")[0] == 0
    assert Path("again.c3d").read_bytes() == Path("out.c3d").read_bytes()
    code, failed = run_json(*words, "-o", "no.c3d", "--param", "training=nowhere.npz")
    assert code == 1
    assert failed["error"]["what"] == "There is no such training set."
    assert failed["error"]["where"] == "nowhere.npz"
    Path("set.npz").unlink()
    code, failed = run_json("replay", "recipe.json", path, "-o", "third.c3d")
    assert code == 1
    assert "needs a training set that is not there" in failed["error"]["what"]
    assert not Path("no.c3d").exists()
    assert not Path("third.c3d").exists()
