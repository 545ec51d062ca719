"""The kinds of files that can be read, as file dialogs list them."""

from collections.abc import Iterator

from PySide6.QtCore import QCoreApplication

from mocapmend.files import FORMATS


def all_kinds() -> str:
    """Return the entry for all kinds of recordings."""
    every = " ".join(f"*{end}" for item in FORMATS for end in item.suffixes)
    return QCoreApplication.translate("FileActions", "Recordings ({0})").format(every)


def kinds() -> Iterator[str]:
    """Yield an entry for each kind."""
    for item in FORMATS:
        yield f"{item.label} ({' '.join(f'*{end}' for end in item.suffixes)})"
