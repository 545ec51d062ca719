"""A field for the path of a file, with a button that asks for it."""

from collections.abc import Callable
from pathlib import Path

from PySide6.QtCore import Signal
from PySide6.QtWidgets import QHBoxLayout, QLineEdit, QPushButton, QWidget


class PathField(QWidget):
    """A path to be typed or chosen.

    Parameters
    ----------
    name : str
        What the field is called.
    ask : callable
        Asks for a path, which it is given to begin with; returns None where the user gives up.
    """

    changed = Signal()

    def __init__(
        self,
        name: str,
        ask: Callable[[Path | None], Path | None],
        parent: QWidget | None = None,
    ) -> None:
        super().__init__(parent)
        self._ask = ask
        self.edit = QLineEdit()
        self.edit.setAccessibleName(name)
        self.edit.textChanged.connect(self._tell)
        self.browse = QPushButton(self.tr("Browse…"))
        self.browse.setAccessibleName(self.tr("Browse: {0}").format(name))
        # Enter begins what the dialog is for.
        self.browse.setAutoDefault(False)
        self.browse.clicked.connect(self._choose)
        layout = QHBoxLayout(self)
        layout.setContentsMargins(0, 0, 0, 0)
        layout.addWidget(self.edit, 1)
        layout.addWidget(self.browse)
        self.setFocusProxy(self.edit)

    def path(self) -> Path | None:
        """Return what is there, None for nothing."""
        text = self.edit.text().strip()
        return Path(text).expanduser() if text else None

    def set_path(self, path: Path) -> None:
        """Show another path; its end says more than its beginning."""
        self.edit.setText(str(path))
        self.edit.setCursorPosition(len(self.edit.text()))

    def _choose(self) -> None:
        path = self._ask(self.path())
        if path is not None:
            self.set_path(path)

    def _tell(self, text: str) -> None:
        self.edit.setToolTip(text)
        self.changed.emit()
