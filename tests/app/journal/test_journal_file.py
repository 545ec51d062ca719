"""A journal file gives back every record that was completely written, and nothing else."""

import errno
import json
import os
import sys
import tracemalloc
import zlib
from collections.abc import Iterator
from contextlib import contextmanager
from pathlib import Path

import pytest

from mocapmend.journal import file as file_module
from mocapmend.journal.file import SUFFIX, JournalFile, Record

RECORDS: list[Record] = [
    ({"journal": 1}, b""),
    ({"step": "fill Ä"}, b"bytes\nof all \0\xff kinds\n"),
    ({"index": 0}, b""),
]

deletes_open_files = pytest.mark.skipif(sys.platform == "win32", reason="no open file is deleted")


@contextmanager
def claimed(path: Path) -> Iterator[JournalFile]:
    file = JournalFile.claim(path)
    assert file is not None
    yield file
    file.close()


def read(path: Path) -> list[Record]:
    with claimed(path) as file:
        return [record for record, _ in file.records()]


@pytest.fixture
def written(tmp_path: Path) -> Path:
    """Return a journal of three records that nobody holds."""
    file = JournalFile.create(tmp_path / "new" / "folder")
    for record in RECORDS:
        file.append(*record)
    file.close()
    return file.path


def ends_in(path: Path) -> list[int]:
    with claimed(path) as file:
        return [end for _, end in file.records()]


def with_checksum(body: bytes, data: bytes = b"") -> bytes:
    head = b"%08x %d %d\n" % (zlib.crc32(body + data), len(body), len(data))
    return head + body + data + b"\n"


def test_what_is_appended_is_read_again(written: Path) -> None:
    assert read(written) == RECORDS
    assert ends_in(written)[-1] == written.stat().st_size
    bodies = (json.dumps(event, separators=(",", ":")).encode() for event, _ in RECORDS)
    by_hand = [with_checksum(body, data) for body, (_, data) in zip(bodies, RECORDS, strict=True)]
    assert written.read_bytes() == b"".join(by_hand)


def test_a_file_cut_at_any_byte_gives_its_complete_records_and_can_go_on(written: Path) -> None:
    whole, ends = written.read_bytes(), ends_in(written)
    for size in range(len(whole) + 1):
        written.write_bytes(whole[:size])
        complete = sum(end <= size for end in ends)
        with claimed(written) as file:
            assert len(list(file.records())) == complete
            assert not file.damaged, "half a record is no damage"
            file.keep([0, *ends][complete])
            file.append({"index": 7})
        assert read(written) == [*RECORDS[:complete], ({"index": 7}, b"")]


def test_a_wrong_byte_ends_the_reading_before_its_record(written: Path) -> None:
    whole, ends = written.read_bytes(), ends_in(written)
    for place in range(len(whole)):
        wrong = bytearray(whole)
        wrong[place] ^= 0x01
        written.write_bytes(wrong)
        assert read(written) == RECORDS[: sum(end <= place for end in ends)]


@pytest.mark.parametrize(
    "raw",
    [
        with_checksum(b"[" * 200_000),
        with_checksum(b"[1]"),
        with_checksum(b"\xff"),
        with_checksum(b"{}")[:-1] + b"x",
        b"\n",
        b"no checksum\n",
        b"00000000 -5 2\n",
        bytes(5000),
    ],
)
def test_what_is_no_record_is_damage(tmp_path: Path, raw: bytes) -> None:
    path = tmp_path / "foreign.journal"
    path.write_bytes(raw)
    with claimed(path) as file:
        assert list(file.records()) == []
        assert file.damaged


def test_a_length_beyond_the_file_takes_no_memory(tmp_path: Path) -> None:
    path = tmp_path / "absurd.journal"
    path.write_bytes(b"00000000 999999999 999999999\n{}")
    tracemalloc.start()
    assert read(path) == []
    assert tracemalloc.get_traced_memory()[1] < 2**20
    tracemalloc.stop()


def test_no_more_is_written_than_is_read(written: Path, monkeypatch: pytest.MonkeyPatch) -> None:
    record = len(with_checksum(b'{"index":1}'))
    monkeypatch.setattr(file_module, "LARGEST", written.stat().st_size + record)
    with claimed(written) as file:
        file.append({"index": 1})
        with pytest.raises(OSError, match=os.strerror(errno.EFBIG)):
            file.append({"index": 2})
    assert read(written) == [*RECORDS, ({"index": 1}, b"")]
    monkeypatch.setattr(file_module, "LARGEST", written.stat().st_size - 1)
    assert read(written) == RECORDS


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
    with pytest.raises(OSError, match=os.strerror(errno.ENOLCK)):
        JournalFile.create(written.parent)
    assert list(written.parent.iterdir()) == [written]


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
