"""Labelling by hand: "This is…", and on to the next point without a label.

Names of edits are English, for reports and journals; they are translated where shown.
"""

from collections.abc import Callable

from PySide6.QtCore import QObject, Signal

from mocapmend.commands import EditSamples
from mocapmend.correcting import step
from mocapmend.document import Document
from mocapmend.errors import MocapmendError
from mocapmend.hand_labels import free_and_taken, given, next_without_label, stretch
from mocapmend.renaming import checked_label, full_label, without_label
from mocapmend.views.engine_texts import error_text
from mocapmend.views.filling import Filling
from mocapmend.viewstate import ViewState


class HandLabelActions(QObject):
    """Gives stretches of the current marker to labels, each time in one undoable step.

    Parameters
    ----------
    do : callable
        Does an undo command.

    Signals
    -------
    message : str
        Something the user should read in passing.
    """

    message = Signal(str)

    def __init__(
        self,
        document: Document,
        view: ViewState,
        filling: Filling,
        do: Callable[[EditSamples], None],
        parent: QObject | None = None,
    ) -> None:
        super().__init__(parent)
        self._document = document
        self._view = view
        self._filling = filling
        self._do = do

    def choices(self) -> tuple[list[int], list[int]] | None:
        """Return the points whose labels are free where the user is, and the others with labels.

        None where no point is meant; then it is told why.
        """
        marker = self._view.marker
        if marker is None:
            self.message.emit(self.tr("Select a marker first."))
            return None
        try:
            frames = stretch(self._document, marker, self._view.frame, self._view.span)
        except MocapmendError as error:
            self.message.emit(error_text(error))
            return None
        return free_and_taken(self._document, marker, frames)

    def may_be_new(self, marker: int) -> bool:
        """Say whether a point may get a label that no point has: it has none itself."""
        return marker in without_label(self._document.labels)

    def this_is(self, typed: str) -> None:
        """Say which marker the current one is, from the playhead on or in the selected frames."""
        document, view, marker = self._document, self._view, self._view.marker
        if marker is None:
            return
        try:
            label = checked_label(typed)
            if label not in document.labels:
                # What is read in the list is without the subject.
                label = full_label(document.labels, label)
            start, stop = stretch(document, marker, view.frame, view.span)
            made = given(document, marker, (start, stop), label)
        except MocapmendError as error:
            self.message.emit(error_text(error))
            return
        name = document.names[marker]
        if made.exchange is None:
            self._do(EditSamples(document, [], f"rename {name} to {label}", labels={marker: label}))
            self.message.emit(self.tr("{0} is called {1} now.").format(name, label))
        else:
            first = document.original.first_frame
            frames = f"{start + first} to {stop - 1 + first}"
            correction = step(document, exchanges=[made.exchange])
            text = f"label {name} as {document.names[made.point]}, frames {frames}"
            self._do(EditSamples(document, correction.edits, text, correction.correction))
            self._filling.refill()
            said = self.tr("Frames {0} to {1} of {2} are {3} now.")
            told = start + first, stop - 1 + first, name, document.names[made.point]
            self.message.emit(said.format(*told))
        if not self.go_on(marker):
            self._view.select((made.point,))

    def step(self) -> None:
        """Go to the next point without a label."""
        if not self.go_on(self._view.marker):
            self.message.emit(self.tr("All points that are seen have labels."))

    def go_on(self, after: int | None) -> bool:
        """Select the next point without a label; say whether there is one."""
        found = next_without_label(self._document, after, self._view.frame)
        if found is None:
            return False
        point, frame = found
        self._view.select((point,))
        self._view.set_frame(frame)
        self._view.keep_in_view()
        return True
