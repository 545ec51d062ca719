"""The form of a method is made from its parameter class, whatever the class."""

from dataclasses import dataclass
from typing import Literal

import pytest
from PySide6.QtCore import Qt
from PySide6.QtWidgets import QCheckBox, QComboBox, QDoubleSpinBox, QSpinBox
from pytestqt.qtbot import QtBot

from mocapmend.views.names_edit import NamesEdit
from mocapmend.views.params_form import ParamsForm
from mocapmend_algorithms.fill.registry import METHODS, Method
from mocapmend_algorithms.params import option


@dataclass(frozen=True)
class Example:
    count: int = option(3, label="Count", text="How many.", minimum=1, maximum=9)
    length: float = option(2.5, label="Length", text="How long.", minimum=0, unit="mm")
    on: bool = option(default=True, label="On", text="Whether.")
    kind: Literal["this", "that"] = option("that", label="Kind", text="Which.")
    free: float | None = option(None, label="Free", text="Left to us.", minimum=0, maximum=5)
    names: tuple[str, ...] = option((), label="Names", text="Whose.")


@pytest.fixture
def form(qtbot: QtBot) -> ParamsForm:
    widget = ParamsForm()
    qtbot.addWidget(widget)
    return widget


@pytest.mark.parametrize("method", METHODS.values(), ids=METHODS)
def test_an_untouched_form_gives_the_defaults(form: ParamsForm, method: Method) -> None:
    form.show_params(method.params())
    assert form.params() == method.params()


def test_every_kind_of_parameter_can_be_edited(form: ParamsForm, qtbot: QtBot) -> None:
    form.show_params(Example())
    assert form.params() == Example()
    count, lengths = form.findChild(QSpinBox), form.findChildren(QDoubleSpinBox)
    with qtbot.waitSignal(form.changed):
        count.setValue(20)
    with qtbot.waitSignal(form.changed):
        lengths[0].setValue(4.25)
    with qtbot.waitSignal(form.changed):
        form.findChild(QCheckBox).setChecked(False)
    with qtbot.waitSignal(form.changed):
        form.findChild(QComboBox).setCurrentIndex(0)
    assert lengths[1].text() == "automatic"
    with qtbot.waitSignal(form.changed):
        lengths[1].setValue(1.5)
    names = form.findChild(NamesEdit, "names").edit
    assert names.placeholderText() == "automatic"
    names.setText("a, b")
    with qtbot.waitSignal(form.changed):
        qtbot.keyClick(names, Qt.Key.Key_Return)
    changed = Example(count=9, length=4.25, on=False, kind="this", free=1.5, names=("a", "b"))
    assert form.params() == changed
    assert lengths[0].suffix() == " mm"


@dataclass(frozen=True)
class Small:
    penalty: float = option(1e-4, label="Penalty", text="Stiff.", minimum=1e-9, maximum=1e3)


def test_a_small_number_is_shown_and_kept_as_it_is(form: ParamsForm) -> None:
    form.show_params(Small())
    box = form.findChild(QDoubleSpinBox)
    assert box.text() == "0.0001"
    box.setValue(2.5e-8)
    assert form.params() == Small(2.5e-8)
    box.setValue(12)
    assert box.text() == "12"


def test_another_method_replaces_the_form(form: ParamsForm) -> None:
    form.show_params(Example())
    form.show_params(METHODS["linear"].params())
    assert form.params() == METHODS["linear"].params()
