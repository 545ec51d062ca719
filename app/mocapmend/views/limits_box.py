"""How long a gap and how large an expected error may be, for filling many gaps at once."""

import math

from PySide6.QtCore import Signal
from PySide6.QtWidgets import QCheckBox, QDoubleSpinBox, QGridLayout, QSpinBox, QWidget

from mocapmend.settings import LIMIT_ERROR, LIMIT_GAP, MAX_ERROR_MM, MAX_GAP_MS, Settings
from mocapmend_algorithms import Recording
from mocapmend_algorithms.fill.limits import Limits


class LimitsBox(QWidget):
    """Edits the limits and remembers them; the length in time, since rates differ.

    Signals
    -------
    changed :
        A limit is another one.
    """

    changed = Signal()

    def __init__(
        self, recording: Recording, settings: Settings, parent: QWidget | None = None
    ) -> None:
        super().__init__(parent)
        self._rate = recording.rate
        self._settings = settings
        self._limit_gap = QCheckBox(self.tr("length"))
        # A length that an older version remembers was always a limit.
        old = settings.chosen(MAX_GAP_MS) and not settings.chosen(LIMIT_GAP)
        self._limit_gap.setChecked(old or settings.get(LIMIT_GAP))
        self._max_gap = QSpinBox()
        self._max_gap.setRange(0, max(1, recording.frames))
        self._max_gap.setPrefix("≤ ")
        self._max_gap.setAccessibleName(self.tr("Longest gap in frames"))
        self._show_longest(settings.get(MAX_GAP_MS))
        self._max_gap.setEnabled(self._limit_gap.isChecked())
        self._limit_error = QCheckBox(self.tr("expected error"))
        self._limit_error.setChecked(settings.get(LIMIT_ERROR))
        self._max_error = QDoubleSpinBox()
        self._max_error.setRange(0.1, 1000.0)
        self._max_error.setDecimals(1)
        self._max_error.setPrefix("≤ ")
        self._max_error.setSuffix(" mm")
        self._max_error.setAccessibleName(self.tr("Largest expected error in mm"))
        self._max_error.setValue(settings.get(MAX_ERROR_MM))
        self._max_error.setEnabled(self._limit_error.isChecked())
        # A form would put the check boxes higher than the numbers.
        grid = QGridLayout(self)
        grid.setContentsMargins(0, 0, 0, 0)
        for row, parts in enumerate(
            ((self._limit_gap, self._max_gap), (self._limit_error, self._max_error))
        ):
            for column, part in enumerate(parts):
                grid.addWidget(part, row, column)
        grid.setColumnStretch(1, 1)
        self._limit_gap.toggled.connect(self._switch_gap)
        self._limit_error.toggled.connect(self._switch_error)
        self._max_gap.valueChanged.connect(self._remember_gap)
        self._max_error.valueChanged.connect(self._remember_error)
        self._show_ms()

    def max_gap(self) -> int | None:
        """Return the longest gap that may be filled, in frames; None for any."""
        return self._max_gap.value() if self._limit_gap.isChecked() else None

    def max_error_mm(self) -> float:
        """Return the largest expected error that may be accepted, in mm."""
        return self._max_error.value() if self._limit_error.isChecked() else math.inf

    def limits(self) -> Limits:
        """Return both."""
        return Limits(max_gap=self.max_gap(), max_error_mm=self.max_error_mm())

    def max_gap_ms(self) -> float | None:
        """Return the longest gap that may be filled, in ms; None for any."""
        return self._ms() if self._limit_gap.isChecked() else None

    def set_limits(self, max_gap_ms: float | None, max_error_mm: float) -> None:
        """Show other limits."""
        self._limit_gap.setChecked(max_gap_ms is not None)
        if max_gap_ms is not None:
            self._show_longest(max_gap_ms)
        self._limit_error.setChecked(math.isfinite(max_error_mm))
        if math.isfinite(max_error_mm):
            self._max_error.setValue(max_error_mm)

    def _show_longest(self, ms: float) -> None:
        self._max_gap.setValue(int(min(ms * self._rate / 1000.0 + 1e-6, self._max_gap.maximum())))

    def _ms(self) -> float:
        return 1000.0 * self._max_gap.value() / self._rate

    def _show_ms(self) -> None:
        self._max_gap.setSuffix(self.tr(" frames ({0} ms)").format(round(self._ms())))

    def _switch_gap(self, on: bool) -> None:  # noqa: FBT001 - a slot of toggled(bool)
        self._settings.set(LIMIT_GAP, on)
        self._max_gap.setEnabled(on)
        self.changed.emit()

    def _switch_error(self, on: bool) -> None:  # noqa: FBT001 - a slot of toggled(bool)
        self._settings.set(LIMIT_ERROR, on)
        self._max_error.setEnabled(on)
        self.changed.emit()

    def _remember_gap(self) -> None:
        """Keep what the user has chosen; what a recording's rate makes of it is not a choice."""
        self._show_ms()
        self._settings.set(MAX_GAP_MS, self._ms())
        self.changed.emit()

    def _remember_error(self, mm: float) -> None:
        self._settings.set(MAX_ERROR_MM, mm)
        self.changed.emit()
