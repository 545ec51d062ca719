"""mocapmend: inspect and repair optical motion-capture recordings."""

__version__ = "0.1.0"
