"""What the methods that code windows of motion share: from gaps to places, before any bones."""

from collections.abc import Iterator, Sequence
from dataclasses import dataclass
from pathlib import Path
from typing import Literal

import numpy as np

from mocapmend_algorithms.arrays import BoolArray, FloatArray, IntArray
from mocapmend_algorithms.fill.company import few_frames, seen_together
from mocapmend_algorithms.fill.edges import Doubt, EdgeParams, Modelled, obstacle, with_edges
from mocapmend_algorithms.gaps import Gap
from mocapmend_algorithms.params import option, training_option
from mocapmend_algorithms.progress import Progress, part
from mocapmend_algorithms.recording import Recording
from mocapmend_algorithms.sparse.body import Body
from mocapmend_algorithms.sparse.bone_space import with_lengths
from mocapmend_algorithms.sparse.code_model import CodeSettings
from mocapmend_algorithms.sparse.examples import Motion
from mocapmend_algorithms.sparse.recovery import LEAST_EXAMPLES, Recovery
from mocapmend_algorithms.sparse.rows import Rows
from mocapmend_algorithms.sparse.training_set import read_training_set
from mocapmend_algorithms.sparse.windows import Span

LEAST_HELPERS = 3
FRAMES = 6
"""Of a window (W18's M)."""
ATOMS_ALONE = 150
ATOMS_TRAINED = 600
"""Where a training set adds to what the recording shows."""
SHORTEST_PIECE_S = 0.05
SHORT_RECORDING = 4
"""Windows are at most this part of a recording."""


@dataclass(frozen=True)
class MotionCodeParams(EdgeParams):
    """Parameters that the methods share."""

    training: str = training_option(
        "Recordings to learn from beside this one. By default it learns from this one alone."
    )
    atoms: int | None = option(
        None,
        label="Atoms",
        text="Examples of motion in the dictionary. Automatic: up to 150 of the recording, or 600 "
        "with a training set.",
        minimum=10,
        maximum=5000,
    )
    penalty: float = option(
        0.1,
        label="Penalty",
        text="The larger, the fewer examples a window is made of.",
        minimum=1e-6,
        maximum=10.0,
    )

    def codes(self, others: Sequence[Motion], *, guided: bool) -> CodeSettings:
        """Return how windows are coded, given the training set."""
        atoms = self.atoms or (ATOMS_TRAINED if others else ATOMS_ALONE)
        return CodeSettings(atoms, 2 * atoms, self.penalty, guided)


@dataclass(frozen=True)
class Way:
    """How windows of motion are coded.

    Attributes
    ----------
    window_ms : float
        What the frames of a window are spread over.
    rows : str
        How a pose is described; see `Rows`.
    heading : bool
        Whether the body's heading is taken out.
    parts : bool
        Whether a marker is told from the triple of its part alone (W18, table 2).
    codes : CodeSettings
        How the rows are coded.
    """

    window_ms: float
    rows: Literal["bones", "root"]
    heading: bool
    parts: bool
    codes: CodeSettings


def read_motions(path: str, recording: Recording, body: Body) -> list[Motion]:
    """Read a training set for a recording.

    Parameters
    ----------
    path : str
        Its file; no motions where it is empty.
    recording : Recording
        What is to be repaired.
    body : Body
        Its bones. Those of a skeleton give the training set its own lengths (W18, eq. 1).

    Returns
    -------
    list of Motion
        With the markers of the recording; those that the set has not are not seen.

    Raises
    ------
    TrainingSetError
        If it cannot be read, or is of other markers.
    """
    if not path:
        return []
    training = read_training_set(Path(path))
    places = training.places_of(recording.labels)
    motions = []
    for motion in training.motions(recording.up, recording.rate):
        points = np.full((len(motion), recording.markers, 3), np.nan)
        points[:, places] = motion
        if body.exact:
            points = with_lengths(points, body, body.edge_lengths)
        motions.append(Motion(points, np.isfinite(points[..., 0])))
    return motions


