"""The methods that `bench paper` compares, each as a function from a case to places."""

import time
from collections.abc import Callable, Mapping
from dataclasses import dataclass, replace
from functools import partial

import numpy as np

from mocapmend.bench.paper.trials import Case
from mocapmend_algorithms import no_progress
from mocapmend_algorithms.arrays import FloatArray
from mocapmend_algorithms.fill import auto, bone_dictionary, registry, smbs
from mocapmend_algorithms.fill.coded_motion import CodedMotion
from mocapmend_algorithms.fill.contract import FillResult
from mocapmend_algorithms.fill.edges import Modelled, meet_edges
from mocapmend_algorithms.fill.motion_codes import window_span
from mocapmend_algorithms.skeleton.projection import project_bones
from mocapmend_algorithms.sparse import part_codes
from mocapmend_algorithms.sparse.bone_space import with_lengths
from mocapmend_algorithms.sparse.examples import Motion, View, choose_places, reference_pose
from mocapmend_algorithms.sparse.part_rows import PartDictionary
from mocapmend_algorithms.sparse.recovery import Recovery
from mocapmend_algorithms.sparse.rows import Rows

Find = Callable[[Case], FloatArray]
"""Returns places in cm, shape (frames of the gap, lost, 3)."""
MOST_WINDOWS = 6000
BEST_MS = bone_dictionary.WINDOW_TRAINED_MS
POSES = 200


@dataclass(frozen=True)
class Rival:
    """A method of the table.

    Attributes
    ----------
    name : str
        In the table.
    settings : mapping of str to Find
        What is tried on the validation trials: three of each, or the one that there is.
    chosen : str
        The setting that erred least there.
    """

    name: str
    settings: Mapping[str, Find]
    chosen: str

    @property
    def find(self) -> Find:
        """The chosen setting."""
        return self.settings[self.chosen]


def project(case: Case, found: FloatArray) -> FloatArray:
    """Move what was found so that bones keep the lengths that are measured on what is left."""
    points = case.recording.points[case.start : case.stop].copy()
    points[:, case.lost] = found
    bones = case.body.constraints(case.lost, case.recording.mm)
    return project_bones(points, case.lost, bones)


def teachers(case: Case) -> list[Motion]:
    """Return the training motions with the case's bone lengths, in mm."""
    lengths = case.body.edge_lengths
    motions = []
    for recording in case.trial.teachers:
        points = with_lengths(recording.points * recording.mm, case.body, lengths)
        motions.append(Motion(points, np.ones(points.shape[:2], dtype=np.bool_)))
    return motions


def by_method(method_id: str, **params: str) -> Find:
    """Fill with a method of the program that learns from the recording alone."""
    method = registry.method(method_id)
    values = registry.parse_params(method, params)
    return lambda case: _values(
        case, method.function(case.recording, case.gaps, values, no_progress)
    )


def by_auto() -> Find:
    """Fill with `auto` and the training trials."""
    params, codes = auto.AutoParams(), bone_dictionary.BoneDictionaryParams()

    def find(case: Case) -> FloatArray:
        coded = CodedMotion(
            case.recording, case.recording.present, codes, case.body, teachers(case)
        )
        return _values(case, auto.fill_coded(case.recording, case.gaps, params, coded, no_progress))

    return find


def by_bones(params: bone_dictionary.BoneDictionaryParams) -> Find:
    """Fill with `bone-dictionary` and the training trials, without self-tests."""
    return _by_codes(partial(bone_dictionary.fill_bare, params=params))


def by_smbs(params: smbs.SmbsParams) -> Find:
    """Fill with `smbs` and the training trials, without self-tests."""
    return _by_codes(partial(smbs.fill_bare, params=params))


def _by_codes(fill: Callable[..., FillResult]) -> Find:
    return lambda case: _values(
        case,
        fill(
            case.recording,
            case.recording.present,
            case.gaps,
            no_progress,
            body=case.body,
            others=teachers(case),
        ),
    )


def speed_of_bones(case: Case) -> tuple[float, float]:
    """Return the seconds that the best setting of W18 takes to learn, and to recover a case.

    It learns once for each set of missing markers.
    """
    recording = case.recording
    own = Motion(recording.points * recording.mm, recording.present)
    helpers = np.setdiff1d(np.arange(recording.markers), case.lost)
    others = teachers(case)
    began = time.perf_counter()
    recovery = Recovery(
        own,
        others,
        Rows.along_bones(case.body, helpers, case.lost),
        window_span(recording, BEST_MS),
        recording.up,
        bone_dictionary.BoneDictionaryParams().codes(others, guided=True),
        no_progress,
    )
    learned = time.perf_counter()
    recovery.ask(case.start - 1, case.stop + 1, no_progress)
    return learned - began, time.perf_counter() - learned


def by_parts(dictionaries: Callable[[Case], Mapping[int, PartDictionary]]) -> Find:
    """Fill with the trained dictionaries of the five parts, as printed in W18."""

    def find(case: Case) -> FloatArray:
        recording, mm = case.recording, case.recording.mm
        found = part_codes.recover(
            recording.points * mm, recording.present, case.body, dictionaries(case), no_progress
        )
        return found[case.start : case.stop][:, case.lost] / mm

    return find


