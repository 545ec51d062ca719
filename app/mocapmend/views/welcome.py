"""What the window shows before a file is open."""

from collections.abc import Sequence
from html import escape
from pathlib import Path

from PySide6.QtCore import Qt, Signal
from PySide6.QtGui import QFont
from PySide6.QtWidgets import QHBoxLayout, QLabel, QPushButton, QVBoxLayout, QWidget

from mocapmend.views.icons import program_icon

RECENT_SHOWN = 5


class Welcome(QWidget):
    """Ways in: a file, a recent file, a sample recording.

    Signals
    -------
    chosen : Path
        The file to open.
    browse :
        The user wants to look for a file.
    """

    chosen = Signal(object)
    browse = Signal()

    def __init__(self, samples: Sequence[tuple[Path, str]], parent: QWidget | None = None) -> None:
        super().__init__(parent)
        logo = QLabel()
        logo.setPixmap(program_icon().pixmap(48, 48))
        title = QLabel("mocapmend")
        title.setFont(_bold(title, 2.4))
        head = QHBoxLayout()
        head.addStretch(1)
        head.addWidget(logo)
        head.addSpacing(8)
        head.addWidget(title)
        head.addStretch(1)
        hint = QLabel(self.tr("Open a C3D recording, or drop one here."))
        hint.setAlignment(Qt.AlignmentFlag.AlignCenter)
        button = QPushButton(self.tr("Open…"))
        button.setMinimumWidth(160)
        button.clicked.connect(self.browse)
        self._recent = QVBoxLayout()
        layout = QVBoxLayout(self)
        layout.setSpacing(10)
        layout.addStretch(2)
        layout.addLayout(head)
        layout.addWidget(hint)
        layout.addWidget(button, 0, Qt.AlignmentFlag.AlignCenter)
        layout.addSpacing(14)
        layout.addLayout(self._recent)
        layout.addWidget(_heading(self.tr("Sample recordings")))
        for path, text in samples:
            layout.addWidget(self._link(path, text), 0, Qt.AlignmentFlag.AlignCenter)
        layout.addStretch(3)

    def show_recent(self, paths: Sequence[str]) -> None:
        """List the files that were open lately."""
        while (item := self._recent.takeAt(0)) is not None:
            widget = item.widget()
            if widget is not None:
                widget.deleteLater()
        if paths:
            self._recent.addWidget(_heading(self.tr("Recent files")))
        for text in paths[:RECENT_SHOWN]:
            path = Path(text)
            link = self._link(path, path.name)
            link.setToolTip(text)
            self._recent.addWidget(link, 0, Qt.AlignmentFlag.AlignCenter)

    def _link(self, path: Path, text: str) -> QLabel:
        link = QLabel(f'<a href="open">{escape(text)}</a>')
        link.setTextInteractionFlags(
            Qt.TextInteractionFlag.LinksAccessibleByMouse
            | Qt.TextInteractionFlag.LinksAccessibleByKeyboard
        )
        link.linkActivated.connect(lambda _: self.chosen.emit(path))
        return link


def _heading(text: str) -> QLabel:
    label = QLabel(text)
    label.setAlignment(Qt.AlignmentFlag.AlignCenter)
    label.setFont(_bold(label, 1.0))
    label.setContentsMargins(0, 10, 0, 0)
    return label


def _bold(label: QLabel, scale: float) -> QFont:
    """Return a label's font, bold and scaled; a style sheet would not follow the theme."""
    font = label.font()
    font.setPointSizeF(font.pointSizeF() * scale)
    font.setBold(True)
    return font
