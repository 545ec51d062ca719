"""What is said of networks and of what they refine, for Qt Linguist."""

from mocapmend.translate import QT_TRANSLATE_NOOP

REFINING = (
    QT_TRANSLATE_NOOP("Sentences", "Kinect, 22 joints, to Plug-in Gait, 39 markers"),
    QT_TRANSLATE_NOOP("Sentences", "Kinect v2, 25 joints, to Axis Neuron, 59 joints"),
    QT_TRANSLATE_NOOP(
        "Sentences",
        "What a network computes is an estimate, not a measurement. It was trained on the people "
        "and movements that its card names; of other movements it knows nothing.",
    ),
    QT_TRANSLATE_NOOP(
        "Sentences",
        "For a person whom it has not seen, expect no more than from smoothing and regression: see "
        "the figures for new people on its card, if there are some. Paired recordings of that "
        "person to calibrate with, one of each movement, take much of the error away.",
    ),
    QT_TRANSLATE_NOOP("Sentences", "Measured on pairs held out ({0}):"),
    QT_TRANSLATE_NOOP(
        "Sentences", "Measured after the same training without some people ({0}; pairs: {1}):"
    ),
    QT_TRANSLATE_NOOP(
        "Sentences",
        "All markers were computed from the joints of another recording; none was measured.",
    ),
    QT_TRANSLATE_NOOP(
        "Sentences",
        "All markers were computed by the network “{0}” from the joints of another recording; none "
        "was measured.",
    ),
    QT_TRANSLATE_NOOP(
        "Sentences",
        "No reference recording was given: how far the markers are from where they really were is "
        "not known.",
    ),
    QT_TRANSLATE_NOOP(
        "Sentences",
        "Lp: mean square error of a coordinate relative to the pelvis or hips, after the best "
        "turn. Lb: of bone lengths, from their means in the reference. Ls: mean square second "
        "difference of a coordinate. All at 60 Hz.",
    ),
    QT_TRANSLATE_NOOP(
        "Sentences",
        "{0} pairs of recordings of {1} people and {2} movements, {3} frames at 60 Hz",
    ),
    QT_TRANSLATE_NOOP(
        "Sentences", "{0} stacked bidirectional recurrent autoencoders of width {1}; {2} weights"
    ),
    QT_TRANSLATE_NOOP(
        "Sentences",
        "{0} stacked bidirectional recurrent autoencoders of width {1}, a linear skip; {2} weights",
    ),
    QT_TRANSLATE_NOOP(
        "Sentences",
        "{0} stacked bidirectional recurrent autoencoders of width {1}, a perceptual autoencoder; "
        "{2} weights",
    ),
    QT_TRANSLATE_NOOP(
        "Sentences",
        "{0} stacked bidirectional recurrent autoencoders of width {1}, a linear skip, a "
        "perceptual autoencoder; {2} weights",
    ),
)

REFUSED = (
    QT_TRANSLATE_NOOP("Sentences", "This recording has no markers to compare with."),
    QT_TRANSLATE_NOOP("Sentences", "These joints are never seen: {0}."),
    QT_TRANSLATE_NOOP(
        "Sentences",
        "The network is for other points ({0}): {1} of {2} are not in this recording ({3}).",
    ),
    QT_TRANSLATE_NOOP("Sentences", "The recording has more than one {0}."),
    QT_TRANSLATE_NOOP("Sentences", "The recording has fewer than two frames."),
    QT_TRANSLATE_NOOP("Sentences", "The reference has fewer than two frames."),
    QT_TRANSLATE_NOOP(
        "Sentences", "Recording and reference have less than half a second in common."
    ),
    QT_TRANSLATE_NOOP("Sentences", "The recording is too long: {0} s of at most {1} s."),
    QT_TRANSLATE_NOOP("Sentences", "{0} is impossibly far from the root: more than {1} m."),
    QT_TRANSLATE_NOOP("Sentences", "Choose another network or recording."),
    QT_TRANSLATE_NOOP("Sentences", "Put the recording right first, or choose another one."),
    QT_TRANSLATE_NOOP(
        "Sentences",
        "Its joints are those of the profile {0}: train a network for it with “mocapmend train "
        "refine”, or choose one.",
    ),
    QT_TRANSLATE_NOOP("Sentences", "Leave this calibration out."),
    QT_TRANSLATE_NOOP("Sentences", "A recording cannot calibrate itself."),
    QT_TRANSLATE_NOOP("Sentences", "Choose another recording of the same person."),
    QT_TRANSLATE_NOOP("Sentences", "Choose another reference."),
    QT_TRANSLATE_NOOP("Sentences", "These pairs are for the profile {0}."),
    QT_TRANSLATE_NOOP("Sentences", "Choose that one."),
    QT_TRANSLATE_NOOP("Sentences", "Choose another file."),
    QT_TRANSLATE_NOOP("Sentences", "There is no such model."),
    QT_TRANSLATE_NOOP("Sentences", "This model may not be read."),
    QT_TRANSLATE_NOOP("Sentences", "This is not a model of mocapmend, or it is damaged."),
    QT_TRANSLATE_NOOP("Sentences", "The model is too large."),
    QT_TRANSLATE_NOOP("Sentences", "The head of the model is too long."),
    QT_TRANSLATE_NOOP("Sentences", "The model has format {0}, not {1}."),
    QT_TRANSLATE_NOOP(
        "Sentences", "The model contradicts itself: its network is not for its profile."
    ),
    QT_TRANSLATE_NOOP("Sentences", "The model contradicts itself: “{0}” is not as its head says."),
    QT_TRANSLATE_NOOP("Sentences", "The model has a spread that is not positive."),
    QT_TRANSLATE_NOOP("Sentences", "The model's network is too large."),
    QT_TRANSLATE_NOOP("Sentences", "The model has weights that are no numbers in “{0}”."),
    QT_TRANSLATE_NOOP(
        "Sentences",
        "Choose a file that “mocapmend train refine” has written, or one that ships with the "
        "program: {0}.",
    ),
)

REFINEMENT = (*REFINING, *REFUSED)
