"""Recipes: the same edits give the same bytes, and a file that is no recipe gives one message."""

import hashlib
import json
import os
import subprocess
import sys
from collections.abc import Callable
from dataclasses import asdict, replace
from pathlib import Path
from typing import Any

import numpy as np
import pytest
from c3d_synthetic import Synthetic, encode, walk
from hypothesis import HealthCheck, given, settings
from hypothesis import strategies as st
from recording_samples import NO_LIMITS, changes_in, repair, write_sample

from mocapmend import engine, recipe
from mocapmend.cli import main
from mocapmend.commands import EditSamples
from mocapmend.document import Document, Edit
from mocapmend.errors import MocapmendError
from mocapmend.files import RepairRecord, Source, read_recording
from mocapmend.files.sidecar import sidecar_path
from mocapmend_algorithms import Cancelled, Gap, find_gaps, no_progress
from mocapmend_algorithms.fill.registry import METHODS
from mocapmend_algorithms.skeleton import Skeleton

WAYS = [(method, {}) for method in METHODS]
WAYS += [
    ("constant", {"hold": "before"}),
    ("kalman", {"direction": "causal", "velocity_interval_ms": 30.0}),
]
"""Methods with parameters."""


def digest(path: Path) -> str:
    return hashlib.sha256(path.read_bytes()).hexdigest()


@pytest.fixture
def holed(tmp_path: Path) -> Path:
    """Write a recording with six interior gaps of three markers, and a leading one."""
    points = walk(frames=120)
    fourth = np.zeros(points.shape[:2])
    places = [(10, 15, 0), (40, 60, 0), (80, 82, 0), (30, 33, 2), (90, 99, 2), (50, 70, 4)]
    for start, stop, marker in [*places, (0, 4, 3)]:
        fourth[start:stop, marker] = -1
        points[start:stop, marker] = 0
    path = tmp_path / "holed.c3d"
    path.write_bytes(encode(Synthetic(points, fourth=fourth, first_frame=7)))
    return path


def interior(source: Source) -> list[Gap]:
    recording = source.measured
    gaps = find_gaps(recording.present)
    return [gap for gap in gaps if gap.kind(recording.frames) == "interior"]


def fills(source: Source, gaps: list[Gap], method: str, **params: Any) -> tuple[RepairRecord, ...]:
    """Fill gaps together and return their records alone."""
    values = METHODS[method].params(**params)
    result = engine.fill(source.measured, gaps, method, values, NO_LIMITS, no_progress)
    return tuple(engine.record(source, patch, method, values) for patch in result.patches)


def export(source: Source, changes: engine.Changes, out: Path) -> Path:
    engine.export(source, changes, out, False, False, no_progress)
    return out


def replayed(path: Path, written: Path, out: Path) -> Path:
    """Replay a recipe in a file that is read anew."""
    source = read_recording(path)
    changes = recipe.replay(source, recipe.read_recipe(written), no_progress)
    return export(source, changes, out)


# --- the same bytes ------------------------------------------------------------------------------


@pytest.mark.parametrize(("method", "params"), WAYS)
@pytest.mark.parametrize("name", ["gait_plug_in_gait", "sprint_basketball", "walk_cmu_02_01"])
def test_a_replay_gives_the_same_bytes(
    name: str, method: str, params: dict[str, Any], samples: Path, tmp_path: Path
) -> None:
    path = samples / f"{name}.c3d"
    source = read_recording(path)
    values = METHODS[method].params(**params)
    gaps = find_gaps(source.recording.present)[:20]
    result = engine.fill(source.measured, gaps, method, values, NO_LIMITS, no_progress)
    changes = engine.changes_of(source, result, method, values)
    assert len(changes.repairs) == len(result.patches)
    # Other cycles are often incomplete in the same way; R1 predicts from markers without any gap,
    # and the sprinter has none.
    least = {"cyclic": 5, "pca-r1": 0 if name == "sprint_basketball" else 15}.get(method, 15)
    assert len(result.patches) >= min(len(gaps), least)
    written = tmp_path / "recipe.json"
    recipe.write_recipe(source, changes.repairs, written)
    read = recipe.read_recipe(written)
    assert read.input == digest(path)
    assert len(read.fills) == len(changes.repairs)
    assert all(item.parameters == asdict(values) for item in read.fills)
    first = export(source, changes, tmp_path / "first.c3d")
    assert digest(first) == digest(replayed(path, written, tmp_path / "second.c3d"))


