"""Smoothing methods and what is said about smoothing and other corrections, for Qt Linguist."""

from mocapmend.translate import QT_TRANSLATE_NOOP

SMOOTHERS = (
    QT_TRANSLATE_NOOP("Methods", "Butterworth, zero lag"),
    QT_TRANSLATE_NOOP(
        "Methods",
        "Takes away what is faster than a cut-off frequency, forwards and backwards so that "
        "nothing is delayed. The common choice of biomechanics; it rounds off impacts.",
    ),
    QT_TRANSLATE_NOOP("Methods", "Cut-off"),
    QT_TRANSLATE_NOOP(
        "Methods",
        "Motion faster than this is taken for noise: where the power is halved. Automatic: "
        "residual analysis.",
    ),
    QT_TRANSLATE_NOOP("Methods", "Choose for"),
    QT_TRANSLATE_NOOP(
        "Methods",
        "Automatic cut-off only: one for each axis of each marker, one for each marker, or "
        "one for all that is smoothed.",
    ),
    QT_TRANSLATE_NOOP("Methods", "axis"),
    QT_TRANSLATE_NOOP("Methods", "marker"),
    QT_TRANSLATE_NOOP("Methods", "all"),
    QT_TRANSLATE_NOOP("Methods", "Rule"),
    QT_TRANSLATE_NOOP(
        "Methods",
        "Automatic cut-off only. Least error: the cut-off with the least expected error, "
        "given the noise that residual analysis finds. Winter: where the residual equals the "
        "noise, which smooths more.",
    ),
    QT_TRANSLATE_NOOP("Methods", "least-error"),
    QT_TRANSLATE_NOOP("Methods", "winter"),
    QT_TRANSLATE_NOOP("Methods", "Order"),
    QT_TRANSLATE_NOOP(
        "Methods",
        "Of the filter that goes forwards and backwards, both ways together: an even number. "
        "Higher cuts more sharply and rings more beside impacts.",
    ),
    QT_TRANSLATE_NOOP("Methods", "Savitzky-Golay"),
    QT_TRANSLATE_NOOP(
        "Methods",
        "Fits a polynomial to a short stretch around each sample. Keeps the height of peaks "
        "better than most; what is faster than its window is not taken away completely.",
    ),
    QT_TRANSLATE_NOOP(
        "Methods",
        "How long the stretch is that a polynomial is fitted to, around each sample: the "
        "nearest odd number of frames. Automatic: the one with the best cross-validation "
        "score, up to half a second.",
    ),
    QT_TRANSLATE_NOOP(
        "Methods",
        "Of the polynomial. Higher follows impacts better and smooths less.",
    ),
    QT_TRANSLATE_NOOP(
        "Methods",
        "A quintic spline that smooths by as much as generalised cross-validation says, and "
        "less at impacts. Good where speeds and accelerations are wanted; jitter that lasts "
        "for several frames is taken for motion.",
    ),
    QT_TRANSLATE_NOOP(
        "Methods",
        "Motion faster than this is taken for noise: where the power is halved. Automatic: "
        "generalised cross-validation, or the measurement noise where it is given.",
    ),
    QT_TRANSLATE_NOOP(
        "Methods",
        "Standard deviation of a measured coordinate: about so much is smoothed away. "
        "Automatic: generalised cross-validation.",
    ),
    QT_TRANSLATE_NOOP("Methods", "Keep impacts"),
    QT_TRANSLATE_NOOP(
        "Methods",
        "Smooths less where the motion is much faster than elsewhere, as at a foot strike or "
        "a kick. Off: as much everywhere, as Woltring's program does.",
    ),
    QT_TRANSLATE_NOOP("Methods", "Kalman smoother"),
    QT_TRANSLATE_NOOP(
        "Methods",
        "Weighs each sample against what the motion around it lets expect. How fast the "
        "motion changes and how noisy the samples are is estimated from the samples.",
    ),
    QT_TRANSLATE_NOOP(
        "Methods",
        "What is carried from frame to frame: the velocity, or the acceleration too, which "
        "makes a smoother curve and rounds off more of an impact.",
    ),
    QT_TRANSLATE_NOOP("Methods", "velocity"),
    QT_TRANSLATE_NOOP("Methods", "acceleration"),
    QT_TRANSLATE_NOOP(
        "Methods",
        "Standard deviation of a measured coordinate. Automatic: estimated together with how "
        "fast the motion changes.",
    ),
)
"""Those that the table of the filling methods has too are listed there."""

SMOOTHING = (
    QT_TRANSLATE_NOOP("Sentences", "smooth {0} markers ({1})"),
    QT_TRANSLATE_NOOP("Sentences", "smooth {0} ({1})"),
    QT_TRANSLATE_NOOP("Sentences", "take smoothing off {0} markers"),
    QT_TRANSLATE_NOOP("Sentences", "take smoothing off {0}"),
    QT_TRANSLATE_NOOP("Sentences", "replay the smoothing of {0}"),
    QT_TRANSLATE_NOOP("Sentences", "There are no samples."),
    QT_TRANSLATE_NOOP("Sentences", "Only {0} on end: this needs at least {1}."),
    QT_TRANSLATE_NOOP("Sentences", "1 sample"),
    QT_TRANSLATE_NOOP("Sentences", "{0} samples"),
    QT_TRANSLATE_NOOP("Sentences", "This cannot be smoothed: {0}."),
    QT_TRANSLATE_NOOP("Sentences", "Choose other parameters, or another method."),
    QT_TRANSLATE_NOOP("Sentences", "order must be an even number from 2, not {0}"),
    QT_TRANSLATE_NOOP(
        "Sentences",
        "cutoff_hz must be above 0 and below half the frame rate, {0} Hz, not {1}",
    ),
    QT_TRANSLATE_NOOP(
        "Sentences",
        "cutoff_hz must be from {0} Hz to below half the frame rate, {1} Hz, not {2}",
    ),
    QT_TRANSLATE_NOOP(
        "Sentences",
        "give cutoff_hz or noise_mm, not both: each says how much to smooth",
    ),
    QT_TRANSLATE_NOOP("Sentences", "noise_mm must be above 0 mm, not {0}"),
    QT_TRANSLATE_NOOP("Sentences", "order must be at least 1, not {0}"),
    QT_TRANSLATE_NOOP(
        "Sentences",
        "window_ms must be at least {0} ms at {1} Hz: order {2} needs {3} frames, and {4} ms "
        "are {5}",
    ),
)
