"""Recipes on the command line."""

import json
from pathlib import Path

import pytest
from recipe_steps import fills, interior
from recording_samples import digest

from mocapmend import recipe
from mocapmend.cli import main
from mocapmend.files import read_recording


def test_in_place(holed: Path, tmp_path: Path) -> None:
    first, written = tmp_path / "first.c3d", tmp_path / "recipe.json"
    words = ["repair", str(holed), "-o", str(first), "--recipe", str(written)]
    assert main([*words, "--max-error", "inf"]) == 0
    assert main(["replay", str(written), str(holed), "--in-place"]) == 0
    assert digest(holed) == digest(first)


def test_a_replay_on_another_input_warns(
    holed: Path, tmp_path: Path, capsys: pytest.CaptureFixture[str]
) -> None:
    source = read_recording(holed)
    written, copy, out = (tmp_path / name for name in ("recipe.json", "copy.c3d", "out.c3d"))
    recipe.write_recipe(source, fills(source, interior(source), "linear"), written)
    raw = bytearray(holed.read_bytes())
    raw[-600] ^= 1
    copy.write_bytes(raw)
    assert main(["replay", str(written), str(copy), "-o", str(out)]) == 0
    assert "made for another file" in capsys.readouterr().err
    assert len(read_recording(out).repairs) == 6


@pytest.mark.parametrize(
    ("arguments", "code"),
    [
        ([], 2),
        (["recipe.json"], 2),
        (["recipe.json", "holed.c3d"], 2),
        (["recipe.json", "holed.c3d", "-o", "out.c3d", "--in-place"], 2),
        (["missing.json", "holed.c3d", "-o", "out.c3d"], 1),
        (["holed.c3d", "holed.c3d", "-o", "out.c3d"], 1),
        (["recipe.json", "missing.c3d", "-o", "out.c3d"], 1),
        (["recipe.json", "holed.c3d", "-o", "holed.c3d"], 1),
        (["recipe.json", "holed.c3d", "-o", "there.c3d"], 1),
        (["recipe.json", "holed.c3d", "-o", "out.bvh"], 1),
        (["recipe.json", "holed.c3d", "-o", "there.c3d", "--overwrite"], 0),
        (["recipe.json", "holed.c3d", "-o", "out.c3d"], 0),
    ],
)
def test_exit_codes(
    arguments: list[str],
    code: int,
    holed: Path,
    tmp_path: Path,
    monkeypatch: pytest.MonkeyPatch,
) -> None:
    monkeypatch.chdir(tmp_path)
    source = read_recording(holed)
    recipe.write_recipe(source, fills(source, interior(source), "linear"), Path("recipe.json"))
    Path("there.c3d").write_bytes(b"precious")
    before = {path.name: path.read_bytes() for path in tmp_path.iterdir()}
    try:
        found = main(["replay", *arguments])
    except SystemExit as stopped:
        found = stopped.code
    assert found == code
    after = {path.name: path.read_bytes() for path in tmp_path.iterdir()}
    assert (after == before) == (code != 0)


def test_a_recipe_says_what_it_holds(holed: Path, tmp_path: Path) -> None:
    source = read_recording(holed)
    records = fills(source, interior(source), "kalman", direction="causal")
    recipe.write_recipe(source, records, tmp_path / "recipe.json")
    content = json.loads((tmp_path / "recipe.json").read_text())
    assert content["input_sha256"] == digest(holed)
    assert [edit["do"] for edit in content["edits"]] == ["fill"] * 6
    assert content["edits"][0]["parameters"]["direction"] == "causal"
    assert recipe.recipe_of(source, recipe.read_recipe(tmp_path / "recipe.json").fills) == (
        recipe.read_recipe(tmp_path / "recipe.json")
    )
