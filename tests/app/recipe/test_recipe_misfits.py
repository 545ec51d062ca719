"""Recipes for something else: what does not fit is named, and nothing is written."""

import json
from collections.abc import Callable
from dataclasses import replace
from pathlib import Path
from typing import Any

import numpy as np
import pytest
from c3d_synthetic import Synthetic, encode
from recipe_steps import AUTO, document, fills, interior, replayed

from mocapmend import recipe, replaying
from mocapmend.cli import main
from mocapmend.errors import MocapmendError
from mocapmend.files import read_recording
from mocapmend_algorithms import Cancelled, find_gaps


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
        replaying.replay(source, made, cancel)


def test_progress_goes_from_method_to_method(holed: Path) -> None:
    source = read_recording(holed)
    gaps = interior(source)
    records = fills(source, gaps[:2], "kalman") + fills(source, gaps[2:], "cubic")
    shares: list[float] = []
    replaying.replay(source, recipe.recipe_of(source, records), shares.append)
    assert shares == sorted(shares)
    assert 0 <= shares[0] < 0.5 < shares[-1] <= 1
