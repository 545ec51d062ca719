"""What the last export of a document has proved, as long as the document is as it was then."""

from pathlib import Path

from PySide6.QtCore import QObject

from mocapmend.document import Document
from mocapmend.exporting import Exported
from mocapmend.views.engine_texts import shown
from mocapmend.views.report_facts import ReportFacts
from mocapmend.views.report_pane import ReportPane


class Proofs(QObject):
    """Shows the proofs of an export in the report, and takes them back at the next edit.

    Its owner calls `show` when the document has become as it was exported, or is so no more.

    Attributes
    ----------
    last_export : Path or None
        The file that was written last.
    """

    def __init__(
        self,
        document: Document,
        facts: ReportFacts,
        report: ReportPane,
        parent: QObject | None = None,
    ) -> None:
        super().__init__(parent)
        self._document = document
        self._facts = facts
        self._report = report
        self.last_export: Path | None = None
        self._exported: Exported | None = None
        self.show()

    def take(self, exported: Exported, *, complete: bool) -> None:
        """Take note that a file now holds the edits: all of them, or those of a while ago."""
        self.last_export = exported.saved.path
        if complete:
            self._exported = exported
            self._document.undo_stack.setClean()
        self.show()

    @property
    def _current(self) -> Exported | None:
        """The export that holds the recording as it is now, if there is one."""
        return self._exported if self._document.undo_stack.isClean() else None

    def show(self) -> None:
        """Show what is proved of the document as it is now."""
        exported = self._current
        self._facts.proof = () if exported is None else exported.sentences
        if self.last_export is None:
            self._report.show_proof(self.tr("Not exported yet."))
        elif exported is None:
            edited = self.tr("Edited since {0} was exported.")
            self._report.show_proof(edited.format(self.last_export.name))
        else:
            proved, name = tuple(map(shown, exported.sentences)), exported.saved.path.name
            self._report.show_proof(f"✔ {name}: {proved[0]}", proved)
