"""A form for a method's parameters, made from its parameter class."""

import math
from collections.abc import Callable, Mapping, Sequence
from dataclasses import Field, fields
from types import NoneType
from typing import Any, Literal, get_args, get_origin, get_type_hints

from PySide6.QtCore import Signal
from PySide6.QtWidgets import (
    QCheckBox,
    QComboBox,
    QDoubleSpinBox,
    QFormLayout,
    QSpinBox,
    QWidget,
)

from mocapmend.views.engine_texts import method_text
from mocapmend.views.names_edit import NamesEdit
from mocapmend.views.training_box import TrainingBox
from mocapmend_algorithms.params import Words

Getter = Callable[[], Any]
UNBOUNDED = 1_000_000


class ParamsForm(QWidget):
    """Edits an instance of a parameter dataclass.

    `changed` follows every change of the user's, `rebuilt` the making of new fields.

    Parameters
    ----------
    markers : mapping of str to str
        What the markers are called here, and their labels, for lists of them.
    """

    changed = Signal()
    rebuilt = Signal()

    def __init__(
        self, markers: Mapping[str, str] | None = None, parent: QWidget | None = None
    ) -> None:
        super().__init__(parent)
        self._markers = markers or {}
        self._selection: tuple[str, ...] = ()
        self._layout = QFormLayout(self)
        self._layout.setContentsMargins(0, 0, 0, 0)
        self._layout.setVerticalSpacing(3)
        self._kind: type[Any] | None = None
        self._getters: dict[str, Getter] = {}

    def set_markers(self, markers: Mapping[str, str]) -> None:
        """Call the markers otherwise in the fields that are made from now on."""
        self._markers = markers

    def show_params(self, params: Any) -> None:
        """Make the fields of a parameter class, with the values of one of its instances."""
        kind = type(params)
        while self._layout.rowCount():
            self._layout.removeRow(0)
        self._kind = kind
        self._getters = {}
        hints = get_type_hints(kind)
        for entry in fields(kind):
            value = getattr(params, entry.name)
            widget, getter = self._editor(entry, hints[entry.name], value)
            widget.setObjectName(entry.name)
            widget.setToolTip(method_text(str(entry.metadata.get("help", ""))))
            label = method_text(str(entry.metadata.get("label", entry.name)))
            # The keyboard may be in a part of it.
            for part in (widget, widget.focusProxy() or widget):
                part.setAccessibleName(label)
            self._layout.addRow(label, widget)
            self._getters[entry.name] = getter
        self.rebuilt.emit()

    def params(self) -> object:
        """Return the parameters as the form shows them."""
        assert self._kind is not None
        return self._kind(**{name: getter() for name, getter in self._getters.items()})

    def set_selection(self, labels: Sequence[str]) -> None:
        """Say which markers can be taken over into a list of markers."""
        self._selection = tuple(labels)
        for field in self.findChildren(NamesEdit):
            field.set_selection(self._selection)

    def pick(self, label: str) -> bool:
        """Add a marker to the list of markers, or take it out; say whether there is such a list."""
        field = self.findChild(NamesEdit)
        if field is None:
            return False
        field.toggle(label)
        return True

    def _editor(self, entry: Field[Any], hint: Any, value: Any) -> tuple[QWidget, Getter]:
        if NoneType in get_args(hint):
            inner = next(part for part in get_args(hint) if part is not NoneType)
            return self._optional(entry, inner, value)
        if get_origin(hint) is Literal:
            return self._choice(get_args(hint), value)
        if hint == Words:
            return self._words(value)
        if entry.metadata["training"]:
            return self._training(entry, value)
        if hint is bool:
            box = QCheckBox()
            box.setChecked(bool(value))
            box.toggled.connect(self.changed)
            return box, box.isChecked
        return self._number(entry, hint, value)

    def _choice(self, options: tuple[str, ...], value: object) -> tuple[QWidget, Getter]:
        combo = QComboBox()
        for option in options:
            combo.addItem(method_text(option), option)
        combo.setCurrentIndex(options.index(str(value)))
        combo.currentIndexChanged.connect(self.changed)
        return combo, combo.currentData

    def _words(self, value: Words) -> tuple[QWidget, Getter]:
        edit = NamesEdit(value, self._markers)
        edit.set_selection(self._selection)
        edit.changed.connect(self.changed)
        return edit, edit.labels

    def _training(self, entry: Field[Any], value: str) -> tuple[QWidget, Getter]:
        box = TrainingBox(value, method_text(entry.metadata["label"]))
        box.changed.connect(self.changed)
        return box, box.name

    def _number(
        self, entry: Field[Any], hint: type, value: Any
    ) -> tuple[QSpinBox | QDoubleSpinBox, Getter]:
        low, high = entry.metadata["min"], entry.metadata["max"]
        # By the default and not by the value: the same field has the same decimals.
        default: Any = entry.default
        small: float = min((x for x in (low, default) if x), default=1.0)
        spin: QSpinBox | QDoubleSpinBox = QSpinBox() if hint is int else _NumberBox(small)
        spin.setRange(0 if low is None else low, UNBOUNDED if high is None else high)
        unit = entry.metadata.get("unit")
        spin.setSuffix(f" {unit}" if unit else "")
        spin.setValue(value)
        spin.setKeyboardTracking(False)
        spin.valueChanged.connect(self.changed)
        return spin, spin.value

    def _optional(self, entry: Field[Any], inner: type, value: Any) -> tuple[QWidget, Getter]:
        """Make a number that can be left to the method: below its minimum it reads "automatic"."""
        low = entry.metadata["min"] or 0
        spin, _ = self._number(entry, inner, low)
        lowest: Any = low - spin.singleStep()
        spin.blockSignals(True)  # noqa: FBT003 - Qt's own signature
        spin.setMinimum(lowest)
        spin.setSpecialValueText(self.tr("automatic"))
        spin.setValue(lowest if value is None else value)
        spin.blockSignals(False)  # noqa: FBT003 - Qt's own signature
        return spin, lambda: None if spin.value() < low else spin.value()


class _NumberBox(QDoubleSpinBox):
    """A number with as many decimals as it takes, 2 at least where a small one needs no more."""

    def __init__(self, small: float) -> None:
        super().__init__()
        decimals = math.ceil(-math.log10(abs(small)))
        if decimals > self.decimals():
            self.setDecimals(decimals)
            self.setStepType(QDoubleSpinBox.StepType.AdaptiveDecimalStepType)

    def textFromValue(self, value: float) -> str:
        text = super().textFromValue(value)
        point = self.locale().decimalPoint()
        return text.rstrip("0").removesuffix(point) if self.decimals() > 2 else text
