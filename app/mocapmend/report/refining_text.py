"""What a report says of a recording whose markers a network has computed. English."""

from math import isnan

from mocapmend.refine.card import CAUTION, NEW_PEOPLE
from mocapmend.refine.judging import Judged
from mocapmend.report.refining import Refining
from mocapmend.report.tables import Column, Table
from mocapmend.wording import count

NONE_MEASURED = "All markers were computed from the joints of another recording; none was measured."
NO_REFERENCE = (
    "No reference recording was given: how far the markers are from where they really were is not "
    "known."
)
MEANINGS = (
    "Lp: mean square error of a coordinate relative to the pelvis or hips, after the best turn. "
    "Lb: of bone lengths, from their means in the reference. Ls: mean square second difference of "
    "a coordinate. All at 60 Hz."
)


def facts(done: Refining) -> tuple[tuple[str, str], ...]:
    """Return what is known of the making, each with its heading."""
    stride, cutoff = done.settings
    rows = [
        ("Network", done.network),
        ("For", done.profile),
        ("Stride", f"{stride} of windows of 120 frames at 60 Hz"),
        ("Output filter", f"zero-lag low-pass of {cutoff}" if cutoff else "none"),
        ("SHA-256 of the network", done.sha256),
    ]
    if done.calibrations:
        rows.append(
            ("Calibrated by", f"{count(done.calibrations, 'recording')} of the same person")
        )
    if done.judged is not None:
        frames = count(done.judged.refined.frames, "frame")
        rows.append(("Reference", f"{done.judged.reference}, {frames} at 60 Hz in common"))
        rows.append(("Lag of the reference", f"{1000 * done.judged.lag:+.0f} ms"))
    return tuple(rows)


def cautions(done: Refining) -> tuple[str, ...]:
    """Return what a reader must know."""
    return (NONE_MEASURED, CAUTION, NEW_PEOPLE, *((NO_REFERENCE,) if done.judged is None else ()))


def errors(judged: Judged) -> Table:
    """Return the table of Lp, Lb and Ls."""
    rows = [
        (name, f"{e.position:.0f}", f"{e.bones:.1f}", f"{e.smoothness:.3f}")
        for name, e in (("refined", judged.refined), ("reference itself", judged.truth))
    ]
    return Table(
        (
            Column("Recording", "name"),
            Column("Lp (mm²)"),
            Column("Lb (mm²)"),
            Column("Ls (mm²)"),
        ),
        tuple(rows),
        MEANINGS,
    )


def distances(judged: Judged) -> Table:
    """Return the table of the markers' distances from the reference."""
    rows = ((name, "–" if isnan(mm) else f"{mm:.1f}") for name, mm in judged.rms)
    return Table((Column("Marker", "name"), Column("RMS distance (mm)")), tuple(rows))


def sentence(done: Refining) -> str:
    """Return what the methods paragraph says."""
    stride, cutoff = done.settings
    text = (
        f"All of its markers had been computed from the joints of another recording by the neural "
        f"network “{done.network}” (stride {stride}, "
        f"{f'output filter of {cutoff}' if cutoff else 'no output filter'}); none was measured."
    )
    if done.judged is not None:
        text += (
            f" Against the reference {done.judged.reference} the mean square error was "
            f"{done.judged.refined.position:.0f} mm² per coordinate."
        )
    return text
