"""What a check found can be read whole, however much it is."""

from pathlib import Path

from PySide6.QtWidgets import QLabel, QWidget
from pytestqt.qtbot import QtBot

from mocapmend.files import CheckReport
from mocapmend.files.check import ChangedRun
from mocapmend.views.check_dialog import check_dialog


def test_a_long_finding_is_scrolled_and_a_short_one_is_not(qtbot: QtBot) -> None:
    runs = tuple(ChangedRun("LKNE", k, k, 1) for k in range(30))
    for count, scrolls in ((1, False), (12, True)):
        others = tuple(f"Marker {k}: 1 sample differs although measured." for k in range(count))
        found = CheckReport(runs, 30, (), others, identical=False)
        parent = QWidget()
        qtbot.addWidget(parent)
        dialog = check_dialog(parent, Path("a.c3d"), Path("b.c3d"), found)
        dialog.resize(500, 330)
        dialog.show()
        qtbot.waitExposed(dialog)
        text = dialog.findChild(QLabel)
        assert text is not None
        qtbot.waitUntil(lambda text=text: text.height() >= text.heightForWidth(text.width()))
        qtbot.waitUntil(
            lambda text=text, scrolls=scrolls: (seen_height(text) < text.height()) == scrolls
        )


def seen_height(widget: QWidget) -> int:
    return widget.visibleRegion().boundingRect().height()
