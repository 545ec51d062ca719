"""The field for a training set: from the list, typed, or from a dialog."""

from pathlib import Path

import pytest
from PySide6.QtCore import Qt
from PySide6.QtWidgets import QFileDialog
from pytestqt.qtbot import QtBot
from taught import TaughtParams, ship

from mocapmend.views.params_form import ParamsForm
from mocapmend.views.training_box import TrainingBox

LEFT = Qt.MouseButton.LeftButton


@pytest.fixture(autouse=True)
def _shipped(tmp_path: Path, monkeypatch: pytest.MonkeyPatch) -> None:
    ship(tmp_path / "shipped", monkeypatch)
    for name in ("runs", "walks"):
        (tmp_path / "shipped" / f"{name}.npz").touch()


@pytest.fixture
def form(qtbot: QtBot) -> ParamsForm:
    made = ParamsForm()
    qtbot.addWidget(made)
    made.show_params(TaughtParams())
    made.show()
    return made


@pytest.fixture
def box(form: ParamsForm, qtbot: QtBot) -> TrainingBox:
    made = form.findChild(TrainingBox, "training")
    made.combo.setFocus()
    qtbot.waitUntil(made.combo.hasFocus)
    return made


@pytest.fixture
def told(form: ParamsForm, box: TrainingBox) -> list[str]:
    """Return the names that the form tells, as they come."""
    names: list[str] = []
    form.changed.connect(lambda: names.append(form.params().training))
    return names


def test_it_offers_the_recording_itself_and_what_ships(form: ParamsForm, box: TrainingBox) -> None:
    rows = [box.combo.itemText(row) for row in range(box.combo.count())]
    assert rows == ["this recording", "runs", "walks"]
    assert box.combo.currentText() == "this recording"
    assert form.params() == TaughtParams("")
    assert box.combo.accessibleName() == "Learn from"
    assert box.browse.accessibleName()
    assert box.toolTip() == "What to learn from."


def test_the_list_is_stepped_through_by_keys(
    box: TrainingBox, told: list[str], qtbot: QtBot
) -> None:
    for key in (Qt.Key.Key_Down, Qt.Key.Key_Down, Qt.Key.Key_Up, Qt.Key.Key_Up):
        qtbot.keyClick(box.combo, key)
    assert told == ["runs", "walks", "runs", ""]


def test_a_path_is_told_when_it_is_typed(box: TrainingBox, told: list[str], qtbot: QtBot) -> None:
    box.combo.lineEdit().selectAll()
    qtbot.keyClicks(box.combo, " my set.npz")
    assert told == []
    qtbot.keyClick(box.combo, Qt.Key.Key_Return)
    assert told == ["my set.npz"]
    assert box.combo.count() == 3, "nothing is remembered"
    assert box.combo.toolTip() == "my set.npz"
    qtbot.keyClick(box.combo, Qt.Key.Key_Return)
    assert len(told) == 1, "nothing has changed"
    box.combo.lineEdit().clear()
    assert told[-1] == ""
    assert box.combo.lineEdit().placeholderText() == "this recording"


def test_a_file_is_chosen_in_a_dialog(
    box: TrainingBox,
    told: list[str],
    qtbot: QtBot,
    tmp_path: Path,
    monkeypatch: pytest.MonkeyPatch,
) -> None:
    asked: list[str] = []
    answers = [str(tmp_path / "mine.npz"), "", str(tmp_path / "mine.npz")]

    def answer(_parent: object, _title: str, start: str, kinds: str) -> tuple[str, str]:
        asked.append(start)
        assert kinds.startswith("Training sets (*.npz)")
        return answers[len(asked) - 1], ""

    monkeypatch.setattr(QFileDialog, "getOpenFileName", answer)
    qtbot.keyClick(box.browse, Qt.Key.Key_Space)
    assert told == [str(tmp_path / "mine.npz")]
    qtbot.mouseClick(box.browse, LEFT)
    assert told == [str(tmp_path / "mine.npz")], "nothing was chosen, nothing changes"
    qtbot.keyClick(box.combo, Qt.Key.Key_Down)
    assert told[-1] == ""
    qtbot.mouseClick(box.browse, LEFT)
    assert asked == ["", str(tmp_path), ""]
    assert told[-1] == str(tmp_path / "mine.npz")