@pytest.mark.parametrize("method", ["auto", "rigid", "pattern", "local-frame"])
@pytest.mark.parametrize("end", ["c3d", "csv"])
def test_donors_picked_by_hand_are_replayed(
    holed: Path, method: str, end: str, tmp_path: Path
) -> None:
    source = read_recording(holed)
    gaps = [gap for gap in interior(source) if gap.marker != 2]
    picked = ("M002", "M004", "M003")
    params = METHODS[method].params(donors=picked)
    result = engine.fill(source.measured, gaps, method, params, NO_LIMITS, no_progress)
    assert not result.unfilled
    changes = engine.changes_of(source, result, method, params)
    written = tmp_path / "recipe.json"
    recipe.write_recipe(source, changes.repairs, written)
    edits = json.loads(written.read_text())["edits"]
    assert all(edit["parameters"]["donors"] == list(picked) for edit in edits)
    made = recipe.read_recipe(written)
    assert all(item.donors and set(item.donors) <= set(picked) for item in made.fills)
    first = export(source, changes, tmp_path / f"first.{end}")
    again = replayed(holed, written, tmp_path / f"again.{end}")
    assert digest(first) == digest(again)
    assert read_recording(again).repairs == read_recording(first).repairs

    chosen = engine.fill(
        source.measured, gaps, method, METHODS[method].params(), NO_LIMITS, no_progress
    )
    values = (np.concatenate([patch.values for patch in r.patches]) for r in (result, chosen))
    assert not np.array_equal(*values), "the recording would have given other donors"


def test_the_window_replays_donors_picked_by_hand(holed: Path, tmp_path: Path) -> None:
    source = read_recording(holed)
    gaps = [gap for gap in interior(source) if gap.marker == 0]
    params = METHODS["auto"].params(donors=("M005", "M003"))
    result = engine.fill(source.measured, gaps, "auto", params, NO_LIMITS, no_progress)
    document = Document(source, Skeleton("", (), "none"))
    edits = Edit.fills(result, "auto", params)
    donors = {edit.repair.donors for edit in edits if edit.repair}
    assert all(sorted(used) == ["M003", "M005"] for used in donors)
    document.undo_stack.push(EditSamples(document, edits, "fill"))
    assert {row.donors for row in document.repair_rows()} == donors
    written = tmp_path / "recipe.json"
    recipe.write_recipe(source, document.changes().repairs, written)
    out = export(source, document.changes(), tmp_path / "out.c3d")
    assert digest(out) == digest(replayed(holed, written, tmp_path / "again.c3d"))


@settings(max_examples=30, suppress_health_check=[HealthCheck.function_scoped_fixture])
@given(data=st.data())
def test_the_order_of_the_edits_does_not_matter(
    data: st.DataObject, holed: Path, tmp_path: Path
) -> None:
    source = read_recording(holed)
    gaps = interior(source)
    ways = [("linear", {}), ("kalman", {"direction": "causal"})]
    chosen = {gap: data.draw(st.sampled_from(ways), label=str(gap)) for gap in gaps}
    together = [
        item
        for method, params in ways
        for item in fills(source, [g for g in gaps if chosen[g][0] == method], method, **params)
    ]
    singly = []
    for gap in data.draw(st.permutations(gaps)):
        method, params = chosen[gap]
        singly += fills(source, [gap], method, **params)
    recipes = [tmp_path / "together.json", tmp_path / "singly.json"]
    for path, records in zip(recipes, (together, singly), strict=True):
        recipe.write_recipe(source, records, path)
    assert digest(recipes[0]) == digest(recipes[1])
    # Whoever changes the order by hand gets the same file too.
    written = json.loads(recipes[0].read_text())
    written["edits"] = data.draw(st.permutations(written["edits"]))
    recipes[1].write_text(json.dumps(written))
    outs = [replayed(holed, path, path.with_suffix(".c3d")) for path in recipes]
    assert digest(outs[0]) == digest(outs[1])


@pytest.mark.parametrize("end", ["c3d", "csv", "long.csv", "npz"])
def test_what_the_window_and_the_engine_write_is_the_same(
    holed: Path, end: str, tmp_path: Path
) -> None:
    source = read_recording(holed)
    gaps = interior(source)
    document = Document(source, Skeleton("", (), "none"))
    params = METHODS["pchip"].params()
    for gap in reversed(gaps):
        (patch,) = engine.fill_gap(source.measured, gap, "pchip", params, no_progress).patches
        edit = EditSamples(document, [Edit.fill(patch, "pchip", params)], "fill")
        document.undo_stack.push(edit)
    result = engine.fill(source.measured, gaps, "pchip", params, NO_LIMITS, no_progress)
    written = tmp_path / "recipe.json"
    recipe.write_recipe(source, document.changes().repairs, written)
    outs = [
        export(source, document.changes(), tmp_path / f"window.{end}"),
        export(source, engine.changes_of(source, result, "pchip", params), tmp_path / f"cli.{end}"),
        replayed(holed, written, tmp_path / f"replayed.{end}"),
    ]
    assert len({digest(out) for out in outs}) == 1


