"""The labels of the points of a file, complete whatever the file leaves out."""

from collections.abc import Sequence


def complete_labels(stated: Sequence[str], count: int, warnings: list[str]) -> tuple[str, ...]:
    """Return one label per point, "point N" where the file has none.

    Parameters
    ----------
    stated : sequence of str
        What the file says, possibly too few or too many.
    count : int
        Points of the file.
    warnings : list of str
        Gets a sentence about points without a name and about repeated labels.
    """
    stated = stated[:count]
    labels = tuple(text or f"point {i}" for i, text in enumerate(stated, 1))
    if len(stated) < count:
        warnings.append(
            f"The file names {len(stated)} of its {count} points; the others are "
            "called by their number."
        )
        labels += tuple(f"point {i}" for i in range(len(stated) + 1, count + 1))
    repeated = len(labels) - len(set(labels))
    if repeated:
        warnings.append(
            "1 point has the label of another point."
            if repeated == 1
            else f"{repeated} points have the label of another point."
        )
    return labels
