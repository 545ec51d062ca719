"""Entries of repair records about corrections, as damaged files and their editors leave them."""

import json
from pathlib import Path
from typing import Any

import pytest

from mocapmend.cli import main
from mocapmend.files import SmoothedRun
from mocapmend.files.sidecar import sidecar_path

SMOOTHED = SmoothedRun(
    *("A", 1, 1, 50),
    method="butterworth",
    parameters={"cutoff_hz": None, "order": 4},
    chosen={"cutoff_hz": (6.0, 7.5, 9.0), "noise": (0.1, 0.2, 0.3)},
    rms_change_mm=0.25,
)


def test_a_smoothed_run_comes_back() -> None:
    assert SmoothedRun.from_json(json.loads(json.dumps(SMOOTHED.as_json()))) == SMOOTHED


@pytest.mark.parametrize("value", [5.0, "x", None, [], ["6"], [6.0, True], [6.0, None], {}])
@pytest.mark.parametrize("key", ["cutoff_hz", "window_frames"])
def test_what_was_chosen_per_axis_are_numbers(key: str, value: Any) -> None:
    data = json.loads(json.dumps(SMOOTHED.as_json()))
    data["chosen"][key] = value
    with pytest.raises(ValueError):
        SmoothedRun.from_json(data)


def test_a_report_of_an_edited_record_is_written_without_it(
    samples: Path, tmp_path: Path, capsys: pytest.CaptureFixture[str]
) -> None:
    walk, out = samples / "walk_cmu_02_01.c3d", tmp_path / "o.trc"
    arguments = ["--method", "linear", "--smooth", "butterworth"]
    assert main(["repair", str(walk), "-o", str(out), *arguments]) == 0
    record = sidecar_path(out)
    data = json.loads(record.read_text("utf-8"))
    data["smoothed"][0]["chosen"]["cutoff_hz"] = "fast"
    record.write_text(json.dumps(data), "utf-8")
    assert main(["report", str(walk), str(out), "-o", str(tmp_path / "r.html")]) == 0
    assert "o.trc.mocapmend.json" in capsys.readouterr().err
