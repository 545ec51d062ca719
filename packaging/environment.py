"""The virtual environment in which a checkout runs: made, refreshed, or left alone."""

import hashlib
import os
import subprocess
import sys
from dataclasses import dataclass
from pathlib import Path

from steps import ROOT, SetupError, step

# Printed by the environment's own Python: its version, then whether the packages are there.
PROBE = """
import importlib.util, sys
import pip
print(sys.version)
print(all(importlib.util.find_spec(name) for name in ("mocapmend", "PySide6")))
sys.exit(sys.version_info < (3, 11))
"""
LOAD_QT = "import PySide6.QtWidgets, PySide6.QtOpenGL, PySide6.QtOpenGLWidgets"
REACH_DISPLAY = "from PySide6.QtGui import QGuiApplication; QGuiApplication([])"


@dataclass(frozen=True)
class Environment:
    """A virtual environment.

    Parameters
    ----------
    folder : Path
        Where it is, or will be.
    """

    folder: Path

    @property
    def python(self) -> Path:
        """The environment's Python."""
        if sys.platform == "win32":
            return self.folder / "Scripts" / "python.exe"
        return self.folder / "bin" / "python"

    def probe(self) -> tuple[str, bool] | None:
        """Return the Python version and whether the packages are there; None if it is broken."""
        if not self.python.exists():
            return None
        done = subprocess.run(
            [self.python, "-c", PROBE], capture_output=True, text=True, check=False
        )
        if done.returncode != 0:
            return None
        *version, installed = done.stdout.splitlines()
        return " ".join(version), installed == "True"

    def reaches_display(self) -> bool:
        """Tell whether Qt can talk to the display; where it cannot, it ends its process."""
        done = subprocess.run([self.python, "-c", REACH_DISPLAY], capture_output=True, check=False)
        return done.returncode == 0

    def stamp(self, extra: str) -> Path:
        """Return the file that records a finished installation with an extra ("" for none)."""
        return self.folder / f"mocapmend-{extra or 'run'}.stamp"


def chosen() -> Environment:
    """Return the environment that MOCAPMEND_VENV names, else .venv in the project root."""
    named = os.environ.get("MOCAPMEND_VENV")
    return Environment(Path(named).expanduser().absolute() if named else ROOT / ".venv")


def contents(version: str, extra: str) -> str:
    """Return what a stamp holds: a hash of everything that decides what gets installed."""
    parts = [(ROOT / "pyproject.toml").read_bytes(), str(ROOT).encode(), version.encode()]
    return hashlib.sha256(b"\0".join([*parts, extra.encode()])).hexdigest()


def refresh(environment: Environment, extra: str = "") -> None:
    """Make the environment hold this checkout and its dependencies.

    Parameters
    ----------
    environment : Environment
        Made when absent, made again when broken, left alone when its stamp is up to date.
    extra : str
        The optional group of dependencies to install too.

    Raises
    ------
    SetupError
        A step failed; its output is on the screen.
    """
    found = environment.probe()
    if found is None:
        create(environment)
        found = environment.probe()
        if found is None:
            raise SetupError(f"The environment in {environment.folder} does not start.")
    version, installed = found
    stamp = environment.stamp(extra)
    if installed and stamp.is_file() and stamp.read_text() == contents(version, extra):
        return
    install(environment, extra)
    for name in {"", extra}:
        environment.stamp(name).write_text(contents(version, name))


def create(environment: Environment) -> None:
    """Make an empty environment in place of what is there, but only if that was one."""
    folder = environment.folder
    strangers = folder.is_dir() and any(folder.iterdir()) and not (folder / "pyvenv.cfg").exists()
    if strangers or (folder.exists() and not folder.is_dir()):
        raise SetupError(
            f"{folder} is not a virtual environment, so it is left as it is. "
            "Name another folder in MOCAPMEND_VENV."
        )
    title = f"Making an environment in {folder}"
    if not step(title, [sys.executable, "-m", "venv", "--clear", folder]):
        raise SetupError("The environment could not be made: see above.")


def install(environment: Environment, extra: str) -> None:
    """Install the checkout, editable, with its dependencies; then see whether Qt loads."""
    target = f"{ROOT}[{extra}]" if extra else str(ROOT)
    pip: list[str | Path] = [
        environment.python,
        "-m",
        "pip",
        "install",
        "--no-input",
        "--disable-pip-version-check",
    ]
    title = "Installing mocapmend and what it needs (minutes, the first time)"
    if not step(title, [*pip, "--editable", target]):
        raise SetupError("The packages could not be installed: see above.")
    if not step("Loading Qt", [environment.python, "-c", LOAD_QT]):
        raise SetupError("Qt cannot be loaded: the line above names the system library it misses.")
