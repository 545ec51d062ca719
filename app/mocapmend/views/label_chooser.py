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
        take: Callable[[str], object],
        parent: QWidget,
    ) -> None:
        self._take = take
        places = [(label, self.tr("free here")) for label in free]
        places += [(label, self.tr("no point has it yet")) for label in unused]
        places += [(label, self.tr("is seen here: the two are exchanged")) for label in taken]
        entries = [Entry(label, place, "", partial(take, label)) for label, place in places]
        super().__init__(entries, parent)
        self.setWindowTitle(self.tr("{0} is…").format(name))
        self.field.setPlaceholderText(self.tr("Type a label"))
        self.field.setAccessibleName(self.tr("Which marker it is"))

    def _show_refusal(self) -> None:
        super()._show_refusal()
        typed = self.field.text().strip()
        if not self._shown and typed:
            self.hint.setText(self.tr("Enter gives the new label {0}.").format(typed))

    def _run(self) -> None:
        typed = self.field.text().strip()
        if self._shown or not typed:
            super()._run()
            return
        self.accept()
        self._take(typed)
