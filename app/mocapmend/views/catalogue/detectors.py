"""What the table of detectors has to read, for Qt Linguist."""

from mocapmend.translate import QT_TRANSLATE_NOOP

DETECTORS = (
    QT_TRANSLATE_NOOP("Detectors", "Spikes"),
    QT_TRANSLATE_NOOP("Detectors", "Swapped labels"),
    QT_TRANSLATE_NOOP("Detectors", "Fragments and ghosts"),
    QT_TRANSLATE_NOOP("Detectors", "Ragged ends"),
    QT_TRANSLATE_NOOP("Detectors", "Frozen samples"),
    QT_TRANSLATE_NOOP("Detectors", "Broken bones"),
    QT_TRANSLATE_NOOP("Detectors", "Far from the body"),
    QT_TRANSLATE_NOOP("Detectors", "Coinciding points"),
    QT_TRANSLATE_NOOP(
        "Detectors",
        "Samples that leave the trajectory for one or a few frames and come back. Fast motion "
        "is told apart by the frames on both sides and by the neighbouring markers.",
    ),
    QT_TRANSLATE_NOOP(
        "Detectors",
        "Two markers that carry each other's label for some time, also where a gap or the end "
        "of the recording hides where it begins or ends. Labels that are swapped throughout "
        "cannot be found.",
    ),
    QT_TRANSLATE_NOOP(
        "Detectors",
        "Points without a label, and labels that come twice, that are pieces of a marker's "
        "trajectory. Those that fit no marker are listed as ghosts.",
    ),
    QT_TRANSLATE_NOOP(
        "Detectors",
        "Samples just before or after a gap that bend away from the trajectory, as those of a "
        "marker that is half hidden.",
    ),
    QT_TRANSLATE_NOOP(
        "Detectors",
        "Samples that repeat the one before exactly while the marker goes on moving. Files in "
        "which repeats are usual, as up-sampled ones, are left alone.",
    ),
    QT_TRANSLATE_NOOP(
        "Detectors",
        "Markers that for some frames are at another distance from their neighbours than "
        "otherwise, and go there or come back in a jump.",
    ),
    QT_TRANSLATE_NOOP(
        "Detectors",
        "Points much further from the body than its markers are, and than they usually are.",
    ),
    QT_TRANSLATE_NOOP(
        "Detectors",
        "Two points in the same place that are apart otherwise: one is a reflection, or was "
        "labelled twice.",
    ),
)
