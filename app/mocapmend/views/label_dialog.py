"""Asks which labelled recordings labels are to be learned from."""

from collections.abc import Iterable
from pathlib import Path

from PySide6.QtCore import Qt, Signal
from PySide6.QtWidgets import (
    QAbstractItemView,
    QCheckBox,
    QDialog,
    QDialogButtonBox,
    QFileDialog,
    QHBoxLayout,
    QLabel,
    QListWidget,
    QListWidgetItem,
    QPushButton,
    QVBoxLayout,
    QWidget,
)

from mocapmend.settings import KEEP_NAMES, LABELLED_FILES, LAST_FOLDER, Settings
from mocapmend.views.file_kinds import all_kinds, kinds
from mocapmend.views.text_scale import fit_text

SIZE = (560, 300)


class LabelDialog(QDialog):
    """A list of files, those of the last time to begin with.

    Signals
    -------
    chosen : list, bool
        The files, and whether names that the recording has are trusted.
    """

    chosen = Signal(list, bool)

    def __init__(self, settings: Settings, parent: QWidget) -> None:
        super().__init__(parent)
        self._settings = settings
        self.setWindowTitle(self.tr("Label from recordings"))
        self.setAttribute(Qt.WidgetAttribute.WA_DeleteOnClose)
        about = QLabel(
            self.tr(
                "Choose labelled recordings of the same marker set, best of the same subject. "
                "Nothing is changed before you have looked at the proposals."
            )
        )
        about.setWordWrap(True)
        self.list = QListWidget()
        self.list.setAccessibleName(self.tr("Labelled recordings"))
        self.list.setSelectionMode(QAbstractItemView.SelectionMode.ExtendedSelection)
        self.keep = QCheckBox(self.tr("Keep the names that this recording has"))
        self.keep.setChecked(settings.get(KEEP_NAMES))
        self.keep.setToolTip(
            self.tr("Off: label all points anew, also those that have names of the marker set")
        )
        self.adding = QPushButton(self.tr("Add…"))
        self.adding.clicked.connect(self._ask)
        self.removing = QPushButton(self.tr("Remove"))
        self.removing.clicked.connect(self._remove)
        self.list.itemSelectionChanged.connect(self._show_possible)
        buttons = QDialogButtonBox(QDialogButtonBox.StandardButton.Cancel)
        self.go = buttons.addButton(self.tr("Label"), QDialogButtonBox.ButtonRole.AcceptRole)
        buttons.accepted.connect(self._choose)
        buttons.rejected.connect(self.reject)
        beside = QVBoxLayout()
        beside.addWidget(self.adding)
        beside.addWidget(self.removing)
        beside.addStretch(1)
        middle = QHBoxLayout()
        middle.addWidget(self.list, 1)
        middle.addLayout(beside)
        layout = QVBoxLayout(self)
        layout.addWidget(about)
        layout.addLayout(middle)
        layout.addWidget(self.keep)
        layout.addWidget(buttons)
        fit_text(self, *SIZE)
        self.add(Path(text) for text in settings.get(LABELLED_FILES) if Path(text).exists())

    @property
    def paths(self) -> list[Path]:
        """The files of the list."""
        items = (self.list.item(row) for row in range(self.list.count()))
        return [Path(item.data(Qt.ItemDataRole.UserRole)) for item in items]

    def add(self, paths: Iterable[Path]) -> None:
        """Put files on the list, each once."""
        known = set(self.paths)
        for path in paths:
            if path in known:
                continue
            item = QListWidgetItem(path.name)
            item.setToolTip(str(path))
            item.setData(Qt.ItemDataRole.UserRole, str(path))
            self.list.addItem(item)
            known.add(path)
        self._show_possible()

    def _ask(self) -> None:
        texts, _ = QFileDialog.getOpenFileNames(
            self,
            self.tr("Labelled recordings"),
            self._settings.get(LAST_FOLDER),
            ";;".join(
                (
                    all_kinds(),
                    *kinds(),
                    self.tr("Templates of labels (*.json)"),
                    self.tr("All files (*)"),
                )
            ),
        )
        self.add(map(Path, texts))

    def _remove(self) -> None:
        for item in self.list.selectedItems():
            self.list.takeItem(self.list.row(item))
        self._show_possible()

    def _show_possible(self) -> None:
        self.removing.setEnabled(bool(self.list.selectedItems()))
        self.go.setEnabled(self.list.count() > 0)
        # Enter goes on to what is to be done.
        (self.go if self.list.count() else self.adding).setDefault(True)

    def _choose(self) -> None:
        paths, keep = self.paths, self.keep.isChecked()
        self._settings.set(LABELLED_FILES, [str(path) for path in paths])
        self._settings.set(KEEP_NAMES, keep)
        self.accept()
        self.chosen.emit(paths, keep)
