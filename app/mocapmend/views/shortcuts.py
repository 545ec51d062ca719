"""Which keys do what: those of the table of actions, or those that the user has chosen."""

from collections.abc import Mapping, Sequence

from PySide6.QtCore import QObject, Signal
from PySide6.QtGui import QAction, QKeySequence

from mocapmend.action_table import ACTIONS
from mocapmend.actions import set_keys, standard_keys, text_of
from mocapmend.settings import SHORTCUTS, Settings

_SPECS = {spec.id: spec for spec in ACTIONS}


class Shortcuts(QObject):
    """The keys of all actions, remembered in the settings.

    Signals
    -------
    changed :
        Some action has other keys.
    """

    changed = Signal()

    def __init__(
        self, actions: Mapping[str, QAction], settings: Settings, parent: QObject | None = None
    ) -> None:
        super().__init__(parent)
        self._actions = actions
        self._settings = settings
        for name, texts in self._chosen().items():
            set_keys(_SPECS[name], actions[name], [QKeySequence(text) for text in texts])

    def keys(self, name: str) -> list[QKeySequence]:
        """Return the keys of an action."""
        return self._actions[name].shortcuts()

    def is_changed(self, name: str) -> bool:
        """Say whether an action has keys that the user has chosen."""
        return name in self._chosen()

    def conflict(self, name: str, key: QKeySequence) -> str:
        """Return what the user reads of the other action that has a key, or an empty text."""
        for other, spec in _SPECS.items():
            if other != name and key in self.keys(other):
                return text_of(spec)
        return ""

    def choose(self, name: str, keys: Sequence[QKeySequence]) -> None:
        """Give an action other keys; they must not be those of another one."""
        set_keys(_SPECS[name], self._actions[name], keys)
        texts = [key.toString(QKeySequence.SequenceFormat.PortableText) for key in keys]
        chosen: dict[str, object] = self._settings.get(SHORTCUTS)
        self._settings.set(SHORTCUTS, {**chosen, name: texts})
        self.changed.emit()

    def reset(self, name: str) -> str:
        """Give an action the keys of the table again.

        Returns
        -------
        str
            What the user reads of another action that has one of them now; nothing is changed
            then. Else empty.
        """
        standard = standard_keys(_SPECS[name])
        for key in standard:
            if other := self.conflict(name, key):
                return other
        set_keys(_SPECS[name], self._actions[name], standard)
        chosen: dict[str, object] = self._settings.get(SHORTCUTS)
        chosen.pop(name, None)
        self._settings.set(SHORTCUTS, chosen)
        self.changed.emit()
        return ""

    def reset_all(self) -> None:
        """Give all actions the keys of the table again."""
        for name, spec in _SPECS.items():
            set_keys(spec, self._actions[name], standard_keys(spec))
        self._settings.set(SHORTCUTS, {})
        self.changed.emit()

    def _chosen(self) -> dict[str, list[str]]:
        """Return what the user has chosen and what this version knows."""
        stored = self._settings.get(SHORTCUTS)
        return {
            name: texts
            for name, texts in stored.items()
            if name in _SPECS
            and isinstance(texts, list)
            and all(isinstance(text, str) for text in texts)
        }
