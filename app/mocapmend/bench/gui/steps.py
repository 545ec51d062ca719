"""Where the playhead and the visible range go: the same for the window and its rivals."""

import numpy as np

PAN_FRAMES = 40_000
PANS = 40
SCRUBS = 200
ZOOM_FRAMES = (1_000, 100_000)
PAGE_S = 10.0
QUARTERS = 40
PAGES = 30


def scrub_places(frames: int) -> list[float]:
    """Return frames all over the recording."""
    return [float(place) for place in np.random.default_rng(0).integers(0, frames, SCRUBS)]


def pan_ranges(frames: int) -> list[tuple[float, float]]:
    """Return ranges of 40,000 frames all over the recording, or of 40 % of a shorter one."""
    width = min(PAN_FRAMES, 0.4 * frames)
    starts = np.random.default_rng(0).uniform(0, frames - width, PANS)
    return [(start, start + width) for start in starts.tolist()]


def zoom_ranges(frames: int) -> list[tuple[float, float]]:
    """Return ranges around some places, each half as wide as the one before, and back again."""
    least, most = (min(size, frames) for size in ZOOM_FRAMES)
    widths = [float(most)]
    while widths[-1] / 2 >= least:
        widths.append(widths[-1] / 2)
    widths += widths[-2::-1]
    found = []
    for centre in np.random.default_rng(0).uniform(0, frames, 4).tolist():
        for width in widths:
            start = min(max(0.0, centre - width / 2), frames - width)
            found.append((start, start + width))
    return found


def page_starts(frames: int, page: float, share: float, count: int) -> list[float]:
    """Return the starts of ranges of one page, each moved by a share of a page."""
    most = int((frames - page) / (share * page))
    return [step * share * page for step in range(1, min(count, most) + 1)]
