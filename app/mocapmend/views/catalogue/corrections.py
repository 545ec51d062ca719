"""What is said of bad samples and of corrections, for Qt Linguist."""

from mocapmend.translate import QT_TRANSLATE_NOOP

STEPS = (
    QT_TRANSLATE_NOOP("Sentences", "fix {0} ({1})"),
    QT_TRANSLATE_NOOP("Sentences", "fix {0} problems ({1})"),
    QT_TRANSLATE_NOOP("Sentences", "fix {0} problems"),
    QT_TRANSLATE_NOOP("Sentences", "set {0} samples of {1} aside"),
    QT_TRANSLATE_NOOP("Sentences", "believe {0} samples of {1} again"),
    QT_TRANSLATE_NOOP("Sentences", "exchange {0}"),
    QT_TRANSLATE_NOOP("Sentences", "correct as in {0}"),
    QT_TRANSLATE_NOOP("Sentences", "fill {0} gaps again"),
    QT_TRANSLATE_NOOP("Sentences", "{0} markers"),
)
"""Names of undo steps."""

FOUND = (
    QT_TRANSLATE_NOOP("Sentences", "It was set aside by hand."),
    QT_TRANSLATE_NOOP("Sentences", "It belongs to none of the labels."),
    QT_TRANSLATE_NOOP("Sentences", "1 frame"),
    QT_TRANSLATE_NOOP("Sentences", "{0} frames"),
    QT_TRANSLATE_NOOP(
        "Sentences",
        "For {0} it is {1} mm from where the frames before and after lead, {2} times the noise "
        "there.",
    ),
    QT_TRANSLATE_NOOP(
        "Sentences",
        "For 1 frame {0} and {1}, {2} mm apart, each continue the other's trajectory.",
    ),
    QT_TRANSLATE_NOOP(
        "Sentences",
        "For {0} frames {1} and {2}, {3} mm apart, each continue the other's trajectory.",
    ),
    QT_TRANSLATE_NOOP(
        "Sentences",
        "For {0} its distances to its neighbours differ by {1} mm from what they are otherwise.",
    ),
    QT_TRANSLATE_NOOP(
        "Sentences",
        "For {0} it is {1} mm from the middle of the body, where it is {2} mm otherwise.",
    ),
    QT_TRANSLATE_NOOP(
        "Sentences",
        "For {0} it is in the same place as {1}, from which it is {2} mm away otherwise.",
    ),
    QT_TRANSLATE_NOOP(
        "Sentences",
        "The sample after a gap bends away from the trajectory, by up to {0} mm.",
    ),
    QT_TRANSLATE_NOOP(
        "Sentences",
        "The sample before a gap bends away from the trajectory, by up to {0} mm.",
    ),
    QT_TRANSLATE_NOOP(
        "Sentences",
        "The {0} samples after a gap bend away from the trajectory, by up to {1} mm.",
    ),
    QT_TRANSLATE_NOOP(
        "Sentences",
        "The {0} samples before a gap bend away from the trajectory, by up to {1} mm.",
    ),
    QT_TRANSLATE_NOOP(
        "Sentences",
        "It jumps {0} mm, and then the same coordinates are repeated {1} times.",
    ),
    QT_TRANSLATE_NOOP(
        "Sentences",
        "The same coordinates are repeated {0}, and then it is {1} mm away.",
    ),
    QT_TRANSLATE_NOOP(
        "Sentences",
        "The same coordinates are repeated {0}, while it has moved by {1} mm.",
    ),
    QT_TRANSLATE_NOOP("Sentences", "once"),
    QT_TRANSLATE_NOOP("Sentences", "{0} times"),
    QT_TRANSLATE_NOOP("Sentences", "It is seen for {0} and {1}."),
    QT_TRANSLATE_NOOP("Sentences", "no marker is missing there that it could be"),
    QT_TRANSLATE_NOOP(
        "Sentences",
        "fits no marker: {0} comes nearest, off by {1} times the usual",
    ),
    QT_TRANSLATE_NOOP("Sentences", "may be {0} or {1}: it fits both about as well"),
    QT_TRANSLATE_NOOP(
        "Sentences",
        "For {0} it fits into a gap of {1}: it is off by {2} times what is usual, no other is "
        "missing.",
    ),
    QT_TRANSLATE_NOOP(
        "Sentences",
        "For {0} it fits into a gap of {1}: it is off by {2} times what is usual, the next marker "
        "by {3}.",
    ),
)
"""Why samples are held for bad."""

CHECKED = (
    QT_TRANSLATE_NOOP(
        "Sentences",
        "{0} measured sample were set aside, or are no longer; the repair record lists them.",
    ),
    QT_TRANSLATE_NOOP(
        "Sentences",
        "{0} measured samples were set aside, or are no longer; the repair record lists them.",
    ),
    QT_TRANSLATE_NOOP(
        "Sentences",
        "{0} measured sample were smoothed; the repair record lists them.",
    ),
    QT_TRANSLATE_NOOP(
        "Sentences",
        "{0} measured samples were smoothed; the repair record lists them.",
    ),
    QT_TRANSLATE_NOOP(
        "Sentences",
        "{0} sample changed places between markers; the repair record lists them.",
    ),
    QT_TRANSLATE_NOOP(
        "Sentences",
        "{0} samples changed places between markers; the repair record lists them.",
    ),
    QT_TRANSLATE_NOOP("Sentences", "{0} is called {1}; the repair record lists it."),
    QT_TRANSLATE_NOOP("Sentences", "{0} is called {1} and {2} more; the repair record lists it."),
    QT_TRANSLATE_NOOP(
        "Sentences",
        "Marker {0}: {1} set aside were not measured as the repair record says, the first at "
        "frame {2}.",
    ),
    QT_TRANSLATE_NOOP(
        "Sentences",
        "The repair record lists exchanges that contradict each other.",
    ),
    QT_TRANSLATE_NOOP(
        "Sentences",
        "{0} of {1} runs that the repair record sets aside are not in the file any more; their "
        "samples are taken as they are.",
    ),
    QT_TRANSLATE_NOOP(
        "Sentences",
        "{0} of {1} exchanged runs of the repair record are not in the file any more; their "
        "samples are taken as they are.",
    ),
    QT_TRANSLATE_NOOP(
        "Sentences",
        "{0} of {1} smoothed runs of the repair record are not in the file any more; their "
        "samples are taken as they are.",
    ),
    QT_TRANSLATE_NOOP(
        "Sentences",
        "{0} of {1} new names of the repair record are not in the file any more.",
    ),
    QT_TRANSLATE_NOOP(
        "Sentences",
        "The parameters of this file have no room for the label {0}.",
    ),
    QT_TRANSLATE_NOOP("Sentences", "Choose shorter labels, or save it as another format."),
)
"""What files and their checks say of corrections."""

CORRECTIONS = (*STEPS, *FOUND, *CHECKED)
