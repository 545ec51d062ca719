"""`mocapmend label`: proposals for a bundled walk that lost its names."""

from collections.abc import Callable
from pathlib import Path
from typing import Any

import numpy as np
import pytest
from c3d_synthetic import Synthetic, encode

from mocapmend.cli import main
from mocapmend.files import read_c3d
from mocapmend_algorithms.names import without_subject

Json = Callable[..., tuple[int, Any]]

FRAMES = 60
NAMED = 6
"""Points that keep their names."""


@pytest.fixture
def walk(samples: Path) -> Path:
    return samples / "walk_cmu_02_01.c3d"


@pytest.fixture
def nameless(tmp_path: Path, walk: Path) -> tuple[Path, list[str]]:
    """Write some frames of the walk, points out of order, most of them without a name."""
    recording = read_c3d(walk).recording
    order = np.random.default_rng(3).permutation(recording.markers)
    truth = [without_subject(recording.labels[k]) for k in order]
    names = [name if at < NAMED else f"*{at}" for at, name in enumerate(truth)]
    path = tmp_path / "nameless.c3d"
    points = recording.points[100 : 100 + FRAMES, order]
    path.write_bytes(encode(Synthetic(points, rate=120.0, first_frame=7, labels=names)))
    return path, truth


def test_json_lists_every_piece_with_its_label(
    run_json: Json, nameless: tuple[Path, list[str]], walk: Path
) -> None:
    path, truth = nameless
    before = path.read_bytes()
    code, found = run_json("label", path, "--from", walk)
    assert code == 0
    assert found["examples"] == [str(walk)]
    assert sorted(found["labels"]) == sorted(truth)
    assert found["scale"] == pytest.approx(1.0, abs=0.01)
    covered = np.zeros((len(truth), FRAMES), int)
    for piece in found["pieces"]:
        covered[piece["point_index"], piece["first_frame"] - 7 : piece["last_frame"] - 6] += 1
        assert piece["label"] in {truth[piece["point_index"]], None}
        assert piece["kept"] is (piece["point_index"] < NAMED)
    assert (covered == 1).all()
    right = [piece for piece in found["pieces"] if piece["label"]]
    assert sum(p["last_frame"] - p["first_frame"] + 1 for p in right) >= 0.99 * covered.size
    assert path.read_bytes() == before


def test_the_labels_are_written(
    run_json: Json, nameless: tuple[Path, list[str]], walk: Path, tmp_path: Path
) -> None:
    path, truth = nameless
    out = tmp_path / "labelled.c3d"
    code, found = run_json("label", path, "--from", walk, "-o", out)
    assert code == 0
    assert found["check"]["passed"]
    before, after = read_c3d(path).recording, read_c3d(out).recording
    wrong = [k for k, label in enumerate(truth) if after.labels[k] != label]
    assert len(wrong) <= 1
    assert np.array_equal(after.points, before.points)
    code, _ = run_json("check", path, out)
    assert code == 0


def test_a_template_does_it_too(
    run_json: Json, nameless: tuple[Path, list[str]], walk: Path, tmp_path: Path
) -> None:
    path, _ = nameless
    template = tmp_path / "set.json"
    _, first = run_json("label", path, "--from", walk, "--save-template", template)
    code, second = run_json("label", path, "--from", template)
    assert code == 0
    one, other = ([(p["point_index"], p["label"]) for p in of["pieces"]] for of in (first, second))
    assert one == other
    assert main(["label", str(path), "--from", str(walk), "--save-template", str(template)]) == 1


@pytest.mark.parametrize("content", ["", "[]", "{}", '{"schema": 99, "labels": []}'])
def test_what_is_no_template(
    content: str,
    nameless: tuple[Path, list[str]],
    tmp_path: Path,
    capsys: pytest.CaptureFixture[str],
) -> None:
    template = tmp_path / "set.json"
    template.write_text(content)
    assert main(["label", str(nameless[0]), "--from", str(template)]) == 1
    assert "This is not a template of labels." in capsys.readouterr().err


def test_the_table_says_why(
    capsys: pytest.CaptureFixture[str], nameless: tuple[Path, list[str]], walk: Path
) -> None:
    path, truth = nameless
    assert main(["label", str(path), "--from", str(walk), "--doubt", truth[0]]) == 0
    lines = capsys.readouterr().out.splitlines()
    assert lines[0].split() == ["Point", "Frames", "Label", "Confidence", "Reason"]
    doubted = next(line for line in lines if line.startswith(f"{truth[0]} "))
    assert "It has this name already." not in doubted
    kept = next(line for line in lines if line.startswith(f"{truth[1]} "))
    assert kept.split()[1:4] == ["7-66", truth[1], "100%"]
    assert "pieces without a trusted name" in lines[-1]


def test_names_can_be_ignored(run_json: Json, nameless: tuple[Path, list[str]], walk: Path) -> None:
    code, found = run_json("label", nameless[0], "--from", walk, walk, "--ignore-names")
    assert code == 0
    assert not any(piece["kept"] for piece in found["pieces"])


def test_nothing_to_learn_from_is_one_clear_error(
    run_json: Json, nameless: tuple[Path, list[str]], tmp_path: Path, walk: Path
) -> None:
    bare = tmp_path / "bare.c3d"
    bare.write_bytes(encode(Synthetic(np.ones((5, 4, 3)), labels=["*0", "*1", "*2", "*3"])))
    code, found = run_json("label", walk, "--from", bare)
    assert code == 1
    assert "No labels can be learned" in found["error"]["what"]
    with pytest.raises(SystemExit) as exit_:
        main(["label", str(walk)])
    assert exit_.value.code == 2


def test_a_recording_without_points_has_no_pieces(
    run_json: Json, tmp_path: Path, walk: Path
) -> None:
    path = tmp_path / "analog.c3d"
    path.write_bytes(encode(Synthetic(np.zeros((20, 0, 3)), analog=np.ones((20, 10, 2)))))
    code, found = run_json("label", path, "--from", walk)
    assert (code, found["pieces"], found["scale"]) == (0, [], None)
