"""Recipes that keep gaps open: made again with the same bytes."""

import json
from dataclasses import replace
from pathlib import Path

import pytest
from recipe_steps import FREED, ITEM, KEPT, document, export, fills, interior, replayed
from recording_samples import digest

from mocapmend import engine, recipe, replaying
from mocapmend.cli import main
from mocapmend.errors import MocapmendError
from mocapmend.files import KeptGap, Source, read_recording
from mocapmend.files.records import LEFT_OPEN, NEVER_FILLED
from mocapmend_algorithms import no_progress


def edited(source: Source) -> engine.Changes:
    """Fill four of the six gaps, protect the first and leave the last one open."""
    first, *filled, last = interior(source)
    made = recipe.Recipe("0" * 64, fills(source, filled, "linear"))
    kept = (
        engine.kept_gap(source, first, never=True, reason="the marker fell off"),
        engine.kept_gap(source, last, never=False, reason=LEFT_OPEN),
    )
    return replace(replaying.replay(source, made, no_progress), kept_open=kept)


def test_the_same_bytes_come_again(holed: Path, tmp_path: Path) -> None:
    source, written = read_recording(holed), tmp_path / "recipe.json"
    changes = edited(source)
    first = export(source, changes, tmp_path / "first.c3d")
    recipe.write_recipe(source, changes.repairs, written, kept_open=changes.kept_open)
    edits = json.loads(written.read_text())["edits"]
    assert [edit["do"] for edit in edits] == ["fill"] * 4 + ["keep open"] * 2
    assert [edit["never"] for edit in edits[4:]] == [True, False]
    second = tmp_path / "second.c3d"
    assert main(["replay", str(written), str(holed), "-o", str(second)]) == 0
    assert digest(second) == digest(first)


def test_gaps_are_freed_and_filled_again(
    holed: Path, tmp_path: Path, capsys: pytest.CaptureFixture[str]
) -> None:
    source, written = read_recording(holed), tmp_path / "recipe.json"
    marked = read_recording(export(source, edited(source), tmp_path / "marked.c3d"))
    (never, entry), (left, _) = marked.kept_open.items()
    more = fills(marked, [left], "linear")
    made = recipe.Recipe("0" * 64, more, freed=(entry,))
    changes = replaying.replay(marked, made, no_progress)
    assert changes.kept_open == ()
    first = export(marked, changes, tmp_path / "first.c3d")
    recipe.write_recipe(marked, changes.repairs, written, kept_open=changes.kept_open)
    edits = json.loads(written.read_text())["edits"]
    assert [edit["do"] for edit in edits] == ["fill", "free", "free"]
    second = tmp_path / "second.c3d"
    assert main(["replay", str(written), str(marked.path), "-o", str(second)]) == 0
    assert "1 gap filled, 0 repairs reopened, 2 gaps freed" in capsys.readouterr().out
    assert digest(second) == digest(first)
    again = read_recording(second)
    assert len(again.repaired) == 5
    assert again.open_gaps() == [*sorted([never, *_leading(again)])]


def _leading(source: Source) -> list[object]:
    return [gap for gap in source.open_gaps() if gap.start == 0]


def test_a_gap_that_left_and_never_swaps(holed: Path, tmp_path: Path) -> None:
    source, written = read_recording(holed), tmp_path / "recipe.json"
    marked = read_recording(export(source, edited(source), tmp_path / "marked.c3d"))
    swapped = tuple(replace(item, never=not item.never) for item in marked.kept_open.values())
    recipe.write_recipe(marked, marked.repairs, written, kept_open=swapped)
    made = recipe.read_recipe(written)
    assert (made.kept_open, made.freed, made.fills) == (swapped, (), ())
    assert replaying.replay(marked, made, no_progress).kept_open == swapped


@pytest.mark.parametrize("frames", [(17, 21), (16, 22)], ids=["the gap", "its ends moved"])
def test_what_the_file_protects_is_not_filled_unless_it_is_freed(
    holed: Path, tmp_path: Path, frames: tuple[int, int]
) -> None:
    source, written = read_recording(holed), tmp_path / "recipe.json"
    entry = KeptGap.from_json(KEPT)
    marked = export(source, engine.Changes((), (), (entry,)), tmp_path / "marked.c3d")
    item = ITEM | {"first_frame": frames[0], "last_frame": frames[1]}
    written.write_text(json.dumps(document(item)))
    with pytest.raises(MocapmendError, match="are never to be filled") as raised:
        replayed(marked, written, tmp_path / "out.c3d")
    assert f"frames {frames[0]} to {frames[1]} of M001" in raised.value.what
    written.write_text(json.dumps(document(item, FREED)))
    again = read_recording(replayed(marked, written, tmp_path / "out.c3d"))
    assert (len(again.repairs), again.kept_open) == (1, {})


def test_a_repair_is_reopened_and_its_gap_protected(holed: Path, tmp_path: Path) -> None:
    source, written = read_recording(holed), tmp_path / "recipe.json"
    first = interior(source)[0]
    filling = recipe.Recipe("0" * 64, fills(source, [first], "linear"))
    filled = replaying.replay(source, filling, no_progress)
    repaired = read_recording(export(source, filled, tmp_path / "repaired.c3d"))
    never = engine.kept_gap(repaired, first, never=True, reason=NEVER_FILLED)
    recipe.write_recipe(repaired, (), written, kept_open=(never,))
    made = recipe.read_recipe(written)
    assert (len(made.reopened), made.kept_open) == (1, (never,))
    again = read_recording(replayed(repaired.path, written, tmp_path / "out.c3d"))
    assert (again.repairs, list(again.kept_open)) == ((), [first])
    written.write_text(json.dumps(document(KEPT)))
    with pytest.raises(MocapmendError, match="are not one of its gaps"):
        replayed(repaired.path, written, tmp_path / "other.c3d")
