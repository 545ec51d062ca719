#!/usr/bin/env python3
"""Set up mocapmend from a checkout and run it, or test it.

    python3 packaging/dev.py run [FILE]
    python3 packaging/dev.py test [PYTEST ARGUMENT ...]

This file keeps to syntax that Python 3.6 can read, and imports its neighbours late, so that an
older Python gets as far as a sentence that says what is missing.
"""

import shutil
import subprocess
import sys
from pathlib import Path

MINIMUM = (3, 11)
NEWER = ("python3.13", "python3.12", "python3.11", "python3.14")


def find_newer_python() -> "str | None":
    """Return a Python on the PATH that is new enough and starts, or None."""
    question = f"import sys; sys.exit(sys.version_info[:2] < {MINIMUM})"
    for name in NEWER:
        path = shutil.which(name)
        if path and subprocess.call([path, "-c", question], stderr=subprocess.DEVNULL) == 0:
            return path
    return None


def start_again() -> int:
    """Hand the same command to a newer Python; without one say what to install."""
    path = find_newer_python()
    if path:
        return subprocess.call([path, str(Path(__file__).resolve()), *sys.argv[1:]])
    print(
        f"mocapmend needs Python 3.11 or newer. This is Python {sys.version_info[0]}."
        f"{sys.version_info[1]}, and the PATH holds no newer one. Install one (see python.org, or "
        "your system's package manager) and run the same command again.",
        file=sys.stderr,
    )
    return 1


def main() -> int:
    """Run the task that the command line names; return the exit code."""
    if sys.version_info[:2] < MINIMUM:
        return start_again()
    import tasks

    return tasks.main(sys.argv[1:])


if __name__ == "__main__":
    sys.exit(main())
