"""What the window shows before a file is open."""

from collections.abc import Collection, Sequence
from html import escape
from pathlib import Path

from PySide6.QtCore import QEvent, Qt, Signal
from PySide6.QtWidgets import (
    QApplication,
    QHBoxLayout,
    QLabel,
    QPushButton,
    QToolButton,
    QVBoxLayout,
    QWidget,
)

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
    forgotten : str
        The recent file that is to be taken out of the list.
    """

    chosen = Signal(object)
    browse = Signal()
    forgotten = Signal(str)

    def __init__(
        self, samples: Sequence[tuple[Path, str]], theme: Theme, parent: QWidget | None = None
    ) -> None:
        super().__init__(parent)
        self._theme = theme
        self._links: list[tuple[QLabel, str]] = []
        logo = QLabel()
        logo.setPixmap(program_icon().pixmap(48, 48))
        title = QLabel("mocapmend")
        title.setProperty("scale", 2.4)
        _scale(title)
        head = QHBoxLayout()
        head.addStretch(1)
        head.addWidget(logo)
        head.addSpacing(8)
        head.addWidget(title)
        head.addStretch(1)
        hint = QLabel(
            self.tr("Open recordings (C3D, TRC, CSV, BVH, ASF/AMC, npz), or drop them here.")
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
        self.samples = QWidget()
        offered = QVBoxLayout(self.samples)
        offered.setSpacing(10)
        offered.addWidget(_heading(self.tr("Sample recordings")))
        for path, text in samples:
            offered.addWidget(self._link(path, text), 0, Qt.AlignmentFlag.AlignCenter)
        layout.addWidget(self.samples, 0, Qt.AlignmentFlag.AlignCenter)
        layout.addStretch(3)

    def set_theme(self, theme: Theme) -> None:
        """Paint the links in other colours from now on: they do not follow the palette."""
        self._theme = theme
        for link, text in self._links:
            link.setText(self._markup(text))

    def show_recent(self, paths: Sequence[str], gone: Collection[str] = ()) -> None:
        """List the files that were open lately; those that are gone can be taken out."""
        while (item := self._recent.takeAt(0)) is not None:
            widget = item.widget()
            if widget is not None:
                # A row that is about to be deleted must not be found any more.
                self._links = [pair for pair in self._links if not widget.isAncestorOf(pair[0])]
                widget.hide()
                widget.deleteLater()
        if paths:
            self._recent.addWidget(_heading(self.tr("Recent files")))
        for text in paths[:RECENT_SHOWN]:
            row = self._gone_row(text) if text in gone else self._recent_row(text)
            row.setToolTip(text)
            self._recent.addWidget(row, 0, Qt.AlignmentFlag.AlignCenter)

    def _recent_row(self, text: str) -> QWidget:
        path, row = Path(text), QWidget()
        layout = QHBoxLayout(row)
        layout.setContentsMargins(0, 0, 0, 0)
        layout.addWidget(self._link(path, path.name))
        return row

    def _gone_row(self, text: str) -> QWidget:
        name, row = Path(text).name, QWidget()
        label = QLabel(self.tr("{0} is gone").format(_short(name)))
        label.setEnabled(False)
        remove = QToolButton()
        remove.setText("✕")
        remove.setAutoRaise(True)
        remove.setToolTip(self.tr("Remove from the list"))
        remove.setAccessibleName(self.tr("Remove {0} from the list").format(name))
        remove.setProperty("path", text)
        remove.clicked.connect(self._forget)
        layout = QHBoxLayout(row)
        layout.setContentsMargins(0, 0, 0, 0)
        layout.addWidget(label)
        layout.addWidget(remove)
        return row

    def _forget(self) -> None:
        self.forgotten.emit(self.sender().property("path"))

    def changeEvent(self, event: QEvent) -> None:
        super().changeEvent(event)
        if event.type() == QEvent.Type.FontChange:
            for label in self.findChildren(QLabel):
                _scale(label)

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
        link = escape(_short(text))
        return f'<a style="color: {self._theme.accent}" href="open">{link}</a>'


def _short(text: str) -> str:
    """Shorten a name: the window is as wide as its widest page."""
    return text if len(text) <= LONGEST else f"{text[: LONGEST // 2]}…{text[-LONGEST // 2 :]}"


def _heading(text: str) -> QLabel:
    label = QLabel(text)
    label.setAlignment(Qt.AlignmentFlag.AlignCenter)
    label.setProperty("scale", 1.0)
    _scale(label)
    label.setContentsMargins(0, 10, 0, 0)
    return label


def _scale(label: QLabel) -> None:
    """Make a heading bold and as large as its kind is; a style sheet would not follow the theme."""
    scale = label.property("scale")
    if scale is not None:
        font = QApplication.font()
        font.setPointSizeF(font.pointSizeF() * scale)
        font.setBold(True)
        label.setFont(font)