@pytest.mark.parametrize("end", ["c3d", "csv", "npz"])
def test_reopened_and_refilled_repairs(holed: Path, end: str, tmp_path: Path) -> None:
    repaired = tmp_path / f"repaired.{end}"
    first = read_recording(holed)
    gaps = interior(first)
    params = METHODS["linear"].params()
    result = engine.fill(first.measured, gaps[:4], "linear", params, NO_LIMITS, no_progress)
    export(first, engine.changes_of(first, result, "linear", params), repaired)

    source = read_recording(repaired)
    assert list(source.repaired) == gaps[:4]
    document = Document(source, Skeleton("", (), "none"))
    cubic = METHODS["cubic"].params()
    edits = [Edit.clear(gaps[0])]
    for gap in (gaps[1], gaps[5]):
        (patch,) = engine.fill_gap(source.measured, gap, "cubic", cubic, no_progress).patches
        edits.append(Edit.fill(patch, "cubic", cubic))
    document.undo_stack.push(EditSamples(document, edits, "edit"))
    written = tmp_path / "recipe.json"
    recipe.write_recipe(source, document.changes().repairs, written)
    made = recipe.read_recipe(written)
    assert [(item.method, item.point) for item in made.reopened] == [("linear", 1)]
    assert [(item.method, item.point) for item in made.fills] == [("cubic", 1), ("cubic", 5)]
    out = export(source, document.changes(), tmp_path / f"out.{end}")
    assert digest(out) == digest(replayed(repaired, written, tmp_path / f"again.{end}"))
    back = read_recording(out)
    assert list(back.repaired) == [gaps[1], gaps[2], gaps[3], gaps[5]]
    assert [item.method for item in back.repairs] == ["cubic", "linear", "linear", "cubic"]
    assert not back.recording.present[gaps[0].start : gaps[0].stop, gaps[0].marker].any()


def test_a_recipe_without_edits_copies_the_file(holed: Path, tmp_path: Path) -> None:
    recipe.write_recipe(read_recording(holed), (), tmp_path / "recipe.json")
    made = recipe.read_recipe(tmp_path / "recipe.json")
    assert (made.fills, made.reopened) == ((), ())
    out = replayed(holed, tmp_path / "recipe.json", tmp_path / "out.c3d")
    assert digest(out) == digest(holed)


def test_a_recipe_of_a_file_with_a_record_beside_it(tmp_path: Path) -> None:
    path, repaired = write_sample(tmp_path, "csv"), tmp_path / "repaired.trc"
    repair(path, repaired, gaps=slice(1, 2))
    assert sidecar_path(repaired).exists()
    source = read_recording(repaired)
    written = tmp_path / "recipe.json"
    changes = changes_in(source, "kalman")
    recipe.write_recipe(source, changes.repairs, written)
    assert [item.method for item in recipe.read_recipe(written).fills] == ["kalman"]
    # In the order of the points, whichever was repaired first.
    first = export(source, changes, tmp_path / "first.c3d")
    second = replayed(repaired, written, tmp_path / "second.c3d")
    assert digest(first) == digest(second)
    assert [item.method for item in read_recording(second).repairs] == ["kalman", "linear"]


def test_the_bytes_do_not_depend_on_the_hash_seed(holed: Path, tmp_path: Path) -> None:
    code = (
        "import sys; from mocapmend.cli import main;"
        "path, out = sys.argv[1:];"
        "assert main(['repair', path, '-o', f'{out}/1.c3d', '--recipe', f'{out}/r.json']) == 0;"
        "assert main(['replay', f'{out}/r.json', path, '-o', f'{out}/2.c3d']) == 0;"
        "assert main(['replay', f'{out}/r.json', path, '-o', f'{out}/3.npz']) == 0"
    )
    found = []
    for seed in ("0", "4242"):
        folder = tmp_path / seed
        folder.mkdir()
        done = subprocess.run(
            [sys.executable, "-c", code, str(holed), str(folder)],
            env=os.environ | {"PYTHONHASHSEED": seed},
            capture_output=True,
            timeout=60,
            check=False,
        )
        assert done.returncode == 0, done.stderr
        assert digest(folder / "1.c3d") == digest(folder / "2.c3d")
        found.append({path.name: digest(path) for path in folder.iterdir()})
    assert len(found[0]) == 5
    assert found[0] == found[1]


