"""The look of the whole program: the theme that the user wants, and the size of the text."""

from PySide6.QtCore import QObject, Qt, Signal
from PySide6.QtGui import QFontDatabase, QFontInfo, QGuiApplication
from PySide6.QtWidgets import QApplication

from mocapmend import theme
from mocapmend.settings import TEXT_SIZE, THEME, Settings
from mocapmend.theme import DARK, LIGHT, THEMES, Theme

SYSTEM = "system"
CHOICES = (SYSTEM, LIGHT.name, DARK.name)
SIZES = (0.8, 0.9, 1.0, 1.15, 1.3, 1.5, 1.75, 2.0)


class Appearance(QObject):
    """Knows and remembers how the program shall look.

    Signals
    -------
    changed :
        The colours are others, or the size of the text is.
    """

    changed = Signal()

    def __init__(self, settings: Settings, parent: QObject | None = None) -> None:
        super().__init__(parent)
        self._settings = settings
        QGuiApplication.styleHints().colorSchemeChanged.connect(self._follow_system)
        self.theme = self._wanted()
        self._size_text()

    @property
    def choice(self) -> str:
        """What the user wants: a theme's name or "system"."""
        chosen = self._settings.get(THEME)
        return chosen if chosen in CHOICES else SYSTEM

    def choose(self, choice: str) -> None:
        """Want a theme by its name, or the system's ("system")."""
        self._settings.set(THEME, choice)
        self._show()

    def apply(self) -> None:
        """Give the whole program the colours."""
        app = QApplication.instance()
        assert isinstance(app, QApplication)
        theme.apply(app, self.theme)

    @property
    def text_size(self) -> float:
        """Size of the text as a multiple of what the system has."""
        return min(max(self._settings.get(TEXT_SIZE), SIZES[0]), SIZES[-1])

    def step_text(self, steps: int) -> None:
        """Make the text larger (1) or smaller (-1); 0 makes it as large as the system has it."""
        nearest = min(range(len(SIZES)), key=lambda k: abs(SIZES[k] - self.text_size))
        size = SIZES[max(0, min(len(SIZES) - 1, nearest + steps))] if steps else 1.0
        self._settings.set(TEXT_SIZE, size)
        if self._size_text():
            self.changed.emit()

    def _follow_system(self) -> None:
        if self.choice == SYSTEM:
            self._show()

    def _show(self) -> None:
        wanted = self._wanted()
        if wanted is not self.theme:
            self.theme = wanted
            self.apply()
            self.changed.emit()

    def _wanted(self) -> Theme:
        if self.choice != SYSTEM:
            return THEMES[self.choice]
        scheme = QGuiApplication.styleHints().colorScheme()
        return LIGHT if scheme == Qt.ColorScheme.Light else DARK

    def _size_text(self) -> bool:
        """Give the text its size; say whether that is another one."""
        font = QFontDatabase.systemFont(QFontDatabase.SystemFont.GeneralFont)
        font.setPointSizeF(QFontInfo(font).pointSizeF() * self.text_size)
        if font == QApplication.font():
            return False
        QApplication.setFont(font)
        return True
