"""The ledger survives being cut, and files are known by their bytes."""

import errno
import json
import os
from pathlib import Path

import pytest
from batch_trials import write_trial

from mocapmend.batch.ledger import NAME, Ledger
from mocapmend.batch.results import Figures, Finished, Fixed, Reason, Row, Seen, Smoothed
from mocapmend.batch.seeing import is_still, see
from mocapmend.errors import MocapmendError
from mocapmend.files.sidecar import sidecar_path

FIGURES = Figures(
    frames=10, markers=2, rate_hz=100.0, gaps=3, filled=1, left_open=2, samples_missing=9,
    samples_filled=2, reasons=(Reason(2, 7, "too long"),), expected_worst_mm=1.5,
    fixed=(Fixed("spikes", 1, 2),), smoothed=Smoothed(2, 0.5, 1.5), warnings=("odd",),
)  # fmt: skip
ROW = Row(file="s/ö.c3d", state="repaired", figures=FIGURES, output="s/ö.c3d", seconds=1.25)
FINISHED = Finished(ROW, Seen(1, 2, "a" * 64), Seen(3, 4, "b" * 64, "c" * 64))


def test_what_is_done_is_known_again(tmp_path: Path) -> None:
    ledger = Ledger(tmp_path)
    ledger.begin("s/ö.c3d")
    ledger.begin("other.c3d")
    ledger.finish(FINISHED, "key")
    ledger.close()
    again = Ledger(tmp_path)
    again.close()
    assert again.begun == {"other.c3d"}
    entry = again.done["s/ö.c3d"]
    assert (entry.key, entry.row) == ("key", ROW)
    assert (entry.input, entry.output) == (FINISHED.input, FINISHED.output)


def test_a_file_that_was_begun_again_may_be_what_it_was_or_not(tmp_path: Path) -> None:
    ledger = Ledger(tmp_path)
    ledger.finish(FINISHED, "key")
    ledger.begin(ROW.file)
    ledger.close()
    again = Ledger(tmp_path)
    assert again.begun == set(again.done) == {ROW.file}
    again.fail(ROW.file)
    again.close()
    failed = Ledger(tmp_path)
    failed.close()
    assert failed.begun == set()
    assert set(failed.done) == {ROW.file}


def test_every_cut_of_the_last_line_leaves_the_lines_before(tmp_path: Path) -> None:
    ledger = Ledger(tmp_path)
    ledger.begin("first.c3d")
    ledger.finish(FINISHED, "key")
    ledger.close()
    raw = (tmp_path / NAME).read_bytes()
    start = raw.index(b"\n") + 1
    for cut in range(start, len(raw) - 1, 7):
        (tmp_path / NAME).write_bytes(raw[:cut])
        cut_off = Ledger(tmp_path)
        assert (cut_off.begun, cut_off.done) == ({"first.c3d"}, {})
        cut_off.begin("next.c3d")
        cut_off.close()
        after = Ledger(tmp_path)
        after.close()
        assert (after.begun, after.done) == ({"first.c3d", "next.c3d"}, {})


@pytest.mark.parametrize(
    ("place", "value"),
    [
        (("row", "state"), "done"), (("row", "file"), "another.c3d"), (("row", "seconds"), "long"),
        (("row", "output"), 5), (("row", "figures", "gaps"), "many"),
        (("row", "figures", "gaps"), True), (("row", "figures", "tracked_before"), [1.0]),
        (("row", "figures", "warnings"), [1]), (("row", "figures", "reasons"), [{"gaps": 1}]),
        (("row", "figures", "fixed", 0, "runs"), None),
        (("row", "figures", "smoothed", "markers"), 2.5), (("input", "size"), "1"),
        (("output", "sha256"), None),
    ],
)  # fmt: skip
def test_lines_that_were_edited_are_passed_over(
    tmp_path: Path, place: tuple[str | int, ...], value: object
) -> None:
    ledger = Ledger(tmp_path)
    ledger.finish(FINISHED, "key")
    ledger.close()
    line = json.loads((tmp_path / NAME).read_bytes())
    inner = line
    for key in place[:-1]:
        inner = inner[key]
    inner[place[-1]] = value
    (tmp_path / NAME).write_text(json.dumps(line) + "\n")
    edited = Ledger(tmp_path)
    edited.close()
    assert edited.done == {}


def test_a_disk_that_is_full_is_said_once(tmp_path: Path) -> None:
    ledger = Ledger(tmp_path)

    class Full:
        def write(self, data: bytes) -> None:
            pass

        def flush(self) -> None:
            raise OSError(errno.ENOSPC, "No space left on device")

        close = flush

    stream, ledger._stream = ledger._stream, Full()
    stream.close()
    with pytest.raises(MocapmendError, match="cannot be written: No space left"):
        ledger.begin("a.c3d")
    ledger.close()


@pytest.mark.parametrize(
    "line",
    [
        b"\xff\xfe", b"[]", b"null", b"{}", b'{"mocapmend_batch": 2, "begun": "x"}',
        b'{"mocapmend_batch": 1}', b'{"mocapmend_batch": 1, "done": "x", "row": {}}',
        b"[" * 100_000,
    ],
)  # fmt: skip
def test_lines_of_others_are_passed_over(tmp_path: Path, line: bytes) -> None:
    (tmp_path / NAME).write_bytes(line + b"\n")
    ledger = Ledger(tmp_path)
    ledger.close()
    assert (ledger.begun, ledger.done) == (set(), {})


def test_rows_that_lack_something_are_passed_over(tmp_path: Path) -> None:
    ledger = Ledger(tmp_path)
    ledger.finish(FINISHED, "key")
    ledger.close()
    whole = json.loads((tmp_path / NAME).read_text())
    for broken in (
        {**whole, "row": {**whole["row"], "figures": None}},
        {**whole, "row": {**whole["row"], "more": 1}},
        {**whole, "input": None},
        {key: value for key, value in whole.items() if key != "key"},
    ):
        (tmp_path / NAME).write_text(json.dumps(broken) + "\n")
        again = Ledger(tmp_path)
        again.close()
        assert (again.begun, again.done) == (set(), {})


def test_a_folder_that_cannot_be_written(tmp_path: Path) -> None:
    (tmp_path / NAME).mkdir()
    with pytest.raises(MocapmendError, match="cannot be written"):
        Ledger(tmp_path)


def test_a_file_is_the_same_by_its_bytes(tmp_path: Path) -> None:
    path = write_trial(tmp_path / "a.c3d")
    seen = see(path)
    assert is_still(path, seen)
    os.utime(path, (1, 1))
    assert is_still(path, seen)
    raw = path.read_bytes()
    path.write_bytes(raw[:-1] + b"x")
    os.utime(path, (1, 1))
    assert not is_still(path, seen)
    path.write_bytes(raw)
    assert is_still(path, seen)
    sidecar_path(path).write_text("{}")
    assert not is_still(path, seen)
    assert is_still(path, see(path))
    path.unlink()
    assert not is_still(path, seen)