# --- a recipe for something else -----------------------------------------------------------------


def other(points: np.ndarray, **values: Any) -> bytes:
    missing = np.isnan(points[..., 0])
    spec = Synthetic(
        np.where(missing[..., None], 0.0, points),
        fourth=np.where(missing, -1.0, 0.0),
        **{"first_frame": 7} | values,
    )
    return encode(spec)


def without(points: np.ndarray, frames: slice, marker: int) -> np.ndarray:
    points = points.copy()
    points[frames, marker] = np.nan
    return points


@pytest.mark.parametrize(
    ("change", "why"),
    [
        (lambda points: other(np.where(np.isnan(points), 9.0, points)), "frames 17 to 21 of M001"),
        (lambda points: other(points, first_frame=8), "frames 17 to 21 of M001 are not one of"),
        (lambda points: other(without(points, slice(8, 11), 0)), "frames 17 to 21 of M001"),
        (lambda points: other(points, labels=list("ABCDE")), "point 1 is not the marker M001"),
        (lambda points: other(points[:, :3]), "point 5 is not the marker M005"),
        (lambda points: other(points[:60]), "frames 87 to 88 of M001"),
    ],
)
@pytest.mark.parametrize("end", ["c3d", "csv"])
def test_what_does_not_fit_is_named_and_nothing_is_written(
    change: Callable[[np.ndarray], bytes], why: str, end: str, holed: Path, tmp_path: Path
) -> None:
    source = read_recording(holed)
    written = tmp_path / "recipe.json"
    recipe.write_recipe(source, fills(source, interior(source), "linear"), written)
    path, out = tmp_path / "other.c3d", tmp_path / f"out.{end}"
    path.write_bytes(change(source.recording.points))
    before = sorted(tmp_path.iterdir())
    with pytest.raises(MocapmendError, match=why) as raised:
        replayed(path, written, out)
    assert raised.value.where == str(path)
    assert main(["replay", str(written), str(path), "-o", str(out)]) == 1
    assert sorted(tmp_path.iterdir()) == before


def test_a_gap_that_cannot_be_filled_stops_the_replay(holed: Path, tmp_path: Path) -> None:
    source = read_recording(holed)
    leading = next(g for g in find_gaps(source.recording.present) if g.kind(120) == "leading")
    item = replace(
        fills(source, interior(source)[:1], "linear")[0],
        marker=source.recording.labels[leading.marker],
        point=leading.marker + 1,
        first_frame=7,
        last_frame=10,
    )
    recipe.write_recipe(source, [item], tmp_path / "recipe.json")
    with pytest.raises(MocapmendError, match="A gap of M004 cannot be filled"):
        replayed(holed, tmp_path / "recipe.json", tmp_path / "out.c3d")


def test_a_donor_that_is_not_there_stops_the_replay(holed: Path, tmp_path: Path) -> None:
    written = tmp_path / "recipe.json"
    written.write_text(json.dumps(document(AUTO | {"parameters": {"donors": ["Z"]}})))
    with pytest.raises(MocapmendError, match="A gap of M001 cannot be filled: there is no marker"):
        replayed(holed, written, tmp_path / "out.c3d")


def test_a_replay_can_be_cancelled(holed: Path) -> None:
    def cancel(_: float) -> None:
        raise Cancelled

    source = read_recording(holed)
    made = recipe.recipe_of(source, fills(source, interior(source), "kalman"))
    with pytest.raises(Cancelled):
        recipe.replay(source, made, cancel)


def test_progress_goes_from_method_to_method(holed: Path) -> None:
    source = read_recording(holed)
    gaps = interior(source)
    records = fills(source, gaps[:2], "kalman") + fills(source, gaps[2:], "cubic")
    shares: list[float] = []
    recipe.replay(source, recipe.recipe_of(source, records), shares.append)
    assert shares == sorted(shares)
    assert 0 <= shares[0] < 0.5 < shares[-1] <= 1


# --- damaged and hostile files -------------------------------------------------------------------

