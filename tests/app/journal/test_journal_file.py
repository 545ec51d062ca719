"""A journal file gives back every line that was completely written, and nothing else."""

import errno
import json
import os
import sys
import zlib
from collections.abc import Iterator
from contextlib import contextmanager
from pathlib import Path

import pytest

from mocapmend.journal import file as file_module
from mocapmend.journal.file import SUFFIX, Event, JournalFile

EVENTS: list[Event] = [{"journal": 1}, {"step": "fill Ä", "values": "AAAA"}, {"index": 0}]

deletes_open_files = pytest.mark.skipif(sys.platform == "win32", reason="no open file is deleted")


@contextmanager
def claimed(path: Path) -> Iterator[JournalFile]:
    file = JournalFile.claim(path)
    assert file is not None
    yield file
    file.close()


def read(path: Path) -> list[Event]:
    with claimed(path) as file:
        return [event for event, _ in file.events()]


@pytest.fixture
def written(tmp_path: Path) -> Path:
    """Return a journal of three lines that nobody holds."""
    file = JournalFile.create(tmp_path / "new" / "folder")
    for event in EVENTS:
        file.append(event)
    file.close()
    return file.path


def with_checksum(body: bytes) -> bytes:
    return b"%08x %s\n" % (zlib.crc32(body), body)


def test_what_is_appended_is_read_again(written: Path) -> None:
    assert read(written) == EVENTS
    with claimed(written) as file:
        assert [end for _, end in file.events()][-1] == written.stat().st_size
        assert not file.damaged


def test_a_file_cut_at_any_byte_gives_its_complete_lines_and_can_go_on(written: Path) -> None:
    whole = written.read_bytes()
    for size in range(len(whole) + 1):
        written.write_bytes(whole[:size])
        complete = whole[:size].count(b"\n")
        with claimed(written) as file:
            ends = [0, *(end for _, end in file.events())]
            assert len(ends) - 1 == complete
            assert not file.damaged, "half a line is no damage"
            file.keep(ends[-1])
            file.append({"index": 7})
        assert read(written) == [*EVENTS[:complete], {"index": 7}]


def test_a_wrong_byte_ends_the_reading_before_its_line(written: Path) -> None:
    whole = written.read_bytes()
    for place in range(len(whole)):
        wrong = bytearray(whole)
        wrong[place] ^= 0x01
        written.write_bytes(wrong)
        assert read(written) == EVENTS[: whole[:place].count(b"\n")]


@pytest.mark.parametrize(
    "line",
    [
        with_checksum(b"[" * 200_000),
        with_checksum(b"[1]"),
        with_checksum(b"\xff"),
        b"\n",
        b"no checksum\n",
        b"\0" * (file_module.LONGEST_FIRST_LINE + 5),
    ],
)
def test_what_is_no_event_is_damage(tmp_path: Path, line: bytes) -> None:
    path = tmp_path / "foreign.journal"
    path.write_bytes(line)
    with claimed(path) as file:
        assert list(file.events()) == []
        assert file.damaged


def test_no_more_is_written_than_is_read(written: Path, monkeypatch: pytest.MonkeyPatch) -> None:
    line = len(with_checksum(json.dumps({"index": 1}, separators=(",", ":")).encode()))
    monkeypatch.setattr(file_module, "LARGEST", written.stat().st_size + line)
    with claimed(written) as file:
        file.append({"index": 1})
        with pytest.raises(OSError, match=os.strerror(errno.EFBIG)):
            file.append({"index": 2})
    assert read(written) == [*EVENTS, {"index": 1}]
    monkeypatch.setattr(file_module, "LARGEST", written.stat().st_size - 1)
    assert read(written) == EVENTS


def test_only_one_holds_a_journal(tmp_path: Path) -> None:
    file = JournalFile.create(tmp_path)
    assert JournalFile.claim(file.path) is None
    file.close()
    with claimed(file.path):
        assert JournalFile.claim(file.path) is None


def test_a_journal_that_is_gone_cannot_be_claimed(tmp_path: Path) -> None:
    assert JournalFile.claim(tmp_path / "gone.journal") is None


def test_a_folder_that_knows_no_locks_is_an_error(
    written: Path, monkeypatch: pytest.MonkeyPatch
) -> None:
    def refuse(_: JournalFile) -> bool:
        raise OSError(errno.ENOLCK, os.strerror(errno.ENOLCK))

    monkeypatch.setattr(JournalFile, "_lock", refuse)
    with pytest.raises(OSError, match=os.strerror(errno.ENOLCK)):
        JournalFile.claim(written)


@deletes_open_files
def test_a_discarded_journal_is_gone_also_for_one_who_has_it_open(written: Path) -> None:
    with written.open("rb") as early:
        with claimed(written) as file:
            file.discard()
        assert early.read() == b""
    assert not written.exists()


@deletes_open_files
@pytest.mark.parametrize("held", [True, False])
def test_a_new_file_that_another_program_cleared_away_is_made_again(
    tmp_path: Path, monkeypatch: pytest.MonkeyPatch, held: bool
) -> None:
    lock = JournalFile._lock
    taken: list[Path] = []

    def lock_later(file: JournalFile) -> bool:
        if taken:
            return lock(file)
        taken.append(file.path)
        file.path.unlink()
        return not held

    monkeypatch.setattr(JournalFile, "_lock", lock_later)
    file = JournalFile.create(tmp_path)
    assert list(tmp_path.glob("*" + SUFFIX)) == [file.path]
    assert file.path not in taken
    file.close()
