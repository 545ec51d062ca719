"""A copy to write to that is made while nobody waits for it."""

from contextlib import suppress
from threading import Thread

import numpy as np
from numpy.typing import NDArray


class WorkingCopy:
    """Coordinates that are those of a recording until the first edit.

    The copy of a long recording takes a good part of a second: once it is to be prepared, a thread
    makes it while the user looks at the recording, and the first edit finds it ready.

    Parameters
    ----------
    original : ndarray
        Never changed.
    """

    def __init__(self, original: NDArray[np.float64]) -> None:
        self._current = original
        self._copy: NDArray[np.float64] | None = None
        self._thread: Thread | None = None

    def prepare(self) -> None:
        """Begin to make the copy, now that nothing else is urgent."""
        if self._thread is None and self._copy is None:
            self._thread = Thread(target=self._make, args=(self._current,), name="working copy")
            self._thread.start()

    @property
    def current(self) -> NDArray[np.float64]:
        """The coordinates as they are now, to be read."""
        return self._current

    def writable(self) -> NDArray[np.float64]:
        """Return the coordinates to be written."""
        if self._copy is None and self._thread is not None:
            self._thread.join()
        if self._copy is None:
            # It was not prepared, or there was too little memory then.
            self._copy = self._current.copy()
        self._current = self._copy
        return self._copy

    def _make(self, original: NDArray[np.float64]) -> None:
        with suppress(MemoryError):
            self._copy = original.copy()
