"""What the table of actions says, in the user's language, and the actions made of it."""

import re
from collections.abc import Mapping, Sequence

from PySide6.QtCore import QCoreApplication, QObject
from PySide6.QtGui import QAction, QKeySequence

from mocapmend.action_table import ACTIONS, ActionSpec, Menu
from mocapmend.translate import QT_TRANSLATE_NOOP

_TITLES: Mapping[Menu, str] = {
    "File": QT_TRANSLATE_NOOP("Menus", "&File"),
    "Edit": QT_TRANSLATE_NOOP("Menus", "&Edit"),
    "Gaps": QT_TRANSLATE_NOOP("Menus", "&Gaps"),
    "Problems": QT_TRANSLATE_NOOP("Menus", "Pro&blems"),
    "Repair": QT_TRANSLATE_NOOP("Menus", "&Repair"),
    "Play": QT_TRANSLATE_NOOP("Menus", "&Play"),
    "View": QT_TRANSLATE_NOOP("Menus", "&View"),
    "Plots": QT_TRANSLATE_NOOP("Menus", "P&lots"),
    "Help": QT_TRANSLATE_NOOP("Menus", "&Help"),
}


def text_of(spec: ActionSpec) -> str:
    """Return what the user reads, in the user's language."""
    return QCoreApplication.translate("Actions", spec.text).format(spec.number)


def menu_title(menu: Menu) -> str:
    """Return what the user reads of a menu, with the mark of its key."""
    return QCoreApplication.translate("Menus", _TITLES[menu])


def menu_name(menu: Menu) -> str:
    """Return what the user reads of a menu, without its key: some languages have it at the end."""
    return re.sub(r"\(&.\)|&", "", menu_title(menu))


def submenu_of(spec: ActionSpec) -> str:
    """Return what the user reads of an action's submenu, in the user's language."""
    return QCoreApplication.translate("Actions", spec.submenu) if spec.submenu else ""


def standard_keys(spec: ActionSpec) -> list[QKeySequence]:
    """Return the keys of the table."""
    # By their texts: a key that is listed twice is ambiguous, and then does nothing.
    sequences = [QKeySequence(key) for key in spec.keys]
    # Some platforms have no key for some standard keys.
    return list({keys.toString(): keys for keys in sequences if not keys.isEmpty()}.values())


def set_keys(spec: ActionSpec, action: QAction, keys: Sequence[QKeySequence]) -> None:
    """Give an action keys, and a tool tip that tells them."""
    action.setShortcuts(keys)
    texts = ", ".join(key_texts(action))
    action.setToolTip(f"{text_of(spec)} ({texts})" if texts else text_of(spec))


def make_actions(parent: QObject) -> Mapping[str, QAction]:
    """Make the QAction of every entry of the table."""
    made = {}
    for spec in ACTIONS:
        action = QAction(text_of(spec), parent)
        action.setObjectName(spec.id)
        action.setCheckable(spec.checkable)
        # Menus show a box to be ticked, like those of the others.
        action.setIconVisibleInMenu(not spec.checkable)
        set_keys(spec, action, standard_keys(spec))
        made[spec.id] = action
    return made


def key_texts(action: QAction) -> list[str]:
    """Return an action's shortcuts as this platform writes them."""
    native = QKeySequence.SequenceFormat.NativeText
    return [keys.toString(native) for keys in action.shortcuts() if not keys.isEmpty()]
