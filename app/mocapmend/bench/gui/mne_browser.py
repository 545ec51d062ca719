"""Scrolling through the same data as raw signals in MNE-Qt-Browser, by its own functions.

Without annotations: 10,000 gaps as annotations alone take it half a minute.
"""

from pathlib import Path
from typing import Any

import numpy as np
from numpy.typing import NDArray

from mocapmend.bench.gui.stage import PLOTS, SIZE, steps_per_second
from mocapmend.bench.gui.steps import PAGE_S, PAGES, QUARTERS, page_starts
from mocapmend.files import read_recording
from mocapmend_algorithms import Recording

HOW_TO_INSTALL = "not installed: pip install 'mocapmend[bench]', or --mne-python PATH"
SCALE_MM = 400.0


def mne(path: Path) -> dict[str, Any]:
    """Return steps per second through the recording, 10 s of 12 channels at a time."""
    from pyqtgraph import mkQApp

    # Its own test for a display knows no offscreen platform; with an application there is none.
    app = mkQApp()
    try:
        import mne as library
        import mne_qt_browser  # noqa: F401 - what the next lines choose
    except ImportError:
        return {"missing": HOW_TO_INSTALL}
    library.set_log_level("ERROR")
    library.viz.set_browser_backend("qt")
    recording = read_recording(path).recording
    names = [f"{label} {axis}" for label in recording.labels for axis in "XYZ"]
    raw = library.io.RawArray(signals(recording), library.create_info(names, recording.rate))
    browser = raw.plot(
        n_channels=PLOTS, duration=PAGE_S, scalings={"misc": SCALE_MM}, show=True, block=False
    )
    browser.resize(*SIZE)
    for _ in range(5):
        app.processEvents()
    page = PAGE_S * recording.rate
    rates = {}
    for name, share, count, step in (
        ("quarter", 0.25, QUARTERS, "right"),
        ("page", 1.0, PAGES, "+full"),
    ):
        browser.mne.plt.setXRange(0, PAGE_S, padding=0)
        app.processEvents()
        steps = [step for _ in page_starts(recording.frames, page, share, count)]
        rates[name] = steps_per_second(browser.hscroll, steps)
    browser.close()
    return rates


def signals(recording: Recording) -> NDArray[np.float64]:
    """Return the coordinates as channels, shape (3 markers, frames), straight across gaps."""
    channels = recording.points.reshape(recording.frames, -1).T.copy()
    frames = np.arange(recording.frames)
    for channel in channels:
        known = ~np.isnan(channel)
        if known.any():
            channel[~known] = np.interp(frames[~known], frames[known], channel[known])
    return np.nan_to_num(channels)
