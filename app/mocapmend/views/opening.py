"""What is to be opened, and how."""

from collections.abc import Callable
from dataclasses import dataclass
from pathlib import Path
from typing import TYPE_CHECKING

if TYPE_CHECKING:
    from mocapmend.views.workspace import Workspace


@dataclass(frozen=True, eq=False)
class Opening:
    """A recording that is to be opened.

    Attributes
    ----------
    path : Path
        The file.
    journal : Path or None
        Of edits that are to be recovered.
    instead_of : Workspace or None
        Whose tab it takes.
    then : callable or None
        Called with the workspace when it is shown.
    """

    path: Path
    journal: Path | None = None
    instead_of: "Workspace | None" = None
    then: "Callable[[Workspace], None] | None" = None
