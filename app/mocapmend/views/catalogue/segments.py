"""Names of segments in the templates that ship with the program, for Qt Linguist."""

from mocapmend.translate import QT_TRANSLATE_NOOP

SEGMENTS = (
    QT_TRANSLATE_NOOP("Segments", "head"),
    QT_TRANSLATE_NOOP("Segments", "thorax"),
    QT_TRANSLATE_NOOP("Segments", "pelvis"),
    QT_TRANSLATE_NOOP("Segments", "left upper arm"),
    QT_TRANSLATE_NOOP("Segments", "right upper arm"),
    QT_TRANSLATE_NOOP("Segments", "left forearm"),
    QT_TRANSLATE_NOOP("Segments", "right forearm"),
    QT_TRANSLATE_NOOP("Segments", "left hand"),
    QT_TRANSLATE_NOOP("Segments", "right hand"),
    QT_TRANSLATE_NOOP("Segments", "left thigh"),
    QT_TRANSLATE_NOOP("Segments", "right thigh"),
    QT_TRANSLATE_NOOP("Segments", "left shank"),
    QT_TRANSLATE_NOOP("Segments", "right shank"),
    QT_TRANSLATE_NOOP("Segments", "left foot"),
    QT_TRANSLATE_NOOP("Segments", "right foot"),
)
