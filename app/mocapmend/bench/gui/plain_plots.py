"""Moving through 12 linked plots of plain pyqtgraph, set up as its manual advises."""

from functools import partial
from pathlib import Path

import pyqtgraph

from mocapmend.bench.gui.stage import SHOWN, steps_per_second
from mocapmend.bench.gui.steps import pan_ranges, zoom_ranges
from mocapmend.files import read_recording


def plain(path: Path, width: float, height: float) -> dict[str, float]:
    """Return steps per second of panning and zooming, without a timeline or a 3D view."""
    app = pyqtgraph.mkQApp()
    points = read_recording(path).recording.points
    widget = pyqtgraph.GraphicsLayoutWidget()
    widget.resize(int(width), int(height))
    first = None
    for row, (marker, axis) in enumerate((m, a) for m in SHOWN for a in range(3)):
        plot = widget.addPlot(row=row, col=0)
        plot.setDownsampling(auto=True, mode="peak")
        plot.setClipToView(True)
        plot.enableAutoRange(x=False, y=True)
        plot.plot(points[:, marker, axis], connect="finite")
        first = first or plot
        plot.setXLink(first)
    assert first is not None
    first.setXRange(0, len(points))
    widget.show()
    app.processEvents()
    show = partial(first.setXRange, padding=0)
    rates = {
        "pan": steps_per_second(lambda span: show(*span), pan_ranges(len(points))),
        "zoom": steps_per_second(lambda span: show(*span), zoom_ranges(len(points))),
    }
    widget.close()
    return rates