def window_span(recording: Recording, window_ms: float) -> Span:
    """Spread the frames of a window over a time, less in a recording that is short."""
    length = round(window_ms / 1000 * recording.rate)
    return Span.over(FRAMES, min(length, recording.frames // SHORT_RECORDING))


def tell_gaps(
    recording: Recording,
    observed: BoolArray,
    gaps: Sequence[Gap],
    way: Way,
    body: Body,
    others: Sequence[Motion],
    params: EdgeParams,
    progress: Progress,
) -> dict[Gap, Modelled | str]:
    """Say what sparse codes make of gaps.

    Parameters
    ----------
    recording : Recording
        Not changed.
    observed : ndarray of bool, shape (frames, markers)
        The samples that may be used.
    gaps : sequence of Gap
        The gaps to fill.
    way : Way
        How.
    body : Body
        The bones.
    others : sequence of Motion
        A training set.
    params : EdgeParams
        Whether gaps at the beginning and the end are to be filled.
    progress : Progress
        Called often.

    Returns
    -------
    dict of Gap to Modelled or str
        For `edges.meet_edges`; with the number of markers (`helpers`) and `examples` in the notes.
    """
    teller = _Teller(recording, observed, way, body, others)
    said: dict[Gap, Modelled | str] = {}
    for done, gap in enumerate(gaps):
        share = part(progress, done / len(gaps), (done + 1) / len(gaps))
        share(0.0)
        said[gap] = obstacle(observed, gap, params) or teller.tell(gap, share)
    progress(1.0)
    return said


class _Teller:
    """Tells gaps of one recording; what it has learned serves all gaps of the same markers."""

    def __init__(
        self,
        recording: Recording,
        observed: BoolArray,
        way: Way,
        body: Body,
        others: Sequence[Motion],
    ) -> None:
        self._own = Motion(recording.points * recording.mm, observed)
        self._recording, self._observed = recording, observed
        self._way, self._body, self._others = way, body, others
        self._taught: BoolArray = np.zeros(recording.markers, dtype=np.bool_)
        for motion in others:
            self._taught |= motion.seen.any(axis=0)
        self._span = window_span(recording, way.window_ms)
        self._shortest = max(2, round(SHORTEST_PIECE_S * recording.rate))
        self._recoveries: dict[tuple[bytes, bytes], Recovery] = {}
        self._answers: dict[tuple[int, int, int], FloatArray] = {}

    def tell(self, gap: Gap, progress: Progress) -> Modelled | str:
        """Say what the codes make of a gap and the samples beside it, or why they say nothing."""
        start, stop = with_edges(self._observed, gap)
        values = np.full((stop - start, 3), np.nan)
        helpers, examples, doubt = [], [], None
        pieces = list(self._pieces(gap.marker, start, stop))
        shares = np.linspace(0.0, 1.0, 2 * len(pieces) + 1).tolist()
        for done, (a, b, seen, shown) in enumerate(pieces):
            learn = part(progress, shares[2 * done], shares[2 * done + 1])
            ask = part(progress, shares[2 * done + 1], shares[2 * done + 2])
            few = few_frames(shown)
            if few and not self._taught[gap.marker]:
                return few
            if seen.size < LEAST_HELPERS:
                return (
                    f"fewer than {LEAST_HELPERS} other markers that are seen often enough are "
                    "there: this method has too little to tell the posture by"
                )
            recovery, targets = self._recovery(gap, seen, learn)
            if recovery.examples < LEAST_EXAMPLES:
                return (
                    f"this method needs {LEAST_EXAMPLES} stretches that show the marker and those "
                    f"that predict it, and has {recovery.examples}"
                )
            told = self._told(recovery, a, b, ask)
            values[a - start : b - start] = told[:, targets.tolist().index(gap.marker)]
            helpers.append(int(seen.size))
            examples.append(recovery.examples)
            missed = recovery.doubt
            doubt = None if missed is None else Doubt(targets, missed)
        if not np.isfinite(values).all():
            return "the recording is too short for the windows of this method"
        notes = {"helpers": min(helpers), "examples": min(examples)}
        return Modelled(values / self._recording.mm, notes, doubt)

    def _pieces(
        self, marker: int, start: int, stop: int
    ) -> Iterator[tuple[int, int, IntArray, int]]:
        """Divide a stretch until enough markers are seen in each piece.

        Yields
        ------
        start, stop : int
            The piece.
        helpers : ndarray of int
            The markers that are seen around it.
        shown : int
            Frames that show them and the marker.
        """
        reach = 2 * self._span.reach
        low, high = max(start - reach, 0), min(stop + reach, self._recording.frames)
        there: BoolArray = np.asarray(self._observed[low:high].all(axis=0))
        there[marker] = False
        near: BoolArray = np.asarray(there & self._near(marker))
        if self._way.parts and np.count_nonzero(near) >= LEAST_HELPERS:
            there = near
        there[marker] = True
        together, complete = seen_together(self._observed, np.flatnonzero(there), marker)
        if few_frames(complete.size) and self._taught[marker]:
            together = np.flatnonzero(there & self._taught)
        helpers = np.setdiff1d(together, [marker])
        if helpers.size >= LEAST_HELPERS or stop - start <= self._shortest:
            yield start, stop, helpers, complete.size
            return
        middle = (start + stop) // 2
        yield from self._pieces(marker, start, middle)
        yield from self._pieces(marker, middle, stop)

    def _near(self, marker: int) -> BoolArray:
        """Return the markers of the parts of the body that a marker is told from."""
        near: BoolArray = np.zeros(self._observed.shape[1], dtype=np.bool_)
        near[self._body.helpers_of(marker)] = True
        return near

    def _recovery(
        self, gap: Gap, helpers: IntArray, progress: Progress
    ) -> tuple[Recovery, IntArray]:
        """Return what tells the marker, with those missing beside it if enough shows them all."""
        targets = self._missing_with(gap, helpers)
        recovery = self._learned(helpers, targets, progress)
        if recovery.examples < LEAST_EXAMPLES and targets.size > 1:
            # Nothing was learned, so no progress was told.
            targets = np.array([gap.marker])
            recovery = self._learned(helpers, targets, progress)
        return recovery, targets

    def _told(self, recovery: Recovery, a: int, b: int, progress: Progress) -> FloatArray:
        """Ask once for the markers that have the same gap."""
        key = id(recovery), a, b
        if key not in self._answers:
            self._answers[key] = recovery.ask(a, b, progress)
        return self._answers[key]

    def _missing_with(self, gap: Gap, helpers: IntArray) -> IntArray:
        """Return the marker and those missing all through its gap that bones join to it."""
        gone: BoolArray = np.asarray(~self._observed[gap.start : gap.stop].any(axis=0))
        gone[helpers] = False
        reached, todo = {gap.marker}, [gap.marker]
        edges = self._body.edges
        while todo:
            marker = todo.pop()
            at = edges[(edges == marker).any(axis=1)]
            for other in np.setdiff1d(at, [marker]).tolist():
                if gone[other] and other not in reached and self._observed[:, other].any():
                    reached.add(other)
                    todo.append(other)
        return np.array(sorted(reached))

    def _learned(self, helpers: IntArray, targets: IntArray, progress: Progress) -> Recovery:
        key = helpers.tobytes(), targets.tobytes()
        if key not in self._recoveries:
            describe = Rows.along_bones if self._way.rows == "bones" else Rows.around_root
            self._recoveries[key] = Recovery(
                self._own,
                self._others,
                describe(self._body, helpers, targets),
                self._span,
                self._recording.up if self._way.heading else None,
                self._way.codes,
                progress,
            )
        return self._recoveries[key]
