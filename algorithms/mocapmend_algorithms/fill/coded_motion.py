"""Candidate of `auto`: sparse codes of windows of motion, as `bone-dictionary` has them.

With a training set they find neighbours together that no donor beside the gap tells one by one.
"""

from collections.abc import Sequence
from dataclasses import dataclass, field

import numpy as np

from mocapmend_algorithms.arrays import BoolArray, FloatArray, IntArray
from mocapmend_algorithms.fill.blending import blended, grown
from mocapmend_algorithms.fill.bone_dictionary import BoneDictionaryParams, fill_bare
from mocapmend_algorithms.fill.candidate import Candidate
from mocapmend_algorithms.fill.case import Case
from mocapmend_algorithms.fill.lessons import Trial
from mocapmend_algorithms.fill.punch import Window, most_at_once, punch
from mocapmend_algorithms.gaps import Gap
from mocapmend_algorithms.progress import Progress, part
from mocapmend_algorithms.recording import Recording
from mocapmend_algorithms.sparse.body import Body
from mocapmend_algorithms.sparse.examples import Motion

Key = tuple[Window, bytes, tuple[int, ...]]
"""A window, the markers that have it, and where it is tried; nowhere for the gaps themselves."""
PULL = 0.03
"""Towards equal weights; weak, since often one of two is much better."""
OWN_LENGTH_POWER = 0.75
LENGTH_POWER = 0.25
"""Powers by which what was learned here, and codes, are taken to err more where the trials are
shorter than the gap: what was learned elsewhere too does not depend on samples beside it."""
BARE_SHARE = 0.2
"""Of the progress: the fill itself; the trials take the rest."""


@dataclass(frozen=True, eq=False)
class CodedMotion:
    """Fills gaps of one recording, and the trials of each.

    Attributes
    ----------
    recording : Recording
        Not changed.
    observed : ndarray of bool, shape (frames, markers)
        The samples that may be looked at.
    params : BoneDictionaryParams
        How windows are coded.
    body : Body
        The bones.
    others : sequence of Motion
        A training set.
    """

    recording: Recording
    observed: BoolArray
    params: BoneDictionaryParams
    body: Body
    others: Sequence[Motion]
    _known: dict[Key, dict[Gap, FloatArray]] = field(default_factory=dict, init=False)

    def candidate(self, case: Case, progress: Progress) -> Candidate | None:
        """Fill a gap and its trials.

        Parameters
        ----------
        case : Case
            The gap.
        progress : Progress
            Called often.

        Returns
        -------
        Candidate or None
            None where the codes do not fill the gap and all its trials.
        """
        gap, trials = case.gap, case.lesson.trials
        values = self.values(gap, part(progress, 0.0, BARE_SHARE))
        if values is None:
            return None
        tried = self._trials(gap, trials, part(progress, BARE_SHARE, 1.0))
        errors = []
        for trial in trials:
            told = tried.get(Gap(gap.marker, trial.start, trial.stop))
            if told is None:
                return None
            judged = trial.hidden[trial.judged]
            errors.append(case.target[judged] - told[case.lesson.frames[judged] - trial.start])
        spreads = tuple(np.ones(len(error)) for error in errors)
        return Candidate(values, np.ones(gap.length), tuple(errors), spreads)

    def values(self, gap: Gap, progress: Progress) -> FloatArray | None:
        """Fill a gap, and those that others have in the same frames.

        Parameters
        ----------
        gap : Gap
            The gap.
        progress : Progress
            Called often.

        Returns
        -------
        ndarray, shape (length, 3), or None
            In mm; None where the codes do not fill it.
        """
        window, members = self._company(gap)
        key = window, members.tobytes(), ()
        if key not in self._known:
            gaps = [Gap(marker, window.start, window.stop) for marker in members.tolist()]
            self._known[key] = self._fill(self.observed, gaps, progress)
        return self._known[key].get(gap)

    def _trials(
        self, gap: Gap, trials: Sequence[Trial], progress: Progress
    ) -> dict[Gap, FloatArray]:
        """Fill the trials of a gap, as it is missing; its companions' are often the same."""
        window, members = self._company(gap)
        starts = tuple(trial.start for trial in trials)
        key = window, members.tobytes(), starts
        if starts and key not in self._known:
            found: dict[Gap, FloatArray] = {}
            length = trials[0].stop - trials[0].start
            runs = self._runs(starts, length)
            for done, places in enumerate(runs):
                hidden = punch(self.observed, window, members, np.array(places), length)
                gaps = [Gap(m, p, p + length) for m in members.tolist() for p in places]
                share = part(progress, done / len(runs), (done + 1) / len(runs))
                found |= self._fill(hidden, gaps, share)
            self._known[key] = found
        return self._known[key]

    def _company(self, gap: Gap) -> tuple[Window, IntArray]:
        """Return the window of a gap, and the markers that have it."""
        window = Window.of(self.observed, gap)
        return window, np.flatnonzero(window.alike(self.observed))

    def _runs(self, starts: Sequence[int], length: int) -> list[list[int]]:
        """Deal trials to runs in which they are apart and hide few enough frames."""
        most = most_at_once(length, len(self.observed))
        runs: list[list[int]] = []
        for start in starts:
            for run in runs:
                if len(run) < most and start > run[-1] + length + 1:
                    run.append(start)
                    break
            else:
                runs.append([start])
        return runs

    def _fill(
        self, observed: BoolArray, gaps: Sequence[Gap], progress: Progress
    ) -> dict[Gap, FloatArray]:
        """Fill gaps, in mm."""
        filled = fill_bare(
            self.recording,
            observed,
            gaps,
            progress,
            params=self.params,
            body=self.body,
            others=self.others,
        )
        return {patch.gap: patch.values * self.recording.mm for patch in filled.patches}


def joined(own: Candidate, coded: Candidate, longer: float) -> tuple[Candidate, float]:
    """Blend codes with what was learned from the recording alone, if the trials speak for it.

    Parameters
    ----------
    own : Candidate
        What was learned from the recording.
    coded : Candidate
        The codes.
    longer : float
        How many times longer than the trials the gap is.

    Returns
    -------
    candidate : Candidate
        Codes alone where nothing could be tried: the recording shows too little of the marker then.
    weight : float
        Of the codes. It is 0 where they err more in the trials, since on the whole even a small
        weight does harm then.
    """
    if not coded.errors:
        return coded, 1.0
    both = grown(own, longer**OWN_LENGTH_POWER), grown(coded, longer**LENGTH_POWER)
    if both[1].error > both[0].error:
        return own, 0.0
    whole, weights = blended(both, PULL)
    return whole, float(weights[1])
