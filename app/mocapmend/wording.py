"""Numbers as people write them. No Qt."""

from collections.abc import Iterable


def count(number: int, thing: str) -> str:
    """Return "1 gap", "2 gaps"."""
    return f"{number} {thing}" if number == 1 else f"{number} {thing}s"


def was(number: int) -> str:
    """Return "was" for one, "were" for others."""
    return "was" if number == 1 else "were"


def span(first: int, last: int) -> str:
    """Return "7-12", or "7" for one frame."""
    return f"{first}-{last}" if last > first else f"{first}"


def cutoffs(of_axes: Iterable[float]) -> str:
    """Return cut-offs in Hz: of x, y and z, or one where they are equal; "" without any."""
    texts = [f"{hz:.1f}" for hz in of_axes]
    return " ".join(texts if len(set(texts)) > 1 else texts[:1])
