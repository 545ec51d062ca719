"""Asks how a recording is to be refined, and says at once where it cannot be."""

from pathlib import Path

from PySide6.QtCore import Qt, Signal
from PySide6.QtGui import QTextOption
from PySide6.QtWidgets import (
    QCheckBox,
    QComboBox,
    QDialog,
    QDialogButtonBox,
    QDoubleSpinBox,
    QFileDialog,
    QFormLayout,
    QHBoxLayout,
    QLabel,
    QMessageBox,
    QTextBrowser,
    QVBoxLayout,
    QWidget,
)

from mocapmend.errors import MocapmendError
from mocapmend.files import Source
from mocapmend.refine.apart import Order
from mocapmend.refine.fitting import Misfit, misfit
from mocapmend.refine.models import load_model
from mocapmend.refine.times import seconds_for
from mocapmend.settings import LAST_FOLDER, REFINE_CUTOFF, REFINE_FILTER, REFINE_STRIDE, Settings
from mocapmend.views.engine_texts import error_text, shown
from mocapmend.views.file_kinds import all_kinds, kinds
from mocapmend.views.model_card import card_html
from mocapmend.views.naming import kind_of, meant
from mocapmend.views.network_box import NetworkBox
from mocapmend.views.path_field import PathField
from mocapmend.views.refine_checks import file_problem
from mocapmend.views.text_scale import fit_text
from mocapmend_algorithms.refine.model import Model
from mocapmend_algorithms.refine.refining import HIGHEST_CUTOFF, LOWEST_CUTOFF, RefineParams
from mocapmend_algorithms.refine.windows import STRIDES

SIZE = (760, 640)
SOON = 1.0
"""Seconds below which nobody wants to know how long it takes."""
WARNING = "⚠ "


