"""A field for a training set: the recording itself, one that ships, or a file."""

from pathlib import Path

from PySide6.QtCore import Qt, Signal
from PySide6.QtWidgets import (
    QComboBox,
    QFileDialog,
    QHBoxLayout,
    QLineEdit,
    QPushButton,
    QSizePolicy,
    QWidget,
)

from mocapmend_resources import training

SHORTEST = 10
"""Characters that the list shows at least."""


class TrainingBox(QWidget):
    """Chooses a training set from a list, by typing a path, or in a dialog.

    Parameters
    ----------
    name : str
        To begin with: the name of one that ships, a path, or nothing for the recording itself.
    label : str
        What the field is called, for those who hear it.
    """

    changed = Signal()

    def __init__(self, name: str, label: str, parent: QWidget | None = None) -> None:
        super().__init__(parent)
        self._itself = self.tr("this recording")
        self.combo = QComboBox()
        self.combo.setEditable(True)
        self.combo.setInsertPolicy(QComboBox.InsertPolicy.NoInsert)
        self.combo.addItems([self._itself, *training.names()])
        self.combo.setSizeAdjustPolicy(
            QComboBox.SizeAdjustPolicy.AdjustToMinimumContentsLengthWithIcon
        )
        self.combo.setMinimumContentsLength(SHORTEST)
        self.combo.setSizePolicy(QSizePolicy.Policy.Expanding, QSizePolicy.Policy.Fixed)
        self.combo.setAccessibleName(label)
        self.browse = QPushButton("…")
        self.browse.setToolTip(self.tr("Browse…"))
        self.browse.setAccessibleName(self.tr("Browse for a training set"))
        # A click must not take the keyboard from the rest of the window.
        self.browse.setFocusPolicy(Qt.FocusPolicy.TabFocus)
        # The pane is narrow: room for the name.
        self.browse.setFixedWidth(self.browse.sizeHint().height())
        layout = QHBoxLayout(self)
        layout.setContentsMargins(0, 0, 0, 0)
        layout.setSpacing(4)
        layout.addWidget(self.combo, 1)
        layout.addWidget(self.browse)
        self.setFocusProxy(self.combo)
        self._told = name
        self._show(name)
        self.browse.clicked.connect(self._ask)
        self.combo.activated.connect(self._tell)
        self._edit.setPlaceholderText(self._itself)
        self._edit.editingFinished.connect(self._tell)
        self._edit.textChanged.connect(self._tell_emptied)

    def name(self) -> str:
        """Return the chosen one as parameters name it; empty for the recording itself."""
        text = self._edit.text().strip()
        return "" if text == self._itself else text

    def _ask(self) -> None:
        name = self.name()
        at_hand = name and name not in training.names()
        path, _ = QFileDialog.getOpenFileName(
            self,
            self.tr("Choose a training set"),
            str(Path(name).parent) if at_hand else "",
            ";;".join((self.tr("Training sets (*.npz)"), self.tr("All files (*)"))),
        )
        if path:
            self._show(path)
            self._tell()

    @property
    def _edit(self) -> QLineEdit:
        edit = self.combo.lineEdit()
        assert edit is not None
        return edit

    def _show(self, name: str) -> None:
        # The list would keep the place of what was chosen before.
        self.combo.setCurrentIndex(self.combo.findText(name or self._itself))
        self.combo.setEditText(name or self._itself)
        # The end of a path says more than its beginning.
        self._edit.setCursorPosition(len(self._edit.text()))
        self.combo.setToolTip(name)

    def _tell(self) -> None:
        name = self.name()
        if name != self._told:
            self._told = name
            self.combo.setToolTip(name)
            self.changed.emit()

    def _tell_emptied(self, text: str) -> None:
        if not text:
            self._tell()
