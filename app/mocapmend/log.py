"""The log file: what a bug report needs, kept small, where the system keeps such files."""

import logging
from logging.handlers import RotatingFileHandler
from pathlib import Path

import platformdirs

MOST_BYTES = 500_000
OLD_FILES = 1
FORMAT = "%(asctime)s %(levelname)s %(process)d %(name)s: %(message)s"


class _QuietHandler(RotatingFileHandler):
    """A log file that cannot be written (full disk, no rights) must not stop anybody's work."""

    def handleError(self, record: logging.LogRecord) -> None:  # noqa: N802 - logging's name
        pass


def log_path() -> Path:
    """Return where the log file is, whether it exists or not."""
    return Path(platformdirs.user_log_dir("mocapmend", appauthor=False)) / "mocapmend.log"


def set_up() -> None:
    """Send the program's log to the file; without effect when that is done already."""
    logger = logging.getLogger("mocapmend")
    if any(isinstance(handler, _QuietHandler) for handler in logger.handlers):
        return
    path = log_path()
    try:
        path.parent.mkdir(parents=True, exist_ok=True)
    except OSError:
        # Without a handler Python would print to stderr.
        logger.addHandler(logging.NullHandler())
        return
    handler = _QuietHandler(
        path, maxBytes=MOST_BYTES, backupCount=OLD_FILES, encoding="utf-8", delay=True
    )
    handler.setFormatter(logging.Formatter(FORMAT))
    logger.addHandler(handler)
    logger.setLevel(logging.INFO)
