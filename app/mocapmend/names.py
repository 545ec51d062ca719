"""What markers are called where people read them. No Qt."""

from collections.abc import Sequence


def short_names(labels: Sequence[str]) -> tuple[str, ...]:
    """Return labels without the subject that all of them name, as in "Matt:LASI".

    Parameters
    ----------
    labels : sequence of str
        As the file has them.

    Returns
    -------
    tuple of str
        The same labels where they do not all begin with one subject.
    """
    subjects = {label.partition(":")[0] for label in labels if ":" in label}
    if len(subjects) != 1 or not all(":" in label for label in labels):
        return tuple(labels)
    return tuple(label.partition(":")[2] for label in labels)
