"""Start-up stays light, and the benchmark command prints its tables."""

import json
import subprocess
import sys
from pathlib import Path

import pytest

from mocapmend.bench import main

HEAVY = ("scipy", "c3d", "jinja2", "reportlab", "mocapmend.engine", "mocapmend.views.workspace")


def test_the_window_starts_without_what_it_needs_later() -> None:
    code = (
        "import sys, mocapmend.views.application; "
        f"print([name for name in {HEAVY!r} if name in sys.modules])"
    )
    done = subprocess.run([sys.executable, "-c", code], capture_output=True, text=True, check=True)
    assert done.stdout.strip() == "[]"


@pytest.mark.parametrize("module", ["mocapmend", "mocapmend.cli"])
def test_numpy_is_told_to_use_one_thread_before_it_is_loaded(
    module: str, monkeypatch: pytest.MonkeyPatch
) -> None:
    monkeypatch.delenv("OPENBLAS_NUM_THREADS", raising=False)
    code = (
        f"import sys, {module}; print('numpy' in sys.modules);"
        "import os; print(os.environ['OPENBLAS_NUM_THREADS'])"
    )
    done = subprocess.run([sys.executable, "-c", code], capture_output=True, text=True, check=True)
    assert done.stdout.split() == ["False", "1"]


def test_once_painted_the_window_loads_the_rest(tmp_path: Path) -> None:
    code = f"""
import sys
from PySide6.QtCore import QSettings
from mocapmend.settings import Settings
from mocapmend.views.application import make_application
from mocapmend.views.first_paint import FirstPaint
from mocapmend.views.main_window import MainWindow
app = make_application()
window = MainWindow(Settings(QSettings({str(tmp_path / "a.ini")!r}, QSettings.Format.IniFormat)))
painted = FirstPaint(window).painted
painted.connect(lambda: print([name for name in {HEAVY!r} if name in sys.modules]))
painted.connect(window.get_ready)
painted.connect(lambda: print("mocapmend.views.workspace" in sys.modules))
painted.connect(window.close)
window.show()
app.exec()
"""
    done = subprocess.run(
        [sys.executable, "-c", code], capture_output=True, text=True, check=True, timeout=60
    )
    assert done.stdout.split() == ["[]", "True"]


@pytest.mark.skipif(sys.platform != "linux", reason="elsewhere there always is a display")
def test_without_a_display_the_window_says_so(
    monkeypatch: pytest.MonkeyPatch, capfd: pytest.CaptureFixture[str]
) -> None:
    for name in ("DISPLAY", "WAYLAND_DISPLAY", "QT_QPA_PLATFORM"):
        monkeypatch.delenv(name, raising=False)
    done = subprocess.run([sys.executable, "-m", "mocapmend", "walk.c3d"], check=False, timeout=60)
    assert done.returncode == 1
    assert capfd.readouterr().err.startswith("mocapmend: There is no display")


def test_a_benchmark_prints_its_table(capsys: pytest.CaptureFixture[str]) -> None:
    assert main(["io", "--frames", "3000", "--runs", "1", "--json"]) == 0
    document = json.loads(capsys.readouterr().out)
    assert document["schema"] == 1
    assert document["command"] == "bench io"
    assert all(row["note"] or row["figure"] > 0 for row in document["rows"])
    assert any(row["ratio"] is not None and row["target"] for row in document["rows"])
