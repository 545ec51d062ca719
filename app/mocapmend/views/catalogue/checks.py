"""What the comparison of two files finds and what an export proves, for Qt Linguist."""

from mocapmend.translate import QT_TRANSLATE_NOOP

SEPARATOR = QT_TRANSLATE_NOOP("Sentences", ", ")
"""Between the parts of a list."""

CHECKS = (
    QT_TRANSLATE_NOOP("Sentences", "The files are the same, byte for byte."),
    QT_TRANSLATE_NOOP(
        "Sentences",
        "Check passed: {0} changed; but for the differences that are allowed, all else is the "
        "same.",
    ),
    QT_TRANSLATE_NOOP(
        "Sentences",
        "Check passed: {0} changed; all else is the same, byte for byte.",
    ),
    QT_TRANSLATE_NOOP("Sentences", "Check failed: {0} changed, and there is more: {1}."),
    QT_TRANSLATE_NOOP("Sentences", "1 marker sample in 1 run"),
    QT_TRANSLATE_NOOP("Sentences", "{0} marker samples in 1 run"),
    QT_TRANSLATE_NOOP("Sentences", "{0} marker samples in {1} runs"),
    QT_TRANSLATE_NOOP("Sentences", "0 marker samples"),
    QT_TRANSLATE_NOOP("Sentences", "1 other difference"),
    QT_TRANSLATE_NOOP("Sentences", "{0} other differences"),
    QT_TRANSLATE_NOOP("Sentences", "The sizes differ: {0} and {1} bytes."),
    QT_TRANSLATE_NOOP("Sentences", "The repair record names another original."),
    QT_TRANSLATE_NOOP("Sentences", "Integers became floats, and no repair record says so."),
    QT_TRANSLATE_NOOP(
        "Sentences",
        "{0} measured sample at the ends of repaired gaps were replaced; the repair record "
        "lists them.",
    ),
    QT_TRANSLATE_NOOP(
        "Sentences",
        "{0} measured samples at the ends of repaired gaps were replaced; the repair record "
        "lists them.",
    ),
    QT_TRANSLATE_NOOP(
        "Sentences",
        "The parameters hold the repair record; it moved the data by {0} block.",
    ),
    QT_TRANSLATE_NOOP(
        "Sentences",
        "The parameters hold the repair record; it moved the data by {0} blocks.",
    ),
    QT_TRANSLATE_NOOP(
        "Sentences",
        "The repair record was taken out of the parameters ({0} blocks).",
    ),
    QT_TRANSLATE_NOOP(
        "Sentences",
        "The integers of the file became floats; all values that were not repaired are equal.",
    ),
    QT_TRANSLATE_NOOP("Sentences", "1 byte differs in {0}."),
    QT_TRANSLATE_NOOP("Sentences", "{0} bytes differ in {1}."),
    QT_TRANSLATE_NOOP("Sentences", "the header"),
    QT_TRANSLATE_NOOP("Sentences", "blocks that nothing uses"),
    QT_TRANSLATE_NOOP("Sentences", "the structure of the parameter section"),
    QT_TRANSLATE_NOOP("Sentences", "the parameter {0}"),
    QT_TRANSLATE_NOOP("Sentences", "what follows the last frame"),
    QT_TRANSLATE_NOOP("Sentences", "1 sample differs"),
    QT_TRANSLATE_NOOP("Sentences", "{0} samples differ"),
    QT_TRANSLATE_NOOP("Sentences", "1 value differs"),
    QT_TRANSLATE_NOOP("Sentences", "{0} values differ"),
    QT_TRANSLATE_NOOP("Sentences", "Model output {0}: {1}, the first at frame {2}."),
    QT_TRANSLATE_NOOP("Sentences", "Marker {0}: {1} although measured, the first at frame {2}."),
    QT_TRANSLATE_NOOP("Sentences", "Marker {0}: {1}, and still missing, the first at frame {2}."),
    QT_TRANSLATE_NOOP(
        "Sentences",
        "Marker {0}: {1} without the mark of a computed sample (fourth word 0), the first at "
        "frame {2}.",
    ),
    QT_TRANSLATE_NOOP(
        "Sentences",
        "Marker {0}: {1} without an entry in the repair record, the first at frame {2}.",
    ),
    QT_TRANSLATE_NOOP(
        "Sentences",
        "Marker {0}: {1} although the repair record keeps the gap open, the first at frame {2}.",
    ),
    QT_TRANSLATE_NOOP("Sentences", "Analog channel {0}: {1}."),
    QT_TRANSLATE_NOOP(
        "Sentences",
        "The c3d library read {0} frames of both files: {1} of {2} written samples decode as they "
        "should, and all else is the same.",
    ),
    QT_TRANSLATE_NOOP("Sentences", "No second check, the c3d library cannot read this file: {0}."),
    QT_TRANSLATE_NOOP("Sentences", "The file was read back: all samples are as they should be."),
    QT_TRANSLATE_NOOP("Sentences", "The repair record is in the file, as parameter group {0}."),
    QT_TRANSLATE_NOOP("Sentences", "The repair record is beside the file: {0}."),
)
