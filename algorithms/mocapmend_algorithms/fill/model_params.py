"""Parameters that all methods share that model how markers move with each other."""

from typing import Any, Literal

from mocapmend_algorithms.params import option

ModelEdges = Literal["fill", "leave"]

LEFT_OPEN = "it is at the start or the end of the recording, where gaps are to be left open"
"""Why a gap stays open where the user says so."""


def model_edges_option() -> Any:
    """Make the parameter `edges`, of type `ModelEdges`."""
    return option(
        "fill",
        label="Start and end",
        text="What to do with a gap at the start or the end of the recording: fill it from the "
        "other markers, or leave it open.",
    )


def donors_option(text: str) -> Any:
    """Make the parameter `donors`, the labels of markers that the user names.

    Parameters
    ----------
    text : str
        Which markers are wanted, as "Markers of the same rigid part".
    """
    return option(
        (),
        label="Donors",
        text=f"{text}, by their labels, with commas between them. Automatic: chosen for each gap "
        "among the markers that are seen throughout it.",
    )
