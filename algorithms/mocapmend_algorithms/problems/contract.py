"""What every detector takes and returns."""

from typing import Any, Protocol

from mocapmend_algorithms.problems.bad_run import BadRun
from mocapmend_algorithms.progress import Progress
from mocapmend_algorithms.recording import Recording
from mocapmend_algorithms.skeleton import Skeleton


class DetectFunction(Protocol):
    """A pure function that looks for one kind of bad samples."""

    def __call__(
        self, recording: Recording, skeleton: Skeleton, params: Any, progress: Progress, /
    ) -> list[BadRun]:
        """Return the bad runs ordered by marker and start; none where nothing can be judged."""
