"""A field for a list of markers: typed with completion, or taken from the selection."""

from collections.abc import Mapping, Sequence

from PySide6.QtCore import QModelIndex, QPersistentModelIndex, Qt, Signal
from PySide6.QtWidgets import QCompleter, QHBoxLayout, QLineEdit, QPushButton, QWidget

from mocapmend_algorithms.params import Words, parse_words, write_words


class NamesEdit(QWidget):
    """Edits a list of labels; an empty one is left to the method.

    Parameters
    ----------
    labels : Words
        To begin with.
    known : mapping of str to str
        What the markers are called here, and their labels. Other names are taken as labels.
    """

    changed = Signal()

    def __init__(
        self, labels: Words, known: Mapping[str, str], parent: QWidget | None = None
    ) -> None:
        super().__init__(parent)
        self._known = known
        self._names = {label: name for name, label in known.items()}
        self._selection: tuple[str, ...] = ()
        self.edit = QLineEdit(self._text(labels))
        self.edit.setPlaceholderText(self.tr("automatic"))
        self.edit.setClearButtonEnabled(True)
        self.edit.setCompleter(_Completer(list(known), self.edit))
        self.take = QPushButton(self.tr("◀ selected"))
        self.take.setAccessibleName(self.tr("Take the selected markers"))
        # A click must not take the keyboard from the rest of the window.
        self.take.setFocusPolicy(Qt.FocusPolicy.TabFocus)
        self.take.clicked.connect(self._take)
        layout = QHBoxLayout(self)
        layout.setContentsMargins(0, 0, 0, 0)
        layout.setSpacing(4)
        layout.addWidget(self.edit, 1)
        layout.addWidget(self.take)
        self.take.setHidden(not known)
        self.setFocusProxy(self.edit)
        self._told = self.labels()
        self.edit.editingFinished.connect(self._tell)
        self.edit.textChanged.connect(self._tell_emptied)
        # Later, when the text is in the field.
        self.edit.completer().activated.connect(self._tell, Qt.ConnectionType.QueuedConnection)
        self.set_selection(())

    def labels(self) -> Words:
        """Return the labels of the markers that are named."""
        return tuple(self._known.get(name, name) for name in parse_words(self.edit.text()))

    def set_selection(self, labels: Sequence[str]) -> None:
        """Say which markers can be taken."""
        self._selection = tuple(labels)
        self.take.setEnabled(bool(labels))
        self.take.setToolTip(
            self.tr("Take the selected markers: {0}").format(self._text(labels))
            if labels
            else self.tr("To take markers, Ctrl+click them in the list.")
        )

    def toggle(self, label: str) -> None:
        """Add a marker, or take it out."""
        labels = self.labels()
        rest = tuple(other for other in labels if other != label)
        self.edit.setText(self._text(rest if len(rest) < len(labels) else (*labels, label)))
        self._tell()

    def _text(self, labels: Sequence[str]) -> str:
        return write_words([self._names.get(label, label) for label in labels])

    def _take(self) -> None:
        self.edit.setText(self._text(self._selection))
        self._tell()

    def _tell_emptied(self, text: str) -> None:
        if not text:
            self._tell()

    def _tell(self) -> None:
        labels = self.labels()
        if labels != self._told:
            self._told = labels
            self.changed.emit()


class _Completer(QCompleter):
    """Completes the last of the names in a text."""

    def __init__(self, names: Sequence[str], edit: QLineEdit) -> None:
        super().__init__(sorted(set(names)), edit)
        self._before = ""
        """What was typed before the last name: the field shows what is highlighted meanwhile."""
        self.setCaseSensitivity(Qt.CaseSensitivity.CaseInsensitive)
        self.setFilterMode(Qt.MatchFlag.MatchContains)

    def splitPath(self, path: str) -> list[str]:
        before, comma, last = path.rpartition(",")
        self._before = f"{before}{comma} " if comma else ""
        return [last.strip()]

    def pathFromIndex(self, index: QModelIndex | QPersistentModelIndex) -> str:
        return self._before + write_words([super().pathFromIndex(index)])
