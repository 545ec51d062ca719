"""Labels that are too long for their place."""

import pytest
from PySide6.QtGui import QFontMetrics
from PySide6.QtWidgets import QApplication
from pytestqt.qtbot import QtBot

from mocapmend.views.labels import elided


@pytest.fixture
def metrics(qtbot: QtBot) -> QFontMetrics:
    return QFontMetrics(QApplication.font())


@pytest.mark.parametrize("label", ["LASI", "WheelchairL:Marker3", "Body:"])
def test_a_label_with_room_stays_whole(metrics: QFontMetrics, label: str) -> None:
    assert elided(label, metrics, metrics.horizontalAdvance(label) + 1) == label


def test_two_subjects_keep_apart_where_their_ends_differ(metrics: QFontMetrics) -> None:
    width = metrics.horizontalAdvance("Wh…L:Marker3") + 8
    left, right = (elided(f"Wheelchair{side}:Marker3", metrics, width) for side in "LR")
    assert left.endswith("L:Marker3")
    assert right.endswith("R:Marker3")
    assert "…" in left
    assert metrics.horizontalAdvance(left) <= width


@pytest.mark.parametrize("label", ["S:" + "M" * 40, "M" * 40, "A" * 40 + ":" + "M" * 40])
@pytest.mark.parametrize("width", [0, 5, 30, 100])
def test_no_label_exceeds_its_place(metrics: QFontMetrics, label: str, width: int) -> None:
    assert metrics.horizontalAdvance(elided(label, metrics, width)) <= max(
        width, metrics.horizontalAdvance("…")
    )
