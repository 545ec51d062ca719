"""Whether bad samples are put right before all gaps are filled, and of which kinds."""

from collections.abc import Collection

from PySide6.QtWidgets import QCheckBox

from mocapmend.settings import FIX_FIRST, Settings
from mocapmend.views.suspect_texts import kinds_text
from mocapmend_algorithms.problems.registry import DETECTORS


class FixFirst(QCheckBox):
    """A box to be ticked; a plan that was loaded says which kinds it stands for."""

    def __init__(self, settings: Settings) -> None:
        super().__init__()
        self.setText(self.tr("Fix bad samples first"))
        self._settings = settings
        self._kinds = tuple(DETECTORS)
        self.setChecked(settings.get(FIX_FIRST))
        self.toggled.connect(self._remember)
        self._explain()

    def kinds(self) -> tuple[str, ...]:
        """Return the detectors of what is fixed, by id; none where the box is not ticked."""
        return self._kinds if self.isChecked() else ()

    def set_kinds(self, kinds: Collection[str]) -> None:
        """Take over what a plan says: detectors by id."""
        self._kinds = tuple(kinds) or tuple(DETECTORS)
        self.setChecked(bool(kinds))
        self._explain()

    def _remember(self, on: bool) -> None:  # noqa: FBT001 - a slot of toggled(bool)
        self._settings.set(FIX_FIRST, on)

    def _explain(self) -> None:
        named = ", ".join(map(kinds_text, self._kinds))
        self.setToolTip(
            self.tr("Before all gaps are filled, set aside or exchange: {0}").format(named)
        )