class RefineDialog(QDialog):
    """Network, parameters, reference and where the outcome goes; those of the last time at first.

    Parameters
    ----------
    source : Source
        The recording.
    out : Path
        Where the outcome goes if the user does not care.
    edited : bool
        Whether it has edits, which are left out.

    Signals
    -------
    chosen : Order
        What is to be done.
    """

    chosen = Signal(object)

    def __init__(
        self, source: Source, out: Path, settings: Settings, parent: QWidget, *, edited: bool
    ) -> None:
        super().__init__(parent)
        self._source = source
        self._settings = settings
        self._first_name = out.name
        self._model: Model | None = None
        self._complaint = ""
        """Why the network cannot be used."""
        self.setWindowTitle(self.tr("Refine by a network"))
        self.setAttribute(Qt.WidgetAttribute.WA_DeleteOnClose)
        self.network = NetworkBox(settings)
        self.card = QTextBrowser()
        self.card.setAccessibleName(self.tr("What is known of the network"))
        self.card.setWordWrapMode(QTextOption.WrapMode.WordWrap)
        self.card.setTabChangesFocus(True)
        self.stride = QComboBox()
        self.stride.setAccessibleName(self.tr("Stride"))
        for stride in reversed(STRIDES):
            self.stride.addItem("", str(stride))
        self.stride.setCurrentIndex(max(0, self.stride.findData(settings.get(REFINE_STRIDE))))
        self.filter = QCheckBox(self.tr("Low-pass at"))
        self.filter.setChecked(settings.get(REFINE_FILTER))
        self.filter.setToolTip(self.tr("Smooths the outcome, without lag; 6 Hz is usual"))
        self.cutoff = self._make_cutoff(settings)
        self.filter.toggled.connect(self.cutoff.setEnabled)
        self.reference = PathField(self.tr("Reference"), self._ask_reference)
        self.reference.edit.setPlaceholderText(self.tr("none"))
        self.reference.setToolTip(
            self.tr(
                "What a better system has recorded meanwhile, with the markers that come out: the "
                "outcome is measured against it"
            )
        )
        self.calibration = PathField(self.tr("Calibrate with"), self._ask_reference)
        self.calibration.edit.setPlaceholderText(self.tr("none"))
        self.calibration.setToolTip(
            self.tr(
                "Another recording of the same person with the same sensor, of which there is a "
                "reference: the mean error of each marker there is subtracted"
            )
        )
        self.truth = PathField(self.tr("Its reference"), self._ask_reference)
        self.truth.edit.setPlaceholderText(self.tr("none"))
        self.truth.setToolTip(self.tr("What a better system has recorded meanwhile"))
        self.out = PathField(self.tr("Outcome"), self._ask_out)
        self.out.set_path(out)
        self.problem = QLabel()
        self.problem.setTextFormat(Qt.TextFormat.PlainText)
        self.problem.setWordWrap(True)
        self.problem.setTextInteractionFlags(Qt.TextInteractionFlag.TextSelectableByMouse)
        self.problem.setAccessibleName(self.tr("Why it cannot be refined"))
        self._arrange(edited=edited)
        self.network.changed.connect(self._load)
        for field in (self.reference, self.calibration, self.truth):
            field.changed.connect(self._check)
        self.out.changed.connect(self._check)
        self._load()
        self.network.setFocus()

    # --- making ------------------------------------------------------------------------------

    def _make_cutoff(self, settings: Settings) -> QDoubleSpinBox:
        cutoff = QDoubleSpinBox()
        cutoff.setAccessibleName(self.tr("Output filter"))
        cutoff.setRange(LOWEST_CUTOFF, HIGHEST_CUTOFF)
        cutoff.setDecimals(1)
        cutoff.setSuffix(" Hz")
        cutoff.setValue(settings.get(REFINE_CUTOFF))
        cutoff.setEnabled(self.filter.isChecked())
        return cutoff

    def _arrange(self, *, edited: bool) -> None:
        filtering = QHBoxLayout()
        filtering.addWidget(self.filter)
        filtering.addWidget(self.cutoff)
        filtering.addStretch(1)
        form = QFormLayout()
        form.addRow(self.tr("Stride"), self.stride)
        form.addRow(self.tr("Output filter"), filtering)
        form.addRow(self.tr("Reference"), self.reference)
        form.addRow(self.tr("Calibrate with"), self.calibration)
        form.addRow(self.tr("Its reference"), self.truth)
        form.addRow(self.tr("Outcome"), self.out)
        buttons = QDialogButtonBox(QDialogButtonBox.StandardButton.Cancel)
        self.go = buttons.addButton(self.tr("Refine"), QDialogButtonBox.ButtonRole.AcceptRole)
        self.go.setDefault(True)
        # Enter gives nothing up while it cannot begin.
        buttons.button(QDialogButtonBox.StandardButton.Cancel).setAutoDefault(False)
        buttons.accepted.connect(self._choose)
        buttons.rejected.connect(self.reject)
        top = QFormLayout()
        top.addRow(self.tr("Network"), self.network)
        layout = QVBoxLayout(self)
        layout.addLayout(top)
        layout.addWidget(self.card, 1)
        layout.addLayout(form)
        for text in self._notes(edited=edited):
            note = QLabel(text)
            note.setWordWrap(True)
            layout.addWidget(note)
        layout.addWidget(self.problem)
        layout.addWidget(buttons)
        fit_text(self, *SIZE)

    def _notes(self, *, edited: bool) -> list[str]:
        """Say what the user may not expect."""
        notes = []
        if edited or self._source.repaired:
            notes.append(
                self.tr("The joints are taken as the file has measured them: edits are left out.")
            )
        if self._source.truncated:
            notes.append(self.tr("The file is truncated: what is there of it is refined."))
        return notes

    # --- showing -----------------------------------------------------------------------------

    def _load(self) -> None:
        """Read the chosen network, and show what is known of it."""
        name = self.network.name()
        self._model, self._complaint = None, ""
        if name:
            try:
                self._model = load_model(name)
            except MocapmendError as error:
                self._complaint = error_text(error)
        else:
            self._complaint = self.tr(
                "Choose a network: a file that “mocapmend train refine” has written."
            )
        self.card.setHtml("" if self._model is None else card_html(self._model))
        self._show_times()
        self._check()

    def _show_times(self) -> None:
        texts = {
            "60": self.tr("60: the middle 60 frames of each window of 120 ({0})"),
            "1": self.tr("1: the middle frame of each window, as in the paper ({0})"),
        }
        recording = self._source.recording
        for row in range(self.stride.count()):
            stride = self.stride.itemData(row)
            seconds = 0.0
            if self._model is not None:
                seconds = seconds_for(recording.frames / recording.rate, int(stride), self._model)
            self.stride.setItemText(row, texts[stride].format(self._time(seconds)))

    def _time(self, seconds: float) -> str:
        if seconds < SOON:
            return self.tr("less than a second")
        if seconds < 120:
            return self.tr("about {0} s").format(round(seconds))
        return self.tr("about {0} min").format(round(seconds / 60))

    def _check(self) -> None:
        """Say what is in the way, if something is."""
        found = self._complaint
        if not found and self._model is not None:
            found = self._misfit_text(misfit(self._source.measured, self._model.profile))
        if not found:
            given = (self.reference.path(), self.calibration.path(), self.truth.path())
            found = file_problem(self._source.path, given, self.out.path())
        self.problem.setText(WARNING + found if found else "")
        self.problem.setVisible(bool(found))
        self.go.setEnabled(not found)

    def _misfit_text(self, found: Misfit) -> str:
        if not found or self._model is None:
            return ""
        profile = self._model.profile
        parts = []
        if found.lacking:
            text = self.tr("This network takes other joints ({0}): {1} of {2} are not here: {3}.")
            count = len(found.lacking), len(profile.inputs)
            parts.append(text.format(shown(profile.name), *count, ", ".join(found.lacking)))
        if found.own:
            text = self.tr(
                "What the recording has are the joints of another profile ({0}); one never stands "
                "for the other."
            )
            parts.append(text.format(shown(found.own)))
        if found.lacking:
            parts.append(
                self.tr("A network for them can be trained with “mocapmend train refine”.")
            )
        if found.twice:
            text = self.tr("These joints are there more than once: {0}.")
            parts.append(text.format(", ".join(found.twice)))
        if found.unseen:
            text = self.tr("These joints are never seen: {0}.")
            parts.append(text.format(", ".join(found.unseen)))
        return " ".join(parts)

    # --- asking ------------------------------------------------------------------------------

    def _ask_reference(self, now: Path | None) -> Path | None:
        folder = self._settings.get(LAST_FOLDER) if now is None else str(now.parent)
        text, _ = QFileDialog.getOpenFileName(
            self,
            self.tr("Reference recording"),
            folder,
            ";;".join((all_kinds(), *kinds(), self.tr("All files (*)"))),
        )
        return Path(text) if text else None

    def _ask_out(self, now: Path | None) -> Path | None:
        choices = {
            self.tr("C3D (*.c3d)"): ".c3d",
            self.tr("TRC (*.trc)"): ".trc",
            self.tr("CSV, one line per frame (*.csv)"): ".csv",
            self.tr("NumPy (*.npz)"): ".npz",
        }
        start = Path(self._first_name) if now is None else now
        text, kind = QFileDialog.getSaveFileName(
            self,
            self.tr("Where the outcome goes"),
            str(start),
            ";;".join(choices),
            kind_of(start.name, choices),
            # What is there is asked about when all is decided.
            QFileDialog.Option.DontConfirmOverwrite,
        )
        return meant(Path(text), start.name, choices, kind) if text else None

    def _choose(self) -> None:
        out = self.out.path()
        assert out is not None
        if out.exists() and not self._may_replace(out):
            return
        settings, stride = self._settings, self.stride.currentData()
        self.network.remember()
        settings.set(REFINE_STRIDE, stride)
        settings.set(REFINE_FILTER, self.filter.isChecked())
        settings.set(REFINE_CUTOFF, self.cutoff.value())
        cutoff = self.cutoff.value() if self.filter.isChecked() else None
        calibration, truth = self.calibration.path(), self.truth.path()
        order = Order(
            self._source.path,
            self._source.stamp,
            self.network.name(),
            RefineParams(stride, cutoff),
            out.absolute(),
            self.reference.path(),
            () if calibration is None or truth is None else ((calibration, truth),),
        )
        self.accept()
        self.chosen.emit(order)

    def _may_replace(self, out: Path) -> bool:
        buttons = QMessageBox.StandardButton
        answer = QMessageBox.question(
            self,
            "mocapmend",
            self.tr("There is a file of this name. Replace {0}?").format(out.name),
            buttons.Yes | buttons.Cancel,
            buttons.Cancel,
        )
        return bool(answer == buttons.Yes)
