"""Words that go with numbers. No Qt."""


def count(number: int, thing: str) -> str:
    """Return "1 gap", "2 gaps"."""
    return f"{number} {thing}" if number == 1 else f"{number} {thing}s"
