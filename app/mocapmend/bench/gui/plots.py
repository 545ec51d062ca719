"""Moving through the recording in our window: 3D view, 12 plots and timeline are painted."""

from pathlib import Path

from mocapmend.bench.gui.stage import opened, show_plots, steps_per_second, window
from mocapmend.bench.gui.steps import (
    PAGE_S,
    PAGES,
    QUARTERS,
    page_starts,
    pan_ranges,
    scrub_places,
    zoom_ranges,
)


def plots(path: Path) -> dict[str, float]:
    """Return steps per second of scrubbing, panning and zooming, and the size of the plots."""
    with window(ranking=False) as shown:
        workspace = opened(shown, path)
        show_plots(workspace)
        view, area = workspace.view, workspace.trajectories
        frames = view.frames
        scrub = steps_per_second(lambda frame: view.set_frame(int(frame)), scrub_places(frames))
        pan = steps_per_second(lambda span: view.set_visible(*span), pan_ranges(frames))
        zoom = steps_per_second(lambda span: view.set_visible(*span), zoom_ranges(frames))
        return {
            "scrub": scrub,
            "pan": pan,
            "zoom": zoom,
            "width": area.width(),
            "height": area.height(),
        }


def scroll(path: Path) -> dict[str, float]:
    """Return steps per second through the recording, 10 s at a time."""
    with window(ranking=False) as shown:
        workspace = opened(shown, path)
        show_plots(workspace)
        view, page = workspace.view, PAGE_S * workspace.document.original.rate
        rates = {}
        for name, share, count in (("quarter", 0.25, QUARTERS), ("page", 1.0, PAGES)):
            view.set_visible(0, page)
            rates[name] = steps_per_second(
                lambda start: view.set_visible(start, start + page),
                page_starts(view.frames, page, share, count),
            )
        return rates
