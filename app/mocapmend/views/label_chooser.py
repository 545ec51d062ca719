"""Asks which marker a point is: a label is typed or taken from the list."""

from collections.abc import Callable, Sequence
from functools import partial

from PySide6.QtWidgets import QWidget

from mocapmend.views.palette import Entry, Palette


class LabelChooser(Palette):
    """A field to type in, and below it the labels that fit; Enter takes the first.

    Parameters
    ----------
    name : str
        What the point is called now.
    free, taken, unused : sequence of str
        Labels whose points are not seen there, those whose points are, and those without a point.
    new : bool
        Whether the point may get a label that no point has.
    take : callable
        Is told the label.
    parent : QWidget
        It is asked over.
    """

    def __init__(
        self,
        name: str,
        free: Sequence[str],
        taken: Sequence[str],
        unused: Sequence[str],
        *,
        new: bool,
        take: Callable[[str], object],
        parent: QWidget,
    ) -> None:
        self._take = take
        self._new = new
        places = [(label, self.tr("free here")) for label in free]
        if new:
            places += [(label, self.tr("no point has it yet")) for label in unused]
        places += [(label, self.tr("is seen here: the two are exchanged")) for label in taken]
        entries = [Entry(label, place, "", partial(take, label)) for label, place in places]
        super().__init__(entries, parent)
        self.setWindowTitle(self.tr("{0} is…").format(name))
        self.field.setPlaceholderText(self.tr("Type a label"))
        self.field.setAccessibleName(self.tr("Which marker it is"))

    def _fitting(self, typed: str) -> list[Entry]:
        found, label = super()._fitting(typed), typed.strip()
        if self._new and label and all(label != entry.text for entry in found):
            # Last: what is typed is mostly a part of a label that there is.
            found.append(Entry(label, self.tr("new label"), "", partial(self._take, label)))
        return found

    def _show_refusal(self) -> None:
        super()._show_refusal()
        if not self._shown:
            self.hint.setText(self.tr("No point has this label. Rename the marker instead (F2)."))
