"""The pane of analog channels: a list to choose from, and their plots."""

from PySide6.QtCore import Qt, Signal
from PySide6.QtGui import QShowEvent
from PySide6.QtWidgets import (
    QCheckBox,
    QLineEdit,
    QListWidget,
    QListWidgetItem,
    QSplitter,
    QVBoxLayout,
    QWidget,
)

from mocapmend.errors import MocapmendError
from mocapmend.files import C3DFile
from mocapmend.jobs import Job, Jobs
from mocapmend.theme import Theme
from mocapmend.views.analog_data import read_channels, wanted_at_once
from mocapmend.views.analog_plots import AnalogPlots
from mocapmend.views.columns import Envelope
from mocapmend.viewstate import ViewState

CHANNEL = Qt.ItemDataRole.UserRole


class AnalogPane(QWidget):
    """Shows chosen analog channels of a file; they are read in the background when first chosen.

    Signals
    -------
    failed : Exception
        What went wrong that no user can mend; what a user can is written in the plots.
    """

    failed = Signal(object)

    def __init__(
        self,
        source: C3DFile,
        view: ViewState,
        jobs: Jobs,
        theme: Theme,
        parent: QWidget | None = None,
    ) -> None:
        super().__init__(parent)
        self._source = source
        self._jobs = jobs
        self._job: Job | None = None
        self._read: dict[int, Envelope] = {}
        self.plots = AnalogPlots(source, view, theme)
        self.list = self._make_list()
        self.filter = QLineEdit()
        self.filter.setPlaceholderText(self.tr("Filter channels"))
        self.filter.setAccessibleName(self.tr("Filter channels"))
        self.filter.setClearButtonEnabled(True)
        self.filter.textChanged.connect(self._filter)
        self.overlay = QCheckBox(self.tr("Overlay"))
        self.overlay.setToolTip(self.tr("All channels in one plot"))
        self.overlay.toggled.connect(self.plots.set_overlaid)
        left = QWidget()
        column = QVBoxLayout(left)
        column.setContentsMargins(4, 4, 4, 4)
        column.setSpacing(4)
        for part in (self.filter, self.list, self.overlay):
            column.addWidget(part)
        parts = QSplitter(Qt.Orientation.Horizontal)
        parts.addWidget(left)
        parts.addWidget(self.plots)
        parts.setStretchFactor(1, 1)
        parts.setSizes([200, 1000])
        parts.setChildrenCollapsible(False)
        layout = QVBoxLayout(self)
        layout.setContentsMargins(0, 0, 0, 0)
        layout.addWidget(parts)
        self.setFocusProxy(self.list)

    def set_theme(self, theme: Theme) -> None:
        """Paint with other colours from now on."""
        self.plots.set_theme(theme)

    def stop(self) -> None:
        """Give up what is being read: the document is going away."""
        if self._job is not None:
            self._job.abandon()
            self._job = None

    def chosen(self) -> tuple[int, ...]:
        """Return the checked channels, in the order of the file."""
        items = [self.list.item(row) for row in range(self.list.count())]
        return tuple(
            item.data(CHANNEL) for item in items if item.checkState() == Qt.CheckState.Checked
        )

    def choose(self, channels: tuple[int, ...]) -> None:
        """Check these channels and no others."""
        self.list.blockSignals(True)  # noqa: FBT003 - Qt's own signature
        for row in range(self.list.count()):
            item = self.list.item(row)
            on = item.data(CHANNEL) in channels
            item.setCheckState(Qt.CheckState.Checked if on else Qt.CheckState.Unchecked)
        self.list.blockSignals(False)  # noqa: FBT003 - Qt's own signature
        self._show_choice()

    def showEvent(self, event: QShowEvent) -> None:
        super().showEvent(event)
        if not self.chosen() and not self._read:
            self.choose((0,))

    def _make_list(self) -> QListWidget:
        made = QListWidget()
        made.setAccessibleName(self.tr("Analog channels"))
        made.setUniformItemSizes(True)
        made.setSpacing(2)
        made.setTextElideMode(Qt.TextElideMode.ElideMiddle)
        labels, units = self._source.analog_labels, self._source.analog_units
        for channel, (label, unit) in enumerate(zip(labels, units, strict=True)):
            item = QListWidgetItem(f"{label} ({unit})" if unit else label)
            item.setToolTip(item.text())
            item.setData(CHANNEL, channel)
            item.setFlags(item.flags() | Qt.ItemFlag.ItemIsUserCheckable)
            item.setCheckState(Qt.CheckState.Unchecked)
            made.addItem(item)
        made.setCurrentRow(0)
        made.itemChanged.connect(self._show_choice)
        return made

    def _filter(self, text: str) -> None:
        for row in range(self.list.count()):
            item = self.list.item(row)
            item.setHidden(text.casefold() not in item.text().casefold())

    # --- reading -----------------------------------------------------------------------------

    def _show_choice(self) -> None:
        self.plots.show_channels(self.chosen(), self._read)
        self._start()

    def _start(self) -> None:
        missing = [channel for channel in self.chosen() if channel not in self._read]
        if self._job is not None or not missing:
            return
        job = self._jobs.read_or_write(
            self.tr("Reading analog channels"),
            read_channels,
            self._source,
            wanted_at_once(self._source, missing),
        )
        job.finished.connect(self._accept)
        job.failed.connect(self._tell)
        job.cancelled.connect(self._give_up)
        self._job = job

    def _accept(self, found: dict[int, Envelope]) -> None:
        self._job = None
        self._read |= found
        self._show_choice()

    def _tell(self, error: Exception) -> None:
        self._job = None
        expected = isinstance(error, MocapmendError)
        text = str(error) if expected else self.tr("The analog channels could not be read")
        self.plots.show_channels(self.chosen(), self._read, text)
        if not expected:
            self.failed.emit(error)

    def _give_up(self) -> None:
        self._job = None
        text = self.tr("Cancelled: check a channel to read it again")
        self.plots.show_channels(self.chosen(), self._read, text)
