"""The files that were open lately, and which of them are gone."""

from collections.abc import Sequence
from pathlib import Path

from PySide6.QtCore import QObject, Signal

from mocapmend.jobs import Job, Jobs
from mocapmend.settings import RECENT_FILES, Settings
from mocapmend_algorithms.progress import Progress


def find_gone(paths: Sequence[str], progress: Progress) -> frozenset[str]:
    """Return the paths that lead nowhere."""
    gone = set()
    for number, path in enumerate(paths, start=1):
        if not Path(path).exists():
            gone.add(path)
        progress(number / len(paths))
    return frozenset(gone)


class RecentFiles(QObject):
    """Reads the list from the settings and looks for the files in the background.

    A file on a drive that does not answer would hold up the window else.

    Signals
    -------
    changed :
        The list is another, or files are found to be gone.
    """

    changed = Signal()

    def __init__(self, settings: Settings, jobs: Jobs, parent: QObject | None = None) -> None:
        super().__init__(parent)
        self._settings = settings
        self._jobs = jobs
        self._looking: Job | None = None
        self.gone: frozenset[str] = frozenset()

    @property
    def paths(self) -> list[str]:
        """The files, the last one first."""
        return self._settings.get(RECENT_FILES)

    def look(self) -> None:
        """Find out which files are gone."""
        if self._looking is not None or not self.paths:
            return
        self._looking = self._jobs.read_or_write(
            self.tr("Looking for recent files"), find_gone, self.paths
        )
        self._looking.finished.connect(self._accept)
        self._looking.ended.connect(self._end_looking)

    def forget(self, *paths: str) -> None:
        """Take files out of the list."""
        for path in paths:
            self._settings.forget_file(path)
        self.changed.emit()

    def forget_gone(self) -> None:
        """Take all files out of the list that are gone."""
        self.forget(*self.gone)

    def _accept(self, gone: frozenset[str]) -> None:
        if gone != self.gone:
            self.gone = gone
            self.changed.emit()

    def _end_looking(self) -> None:
        self._looking = None
