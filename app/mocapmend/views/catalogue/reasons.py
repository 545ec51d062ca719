"""Names of edits, and why gaps stay open or methods refuse, for Qt Linguist."""

from mocapmend.translate import QT_TRANSLATE_NOOP

USUAL = (
    QT_TRANSLATE_NOOP("Sentences", "the marker is hidden throughout"),
    QT_TRANSLATE_NOOP("Sentences", "the marker fell off"),
    QT_TRANSLATE_NOOP("Sentences", "the marker has moved on the body"),
    QT_TRANSLATE_NOOP("Sentences", "it is too long to trust a repair"),
    QT_TRANSLATE_NOOP("Sentences", "too few markers around it are seen"),
    QT_TRANSLATE_NOOP("Sentences", "it is not needed for the analysis"),
)
"""Why users keep gaps open."""

REASONS = (
    QT_TRANSLATE_NOOP("Sentences", "fill {0} gaps ({1})"),
    QT_TRANSLATE_NOOP("Sentences", "fill {0} ({1})"),
    QT_TRANSLATE_NOOP("Sentences", "clear the repair of {0}"),
    QT_TRANSLATE_NOOP("Sentences", "leave a gap of {0} open"),
    QT_TRANSLATE_NOOP("Sentences", "take up a gap of {0} again"),
    QT_TRANSLATE_NOOP("Sentences", "say why a gap of {0} stays open"),
    QT_TRANSLATE_NOOP("Sentences", "say why {0} gaps stay open"),
    QT_TRANSLATE_NOOP("Sentences", "never fill {0} gaps"),
    QT_TRANSLATE_NOOP("Sentences", "allow to fill {0} gaps"),
    QT_TRANSLATE_NOOP("Sentences", "move the ends of a gap of {0}"),
    QT_TRANSLATE_NOOP("Sentences", "replay {0}"),
    QT_TRANSLATE_NOOP("Sentences", "left open by hand"),
    *USUAL,
    QT_TRANSLATE_NOOP("Sentences", "it is marked as never to be filled"),
    QT_TRANSLATE_NOOP("Sentences", "the preview was cancelled"),
    QT_TRANSLATE_NOOP("Sentences", "the preview failed"),
    QT_TRANSLATE_NOOP("Sentences", "the expected error of {0} is above the limit of {1}"),
    QT_TRANSLATE_NOOP("Sentences", "the expected error of {0} is above the default limit of {1}"),
    QT_TRANSLATE_NOOP(
        "Sentences",
        "its error could not be estimated: there is nothing like it to test this method on",
    ),
    QT_TRANSLATE_NOOP(
        "Sentences",
        "its error could not be estimated, and {0} is longer than the {1} allowed in that case",
    ),
    QT_TRANSLATE_NOOP("Sentences", "{0} is longer than the limit of {1}"),
    QT_TRANSLATE_NOOP("Sentences", "{0} is longer than the default limit of {1}"),
    QT_TRANSLATE_NOOP("Sentences", "1 frame ({0} ms)"),
    QT_TRANSLATE_NOOP("Sentences", "{0} frames ({1} ms)"),
    QT_TRANSLATE_NOOP("Sentences", "the marker is never seen in this recording"),
    QT_TRANSLATE_NOOP(
        "Sentences",
        "the marker is never seen after frame {0}: this method needs both sides",
    ),
    QT_TRANSLATE_NOOP(
        "Sentences",
        "the marker is never seen before frame {0}: this method needs both sides",
    ),
    QT_TRANSLATE_NOOP("Sentences", "a constant needs {0} samples, and the marker has only {1}"),
    QT_TRANSLATE_NOOP(
        "Sentences",
        "a straight line needs {0} samples, and the marker has only {1}",
    ),
    QT_TRANSLATE_NOOP("Sentences", "a cubic curve needs {0} samples, and the marker has only {1}"),
    QT_TRANSLATE_NOOP("Sentences", "a curve needs {0} samples, and the marker has only {1}"),
    QT_TRANSLATE_NOOP(
        "Sentences",
        "a quintic curve needs {0} samples, and the marker has only {1}",
    ),
    QT_TRANSLATE_NOOP("Sentences", "the filter needs {0} samples, and the marker has only {1}"),
    QT_TRANSLATE_NOOP(
        "Sentences",
        "the filter needs {0} samples before the gap, and the marker has only {1}",
    ),
    QT_TRANSLATE_NOOP(
        "Sentences",
        "the motion is not periodic: it does not repeat itself closely enough",
    ),
    QT_TRANSLATE_NOOP(
        "Sentences",
        "no other cycle of {0} s has this marker in all frames that are missing here",
    ),
    QT_TRANSLATE_NOOP(
        "Sentences",
        "the gap lies at the beginning of the recording, and such gaps are to be left open",
    ),
    QT_TRANSLATE_NOOP(
        "Sentences",
        "the gap lies at the end of the recording, and such gaps are to be left open",
    ),
    QT_TRANSLATE_NOOP(
        "Sentences",
        "it is at the start or the end of the recording, where gaps are to be left open",
    ),
    QT_TRANSLATE_NOOP(
        "Sentences",
        "it is at the beginning or the end, and no other marker is seen throughout",
    ),
    QT_TRANSLATE_NOOP(
        "Sentences",
        "only {0} frames show the marker and those that predict it: this method needs {1}",
    ),
    QT_TRANSLATE_NOOP(
        "Sentences",
        "only {0} frames show the marker and those that predict it: this method needs {1} in a row",
    ),
    QT_TRANSLATE_NOOP(
        "Sentences",
        "of the other markers, {0} have no gap at all: this method needs {1}",
    ),
    QT_TRANSLATE_NOOP(
        "Sentences",
        "of the other markers, {0} are seen throughout the gap: this method needs {1}",
    ),
    QT_TRANSLATE_NOOP(
        "Sentences",
        "fewer than {0} other markers that are seen often enough are there in most of the "
        "gap: this method has too little to tell the posture by",
    ),
    QT_TRANSLATE_NOOP(
        "Sentences",
        "fewer than {0} other markers that are seen often enough are there: this method has "
        "too little to tell the posture by",
    ),
    QT_TRANSLATE_NOOP(
        "Sentences",
        "fewer than {0} other markers that are seen often enough are there in some of the "
        "gap: this method has too little to tell the pose by",
    ),
    QT_TRANSLATE_NOOP(
        "Sentences",
        "this method needs {0} stretches that show the marker and those that predict it, and has "
        "{1}",
    ),
    QT_TRANSLATE_NOOP("Sentences", "the recording is too short for the windows of this method"),
    QT_TRANSLATE_NOOP("Sentences", "there is no marker {0} to take as a donor"),
    QT_TRANSLATE_NOOP("Sentences", "{0} markers are called {1}: it cannot be a donor"),
    QT_TRANSLATE_NOOP("Sentences", "{0} cannot be its own donor"),
    QT_TRANSLATE_NOOP("Sentences", "the donor {0} is missing in the gap too"),
    QT_TRANSLATE_NOOP("Sentences", "the donor {0} is missing at an edge of the gap"),
    QT_TRANSLATE_NOOP("Sentences", "it takes {0} donors and was given {1}"),
    QT_TRANSLATE_NOOP(
        "Sentences",
        "no marker is seen throughout the gap and at its edges, and it takes {0}",
    ),
    QT_TRANSLATE_NOOP(
        "Sentences",
        "only {0} of the markers are seen throughout the gap and at its edges, and it takes {1}",
    ),
    QT_TRANSLATE_NOOP("Sentences", "the marker and its donor {0} are hardly ever seen together"),
    QT_TRANSLATE_NOOP("Sentences", "the marker and its donors are hardly ever seen together"),
    QT_TRANSLATE_NOOP("Sentences", "the training set does not have this marker"),
    QT_TRANSLATE_NOOP("Sentences", "the training set has no such marker"),
    QT_TRANSLATE_NOOP("Sentences", "no marker of the training set is seen all through the gap"),
    QT_TRANSLATE_NOOP(
        "Sentences",
        "Trained dictionaries come with a training set, and none is given.",
    ),
    QT_TRANSLATE_NOOP(
        "Sentences",
        "The dictionaries were trained at {0} Hz, and this recording has {1}.",
    ),
    QT_TRANSLATE_NOOP(
        "Sentences",
        "The training set is of other markers: {0} of its {1} are not in this recording ({2}).",
    ),
    QT_TRANSLATE_NOOP(
        "Sentences",
        "The recording has more than one marker {0}: a training set is for one subject.",
    ),
    QT_TRANSLATE_NOOP("Sentences", "This is not a file."),
    QT_TRANSLATE_NOOP("Sentences", "There is no such training set."),
    QT_TRANSLATE_NOOP("Sentences", "This training set may not be read."),
    QT_TRANSLATE_NOOP("Sentences", "This is not a training set of mocapmend, or it is damaged."),
    QT_TRANSLATE_NOOP("Sentences", "The training set would grow beyond what is believable."),
    QT_TRANSLATE_NOOP("Sentences", "The head of the training set is too long."),
    QT_TRANSLATE_NOOP("Sentences", "The training set has {0} in “{1}”, not float32."),
    QT_TRANSLATE_NOOP("Sentences", "The training set has format {0}, not {1}."),
    QT_TRANSLATE_NOOP("Sentences", "The training set says that {0} points up."),
    QT_TRANSLATE_NOOP(
        "Sentences",
        "The training set contradicts itself: its frames are not as listed.",
    ),
    QT_TRANSLATE_NOOP("Sentences", "The training set has a dictionary that is no table."),
    QT_TRANSLATE_NOOP("Sentences", "The training set has values that are no numbers."),
    QT_TRANSLATE_NOOP("Sentences", "The training set has no trained dictionaries of all parts."),
    QT_TRANSLATE_NOOP("Sentences", "Choose a file that “mocapmend train sparse” has written."),
    QT_TRANSLATE_NOOP(
        "Sentences",
        "Choose a file that “mocapmend train sparse” has written, or one that ships with the "
        "program: {0}.",
    ),
)
