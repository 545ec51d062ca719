"""`repair --fix` and `--smooth`: bad samples put right headless, in recipes and in plans."""

import json
from collections.abc import Callable, Iterator
from dataclasses import replace
from importlib.resources import files
from pathlib import Path
from typing import Any

import numpy as np
import pytest

from mocapmend import engine
from mocapmend.changes import bare
from mocapmend.cli import main
from mocapmend.errors import MocapmendError
from mocapmend.files import Source, read_c3d
from mocapmend.files.c3d_encode import SampleRun
from mocapmend.files.c3d_patch import save_patched
from mocapmend.layers import Layers
from mocapmend.plan import Plan, Smoothing, read_plan, write_plan
from mocapmend.prospects import Way
from mocapmend.repairing import Request, repair_file
from mocapmend_algorithms import no_progress

Json = Callable[..., tuple[int, Any]]
GAIT = Path(str(files("mocapmend_resources").joinpath("samples/gait_plug_in_gait.c3d")))
SPIKE_FRAME, SPIKED = 120, 7
SWAP, SWAPPED = slice(200, 230), (10, 31)


@pytest.fixture(scope="module")
def spoilt(tmp_path_factory: pytest.TempPathFactory) -> Path:
    """Write a bundled recording with a spike of 150 mm, and two markers that change places."""
    source = read_c3d(GAIT)
    path = tmp_path_factory.mktemp("spoilt") / "spoilt.c3d"
    save_patched(source, list(_wrong(source)), path)
    return path


def _wrong(source: Source) -> Iterator[SampleRun]:
    points = source.recording.points
    leap = points[SPIKE_FRAME : SPIKE_FRAME + 1, SPIKED] + [90.0, 0.0, 120.0]
    yield SampleRun(SPIKED, SPIKE_FRAME, leap)
    one, other = SWAPPED
    yield SampleRun(one, SWAP.start, points[SWAP, other])
    yield SampleRun(other, SWAP.start, points[SWAP, one])


@pytest.fixture(scope="module")
def sample() -> Source:
    return read_c3d(GAIT)


def test_spikes_and_swaps_are_put_right(
    run_json: Json, spoilt: Path, sample: Source, tmp_path: Path
) -> None:
    out, recipe = tmp_path / "out.c3d", tmp_path / "recipe.json"
    code, done = run_json(
        "repair", spoilt, "-o", out, "--fix", "spikes,swaps", "--recipe", recipe, "--max-gap", 10
    )
    assert code == 0
    assert {(run["kind"], run["marker_index"]) for run in done["fixed"]} >= {
        ("spikes", SPIKED),
        ("swaps", SWAPPED[0]),
    }
    repaired = read_c3d(out).recording.points
    assert np.array_equal(
        repaired[SWAP, list(SWAPPED)], sample.recording.points[SWAP, list(SWAPPED)]
    )
    away = repaired[SPIKE_FRAME, SPIKED] - sample.recording.points[SPIKE_FRAME, SPIKED]
    assert np.linalg.norm(away) < 5.0
    assert done["check"]["passed"]

    again = tmp_path / "again.c3d"
    code, replayed = run_json("replay", recipe, spoilt, "-o", again)
    assert code == 0
    assert replayed["moved"] == 2
    assert replayed["set_aside"] == sum(run["kind"] == "spikes" for run in done["fixed"])
    assert again.read_bytes() == out.read_bytes()
    code, info = run_json("info", out)
    assert [run["problem"] for run in info["set_aside"]] == ["spikes"] * len(info["set_aside"])
    assert {run["from_point"] for run in info["moved"]} == {run["point"] for run in info["moved"]}


def test_without_filling_what_is_set_aside_is_missing(
    run_json: Json, spoilt: Path, tmp_path: Path
) -> None:
    out = tmp_path / "out.c3d"
    _, done = run_json("repair", spoilt, "-o", out, "--fix", "spikes", "--max-gap", 0)
    assert done["totals"]["filled"] == 0
    assert not read_c3d(out).recording.present[SPIKE_FRAME, SPIKED]


