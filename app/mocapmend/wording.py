"""Numbers as people write them. No Qt."""


def count(number: int, thing: str) -> str:
    """Return "1 gap", "2 gaps"."""
    return f"{number} {thing}" if number == 1 else f"{number} {thing}s"


def span(first: int, last: int) -> str:
    """Return "7-12", or "7" for one frame."""
    return f"{first}-{last}" if last > first else f"{first}"
