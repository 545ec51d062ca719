"""The log file: written where it can be, silent where it cannot."""

import logging
from collections.abc import Iterator
from pathlib import Path

import pytest

from mocapmend import log


@pytest.fixture(autouse=True)
def no_handlers() -> Iterator[None]:
    """Give the program's logger no handlers before and after the test."""
    logger = logging.getLogger("mocapmend")
    before = logger.handlers[:]
    for handler in before:
        logger.removeHandler(handler)
    yield
    for handler in logger.handlers[:]:
        logger.removeHandler(handler)
        handler.close()
    for handler in before:
        logger.addHandler(handler)


def test_messages_and_tracebacks_reach_the_file(
    tmp_path: Path, monkeypatch: pytest.MonkeyPatch
) -> None:
    path = tmp_path / "deep" / "folder" / "mocapmend.log"
    monkeypatch.setattr(log, "log_path", lambda: path)
    log.set_up()
    log.set_up()
    try:
        raise RuntimeError("boom")
    except RuntimeError:
        logging.getLogger("mocapmend.part").exception("it broke")
    text = path.read_text("utf-8")
    assert text.count("it broke") == 1
    assert "Traceback" in text
    assert "mocapmend.part" in text


def test_the_file_stays_small(tmp_path: Path, monkeypatch: pytest.MonkeyPatch) -> None:
    path = tmp_path / "mocapmend.log"
    monkeypatch.setattr(log, "log_path", lambda: path)
    monkeypatch.setattr(log, "MOST_BYTES", 2000)
    log.set_up()
    for number in range(200):
        logging.getLogger("mocapmend").info("message %d", number)
    assert len(list(tmp_path.iterdir())) == 1 + log.OLD_FILES
    assert all(file.stat().st_size <= 2000 for file in tmp_path.iterdir())
    assert "message 199" in path.read_text("utf-8")


@pytest.mark.parametrize("name", ["a file/mocapmend.log", "a file"])
def test_a_file_that_cannot_be_written_disturbs_nobody(
    tmp_path: Path,
    monkeypatch: pytest.MonkeyPatch,
    capsys: pytest.CaptureFixture[str],
    name: str,
) -> None:
    (tmp_path / "a file").mkdir() if name == "a file" else (tmp_path / "a file").write_text("")
    monkeypatch.setattr(log, "log_path", lambda: tmp_path / name)
    log.set_up()
    logging.getLogger("mocapmend").error("nobody will read this")
    assert capsys.readouterr().err == ""


def test_the_path_is_the_users_and_needs_no_folder() -> None:
    assert log.log_path().name == "mocapmend.log"
    assert log.log_path().is_absolute()
