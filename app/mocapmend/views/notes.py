"""What was odd in the file, one click away."""

from PySide6.QtCore import Qt
from PySide6.QtWidgets import QMessageBox, QToolButton, QWidget

from mocapmend.views.dialogs import widen
from mocapmend.views.engine_texts import shown


class NotesBar(QToolButton):
    """A button that tells how many notes the reader made, and shows them."""

    def __init__(self, parent: QWidget | None = None) -> None:
        super().__init__(parent)
        self._warnings: tuple[str, ...] = ()
        self.setAutoRaise(True)
        self.clicked.connect(self._show)

    def show_warnings(self, warnings: tuple[str, ...]) -> None:
        """Offer the notes of a file, or hide when there are none."""
        self._warnings = tuple(map(shown, warnings))
        count = len(warnings)
        text = self.tr("1 note on this file") if count == 1 else self.tr("{0} notes on this file")
        self.setText("⚠ " + text.format(count))
        self.setToolTip("\n".join(self._warnings))
        self.setVisible(bool(warnings))

    def _show(self) -> None:
        box = QMessageBox(self.window())
        box.setAttribute(Qt.WidgetAttribute.WA_DeleteOnClose)
        box.setWindowTitle("mocapmend")
        box.setTextFormat(Qt.TextFormat.PlainText)
        box.setText(self.tr("What was odd in this file, and what was assumed:"))
        box.setInformativeText("\n\n".join(f"• {text}" for text in self._warnings))
        widen(box)
        box.open()
