"""Markers that get other labels: in the file, in the record, in an open recording."""

import json
from dataclasses import replace
from pathlib import Path

import numpy as np
import pytest
from c3d_synthetic import Synthetic, encode, walk
from test_layers import MACHINES, bare_of, write

from mocapmend import engine
from mocapmend.changes import Repaired, bare
from mocapmend.commands import EditSamples
from mocapmend.document import NO_SKELETON, Document
from mocapmend.edits import Edit
from mocapmend.errors import MocapmendError
from mocapmend.files import Renamed, check_files, read_recording
from mocapmend.files.c3d_reader import C3DFile, read_c3d
from mocapmend.journal.edits import decode_labels
from mocapmend.journal.edits import encode as encode_step
from mocapmend.layers import Layers
from mocapmend.recipe import read_recipe
from mocapmend.replaying import replay
from mocapmend.unsaved import write_recipe
from mocapmend_algorithms import no_progress
from mocapmend_algorithms.fill.registry import METHODS

SHORT, LONG = {1: "Hip"}, {1: "LeftHip_of_the_subject", 3: "Zehe ü"}


def renamed(source: C3DFile, labels: dict[int, str]) -> Repaired:
    """Return a recording with other labels for some of its markers."""
    entries = tuple(
        Renamed(source.stored_points[marker] + 1, source.recording.labels[marker], label)
        for marker, label in labels.items()
    )
    return replace(bare(Layers.of(source)), renamed=entries)


def export(source: C3DFile, made: Repaired, out: Path) -> engine.Exported:
    return engine.export(source, made.changes(), out, False, False, no_progress)


@pytest.mark.parametrize("labels", [SHORT, LONG], ids=["short", "long"])
@pytest.mark.parametrize("machine", MACHINES)
def test_a_file_with_other_labels(tmp_path: Path, machine: str, labels: dict[int, str]) -> None:
    source = write(tmp_path / "in.c3d", machine)
    done = export(source, renamed(source, labels), tmp_path / "out.c3d")
    assert done.check is not None
    assert any("is called" in text for text in done.check.allowed)
    again = read_c3d(tmp_path / "out.c3d")
    expected = tuple(labels.get(k, label) for k, label in enumerate(source.recording.labels))
    assert again.recording.labels == expected
    assert not again.warnings
    assert np.array_equal(again.recording.points, source.recording.points, equal_nan=True)
    assert np.array_equal(again.read_analog(), source.read_analog())
    assert again.model_outputs == source.model_outputs


def test_names_go_back(tmp_path: Path) -> None:
    source = write(tmp_path / "in.c3d")
    export(source, renamed(source, LONG), tmp_path / "out.c3d")
    again = read_c3d(tmp_path / "out.c3d")
    done = export(again, replace(bare(Layers.of(again)), renamed=()), tmp_path / "back.c3d")
    assert done.check is not None
    assert read_c3d(tmp_path / "back.c3d").recording.labels == source.recording.labels


def test_entries_name_markers_as_they_are_called_now(tmp_path: Path) -> None:
    source = write(tmp_path / "in.c3d")
    made = replace(bare_of(source), renamed=renamed(source, {0: "Knee", 2: "Toe"}).renamed)
    export(source, made, tmp_path / "out.c3d")
    corrections = read_c3d(tmp_path / "out.c3d").provenance.corrections
    assert {entry.marker for entry in corrections.moved} == {"Knee", "Toe"}
    assert {entry.from_marker for entry in corrections.moved} == {"Knee", "Toe"}


@pytest.mark.parametrize("rows", [255, 300])
def test_many_labels_that_grow(tmp_path: Path, rows: int) -> None:
    spec = Synthetic(walk(3, rows), labels=[f"{k:03}" for k in range(rows)])
    (tmp_path / "in.c3d").write_bytes(encode(spec))
    source = read_c3d(tmp_path / "in.c3d")
    labels = {0: "first", rows - 1: "a last marker"}
    export(source, renamed(source, labels), tmp_path / "out.c3d")
    again = read_c3d(tmp_path / "out.c3d").recording.labels
    assert (again[0], again[1], again[-1]) == ("first", "001", "a last marker")


