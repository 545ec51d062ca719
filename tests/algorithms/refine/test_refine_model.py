"""The file of a network: what is written is read, and what is damaged is refused."""

import io
import json
from dataclasses import replace
from pathlib import Path

import numpy as np
import pytest
from hypothesis import given
from hypothesis import strategies as st
from refine_samples import PROFILE, model

from mocapmend_algorithms.refine.model import ModelError, encode_model, read_model
from mocapmend_algorithms.zip_arrays import write_arrays


def test_what_is_written_is_read(tmp_path: Path) -> None:
    written = replace(model(), mirrored=True)
    path = tmp_path / "model.npz"
    path.write_bytes(encode_model(written))
    found = read_model(path)
    assert found.profile == PROFILE
    assert found.shape == written.shape
    assert found.card == {"about": "random weights"}
    assert found.mirrored
    windows = np.random.default_rng(0).normal(0, 300, (2, 120, 5, 3))
    for a, b in zip(found.outputs(windows), written.outputs(windows), strict=True):
        np.testing.assert_array_equal(a, b)
    assert encode_model(found) == path.read_bytes()


def test_the_same_network_has_the_same_bytes() -> None:
    assert encode_model(model()) == encode_model(model())


def changed(path: Path, **changes: object) -> Path:
    """Write a model with other arrays, or with another head."""
    made = model()
    with np.load(io.BytesIO(encode_model(made))) as data:
        arrays = dict(data)
    head = json.loads(str(arrays["head"]))
    for name, value in changes.items():
        if name in head:
            head[name] = value if not isinstance(value, dict) else {**head[name], **value}
        elif value is None:
            del arrays[name]
        else:
            arrays[name] = np.asarray(value)
    arrays["head"] = np.array(json.dumps(head))
    with path.open("wb") as stream:
        write_arrays(stream, arrays, compress=True)
    return path


@pytest.mark.parametrize(
    ("changes", "what"),
    [
        ({"format": 2}, "format 2"),
        ({"shape": {"inputs": 12}}, "not for its profile"),
        ({"shape": {"width": 5}}, "not as its head says"),
        ({"shape": {"width": 5000}}, "too large"),
        ({"shape": {"stacks": 0}}, "damaged"),
        ({"profile": {"bones": [[0, 99]]}}, "damaged"),
        ({"profile": {"inputs": "Root"}}, "damaged"),
        ({"input_spread": np.zeros((5, 3))}, "spread"),
        ({"output_mean": np.full((6, 3), np.nan)}, "no numbers"),
        ({"output_mean": np.zeros((5, 3))}, "not as its head says"),
        ({"skip.bias": np.zeros(18)}, "not as its head says"),
        ({"skip.bias": None}, "damaged"),
    ],
)
def test_networks_that_contradict_themselves_are_refused(
    tmp_path: Path, changes: dict[str, object], what: str
) -> None:
    with pytest.raises(ModelError, match=what):
        read_model(changed(tmp_path / "model.npz", **changes))


@given(st.integers(0, 2**31), st.integers(1, 40))
def test_damaged_files_are_refused_or_read(
    tmp_path_factory: pytest.TempPathFactory, seed: int, spoilt: int
) -> None:
    rng = np.random.default_rng(seed)
    raw = bytearray(encode_model(model()))
    for at in rng.integers(len(raw), size=spoilt):
        raw[at] = rng.integers(256)
    path = tmp_path_factory.mktemp("damaged") / "model.npz"
    path.write_bytes(raw[: rng.integers(1, len(raw) + 1)])
    with pytest.raises(ModelError):
        read_model(path)
        raise ModelError("what was spoilt is what nobody reads")


def test_what_is_no_file_is_refused(tmp_path: Path) -> None:
    with pytest.raises(ModelError, match="no such model"):
        read_model(tmp_path / "none.npz")
    with pytest.raises(ModelError, match="not a file"):
        read_model(tmp_path)
    (tmp_path / "text.npz").write_text("hello")
    with pytest.raises(ModelError, match="damaged"):
        read_model(tmp_path / "text.npz")
