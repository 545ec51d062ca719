"""What is said about names, and why labels are proposed, for Qt Linguist."""

from mocapmend.translate import QT_TRANSLATE_NOOP

STEPS = (
    QT_TRANSLATE_NOOP("Sentences", "rename {0} to {1}"),
    QT_TRANSLATE_NOOP("Sentences", "exchange the names of {0} and {1}"),
    QT_TRANSLATE_NOOP("Sentences", "label {0} pieces"),
    QT_TRANSLATE_NOOP("Sentences", "label {0} as {1}, frames {2} to {3}"),
)
"""Names of undo steps."""

PROPOSED = (
    QT_TRANSLATE_NOOP("Sentences", "It has this name already."),
    QT_TRANSLATE_NOOP(
        "Sentences",
        "It has a name that the labelled recordings do not have, and is left alone.",
    ),
    QT_TRANSLATE_NOOP(
        "Sentences",
        "It is {0} mm from where the other markers put {1}; no other label fits nearly as well.",
    ),
    QT_TRANSLATE_NOOP("Sentences", "It is {0} mm from where the other markers put {1}, but {2}."),
    QT_TRANSLATE_NOOP(
        "Sentences",
        "Its distances to the other markers are those of {0}; no other label fits nearly as well.",
    ),
    QT_TRANSLATE_NOOP("Sentences", "Its distances to the other markers are those of {0}, but {1}."),
    QT_TRANSLATE_NOOP("Sentences", "it may as well be no marker at all"),
    QT_TRANSLATE_NOOP("Sentences", "{0} fits nearly as well"),
    QT_TRANSLATE_NOOP(
        "Sentences",
        "left and right can hardly be told apart: with {0} labels in each other's place, and {1} "
        "here, the body fits nearly as well",
    ),
    QT_TRANSLATE_NOOP(
        "Sentences", "by the shape of the body that was learned, it may be {0} throughout"
    ),
    QT_TRANSLATE_NOOP("Sentences", "the other pieces with this label fit better"),
    QT_TRANSLATE_NOOP(
        "Sentences", "Too few points are seen at once to tell which labels they are."
    ),
    QT_TRANSLATE_NOOP("Sentences", "It is where no label would be."),
    QT_TRANSLATE_NOOP("Sentences", "It is most like {0}, but other points fit that better."),
)
"""Why labels are proposed."""

REFUSED = (
    QT_TRANSLATE_NOOP("Sentences", "A marker needs a name."),
    QT_TRANSLATE_NOOP("Sentences", "Type one."),
    QT_TRANSLATE_NOOP("Sentences", "A name must not have line breaks or other control characters."),
    QT_TRANSLATE_NOOP(
        "Sentences",
        "This name is too long: it takes {0} bytes, and a C3D file has room for {1}.",
    ),
    QT_TRANSLATE_NOOP("Sentences", "The marker is not seen in the selected frames."),
    QT_TRANSLATE_NOOP(
        "Sentences", "The marker is not seen in this frame: go to one in which it is."
    ),
    QT_TRANSLATE_NOOP("Sentences", "The marker has this label already."),
    QT_TRANSLATE_NOOP("Sentences", "No point has this label, and this one has another."),
    QT_TRANSLATE_NOOP("Sentences", "Rename the marker, or choose a label that a point has."),
    QT_TRANSLATE_NOOP(
        "Sentences",
        "the recordings to learn from show {0} named markers; at least {1} are needed that are "
        "seen together",
    ),
    QT_TRANSLATE_NOOP(
        "Sentences",
        "{0} of {1} points have no label. “Label from recordings…” in the Edit menu finds out "
        "which markers they are.",
    ),
)
"""What cannot be done, and what could be."""

LABELS = (*STEPS, *PROPOSED, *REFUSED)
