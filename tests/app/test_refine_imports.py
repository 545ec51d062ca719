"""Refining needs no PyTorch, and the window none of refining before it is asked for."""

import subprocess
import sys

import pytest

CODE = """
import sys
import {module}
print(*sorted(name for name in sys.modules if name in {unwanted}))
"""


@pytest.mark.parametrize(
    ("module", "unwanted"),
    [
        ("mocapmend.refine.running", ("torch", "PySide6")),
        ("mocapmend.cli.refine", ("torch", "PySide6")),
        ("mocapmend.cli.train.refine", ("torch", "PySide6")),
        ("mocapmend.bench.kinect", ("torch", "PySide6")),
        ("mocapmend.views.main_window", ("torch", "mocapmend_algorithms.refine.network")),
    ],
)
def test_what_is_not_needed_is_not_loaded(module: str, unwanted: tuple[str, ...]) -> None:
    code = CODE.format(module=module, unwanted=unwanted)
    done = subprocess.run([sys.executable, "-c", code], capture_output=True, text=True, check=True)
    assert done.stdout.split() == []
