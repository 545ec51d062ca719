"""The language of the window: which one the user wants, and the texts in it."""

from importlib.resources import files
from typing import TYPE_CHECKING, Final

from PySide6.QtCore import QCoreApplication, QLibraryInfo, QLocale, QTranslator

from mocapmend.settings import LANGUAGE, Settings

if TYPE_CHECKING:
    from mocapmend.views.main_window import MainWindow

translate = QCoreApplication.translate

SYSTEM: Final = "system"
ENGLISH: Final = "en"
CHINESE: Final = "zh_CN"
CHOICES: Final = (SYSTEM, ENGLISH, CHINESE)


def wanted(settings: Settings) -> str:
    """Return what the user wants: a language's name or "system"."""
    chosen = settings.get(LANGUAGE)
    return chosen if chosen in CHOICES else SYSTEM


def choose(choice: str, window: "MainWindow") -> None:
    """Want a language by its name, or the system's, from the next start on."""
    window.settings.set(LANGUAGE, choice)
    window.say(translate("Language", "The language changes at the next start."))


def of_system(languages: list[str]) -> str:
    """Return the language for a user of the system's languages, the preferred one first.

    A later one does not count: a user who prefers English to Chinese gets English.
    """
    first = QLocale(languages[0].replace("-", "_")) if languages else QLocale.c()
    simplified = first.script() == QLocale.Script.SimplifiedHanScript
    return CHINESE if first.language() == QLocale.Language.Chinese and simplified else ENGLISH


def install(app: QCoreApplication, settings: Settings) -> str:
    """Give the program the language that the user wants, before any window is made; return it."""
    choice = wanted(settings)
    language = of_system(QLocale.system().uiLanguages()) if choice == SYSTEM else choice
    if choice != SYSTEM:
        QLocale.setDefault(QLocale(language))
    if language != ENGLISH:
        ours = str(files("mocapmend_resources") / "translations")
        qt = QLibraryInfo.path(QLibraryInfo.LibraryPath.TranslationsPath)
        for name, folder in ((f"qtbase_{language}", qt), (f"mocapmend_{language}", ours)):
            translator = QTranslator(app)
            if translator.load(name, folder):
                app.installTranslator(translator)
    return language
