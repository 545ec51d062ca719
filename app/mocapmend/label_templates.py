"""What labels are learned from: labelled recordings, or a template of an earlier time. No Qt."""

from collections.abc import Sequence
from pathlib import Path

from mocapmend.errors import MocapmendError
from mocapmend.files import read_recording
from mocapmend.files.atomic import write_bytes
from mocapmend.files.opening import read_whole
from mocapmend_algorithms import Progress, Recording
from mocapmend_algorithms.labelling import LabelModel
from mocapmend_algorithms.names import without_subject
from mocapmend_algorithms.progress import part
from mocapmend_algorithms.skeleton import match_template
from mocapmend_resources import skeletons

SUFFIX = ".json"
MOST_BYTES = 50_000_000


def learn(examples: Sequence[Recording], progress: Progress) -> LabelModel:
    """Learn from labelled recordings.

    Raises
    ------
    MocapmendError
        If nothing can be learned from them.
    """
    known = match_template(examples[0].labels, skeletons.load()) if examples else None
    segments = [
        [without_subject(examples[0].labels[marker]) for marker in segment.markers]
        for segment in (known.segments if known else ())
    ]
    try:
        return LabelModel.learn(examples, segments, progress)
    except ValueError as error:
        raise MocapmendError(
            f"No labels can be learned: {error}.",
            todo="Choose recordings whose markers are labelled.",
        ) from error


def model_of(paths: Sequence[Path], progress: Progress) -> LabelModel:
    """Learn from labelled recordings, or read the template that is the only file.

    Raises
    ------
    MocapmendError
        If one of them cannot be read, or nothing can be learned from them.
    """
    if [path.suffix.lower() for path in paths] == [SUFFIX]:
        return read_template(paths[0])
    examples = []
    for number, path in enumerate(paths):
        progress(0.9 * number / len(paths))
        examples.append(read_recording(path).recording)
    return learn(examples, part(progress, 0.9, 1.0))


def read_template(path: Path) -> LabelModel:
    """Read a template.

    Raises
    ------
    MocapmendError
        If it is none.
    """
    try:
        return LabelModel.from_json(read_whole(path, MOST_BYTES).decode("utf-8"))
    except (ValueError, RecursionError):
        raise MocapmendError(
            "This is not a template of labels.",
            str(path),
            "Choose a file that “mocapmend label --save-template” has written.",
        ) from None


def write_template(model: LabelModel, path: Path) -> None:
    """Write a template; a file of that name is replaced.

    Raises
    ------
    MocapmendError
        If it cannot be written.
    """
    write_bytes(path, (model.to_json() + "\n").encode("utf-8"))
