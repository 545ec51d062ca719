"""What a release promises: commands, credits, pins, and packages without Qt."""

import hashlib
import os
import re
import shutil
import subprocess
import sys
import tomllib
from pathlib import Path

import pytest
from packaging.requirements import Requirement
from threadpoolctl import threadpool_info

ROOT = Path(__file__).resolve().parent.parent
TEST_COMMAND = "python3 packaging/dev.py test"
RUN_COMMAND = "python3 packaging/dev.py run"


def python(code: str) -> str:
    """Run code in a Python of its own and return what it prints."""
    done = subprocess.run([sys.executable, "-c", code], capture_output=True, text=True, check=False)
    assert done.returncode == 0, done.stderr
    return done.stdout


class TestRepository:
    def test_packaging_is_no_package(self) -> None:
        assert not (ROOT / "packaging" / "__init__.py").exists()

    def test_readme_names_the_two_commands_and_help_explains_them(self) -> None:
        readme = (ROOT / "README.md").read_text(encoding="utf-8")
        named = set(re.findall(r"python3 packaging/dev\.py \w+", readme))
        assert named == {RUN_COMMAND, TEST_COMMAND}
        command = [sys.executable, ROOT / "packaging" / "dev.py", "--help"]
        text = subprocess.run(command, capture_output=True, text=True, check=True).stdout
        assert all(words in text for words in named)

    def test_ci_runs_exactly_the_test_command(self) -> None:
        script = ROOT / ".ci" / "run"
        assert os.access(script, os.X_OK)
        lines = script.read_text(encoding="utf-8").splitlines()
        assert lines[-1] == TEST_COMMAND
        assert "set -euo pipefail" in lines

    @pytest.mark.skipif(shutil.which("bash") is None, reason="a script of bash")
    @pytest.mark.parametrize("code", [0, 1, 3])
    def test_ci_ends_as_the_tests_end(self, tmp_path: Path, code: int) -> None:
        for name in (".ci/run", "packaging/dev.py"):
            copy = tmp_path / name
            copy.parent.mkdir()
            shutil.copy(ROOT / name, copy)
        (tmp_path / "packaging" / "tasks.py").write_text(f"""
import os, pathlib
def main(arguments):
    folder = pathlib.Path(os.environ["MOCAPMEND_VENV"])
    folder.mkdir()
    print(arguments, folder.parent)
    return {code}
""")
        done = subprocess.run(
            ["bash", tmp_path / ".ci" / "run"], capture_output=True, text=True, check=False
        )
        assert done.returncode == code
        arguments, _, folder = done.stdout.strip().partition("] ")
        assert arguments == "['test'"
        assert not Path(folder).exists()

    def test_credits_list_every_sample_with_its_hash(self, samples: Path) -> None:
        text = (samples.parent / "CREDITS.md").read_text(encoding="utf-8")
        listed = dict(re.findall(r"\| (\S+\.c3d) \| ([0-9a-f]{64}) \|", text))
        found = {
            file.name: hashlib.sha256(file.read_bytes()).hexdigest() for file in samples.iterdir()
        }
        assert listed == found
        assert all(f"\n## {name}\n" in text for name in found)


class TestDependencies:
    def test_tests_compute_in_one_thread_as_the_program_does(self) -> None:
        import scipy.linalg  # noqa: F401

        libraries = [each for each in threadpool_info() if each["user_api"] == "blas"]
        assert [each["num_threads"] for each in libraries] == [1] * len(libraries)

    def test_pin_keeps_out_the_pyside_that_aborts(self) -> None:
        project = tomllib.loads((ROOT / "pyproject.toml").read_text(encoding="utf-8"))["project"]
        wanted = [Requirement(line) for line in project["dependencies"]]
        (pyside,) = [each for each in wanted if each.name.startswith("PySide6")]
        assert pyside.name == "PySide6-Essentials"
        assert pyside.specifier.contains("6.11.3")
        assert not pyside.specifier.contains("6.12.0")

    @pytest.mark.skipif(sys.version_info >= (3, 12), reason="None is immortal on Python >= 3.12")
    def test_qt_calls_give_back_no_reference_that_they_do_not_own(self) -> None:
        code = """
import sys
from PySide6.QtCore import QObject, Signal

class Emitter(QObject):
    done = Signal(bool)

def change(value, call, count):
    before = sys.getrefcount(value)
    for _ in range(count):
        call()
    return sys.getrefcount(value) - before

emitter = Emitter()
print(change(None, lambda: emitter.setObjectName("x"), 1000))
print(change(True, lambda: emitter.done.emit(False), 100))
"""
        void_call, emit = (int(line) for line in python(code).split())
        assert void_call > -100
        assert emit > -10

    @pytest.mark.parametrize("package", ["mocapmend_algorithms", "mocapmend.files"])
    def test_package_loads_no_qt(self, package: str) -> None:
        code = f"""
import importlib, pkgutil, sys
package = importlib.import_module({package!r})
names = [module.name for module in pkgutil.walk_packages(package.__path__, {package!r} + ".")]
for name in names:
    importlib.import_module(name)
print(len(names), *(name for name in sys.modules if name.startswith(("PySide6", "pyqtgraph"))))
"""
        count, *qt = python(code).split()
        assert int(count) > 0
        assert qt == []
