"""The recordings that ship with the program."""

from importlib.resources import files
from pathlib import Path

from PySide6.QtCore import QCoreApplication

from mocapmend.translate import QT_TRANSLATE_NOOP

_SAMPLES = (
    ("sprint_basketball.c3d", QT_TRANSLATE_NOOP("Samples", "Wheelchair sprint, many gaps")),
    ("gait_plug_in_gait.c3d", QT_TRANSLATE_NOOP("Samples", "Gait, Plug-in Gait, with fragments")),
    ("walk_cmu_02_01.c3d", QT_TRANSLATE_NOOP("Samples", "Walk, 41 markers, complete")),
    ("squat_kinect.c3d", QT_TRANSLATE_NOOP("Samples", "Squat, 22 joints of a Kinect, to refine")),
)


def sample_recordings() -> list[tuple[Path, str]]:
    """Return the sample files with what they show."""
    return [
        (_folder() / name, QCoreApplication.translate("Samples", text)) for name, text in _SAMPLES
    ]


def is_sample(path: Path) -> bool:
    """Say whether a file ships with the program; its folder is no place for the user's files."""
    return path.resolve().parent == _folder().resolve()


def _folder() -> Path:
    return Path(str(files("mocapmend_resources") / "samples"))
