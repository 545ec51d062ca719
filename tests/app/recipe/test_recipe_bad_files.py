"""Recipes that are damaged or hostile: one clear message, and nothing hangs."""

import json
from pathlib import Path
from typing import Any

import numpy as np
import pytest
from hypothesis import HealthCheck, given, settings
from hypothesis import strategies as st
from recipe_steps import AUTO, FREED, HASH, ITEM, KALMAN, KEPT, REOPENED, document, replayed

from mocapmend import recipe, replaying
from mocapmend.errors import MocapmendError
from mocapmend.files import read_recording
from mocapmend_algorithms import no_progress


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
        json.dumps(document({"do": "keep open"})).encode(),
        json.dumps(document(KEPT | {"never": 1})).encode(),
        json.dumps(document(KEPT | {"never": None})).encode(),
        json.dumps(document(KEPT | {"reason": None})).encode(),
        json.dumps(document(KEPT | {"reason": "r" * 10_000})).encode(),
        json.dumps(document(KEPT | {"first_frame": 10**400})).encode(),
        json.dumps(document(FREED | {"point": True})).encode(),
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
        ([FREED], "are not one of its gaps"),
        ([KEPT | {"last_frame": 20}], "are not one of its gaps"),
        ([KEPT | {"point": 2}], "point 2 is not the marker"),
        ([KEPT, KEPT], "two edits of one gap"),
        ([KEPT, ITEM], "two edits of one gap"),
        ([KEPT, ITEM | {"last_frame": 22}], "two edits of one gap"),
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
    | st.sampled_from(
        ["fill", "reopen", "keep open", "free", "kalman", "M001", HASH, 17, 21, 1, 5]
    ),
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
    other = KALMAN | {"point": 5, "marker": "M005"}
    kept = KEPT | {"first_frame": 47, "last_frame": 66}
    mutant = json.loads(json.dumps(document(ITEM, other, kept)))
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
        changes = replaying.replay(source, recipe.read_recipe(path), no_progress)
    except MocapmendError as error:
        assert error.what.endswith(".")
        assert len(str(error)) < 3000
    else:
        assert all(np.isfinite(run.values).all() for run in changes.runs)
        recipe.recipe_of(source, changes.repairs, changes.kept_open)