ITEM: dict[str, Any] = {
    "do": "fill",
    "marker": "M001",
    "point": 1,
    "first_frame": 17,
    "last_frame": 21,
    "method": "linear",
    "parameters": {},
    "donors": [],
    "expected_error_mm": 1.5,
    "r90_mm": None,
}
REOPENED = ITEM | {"do": "reopen"}
KALMAN = ITEM | {"method": "kalman"}
AUTO = ITEM | {"method": "auto"}
HASH = "0" * 64


def document(*edits: object, **head: object) -> dict[str, Any]:
    start = {"mocapmend_recipe": 1, "program": "mocapmend 0.1", "input_sha256": HASH}
    return start | {"edits": list(edits)} | head


def nested(depth: int) -> Any:
    value: Any = []
    for _ in range(depth):
        value = [value]
    return value


@pytest.mark.parametrize(
    "content",
    [
        b"",
        b"{",
        b"null",
        b"[1, 2]",
        b"\xff\xfe\x00",
        b"\x00" * 1000,
        b"PK\x03\x04",
        json.dumps(document(ITEM)).encode()[:-40],
        b"[" * 100_000,
        b'{"mocapmend_recipe": ' + b"9" * 5000 + b"}",
        json.dumps(document(ITEM, mocapmend_recipe=2)).encode(),
        json.dumps(document(ITEM, mocapmend_recipe=nested(300))).encode(),
        json.dumps(document(ITEM, input_sha256=7)).encode(),
        json.dumps(document(ITEM, input_sha256="z" * 64)).encode(),
        json.dumps(document(ITEM, input_sha256=None)).encode(),
        json.dumps(document(ITEM, edits={"a": 1})).encode(),
        json.dumps(document(ITEM, "edit")).encode(),
        json.dumps(document(ITEM | {"do": "delete"})).encode(),
        json.dumps(document(ITEM | {"do": ["fill"]})).encode(),
        json.dumps(document(ITEM | {"point": 10**400})).encode(),
        json.dumps(document(ITEM | {"first_frame": 1.5})).encode(),
        json.dumps(document(ITEM | {"last_frame": True})).encode(),
        json.dumps(document(ITEM | {"expected_error_mm": 10**400})).encode(),
        json.dumps(document(ITEM | {"r90_mm": float("nan")})).encode(),
        json.dumps(document(ITEM | {"marker": "M" * 10_000})).encode(),
        json.dumps(document(ITEM | {"donors": [1]})).encode(),
        json.dumps(document(AUTO | {"parameters": {"donors": [1]}})).encode(),
        json.dumps(document(AUTO | {"parameters": {"donors": [["A"]]}})).encode(),
        json.dumps(document(AUTO | {"parameters": {"donors": ["M" * 10_000]}})).encode(),
        json.dumps(document(KALMAN | {"parameters": {"noise_mm": nested(300)}})).encode(),
        json.dumps(document(KALMAN | {"parameters": {"noise_mm": float("inf")}})).encode(),
        json.dumps(document({"do": "fill"})).encode(),
    ],
)
def test_what_is_no_recipe(content: bytes, tmp_path: Path) -> None:
    path = tmp_path / "recipe.json"
    path.write_bytes(content)
    with pytest.raises(MocapmendError, match="This is not a recipe") as raised:
        recipe.read_recipe(path)
    assert raised.value.where == str(path)
    assert raised.value.todo
    assert len(str(raised.value)) < 500


@pytest.mark.parametrize(
    ("edits", "why"),
    [
        ([ITEM | {"method": "magic"}], "no method 'magic'"),
        ([ITEM | {"method": "magic", "parameters": {"a": 1}}], "no method 'magic'"),
        ([ITEM | {"parameters": {"stiffness": 1}}], "no parameter 'stiffness'"),
        ([KALMAN | {"parameters": {"noise_mm": -1}}], "noise_mm must be at least"),
        ([KALMAN | {"parameters": {"noise_mm": 1e15}}], "noise_mm must be at most"),
        ([KALMAN | {"parameters": {"noise_mm": "much"}}], "noise_mm must be a number"),
        ([KALMAN | {"parameters": {"noise_mm": True}}], "noise_mm must be a number"),
        ([KALMAN | {"parameters": {"noise_mm": ["1"]}}], "noise_mm must not be a list"),
        ([KALMAN | {"parameters": {"direction": "up"}}], "direction must be one of"),
        ([KALMAN | {"parameters": {"direction": None}}], "direction must be one of"),
        ([ITEM | {"first_frame": -(10**12)}], "are not one of its gaps"),
        ([ITEM | {"last_frame": 2**53}], "are not one of its gaps"),
        ([ITEM | {"first_frame": 21, "last_frame": 17}], "are not one of its gaps"),
        ([ITEM | {"point": 0}], "point 0 is not the marker"),
        ([ITEM | {"point": -1}], "point -1 is not the marker"),
        ([ITEM, ITEM], "two edits of one gap"),
        ([ITEM, KALMAN], "two edits of one gap"),
        ([REOPENED], "are not one of its gaps"),
    ],
)
def test_what_cannot_be_done(
    edits: list[dict[str, Any]], why: str, holed: Path, tmp_path: Path
) -> None:
    path, out = tmp_path / "recipe.json", tmp_path / "out.c3d"
    path.write_text(json.dumps(document(*edits)))
    with pytest.raises(MocapmendError, match=why) as raised:
        replayed(holed, path, out)
    assert raised.value.where == str(holed)
    assert not out.exists()


