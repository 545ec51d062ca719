"""What the user does about names: renaming a marker, and exchanging the names of two.

Names of edits are English, for reports and journals; they are translated where shown.
"""

from collections.abc import Callable, Mapping

from PySide6.QtCore import QObject, Signal

from mocapmend.commands import EditSamples
from mocapmend.document import Document
from mocapmend.errors import MocapmendError
from mocapmend.renaming import checked_label, full_label
from mocapmend.views.engine_texts import error_text
from mocapmend.viewstate import ViewState


class RenamingActions(QObject):
    """Renames markers, each time in one undoable step. No sample changes, and no repair.

    Parameters
    ----------
    do : callable
        Does an undo command.

    Signals
    -------
    message : str
        Something the user should read in passing.
    """

    message = Signal(str)

    def __init__(
        self,
        document: Document,
        view: ViewState,
        do: Callable[[EditSamples], None],
        parent: QObject | None = None,
    ) -> None:
        super().__init__(parent)
        self._document = document
        self._view = view
        self._do = do

    def rename(self, marker: int, typed: str) -> bool:
        """Call a marker as the user has typed; say whether it is called so."""
        document = self._document
        try:
            name = checked_label(typed)
            label = checked_label(full_label(document.labels, name))
        except MocapmendError as error:
            self.message.emit(error_text(error))
            return False
        before = document.labels[marker]
        if label == before:
            return True
        twice = label in document.labels
        self._make({marker: label}, f"rename {document.names[marker]} to {name}")
        said = self.tr("{0} is called {1} now.")
        if twice:
            said = self.tr("⚠ {0} is called {1} now, as another marker is.")
        self.message.emit(said.format(before, label))
        return True

    def exchange_names(self) -> None:
        """Give each of the two selected markers the other's name, over the whole recording."""
        if len(self._view.selection) != 2:
            self.message.emit(
                self.tr(
                    "Select the two markers whose names are to be exchanged (Ctrl+click adds one)."
                )
            )
            return
        first, second = self._view.selection
        labels, names = self._document.labels, self._document.names
        if labels[first] == labels[second]:
            self.message.emit(self.tr("Both have the same name."))
            return
        one, other = names[first], names[second]
        self._make(
            {first: labels[second], second: labels[first]},
            f"exchange the names of {one} and {other}",
        )
        self.message.emit(self.tr("{0} and {1} have each other's name now.").format(one, other))

    def _make(self, labels: Mapping[int, str], text: str) -> None:
        self._do(EditSamples(self._document, [], text, labels=labels))
