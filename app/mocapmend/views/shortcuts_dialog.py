"""The list of all actions and their keys, which can be changed here."""

from PySide6.QtCore import Qt
from PySide6.QtGui import QKeySequence
from PySide6.QtWidgets import (
    QDialog,
    QDialogButtonBox,
    QHBoxLayout,
    QHeaderView,
    QKeySequenceEdit,
    QLabel,
    QLineEdit,
    QPushButton,
    QTableWidget,
    QTableWidgetItem,
    QVBoxLayout,
    QWidget,
)

from mocapmend.action_table import ACTIONS
from mocapmend.actions import menu_name, submenu_of, text_of
from mocapmend.views.fuzzy import ranked
from mocapmend.views.shortcuts import Shortcuts
from mocapmend.views.tables import dress
from mocapmend.views.text_scale import fit_text

SIZE = (760, 560)


class ShortcutsDialog(QDialog):
    """Finds an action by its name or its keys, and gives it others."""

    def __init__(self, shortcuts: Shortcuts, parent: QWidget) -> None:
        super().__init__(parent)
        self._shortcuts = shortcuts
        self._specs = list(ACTIONS)
        self.setWindowTitle(self.tr("Keyboard shortcuts"))
        self.setAttribute(Qt.WidgetAttribute.WA_DeleteOnClose)
        self.field = QLineEdit()
        self.field.setPlaceholderText(self.tr("Search for an action or a key"))
        self.field.setAccessibleName(self.tr("Search"))
        self.field.setClearButtonEnabled(True)
        self.field.textChanged.connect(self._fill)
        self.table = self._make_table()
        self.edit = QKeySequenceEdit()
        self.edit.setMaximumSequenceLength(1)
        self.edit.setAccessibleName(self.tr("New key"))
        self.edit.setClearButtonEnabled(True)
        self.edit.keySequenceChanged.connect(self._show_conflict)
        self.answer = QLabel()
        self.answer.setWordWrap(True)
        self.answer.setTextFormat(Qt.TextFormat.PlainText)
        self.answer.setMinimumHeight(2 * self.answer.fontMetrics().height())
        self.set_button = self._button(self.tr("Set"), self._set)
        self.set_button.setToolTip(self.tr("Make this the only key of the action"))
        self.add_button = self._button(self.tr("Add"), self._add)
        self.add_button.setToolTip(self.tr("Keep its other keys too"))
        self.none_button = self._button(self.tr("No key"), self._clear)
        self.reset_button = self._button(self.tr("Reset"), self._reset)
        self.reset_button.setToolTip(self.tr("Give the action its first keys again"))
        editing = QHBoxLayout()
        self._name = QLabel()
        editing.addWidget(self._name, 1)
        for part in (
            self.edit,
            self.set_button,
            self.add_button,
            self.none_button,
            self.reset_button,
        ):
            editing.addWidget(part)
        buttons = QDialogButtonBox(QDialogButtonBox.StandardButton.Close)
        self.reset_all_button = buttons.addButton(
            self.tr("Reset all"), QDialogButtonBox.ButtonRole.ResetRole
        )
        self.reset_all_button.setAutoDefault(False)
        self.reset_all_button.clicked.connect(self._reset_all)
        buttons.button(QDialogButtonBox.StandardButton.Close).setAutoDefault(False)
        buttons.rejected.connect(self.reject)
        layout = QVBoxLayout(self)
        layout.addWidget(self.field)
        layout.addWidget(self.table)
        layout.addLayout(editing)
        layout.addWidget(self.answer)
        layout.addWidget(self._mouse_help())
        layout.addWidget(buttons)
        fit_text(self, *SIZE)
        self._fill()

    @property
    def current(self) -> str:
        """Id of the action whose keys can be changed; empty if none is listed."""
        row = self.table.currentRow()
        return self._specs[row].id if 0 <= row < len(self._specs) else ""

    # --- parts -------------------------------------------------------------------------------

    def _make_table(self) -> QTableWidget:
        table = QTableWidget(0, 3)
        table.setHorizontalHeaderLabels([self.tr("Menu"), self.tr("Action"), self.tr("Keys")])
        table.setAccessibleName(self.tr("Actions and their keys"))
        dress(table)
        table.setSelectionMode(QTableWidget.SelectionMode.SingleSelection)
        header = table.horizontalHeader()
        header.setSectionResizeMode(QHeaderView.ResizeMode.ResizeToContents)
        header.setSectionResizeMode(1, QHeaderView.ResizeMode.Stretch)
        table.currentCellChanged.connect(self._show_action)
        table.activated.connect(self._edit)
        return table

    def _button(self, text: str, call: object) -> QPushButton:
        button = QPushButton(text)
        button.setAutoDefault(False)
        button.clicked.connect(call)
        return button

    def _mouse_help(self) -> QLabel:
        hint = QLabel(
            self.tr(
                "3D view: drag to orbit, Shift+drag to move, wheel to zoom, click to pick, "
                "double-click to centre. Plots and timeline: drag to scrub, wheel to zoom, "
                "Shift+wheel to move, double-click a gap to go there; Ctrl+click adds a marker."
            )
        )
        hint.setWordWrap(True)
        return hint

    # --- what it shows -----------------------------------------------------------------------

    def _fill(self) -> None:
        """List the actions that fit what is searched for; the current one stays current."""
        current = self.current
        texts = [
            f"{text_of(spec)} {menu_name(spec.menu)} {self._keys_of(spec.id)}" for spec in ACTIONS
        ]
        typed = self.field.text()
        # Signs are no words: a key like "]" is found in the text as it is.
        order = ranked(typed, texts) if any(map(str.isalnum, typed)) else range(len(ACTIONS))
        if typed and not any(map(str.isalnum, typed)):
            order = [k for k, text in enumerate(texts) if typed.strip() in text]
        self._specs = [ACTIONS[k] for k in order]
        self.table.setRowCount(len(self._specs))
        for row, spec in enumerate(self._specs):
            place = menu_name(spec.menu)
            if spec.submenu:
                place = f"{place} › {submenu_of(spec)}"
            keys = self._keys_of(spec.id)
            if self._shortcuts.is_changed(spec.id):
                keys = self.tr("{0} (changed)").format(keys or "—")
            for column, text in enumerate((place, text_of(spec), keys)):
                self.table.setItem(row, column, QTableWidgetItem(text))
        ids = [spec.id for spec in self._specs]
        self.table.setCurrentCell(ids.index(current) if current in ids else 0, 0)
        self._show_action()

    def _keys_of(self, name: str) -> str:
        native = QKeySequence.SequenceFormat.NativeText
        return ", ".join(key.toString(native) for key in self._shortcuts.keys(name))

    def _show_action(self) -> None:
        self.edit.clear()
        has = bool(self.current)
        for part in (self.edit, self.none_button):
            part.setEnabled(has)
        self.reset_button.setEnabled(has and self._shortcuts.is_changed(self.current))
        self._name.setText(
            text_of(self._specs[self.table.currentRow()])
            if has
            else self.tr("Nothing fits. Fewer letters find more.")
        )
        self._show_conflict()

    def _show_conflict(self) -> None:
        """Say what a key that was typed means already; it cannot be set then."""
        key = self.edit.keySequence()
        typed = bool(self.current) and not key.isEmpty()
        other = self._shortcuts.conflict(self.current, key) if typed else ""
        for button in (self.set_button, self.add_button):
            button.setEnabled(typed and not other)
        self._answer(key, other)

    def _answer(self, key: QKeySequence, other: str) -> None:
        text = ""
        if other:
            text = self.tr("{0} belongs to “{1}”. Choose another key, or change that one first.")
            text = text.format(key.toString(QKeySequence.SequenceFormat.NativeText), other)
        self.answer.setText(text)

    # --- what the user does ------------------------------------------------------------------

    def _edit(self) -> None:
        self.edit.setFocus()

    def _set(self) -> None:
        self._shortcuts.choose(self.current, [self.edit.keySequence()])
        self._fill()

    def _add(self) -> None:
        keys, new = self._shortcuts.keys(self.current), self.edit.keySequence()
        self._shortcuts.choose(self.current, [*(key for key in keys if key != new), new])
        self._fill()

    def _clear(self) -> None:
        self._shortcuts.choose(self.current, [])
        self._fill()

    def _reset(self) -> None:
        other = self._shortcuts.reset(self.current)
        if other:
            text = self.tr("One of its first keys belongs to “{0}” now. Change that one first.")
            self.answer.setText(text.format(other))
        else:
            self._fill()

    def _reset_all(self) -> None:
        self._shortcuts.reset_all()
        self._fill()
