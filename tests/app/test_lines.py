"""Lines are equally thick wherever they are, also where a pixel is 1.5 pixels of the screen."""

import pytest
from PySide6.QtCore import QLineF
from PySide6.QtGui import QColor, QImage, QPainter

from mocapmend.views.lane import thin


@pytest.mark.parametrize(
    ("ratio", "expected"), [(1.0, 1), (1.25, 1), (1.5, 2), (1.75, 2), (2.0, 2)]
)
def test_a_thin_line_takes_a_whole_number_of_pixels(ratio: float, expected: int) -> None:
    for place in (10.0, 10.3, 10.5, 10.7, 11.0):
        image = QImage(40, 80, QImage.Format.Format_RGB32)
        image.setDevicePixelRatio(ratio)
        image.fill(0)
        painter = QPainter(image)
        painter.setPen(thin(painter, "#ffffff"))
        painter.drawLine(QLineF(0, place, 40, place))
        painter.end()
        inked = [y for y in range(80) if image.pixelColor(5, y) == QColor("#ffffff")]
        assert len(inked) == expected
