"""What the readers and writers of files remark, for Qt Linguist."""

from mocapmend.translate import QT_TRANSLATE_NOOP

WARNINGS = (
    QT_TRANSLATE_NOOP("Sentences", "The file's repair record cannot be used: {0}."),
    QT_TRANSLATE_NOOP(
        "Sentences",
        "{0} samples at (0, 0, 0), which means missing in a C3D file, were moved by {1} {2}.",
    ),
    QT_TRANSLATE_NOOP("Sentences", "The file says that it has {0} force plates and describes {1}."),
    QT_TRANSLATE_NOOP("Sentences", "Force plates {0}: {1}."),
    QT_TRANSLATE_NOOP("Sentences", "Force plate {0}: {1}."),
    QT_TRANSLATE_NOOP("Sentences", "the type is not known"),
    QT_TRANSLATE_NOOP("Sentences", "type {0} is not known"),
    QT_TRANSLATE_NOOP("Sentences", "not all analog channels are in the file"),
    QT_TRANSLATE_NOOP("Sentences", "{0} analog channels do not belong to type {1}"),
    QT_TRANSLATE_NOOP("Sentences", "type {0} needs a calibration matrix, and there is none"),
    QT_TRANSLATE_NOOP("Sentences", "type {0} has no use for the calibration matrix"),
    QT_TRANSLATE_NOOP("Sentences", "the corners span no surface"),
    QT_TRANSLATE_NOOP(
        "Sentences",
        "The {0} analog values of a frame cannot be split into channels; they are taken for "
        "one sample of each.",
    ),
    QT_TRANSLATE_NOOP(
        "Sentences",
        "The file states no usable scale; floats in its own unit are assumed.",
    ),
    QT_TRANSLATE_NOOP(
        "Sentences",
        "The header's scale ({0}) and POINT:SCALE ({1}) differ; {2} is used.",
    ),
    QT_TRANSLATE_NOOP("Sentences", "The file states no frame rate; {0} Hz is assumed."),
    QT_TRANSLATE_NOOP(
        "Sentences",
        "The header's frame rate ({0} Hz) and POINT:RATE ({1} Hz) differ; {2} Hz is used.",
    ),
    QT_TRANSLATE_NOOP(
        "Sentences",
        "TRIAL:ACTUAL_START_FIELD says that the first frame is {0}; the header's {1} is used.",
    ),
    QT_TRANSLATE_NOOP(
        "Sentences",
        "The header's first frame ({0}) and TRIAL:ACTUAL_START_FIELD ({1}) differ; {2} is used.",
    ),
    QT_TRANSLATE_NOOP(
        "Sentences",
        "Header and parameters disagree on the numbers of points and analog values per frame; "
        "{0} and {1} are used.",
    ),
    QT_TRANSLATE_NOOP(
        "Sentences",
        "The file states different numbers of frames ({0}); {1} is used.",
    ),
    QT_TRANSLATE_NOOP(
        "Sentences",
        "The file does not say where its data begin; they are taken to follow the parameters.",
    ),
    QT_TRANSLATE_NOOP("Sentences", "Parameters occur more than once, and the first is used: {0}."),
    QT_TRANSLATE_NOOP(
        "Sentences",
        "The header puts the data at block {0} and POINT:DATA_START at block {1}; {2} is used.",
    ),
    QT_TRANSLATE_NOOP(
        "Sentences",
        "Names that a C3D file cannot hold were cut ({0}); the first is {1}.",
    ),
    QT_TRANSLATE_NOOP("Sentences", "The file holds no marker data: there is nothing to repair."),
    QT_TRANSLATE_NOOP("Sentences", "{0} bytes follow the last frame; they are kept as they are."),
    QT_TRANSLATE_NOOP(
        "Sentences",
        "{0} samples are exactly (0, 0, 0) or not finite without a mark of missing; they are "
        "taken as missing.",
    ),
    QT_TRANSLATE_NOOP(
        "Sentences",
        "The file says that {0} points up, which would put the markers below the floor; {1} "
        "is used.",
    ),
    QT_TRANSLATE_NOOP(
        "Sentences",
        "A skeleton file holds no motion; the rest pose is shown as one frame. Open the .amc "
        "file to see a motion.",
    ),
    QT_TRANSLATE_NOOP(
        "Sentences",
        "The file states no rate and no axis that points up; {0} Hz and +y, as in CMU's "
        "recordings, are assumed.",
    ),
    QT_TRANSLATE_NOOP(
        "Sentences",
        "One length unit of the skeleton is taken for 1/{0} inch, as in CMU's recordings, and "
        "lengths are converted to cm.",
    ),
    QT_TRANSLATE_NOOP("Sentences", "The skeleton is {0}, the only one in the folder."),
    QT_TRANSLATE_NOOP("Sentences", "{0} bones have no values in the motion and do not turn."),
    QT_TRANSLATE_NOOP("Sentences", "The last frame is incomplete and is left out."),
    QT_TRANSLATE_NOOP(
        "Sentences",
        "Frame {0} does not follow the frame before it; frames are read as if none were left out.",
    ),
    QT_TRANSLATE_NOOP("Sentences", "Bones that shift or stretch are drawn with a fixed length."),
    QT_TRANSLATE_NOOP(
        "Sentences",
        "The numbers of the frames do not count up by one; the lines are taken as consecutive "
        "frames.",
    ),
    QT_TRANSLATE_NOOP(
        "Sentences",
        "Some frames have no number; the lines are taken as consecutive frames.",
    ),
    QT_TRANSLATE_NOOP(
        "Sentences",
        "Frames that the file leaves out are taken as frames without markers: {0}.",
    ),
    QT_TRANSLATE_NOOP("Sentences", "The file states no frame rate; its times say {0} Hz."),
    QT_TRANSLATE_NOOP(
        "Sentences",
        "The file states {0} Hz, but its times say {1} Hz; {2} Hz is used.",
    ),
    QT_TRANSLATE_NOOP(
        "Sentences",
        "The file states no length unit; {0} is assumed from the size of the skeleton.",
    ),
    QT_TRANSLATE_NOOP("Sentences", "The file does not say which axis points up; {0} is assumed."),
    QT_TRANSLATE_NOOP(
        "Sentences",
        "The frame time {0} s may be a rounded 1/{1} s; {2} Hz is used.",
    ),
    QT_TRANSLATE_NOOP(
        "Sentences",
        "The file states no length unit; 1/0.45 inch, as in CMU's recordings, is assumed from "
        "the size of the skeleton, and lengths are converted to cm.",
    ),
    QT_TRANSLATE_NOOP("Sentences", "The file states no usable frame time; {0} Hz is assumed."),
    QT_TRANSLATE_NOOP(
        "Sentences",
        "The file holds no motion; the rest pose is shown as one frame.",
    ),
    QT_TRANSLATE_NOOP("Sentences", "The file does not say how many frames it holds."),
    QT_TRANSLATE_NOOP(
        "Sentences",
        "The file says that it holds {0} frames, but {1} are there; all are read.",
    ),
    QT_TRANSLATE_NOOP("Sentences", "The last line is no complete frame and is left out."),
    QT_TRANSLATE_NOOP("Sentences", "Most lines after line {0} end before their last column."),
    QT_TRANSLATE_NOOP("Sentences", "The last line is cut off; it is left out."),
    QT_TRANSLATE_NOOP(
        "Sentences",
        "Labels that were empty or had characters that no file holds are changed: {0}.",
    ),
    QT_TRANSLATE_NOOP(
        "Sentences",
        "TRC files know mm, cm and m; the coordinates are written in mm, not {0}.",
    ),
    QT_TRANSLATE_NOOP(
        "Sentences",
        "Samples exactly at (0, 0, 0) would be missing to a reader; their x is written as "
        "{0}: {1}.",
    ),
    QT_TRANSLATE_NOOP("Sentences", "Samples exactly at (0, 0, 0) are taken as missing: {0}."),
    QT_TRANSLATE_NOOP(
        "Sentences",
        "Samples without some of their coordinates are taken as missing: {0}.",
    ),
    QT_TRANSLATE_NOOP("Sentences", "Samples impossibly far away are taken as missing: {0}."),
    QT_TRANSLATE_NOOP(
        "Sentences",
        "{0} samples depend on values that are no numbers or far too large; they are taken as "
        "missing.",
    ),
    QT_TRANSLATE_NOOP("Sentences", "1 joint has the label of another joint."),
    QT_TRANSLATE_NOOP("Sentences", "{0} joints have the label of another joint."),
    QT_TRANSLATE_NOOP("Sentences", "1 point has the label of another point."),
    QT_TRANSLATE_NOOP("Sentences", "{0} points have the label of another point."),
    QT_TRANSLATE_NOOP(
        "Sentences",
        "Markers that are not measured, but where Motive expects them on a body or bone: {0} "
        "of {1}.",
    ),
    QT_TRANSLATE_NOOP("Sentences", "The poses of bodies and bones are left out: {0}."),
    QT_TRANSLATE_NOOP("Sentences", "Other sections of the file are left out: {0}."),
    QT_TRANSLATE_NOOP("Sentences", "The orientations of the joints are left out."),
    QT_TRANSLATE_NOOP(
        "Sentences",
        "Samples that the Kinect did not track are taken as missing: {0}.",
    ),
    QT_TRANSLATE_NOOP(
        "Sentences",
        "Samples that the Kinect did not see but inferred are kept as they are: {0} of {1}.",
    ),
    QT_TRANSLATE_NOOP(
        "Sentences",
        "Samples whose state of tracking is unknown are kept as they are: {0}.",
    ),
    QT_TRANSLATE_NOOP("Sentences", "The times in {0} cannot be used."),
    QT_TRANSLATE_NOOP("Sentences", "The times in {0} say {1} Hz."),
    QT_TRANSLATE_NOOP(
        "Sentences",
        "{0} has {1} times for {2} frames; only the frame rate is taken from it.",
    ),
    QT_TRANSLATE_NOOP(
        "Sentences",
        "{0} of {1} steps from frame to frame are more than a quarter longer or shorter than {2} "
        "ms; the frames are taken as evenly spaced.",
    ),
    QT_TRANSLATE_NOOP(
        "Sentences",
        "There are {0} frames of positions and {1} of angles; the first {2} are read.",
    ),
    QT_TRANSLATE_NOOP(
        "Sentences",
        "The file does not name its markers; Plug-in Gait's names are assumed.",
    ),
    QT_TRANSLATE_NOOP(
        "Sentences",
        "The bones of the file do not fit its markers; they are ignored.",
    ),
    QT_TRANSLATE_NOOP(
        "Sentences",
        "The parents of the markers do not fit the markers; they are ignored.",
    ),
    QT_TRANSLATE_NOOP("Sentences", "There are {0} markers by the header, but it names {1}."),
    QT_TRANSLATE_NOOP("Sentences", "Markers without a label in the file: {0}."),
    QT_TRANSLATE_NOOP("Sentences", "There are {0} markers by the header, but {1} in the file."),
    QT_TRANSLATE_NOOP("Sentences", "There are {0} frames by the header, but {1} in the file."),
    QT_TRANSLATE_NOOP(
        "Sentences",
        "The file names {0} of its {1} points; the others are called by their number.",
    ),
    QT_TRANSLATE_NOOP(
        "Sentences",
        "{0} of {1} repairs of the repair record are not in the file any more; their samples "
        "are taken as they are.",
    ),
    QT_TRANSLATE_NOOP(
        "Sentences",
        "{0} of {1} gaps that the repair record keeps open are not in the file any more.",
    ),
    QT_TRANSLATE_NOOP(
        "Sentences",
        "The repair record {0} belongs to another state of this file; its repairs are taken "
        "for measured samples.",
    ),
    QT_TRANSLATE_NOOP("Sentences", "The repair record {0} cannot be read: {1}."),
    QT_TRANSLATE_NOOP("Sentences", "The repair record {0} cannot be used: {1}."),
    QT_TRANSLATE_NOOP(
        "Sentences",
        "The file is truncated: it says that it holds {0} frames, but only {1} are there.",
    ),
    QT_TRANSLATE_NOOP(
        "Sentences",
        "The file states no length unit; {0} is assumed from the size of its numbers.",
    ),
    QT_TRANSLATE_NOOP(
        "Sentences",
        "The file states an unknown length unit ({0}); {1} is assumed from the size of its "
        "numbers.",
    ),
    QT_TRANSLATE_NOOP("Sentences", "The file does not say which axis points up; {0} is a guess."),
    QT_TRANSLATE_NOOP("Sentences", "The new file has the markers alone, without {0}."),
    QT_TRANSLATE_NOOP("Sentences", "analog data"),
    QT_TRANSLATE_NOOP("Sentences", "model outputs"),
    QT_TRANSLATE_NOOP("Sentences", "events"),
    QT_TRANSLATE_NOOP("Sentences", "residuals"),
    QT_TRANSLATE_NOOP("Sentences", "bones"),
    QT_TRANSLATE_NOOP("Sentences", "the axis that points up"),
    QT_TRANSLATE_NOOP("Sentences", "The skeleton template {0} is left out: {1}."),
    QT_TRANSLATE_NOOP("Sentences", "it is larger than 1 MB"),
    QT_TRANSLATE_NOOP("Sentences", "it is not UTF-8 text"),
    QT_TRANSLATE_NOOP("Sentences", "it is nested too deeply"),
    QT_TRANSLATE_NOOP("Sentences", "it is not TOML: {0}"),
    QT_TRANSLATE_NOOP("Sentences", "it has format {0}, and this version reads {1}"),
    QT_TRANSLATE_NOOP("Sentences", "it is not written in JSON"),
    QT_TRANSLATE_NOOP("Sentences", "it is not a JSON document"),
    QT_TRANSLATE_NOOP("Sentences", "it is not of format {0}, which this version reads"),
    QT_TRANSLATE_NOOP("Sentences", "it has no list of repairs"),
    QT_TRANSLATE_NOOP("Sentences", "it has no list of gaps kept open"),
    QT_TRANSLATE_NOOP("Sentences", "it has no {0}"),
    QT_TRANSLATE_NOOP("Sentences", "it is too large"),
    QT_TRANSLATE_NOOP("Sentences", "it does not say which file it belongs to"),
    QT_TRANSLATE_NOOP("Sentences", "it does not say which file was repaired"),
    QT_TRANSLATE_NOOP("Sentences", "a repair is not an object"),
    QT_TRANSLATE_NOOP("Sentences", "{0} of a repair is missing or of another kind"),
    QT_TRANSLATE_NOOP("Sentences", "a number or a text of a repair is too large"),
    QT_TRANSLATE_NOOP("Sentences", "a gap kept open is not an object"),
    QT_TRANSLATE_NOOP("Sentences", "{0} of a gap kept open is missing or of another kind"),
    QT_TRANSLATE_NOOP("Sentences", "a number or a text of a gap kept open is too large"),
    QT_TRANSLATE_NOOP("Sentences", "a donor is not a label"),
    QT_TRANSLATE_NOOP(
        "Sentences",
        "a parameter is neither a number nor a text, nor a list of texts",
    ),
)
