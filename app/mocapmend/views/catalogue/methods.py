"""What the table of methods and their parameters has to read, for Qt Linguist."""

from mocapmend.translate import QT_TRANSLATE_NOOP

METHODS = (
    QT_TRANSLATE_NOOP("Methods", "Automatic"),
    QT_TRANSLATE_NOOP("Methods", "Interpolation"),
    QT_TRANSLATE_NOOP("Methods", "Donors"),
    QT_TRANSLATE_NOOP("Methods", "Low rank"),
    QT_TRANSLATE_NOOP("Methods", "Sparse"),
    QT_TRANSLATE_NOOP("Methods", "Kalman"),
    QT_TRANSLATE_NOOP("Methods", "Constant"),
    QT_TRANSLATE_NOOP("Methods", "Linear"),
    QT_TRANSLATE_NOOP("Methods", "Cubic spline"),
    QT_TRANSLATE_NOOP("Methods", "PCHIP"),
    QT_TRANSLATE_NOOP("Methods", "Woltring, quintic spline"),
    QT_TRANSLATE_NOOP("Methods", "Cyclic"),
    QT_TRANSLATE_NOOP("Methods", "Rigid body"),
    QT_TRANSLATE_NOOP("Methods", "Pattern"),
    QT_TRANSLATE_NOOP("Methods", "Local frame regression"),
    QT_TRANSLATE_NOOP("Methods", "Principal components, all gaps at once"),
    QT_TRANSLATE_NOOP("Methods", "Principal components, marker by marker"),
    QT_TRANSLATE_NOOP("Methods", "Low-dimensional Kalman smoother"),
    QT_TRANSLATE_NOOP("Methods", "Matrix completion of trajectory segments"),
    QT_TRANSLATE_NOOP("Methods", "Sparse code of poses"),
    QT_TRANSLATE_NOOP("Methods", "Sparse code of motion, with bones"),
    QT_TRANSLATE_NOOP("Methods", "Sparse motion bases"),
    QT_TRANSLATE_NOOP("Methods", "Kalman, constant velocity"),
    QT_TRANSLATE_NOOP(
        "Methods",
        "Holds the value at one edge of the gap. Right only for a marker that stands still.",
    ),
    QT_TRANSLATE_NOOP(
        "Methods",
        "A straight line between the edges of the gap. It cuts every curve of the motion; "
        "good for a few frames.",
    ),
    QT_TRANSLATE_NOOP(
        "Methods",
        "A smooth curve through the samples on both sides. Good below about 0.2 s; above, it "
        "invents motion and may overshoot.",
    ),
    QT_TRANSLATE_NOOP(
        "Methods",
        "A curve that never overshoots the edges of the gap. Safer than the cubic spline on "
        "jittery samples, less exact on smooth motion.",
    ),
    QT_TRANSLATE_NOOP(
        "Methods",
        "A quintic spline that first smooths the samples beside the gap, by as much as "
        "cross-validation says, so that jitter does not swing it. Measured samples stay as "
        "they are. Good below about 0.2 s; above, it invents motion and may overshoot further "
        "than the cubic spline.",
    ),
    QT_TRANSLATE_NOOP(
        "Methods",
        "For gait, pedalling and other motion in cycles: takes the same phase of the "
        "neighbouring cycles and fits it between the edges of the gap. Good for gaps that "
        "span much of a cycle, poor where speed or direction change, as in a turn.",
    ),
    QT_TRANSLATE_NOOP(
        "Methods",
        "Moves the marker with three or more donors that keep their distance to it, such as "
        "those of the same segment. Good while that part of the body is stiff; it cannot "
        "follow skin and joints.",
    ),
    QT_TRANSLATE_NOOP(
        "Methods",
        "Moves the marker along with one donor. For lack of better donors: it does not turn "
        "with the body.",
    ),
    QT_TRANSLATE_NOOP(
        "Methods",
        "Learns from this recording how the marker moves beside its donors, in a frame that "
        "moves with four of them. Follows skin and joints as far as the donors show them.",
    ),
    QT_TRANSLATE_NOOP(
        "Methods",
        "Learns from the complete frames how the markers move together and predicts all "
        "markers with gaps at once from those without any (Gløersen and Federolf 2016, R1). "
        "For recordings with few gaps; it learns nothing of postures that no complete frame "
        "shows.",
    ),
    QT_TRANSLATE_NOOP(
        "Methods",
        "Learns how the markers move together and predicts each marker with gaps from those "
        "that are seen in them, near ones first (Gløersen and Federolf 2016, R2). Good for "
        "gaps up to seconds in repetitive motion; poor where a marker's neighbours are "
        "missing too.",
    ),
    QT_TRANSLATE_NOOP(
        "Methods",
        "Learns from the complete frames in which few directions the whole body moves, and "
        "follows the posture there with a Kalman smoother (Burke and Lasenby 2016). Fast; "
        "good for one marker in motion like that of the complete frames, poor where several "
        "markers of a segment are missing.",
    ),
    QT_TRANSLATE_NOOP(
        "Methods",
        "Completes the trajectories around the gap so that they move in as few directions as "
        "possible, near markers counting more (after Tan, Hou and Chau 2013). About as good "
        "as the principal components, and often better where several neighbours are missing "
        "too; poor where the body turns or moves in the gap as it does nowhere around it.",
    ),
    QT_TRANSLATE_NOOP(
        "Methods",
        "Composes each pose from few complete ones, of this recording or of a training set, "
        "that agree with it in the markers that are seen, and takes the missing marker from "
        "them. Good for long gaps where like poses are known; in motion that comes only once, "
        "there is nothing to take from.",
    ),
    QT_TRANSLATE_NOOP(
        "Methods",
        "Composes each stretch of motion from few examples, of this recording or of a "
        "training set, and keeps bone lengths (after Wang, Lu, Han 2018). For several "
        "neighbouring markers or joints that are missing together; poor where no example is "
        "like the motion.",
    ),
    QT_TRANSLATE_NOOP(
        "Methods",
        "Composes short windows of motion from few examples, part by part and without bones. "
        "It is what the sparse code with bones is compared to.",
    ),
    QT_TRANSLATE_NOOP(
        "Methods",
        "Carries position and velocity into the gap from both sides, relative to the "
        "neighbouring markers that are seen, and says how sure it is. Where none are, it "
        "looks at one marker alone and cannot know what happened inside a gap much longer "
        "than 0.2 s.",
    ),
    QT_TRANSLATE_NOOP(
        "Methods",
        "Learns from this very recording how the marker moves with all others that are seen "
        "in the gap. Several such fills are tested on hidden stretches like the gap and "
        "blended by how well they did; the expected error and the band come from these tests.",
    ),
    QT_TRANSLATE_NOOP("Methods", "Hold the value"),
    QT_TRANSLATE_NOOP(
        "Methods",
        "Which value to hold: that before the gap, that after it, or the nearer one.",
    ),
    QT_TRANSLATE_NOOP("Methods", "before"),
    QT_TRANSLATE_NOOP("Methods", "after"),
    QT_TRANSLATE_NOOP("Methods", "nearest"),
    QT_TRANSLATE_NOOP("Methods", "Start and end"),
    QT_TRANSLATE_NOOP(
        "Methods",
        "What to do with a gap at the start or the end of the recording: leave it open, or "
        "hold the nearest sample over all of it.",
    ),
    QT_TRANSLATE_NOOP("Methods", "leave"),
    QT_TRANSLATE_NOOP("Methods", "hold"),
    QT_TRANSLATE_NOOP("Methods", "repeat"),
    QT_TRANSLATE_NOOP("Methods", "fill"),
    QT_TRANSLATE_NOOP("Methods", "Measurement noise"),
    QT_TRANSLATE_NOOP(
        "Methods",
        "Standard deviation of a measured coordinate: so much is smoothed away before the "
        "curve enters the gap; 0 smooths nothing. Automatic: generalised cross-validation.",
    ),
    QT_TRANSLATE_NOOP("Methods", "Period"),
    QT_TRANSLATE_NOOP(
        "Methods",
        "How long a cycle lasts. Automatic: estimated from the marker, or from all markers "
        "where this one alone does not repeat itself.",
    ),
    QT_TRANSLATE_NOOP(
        "Methods",
        "What to do with a gap at the start or the end of the recording: leave it open, or "
        "repeat the neighbouring cycles there.",
    ),
    QT_TRANSLATE_NOOP(
        "Methods",
        "What to do with a gap at the start or the end of the recording: fill it from the "
        "other markers, or leave it open.",
    ),
    QT_TRANSLATE_NOOP(
        "Methods",
        "Three or more markers of the same rigid part, by their labels, with commas between "
        "them. Automatic: chosen for each gap among the markers that are seen throughout it.",
    ),
    QT_TRANSLATE_NOOP(
        "Methods",
        "A marker that moves like this one, or several, by their labels, with commas between "
        "them. Automatic: chosen for each gap among the markers that are seen throughout it.",
    ),
    QT_TRANSLATE_NOOP(
        "Methods",
        "Markers that move with this one, by their labels, with commas between them. "
        "Automatic: chosen for each gap among the markers that are seen throughout it.",
    ),
    QT_TRANSLATE_NOOP("Methods", "Penalty"),
    QT_TRANSLATE_NOOP(
        "Methods",
        "Of large coefficients, relative to how much the donors move: more is stiffer.",
    ),
    QT_TRANSLATE_NOOP("Methods", "Meet the edges"),
    QT_TRANSLATE_NOOP(
        "Methods",
        "Carry what the model leaves over at the edges of the gap into it. Off: as printed.",
    ),
    QT_TRANSLATE_NOOP("Methods", "Distance scale"),
    QT_TRANSLATE_NOOP(
        "Methods",
        "Markers much farther away than this from the missing one hardly count.",
    ),
    QT_TRANSLATE_NOOP("Methods", "Weight of the missing marker"),
    QT_TRANSLATE_NOOP(
        "Methods",
        "How much the missing marker itself shapes the components, 1 = as much as a marker at "
        "its place.",
    ),
    QT_TRANSLATE_NOOP("Methods", "Components"),
    QT_TRANSLATE_NOOP(
        "Methods",
        "Share of the sum of the singular values that the components kept make up.",
    ),
    QT_TRANSLATE_NOOP("Methods", "Near markers"),
    QT_TRANSLATE_NOOP(
        "Methods",
        "Markers with gaps of their own help only if they are nearer than this share of the "
        "mean distance of all markers.",
    ),
    QT_TRANSLATE_NOOP(
        "Methods",
        "Standard deviation of a measured coordinate. More noise gives smoother postures.",
    ),
    QT_TRANSLATE_NOOP("Methods", "Segments around the gap"),
    QT_TRANSLATE_NOOP(
        "Methods",
        "How much of the trajectories before and after the gap is looked at, at least as much "
        "as the gap is long.",
    ),
    QT_TRANSLATE_NOOP(
        "Methods",
        "Markers much farther away than this from the missing ones hardly count.",
    ),
    QT_TRANSLATE_NOOP("Methods", "Weight of the missing markers"),
    QT_TRANSLATE_NOOP(
        "Methods",
        "How much the missing markers themselves shape the matrix, 1 = as much as a marker at "
        "their place.",
    ),
    QT_TRANSLATE_NOOP("Methods", "Threshold"),
    QT_TRANSLATE_NOOP(
        "Methods",
        "Singular values below this share of the largest one are taken for noise.",
    ),
    QT_TRANSLATE_NOOP("Methods", "Learn from"),
    QT_TRANSLATE_NOOP(
        "Methods",
        "Poses to tell this recording's by, in place of its own complete frames.",
    ),
    QT_TRANSLATE_NOOP("Methods", "Poses"),
    QT_TRANSLATE_NOOP(
        "Methods",
        "At most so many known poses, evenly spread, make up the dictionary.",
    ),
    QT_TRANSLATE_NOOP(
        "Methods",
        "The larger, the fewer known poses a pose is made of, and the nearer to the mean pose "
        "it is.",
    ),
    QT_TRANSLATE_NOOP(
        "Methods",
        "Markers much farther away than this from the missing one hardly count. As printed, "
        "all count alike: 100000 mm.",
    ),
    QT_TRANSLATE_NOOP("Methods", "Relative to"),
    QT_TRANSLATE_NOOP(
        "Methods",
        "What poses are compared by: body = wherever it is and faces, place = wherever it is, "
        "world = nothing is taken out, as printed.",
    ),
    QT_TRANSLATE_NOOP("Methods", "body"),
    QT_TRANSLATE_NOOP("Methods", "place"),
    QT_TRANSLATE_NOOP("Methods", "world"),
    QT_TRANSLATE_NOOP("Methods", "Mean pose taken out"),
    QT_TRANSLATE_NOOP("Methods", "Code what differs from the mean pose. Off: as printed."),
    QT_TRANSLATE_NOOP(
        "Methods",
        "Recordings to learn from beside this one. By default it learns from this one alone.",
    ),
    QT_TRANSLATE_NOOP("Methods", "Atoms"),
    QT_TRANSLATE_NOOP(
        "Methods",
        "Examples of motion in the dictionary. Automatic: up to 150 of the recording, or 600 "
        "with a training set.",
    ),
    QT_TRANSLATE_NOOP("Methods", "The larger, the fewer examples a window is made of."),
    QT_TRANSLATE_NOOP("Methods", "Dictionary"),
    QT_TRANSLATE_NOOP(
        "Methods",
        "Examples: stretches of motion as they are. Trained: the dictionaries of the five "
        "parts of a skeleton that a training set has, as printed in the paper; less exact.",
    ),
    QT_TRANSLATE_NOOP("Methods", "examples"),
    QT_TRANSLATE_NOOP("Methods", "trained"),
    QT_TRANSLATE_NOOP("Methods", "Window"),
    QT_TRANSLATE_NOOP(
        "Methods",
        "The stretch of motion that is coded as one: six frames spread over it. Automatic: "
        "330 ms, or 600 ms with a training set.",
    ),
    QT_TRANSLATE_NOOP("Methods", "Keep bone lengths"),
    QT_TRANSLATE_NOOP(
        "Methods",
        "The bones of a skeleton get their exact lengths; markers on skin are pulled towards "
        "theirs as far as these are sure.",
    ),
    QT_TRANSLATE_NOOP("Methods", "Parts of the body"),
    QT_TRANSLATE_NOOP(
        "Methods",
        "Tell each part of the body from itself, the trunk and one more part. Off: from all.",
    ),
    QT_TRANSLATE_NOOP("Methods", "Direction"),
    QT_TRANSLATE_NOOP(
        "Methods",
        "Two-sided uses the samples before and after the gap; causal only those before, as a "
        "live system must.",
    ),
    QT_TRANSLATE_NOOP("Methods", "two-sided"),
    QT_TRANSLATE_NOOP("Methods", "causal"),
    QT_TRANSLATE_NOOP("Methods", "Frame"),
    QT_TRANSLATE_NOOP(
        "Methods",
        "Local: the common rigid motion of the neighbouring markers is taken out first; where "
        "fewer than three keep their distance and are seen all along, the world frame is "
        "used. World: as printed in the paper.",
    ),
    QT_TRANSLATE_NOOP("Methods", "local"),
    QT_TRANSLATE_NOOP(
        "Methods",
        "Local frame only: the labels of the markers whose common motion is taken out; one or "
        "two are followed without their rotation. Automatic: the four that keep their "
        "distance to the marker best.",
    ),
    QT_TRANSLATE_NOOP(
        "Methods",
        "Standard deviation of a measured coordinate. More noise means that more samples "
        "beside the gap share in its velocity. Automatic: chosen by self-tests for each gap.",
    ),
    QT_TRANSLATE_NOOP("Methods", "Velocity interval"),
    QT_TRANSLATE_NOOP(
        "Methods",
        "Causal only: the fixed interval over which the velocity is taken; 0 takes it between "
        "consecutive frames. Automatic: chosen by self-tests for each gap.",
    ),
    QT_TRANSLATE_NOOP("Methods", "Jump"),
    QT_TRANSLATE_NOOP(
        "Methods",
        "A marker that moves further between two frames was lost or is wrong there, and its "
        "samples beside such a jump are not trusted. A large number switches this off. "
        "Automatic: estimated from the motion of each marker.",
    ),
    QT_TRANSLATE_NOOP("Methods", "Gate"),
    QT_TRANSLATE_NOOP(
        "Methods",
        "A single sample beside the gap is not trusted if it lies more than this many "
        "standard deviations from what the filter makes of the others. A large number "
        "switches this off.",
    ),
    QT_TRANSLATE_NOOP("Methods", "Pull to bone lengths"),
    QT_TRANSLATE_NOOP(
        "Methods",
        "Moves the predicted points towards the lengths of the bones to up to four markers at "
        "a nearly constant distance, as far as the filter is unsure and the lengths are not.",
    ),
    QT_TRANSLATE_NOOP(
        "Methods",
        "Recordings to learn from beside this one. Windows of motion that are coded by them, "
        "as in bone-dictionary, become part of the blend as far as tests speak for it; bones "
        "of a skeleton get their exact lengths. This takes seconds a gap.",
    ),
)
