"""What the window shows before a file is open."""

from collections.abc import Sequence
from html import escape
from pathlib import Path

from PySide6.QtCore import Qt, Signal
from PySide6.QtGui import QFont
from PySide6.QtWidgets import QHBoxLayout, QLabel, QPushButton, QVBoxLayout, QWidget

from mocapmend.theme import Theme
from mocapmend.views.icons import program_icon

RECENT_SHOWN = 5
LONGEST = 60
"""Characters of a file name that are shown."""


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

    def __init__(
        self, samples: Sequence[tuple[Path, str]], theme: Theme, parent: QWidget | None = None
    ) -> None:
        super().__init__(parent)
        self._theme = theme
        self._links: list[tuple[QLabel, str]] = []
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
        hint = QLabel(
            self.tr("Open a recording (C3D, TRC, CSV, BVH, ASF/AMC, npz), or drop one here.")
        )
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

    def set_theme(self, theme: Theme) -> None:
        """Paint the links in other colours from now on: they do not follow the palette."""
        self._theme = theme
        for link, text in self._links:
            link.setText(self._markup(text))

    def show_recent(self, paths: Sequence[str]) -> None:
        """List the files that were open lately."""
        while (item := self._recent.takeAt(0)) is not None:
            widget = item.widget()
            if widget is not None:
                self._links = [pair for pair in self._links if pair[0] is not widget]
                widget.deleteLater()
        if paths:
            self._recent.addWidget(_heading(self.tr("Recent files")))
        for text in paths[:RECENT_SHOWN]:
            path = Path(text)
            link = self._link(path, path.name)
            link.setToolTip(text)
            self._recent.addWidget(link, 0, Qt.AlignmentFlag.AlignCenter)

    def _link(self, path: Path, text: str) -> QLabel:
        link = QLabel(self._markup(text))
        link.setTextInteractionFlags(
            Qt.TextInteractionFlag.LinksAccessibleByMouse
            | Qt.TextInteractionFlag.LinksAccessibleByKeyboard
        )
        link.linkActivated.connect(lambda _: self.chosen.emit(path))
        self._links.append((link, text))
        return link

    def _markup(self, text: str) -> str:
        # The window is as wide as its widest page: a long name must not stretch it.
        short = text if len(text) <= LONGEST else f"{text[: LONGEST // 2]}…{text[-LONGEST // 2 :]}"
        return f'<a style="color: {self._theme.accent}" href="open">{escape(short)}</a>'


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