def by_ridge(weight: float, window_ms: float, *, as_printed: bool) -> Find:
    """Regress the lost differences on the known ones, window by window.

    As printed, the known rows are the bones whose ends are seen, and the edges of the gap are not
    met; otherwise all is as in `bone-dictionary`, the regression apart.
    """

    def find(case: Case) -> FloatArray:
        recording = case.recording
        span = window_span(recording, window_ms)
        own = Motion(recording.points * recording.mm, recording.present)
        everyone = np.arange(recording.markers)
        rows = Rows.along_bones(case.body, np.setdiff1d(everyone, case.lost), case.lost)
        if as_printed:
            edges = case.body.edges
            rows = replace(rows, known=edges[~np.isin(edges, case.lost).any(axis=1)])
        chosen = choose_places(own, teachers(case), everyone, span, MOST_WINDOWS)
        view = View(
            rows,
            span,
            recording.up,
            reference_pose(chosen, rows.helpers, span, recording.up, POSES),
        )
        regress = _ridge(*view.both(chosen), weight)
        start, stop = case.start - 1, case.stop + 1
        places = span.touching(start, stop, recording.frames)
        asked, angles = view.known(own, places)
        told = span.average(view.told(regress(asked), angles), places, start, stop)
        found = rows.places(told, own.points[start:stop]) / recording.mm
        return found[1:-1] if as_printed else _met(case, found)

    return find


def _ridge(
    known: FloatArray, lost: FloatArray, weight: float
) -> Callable[[FloatArray], FloatArray]:
    mean, level = known.mean(axis=0), lost.mean(axis=0)
    gram = (known - mean).T @ (known - mean)
    gram[np.diag_indices_from(gram)] += weight * np.trace(gram) / len(gram)
    slopes = np.linalg.solve(gram, (known - mean).T @ (lost - level))
    return lambda asked: (asked - mean) @ slopes + level


def _met(case: Case, found: FloatArray) -> FloatArray:
    """Carry what is left over at the edges into the gap, as `bone-dictionary` does."""
    said = {gap: Modelled(found[:, at], {}) for at, gap in enumerate(case.gaps)}
    params = bone_dictionary.BoneDictionaryParams()
    return _values(
        case,
        meet_edges(
            case.recording,
            case.recording.present,
            case.gaps,
            said,
            params,
            bone_dictionary.FADE_S,
        ),
    )


def _values(case: Case, result: FillResult) -> FloatArray:
    found = np.full((case.stop - case.start, case.lost.size, 3), np.nan)
    where = {marker: at for at, marker in enumerate(case.lost.tolist())}
    for patch in result.patches:
        found[:, where[patch.gap.marker]] = patch.values
    return found


def rivals(dictionaries: Callable[[Case], Mapping[int, PartDictionary]]) -> list[Rival]:
    """Return the methods of the table.

    Parameters
    ----------
    dictionaries : callable
        Returns the trained dictionaries for a case; called when they are needed.
    """
    bones, motion_bases = bone_dictionary.BoneDictionaryParams, smbs.SmbsParams
    weights = (1e-3, 1e-2, 1e-1)
    return [
        Rival("spline", {"cubic": by_method("cubic")}, "cubic"),
        Rival(
            "Kalman",
            {
                f"noise {noise} mm": by_method("kalman", noise_mm=noise)
                for noise in ("auto", "1", "5")
            },
            "noise auto mm",
        ),
        Rival(
            "ridge, W18's windows",
            {f"weight {w:g}": by_ridge(w, 0.0, as_printed=True) for w in weights},
            "weight 0.01",
        ),
        Rival(
            "ridge, best's windows",
            {f"weight {w:g}": by_ridge(w, BEST_MS, as_printed=False) for w in weights},
            "weight 0.01",
        ),
        Rival(
            "local-frame",
            {f"penalty {p}": by_method("local-frame", penalty=p) for p in ("1e-5", "1e-4", "1e-3")},
            "penalty 1e-3",
        ),
        Rival("auto", {"default": by_method("auto")}, "default"),
        Rival("auto, the trials given", {"default": by_auto()}, "default"),
        Rival(
            "TSMC, plain",
            {
                "threshold 0.003 %": by_method(
                    "tsmc",
                    weight_scale_mm="10000",
                    missing_weight="1",
                    meet_edges="false",
                    around_s="600",
                ),
            },
            "threshold 0.003 %",
        ),
        Rival(
            "TSMC",
            {
                f"threshold {t} %": by_method("tsmc", threshold=t)
                for t in ("0.001", "0.003", "0.03")
            },
            "threshold 0.003 %",
        ),
        Rival(
            "SMBS",
            {
                "whole body, penalty 0.01": by_smbs(motion_bases(penalty=0.01, parts=False)),
                "parts, penalty 0.01": by_smbs(motion_bases(penalty=0.01)),
                "whole body, penalty 0.1": by_smbs(motion_bases(penalty=0.1, parts=False)),
            },
            "whole body, penalty 0.01",
        ),
        Rival("W18, as printed", {"lambda 1e-4, 0.4": by_parts(dictionaries)}, "lambda 1e-4, 0.4"),
        Rival(
            "W18, best",
            {f"window {ms} ms": by_bones(bones(window_ms=float(ms))) for ms in (150, 330, 600)},
            "window 600 ms",
        ),
    ]


def before_projection() -> Find:
    """Return the best setting of W18 without its bone projection."""
    return by_bones(bone_dictionary.BoneDictionaryParams(keep_bones=False))
