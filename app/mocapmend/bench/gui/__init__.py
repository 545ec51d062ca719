"""Speed and memory of the window with a large recording, on whatever platform Qt finds.

Each measurement has a process of its own; rivals run in turn with the window.
"""

from mocapmend.bench.gui.command import add_arguments, run

__all__ = ["add_arguments", "run"]
