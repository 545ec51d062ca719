"""Wrong usage that the parser alone cannot see."""


class UsageError(Exception):
    """A command line that cannot be meant: exit code 2."""