@pytest.mark.parametrize("content", ["spaces", "zeros", "edits"])
def test_a_hundred_megabytes(content: str, tmp_path: Path) -> None:
    path = tmp_path / "recipe.json"
    with path.open("wb") as stream:
        if content == "spaces":
            stream.writelines(b" " * 1_000_000 for _ in range(100))
        elif content == "edits":
            stream.write(b'{"mocapmend_recipe": 1, "edits": "')
            stream.writelines(b"a" * 1_000_000 for _ in range(100))
            stream.write(b'"}')
        else:
            stream.truncate(100_000_000)
    with pytest.raises(MocapmendError, match="This is not a recipe"):
        recipe.read_recipe(path)


def test_what_is_too_large_is_not_read(tmp_path: Path) -> None:
    with (tmp_path / "recipe.json").open("wb") as stream:
        stream.truncate(recipe.MOST_BYTES + 1)
    with pytest.raises(MocapmendError, match="too large"):
        recipe.read_recipe(tmp_path / "recipe.json")


JSON = st.recursive(
    st.none()
    | st.booleans()
    | st.integers()
    | st.integers(-(10**400), 10**400)
    | st.floats()
    | st.text(max_size=5)
    | st.sampled_from(["fill", "reopen", "kalman", "M001", HASH, 17, 21, 1, 5]),
    lambda inner: st.lists(inner, max_size=3) | st.dictionaries(st.text(max_size=5), inner),
    max_leaves=5,
)


def places(value: Any) -> list[tuple[Any, Any]]:
    """List all containers in a JSON document with their keys."""
    keys = range(len(value)) if isinstance(value, list) else list(value)
    found = [(value, key) for key in keys]
    for key in keys:
        if isinstance(value[key], (list, dict)):
            found += places(value[key])
    return found


@settings(max_examples=300, suppress_health_check=[HealthCheck.function_scoped_fixture])
@given(data=st.data())
def test_mutated_recipes_are_replayed_or_refused(
    data: st.DataObject, holed: Path, tmp_path: Path
) -> None:
    mutant = json.loads(json.dumps(document(ITEM, KALMAN | {"point": 5, "marker": "M005"})))
    for _ in range(data.draw(st.integers(1, 3))):
        container, key = data.draw(st.sampled_from(places(mutant)))
        if data.draw(st.booleans()) and isinstance(container, dict):
            container[data.draw(st.text(max_size=5))] = container.pop(key)
        else:
            container[key] = data.draw(JSON)
    path = tmp_path / "recipe.json"
    path.write_text(json.dumps(mutant))
    replay_or_refuse(holed, path)


@settings(max_examples=100, suppress_health_check=[HealthCheck.function_scoped_fixture])
@given(at=st.integers(0, 300), new=st.binary(max_size=4), cut=st.integers(0, 8))
def test_damaged_recipes_are_replayed_or_refused(
    at: int, new: bytes, cut: int, holed: Path, tmp_path: Path
) -> None:
    raw = json.dumps(document(ITEM)).encode()
    path = tmp_path / "recipe.json"
    path.write_bytes(raw[:at] + new + raw[at + cut :])
    replay_or_refuse(holed, path)


def replay_or_refuse(holed: Path, path: Path) -> None:
    source = read_recording(holed)
    try:
        changes = recipe.replay(source, recipe.read_recipe(path), no_progress)
    except MocapmendError as error:
        assert error.what.endswith(".")
        assert len(str(error)) < 3000
    else:
        assert all(np.isfinite(run.values).all() for run in changes.runs)
        recipe.recipe_of(source, changes.repairs)


# --- the command ---------------------------------------------------------------------------------


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
