"""One measurement in a process of its own: `python -m mocapmend.bench.gui.child NAME FILE ...`."""

import json
import sys
from importlib import import_module
from pathlib import Path

MODULES = {
    "plots": "plots",
    "scroll": "plots",
    "plain": "plain_plots",
    "mne": "mne_browser",
    "reading": "opening",
    "sharing": "opening",
    "opening": "opening",
    "pauses": "pauses",
    "memory": "memory",
}
"""The module of each measurement; it has a function of the measurement's name."""


def main() -> None:
    """Measure what the command line names and print it."""
    name, path, *sizes = sys.argv[1:]
    module = import_module(f"mocapmend.bench.gui.{MODULES[name]}")
    found = getattr(module, name)(Path(path), *map(float, sizes))
    sys.stdout.write("\n" + json.dumps(found) + "\n")


if __name__ == "__main__":
    main()
