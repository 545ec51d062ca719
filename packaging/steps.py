"""One step of the set-up: a line while it runs, its whole output when it fails."""

import os
import subprocess
import time
from collections.abc import Mapping, Sequence
from pathlib import Path

ROOT = Path(__file__).resolve().parent.parent


class SetupError(Exception):
    """The set-up cannot go on; the text tells the user why and what to do."""


def step(
    title: str, command: Sequence[str | Path], *, environment: Mapping[str, str] | None = None
) -> bool:
    """Run a command in the project root, quietly when it works.

    Parameters
    ----------
    title : str
        What is being done, for the line on the screen.
    command : sequence of str or Path
        Program and arguments.
    environment : mapping, optional
        Variables to set on top of the present ones.

    Returns
    -------
    bool
        Whether the command ended with exit code 0.
    """
    print(f"{title} ...", end=" ", flush=True)
    start = time.monotonic()
    done = subprocess.run(
        [str(part) for part in command],
        cwd=ROOT,
        env={**os.environ, **(environment or {})},
        stdin=subprocess.DEVNULL,
        stdout=subprocess.PIPE,
        stderr=subprocess.STDOUT,
        encoding="utf-8",
        errors="replace",
        check=False,
    )
    seconds = time.monotonic() - start
    if done.returncode == 0:
        print(f"done ({seconds:.0f} s)", flush=True)
        return True
    print(f"FAILED (exit code {done.returncode})\n{done.stdout.rstrip()}", flush=True)
    return False
