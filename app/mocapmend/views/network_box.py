"""A field for a network: one that ships, one used lately, or a file."""

from pathlib import Path

from PySide6.QtCore import Qt, Signal
from PySide6.QtWidgets import QComboBox, QFileDialog, QHBoxLayout, QPushButton, QWidget

from mocapmend.refine import models
from mocapmend.settings import LAST_FOLDER, REFINE_FILES, REFINE_NETWORK, Settings

MOST_FILES = 5


class NetworkBox(QWidget):
    """Chooses a network from a list, which a button adds files to."""

    changed = Signal()

    def __init__(self, settings: Settings, parent: QWidget | None = None) -> None:
        super().__init__(parent)
        self._settings = settings
        self.combo = QComboBox()
        self.combo.setAccessibleName(self.tr("Network"))
        self.combo.setSizeAdjustPolicy(
            QComboBox.SizeAdjustPolicy.AdjustToMinimumContentsLengthWithIcon
        )
        self.combo.setPlaceholderText(self.tr("none is chosen"))
        for name in models.names():
            self.combo.addItem(name, name)
        for text in settings.get(REFINE_FILES):
            if Path(text).exists():
                self._add(text)
        last = self.combo.findData(settings.get(REFINE_NETWORK))
        first = max(0, self.combo.findData(models.DEFAULT)) if self.combo.count() else -1
        self.combo.setCurrentIndex(last if last >= 0 else first)
        self.choosing = QPushButton(self.tr("Choose file…"))
        # Enter begins what the dialog is for.
        self.choosing.setAutoDefault(False)
        self.choosing.clicked.connect(self._ask)
        layout = QHBoxLayout(self)
        layout.setContentsMargins(0, 0, 0, 0)
        layout.addWidget(self.combo, 1)
        layout.addWidget(self.choosing)
        self.setFocusProxy(self.combo)
        self.combo.currentIndexChanged.connect(self.changed)

    def name(self) -> str:
        """Return the name or the path of the chosen network; "" where none is."""
        return str(self.combo.currentData() or "")

    def remember(self) -> None:
        """Offer the chosen one first the next time."""
        name = self.name()
        self._settings.set(REFINE_NETWORK, name)
        if name not in models.names():
            others = [text for text in self._settings.get(REFINE_FILES) if text != name]
            self._settings.set(REFINE_FILES, [name, *others][:MOST_FILES])

    def choose(self, path: Path) -> None:
        """Put a file on the list and choose it."""
        text = str(path)
        if self.combo.findData(text) < 0:
            self._add(text)
        self.combo.setCurrentIndex(self.combo.findData(text))

    def _add(self, text: str) -> None:
        self.combo.addItem(Path(text).name, text)
        self.combo.setItemData(self.combo.count() - 1, text, Qt.ItemDataRole.ToolTipRole)

    def _ask(self) -> None:
        text, _ = QFileDialog.getOpenFileName(
            self,
            self.tr("Choose a network"),
            self._settings.get(LAST_FOLDER),
            ";;".join((self.tr("Networks (*.npz)"), self.tr("All files (*)"))),
        )
        if text:
            self.choose(Path(text))