def test_a_label_that_no_file_can_hold(tmp_path: Path) -> None:
    source = write(tmp_path / "in.c3d")
    with pytest.raises(MocapmendError, match="no room for the label"):
        export(source, renamed(source, {0: "x" * 256}), tmp_path / "out.c3d")
    assert not (tmp_path / "out.c3d").exists()


def test_the_check_finds_a_label_that_nobody_has_changed(tmp_path: Path) -> None:
    source = write(tmp_path / "in.c3d")
    export(source, renamed(source, {1: "Hip"}), tmp_path / "out.c3d")
    raw = (tmp_path / "out.c3d").read_bytes()
    layout = read_c3d(tmp_path / "out.c3d").layout
    at = layout.parameters["POINT:LABELS"].data
    changed = bytearray(raw)
    changed[at] ^= 1
    (tmp_path / "wrong.c3d").write_bytes(changed)
    found = check_files(tmp_path / "in.c3d", tmp_path / "wrong.c3d")
    assert found.other_differences == ("1 byte differs in the parameter POINT:LABELS.",)


@pytest.mark.parametrize("end", ["trc", "csv", "npz"])
def test_other_formats_have_the_new_names(tmp_path: Path, end: str) -> None:
    source = write(tmp_path / "in.c3d")
    out = tmp_path / f"out.{end}"
    export(source, renamed(source, {0: "Knee"}), out)
    assert read_recording(out).recording.labels[0] == "Knee"


def test_an_open_recording_is_renamed_and_back(tmp_path: Path) -> None:
    source = write(tmp_path / "in.c3d")
    document = Document(source, NO_SKELETON)
    heard: list[tuple[str, ...]] = []
    document.names_changed.connect(lambda: heard.append(document.names))
    document.undo_stack.push(EditSamples(document, [], "rename", labels={1: "Hip"}))
    assert document.labels == document.base.labels == ("A", "Hip", "C", "D")
    assert document.share_base().recording().labels == document.labels
    assert heard == [("A", "Hip", "C", "D")]
    (entry,) = document.unsaved().changes().corrections.renamed
    assert entry == Renamed(source.stored_points[1] + 1, "B", "Hip")
    document.undo_stack.undo()
    assert document.labels == source.recording.labels
    assert not document.unsaved().changes().corrections.renamed


def test_the_journal_keeps_names(tmp_path: Path) -> None:
    source = write(tmp_path / "in.c3d")
    event, _ = encode_step("rename", [], None, {2: "Zehe ü"})
    assert decode_labels(json.loads(json.dumps(event)), source.recording) == {2: "Zehe ü"}
    with pytest.raises(ValueError, match="do not fit"):
        decode_labels({"labels": {"9": "x"}}, source.recording)


def test_a_recipe_replays_fills_whose_donors_were_renamed(tmp_path: Path) -> None:
    fourth = np.zeros((60, 4))
    fourth[20:30, 0] = -1
    points = walk(60, 4)
    points[fourth < 0] = 0
    (tmp_path / "in.c3d").write_bytes(
        encode(Synthetic(points, fourth=fourth, labels=["A", "B", "C", "D"]))
    )
    source = read_c3d(tmp_path / "in.c3d")
    document = Document(source, NO_SKELETON)
    params = METHODS["pattern"].params(donors=("B",))
    result = engine.fill_gap(document.base, document.gaps[0], "pattern", params, no_progress)
    document.undo_stack.push(EditSamples(document, Edit.fills(result, "pattern", params), "fill"))
    # Each has the other's name: that of then is not that of now.
    document.undo_stack.push(EditSamples(document, [], "rename", labels={1: "C", 2: "B"}))
    write_recipe(document.unsaved(), tmp_path / "recipe.json", no_progress)
    changes = replay(source, read_recipe(tmp_path / "recipe.json"), no_progress)
    (entry,) = changes.repairs
    assert tuple(entry.donors) == ("C",)
    assert changes.repairs == document.unsaved().changes().repairs