def test_smoothing_is_told(run_json: Json, spoilt: Path, tmp_path: Path) -> None:
    out = tmp_path / "out.c3d"
    code, done = run_json(
        *("repair", spoilt, "-o", out, "--smooth", "butterworth"),
        *("--smooth-param", "cutoff_hz=6", "--markers", "LASI", "--max-gap", 0),
    )
    assert code == 0
    (run,) = done["smoothed"]
    assert (run["marker"], run["method"], run["parameters"]["cutoff_hz"]) == (
        "LASI",
        "butterworth",
        6,
    )
    assert 0 < run["rms_change_mm"] <= run["largest_change_mm"]
    assert any("were smoothed" in text for text in done["check"]["allowed"])


@pytest.mark.parametrize(
    ("given", "message"),
    [
        (["--fix", "spikes,ghosts"], "there is no detector 'ghosts'"),
        (["--smooth", "magic"], "there is no smoothing method 'magic'"),
        (["--smooth-param", "cutoff_hz=6"], "--smooth-param belongs to --smooth"),
        (["--smooth", "butterworth", "--smooth-param", "cutoff_hz=no"], "smoothing butterworth"),
        (["--smooth", "butterworth", "--smooth-param", "order"], "takes NAME=VALUE"),
    ],
)
def test_wrong_usage(
    given: list[str], message: str, spoilt: Path, capsys: pytest.CaptureFixture[str]
) -> None:
    with pytest.raises(SystemExit) as ended:
        raise SystemExit(main(["repair", str(spoilt), "--dry-run", *given]))
    assert ended.value.code == 2
    assert message in capsys.readouterr().err


def test_an_impossible_cut_off_is_one_error(
    spoilt: Path, capsys: pytest.CaptureFixture[str]
) -> None:
    given = ["--smooth", "butterworth", "--smooth-param", "cutoff_hz=5000"]
    assert main(["repair", str(spoilt), "--dry-run", *given]) == 1
    assert "This cannot be smoothed" in capsys.readouterr().err


def test_a_plan_does_it_too(spoilt: Path, tmp_path: Path) -> None:
    smoothing = Smoothing.default("savgol")
    plan = Plan(Way.default("cubic"), 100.0, fix=("spikes", "swaps"), smooth=smoothing)
    write_plan(plan, tmp_path / "plan.json")
    assert read_plan(tmp_path / "plan.json") == plan
    request = Request(file=spoilt, plan=plan, out=tmp_path / "out.c3d")
    done = repair_file(request, no_progress, lambda _: None)
    assert {run.kind for run in done.fixed} == {"spikes", "swaps"}
    assert done.smoothing is not None
    kinds = [row.text.split(" (")[1] for row in done.about.edits]
    assert kinds == ["spikes)", "swaps)", "cubic)", "savgol)"]


@pytest.mark.parametrize(
    ("key", "value", "why"),
    [
        ("fix", "spikes", "not a list of detectors"),
        ("fix", ["ghosts"], "there is no detector 'ghosts'"),
        ("smooth", ["gcv"], "no method with parameters"),
        ("smooth", {"method": "magic", "parameters": {}}, "no smoothing method"),
    ],
)
def test_what_is_no_plan(tmp_path: Path, key: str, value: object, why: str) -> None:
    path = tmp_path / "plan.json"
    write_plan(Plan(Way.default("cubic")), path)
    path.write_text(json.dumps(json.loads(path.read_text()) | {key: value}))
    with pytest.raises(MocapmendError, match=why):
        read_plan(path)


def test_a_repaired_file_is_fixed_later(run_json: Json, spoilt: Path, tmp_path: Path) -> None:
    """Repairs of before stay, but where they were computed beside bad samples."""
    first, second, back = (tmp_path / f"{name}.c3d" for name in ("first", "second", "back"))
    run_json("repair", spoilt, "-o", first, "--method", "cubic", "--max-gap", 20)
    earlier = len(read_c3d(first).repairs)
    assert earlier
    _, done = run_json("repair", first, "-o", second, "--fix", "spikes,swaps", "--max-gap", 10)
    assert done["check"]["passed"]
    again = read_c3d(second)
    assert len(again.repairs) >= earlier
    stored = read_c3d(spoilt).recording.points
    assert np.array_equal(again.as_stored.points, stored, equal_nan=True)
    changes = replace(bare(Layers(again)).changes(), repairs=())
    engine.export(again, changes, back, False, False, no_progress)
    assert np.array_equal(read_c3d(back).recording.points, stored, equal_nan=True)
